// @ts-check
// How the state of the page changes while flows are compared. Pure, as all transitions.

/** @import { Configured, State as Reading } from "./generated/types.js" */
/** @import { Field, Frame } from "./state.js" */
/** @import { Comparison, Rival } from "./comparison.js" */
/** @import { PageState } from "./state.js" */

import { alone, unborn } from "./comparison.js";
import { extended } from "./state.js";

/** @typedef {Readonly<PageState>} S */

/** @param {S} s @param {number} id @param {(rival: Rival) => Partial<Rival>} change @returns {S} */
const changed = (s, id, change) => ({
  ...s,
  comparison: {
    ...s.comparison,
    rivals: s.comparison.rivals.map((one) => (one.id === id ? { ...one, ...change(one) } : one)),
  },
});

/** @param {readonly number[]} bending @param {number} step @param {number} value */
function measured(bending, step, value) {
  const list = bending.slice(0, step + 1);
  list[step] = value;
  return list;
}

export const comparisonTransitions = {
  /** @param {S} s @param {Partial<Comparison>} change @returns {S} */
  compared: (s, change) => {
    const comparison = { ...s.comparison, ...change };
    const { rivals, shown, difference } = comparison;
    if (rivals.length === 0) return { ...s, comparison: alone };
    // What was shown or compared with may be gone.
    return {
      ...s,
      comparison: {
        ...comparison,
        shown: shown === "side" || shown <= rivals.length ? shown : "side",
        difference: difference !== null && difference > rivals.length ? null : difference,
      },
    };
  },

  /** Its solver is being made, or made anew. @param {S} s @param {number} id @returns {S} */
  rivalLoading: (s, id) => changed(s, id, () => unborn),

  /** @param {S} s @param {number} id @param {Rival["change"]} change @param {Configured} configured @returns {S} */
  rivalConfigured: (s, id, change, configured) =>
    changed(s, id, () => ({
      change,
      configured,
      phase: "ready",
      reason: "",
      reading: configured.state,
      history: extended([], configured.state, []),
      bending: [],
    })),

  /** @param {S} s @param {number} id @param {Frame} frame @returns {S} */
  rivalFrame: (s, id, { state, reports, positions, field, flippedTriangles }) =>
    changed(s, id, ({ history }) => ({
      reason: "",
      reading: state,
      history: extended(history, state, reports),
      frame: { positions, field, flippedTriangles },
    })),

  /** @param {S} s @param {number} id @param {string} reason @returns {S} */
  rivalLost: (s, id, reason) => changed(s, id, () => ({ phase: "lost", reason })),

  /** @param {S} s @param {number} id @param {Reading} reading @returns {S} */
  rivalRevived: (s, id, reading) =>
    changed(s, id, ({ history }) => ({
      phase: "ready",
      reason: "",
      reading,
      history: extended(history, reading, []),
    })),

  /** @param {S} s @param {number} id @param {Field | null} field @returns {S} */
  rivalColoured: (s, id, field) =>
    changed(s, id, ({ frame }) => ({ frame: frame && { ...frame, field } })),

  /** ∫H² dA after a step. @param {S} s @param {number | null} id  null: of the first pane @param {number} step @param {number} value @returns {S} */
  bent: (s, id, step, value) =>
    id === null
      ? {
          ...s,
          comparison: {
            ...s.comparison,
            bending: measured(s.comparison.bending, step, value),
          },
        }
      : changed(s, id, ({ bending }) => ({ bending: measured(bending, step, value) })),
};

/** Whether anybody may go a step back. @param {S} s */
export const canStepBack = ({ reading, comparison }) =>
  (reading?.canStepBack ?? false) ||
  comparison.rivals.some((rival) => rival.reading?.canStepBack ?? false);

/** Whether anybody has left the start. @param {S} s */
export const hasMoved = ({ reading, comparison }) =>
  (reading?.step ?? 0) > 0 || comparison.rivals.some((rival) => (rival.reading?.step ?? 0) > 0);
