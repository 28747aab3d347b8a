// @ts-check
// Where a run stands: what its status means.

/** @import { Status } from "./generated/types.js" */

/** @typedef {Exclude<Status, "ready">} Ended */

/** A run that came to its end, of its own accord or at a limit. @param {Status} status @returns {status is Ended} */
export const isOver = (status) => status !== "ready";
