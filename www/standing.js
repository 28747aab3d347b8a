// @ts-check
// Where a run stands: what its status means, and what that is called.

/** @import { Status } from "./generated/types.js" */

/** @typedef {Exclude<Status, "ready">} Ended */

/** A run that came to its end, of its own accord or at a limit. @param {Status} status @returns {status is Ended} */
export const isOver = (status) => status !== "ready";

/** In a word or two. @type {Readonly<Record<Status, string>>} */
export const standings = {
  ready: "moving",
  converged: "converged",
  stalled: "stalled",
  stepLimit: "at its limit",
  singular: "singular",
  collapsed: "collapsed",
  failed: "failed",
};
