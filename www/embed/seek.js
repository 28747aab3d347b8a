// @ts-check
// To any step, forwards or backwards, by what the page can do anyway.

/** @import { PageState } from "../state.js" */

/**
 * @typedef {object} Moves
 * @property {() => Promise<unknown>} back
 * @property {() => Promise<unknown>} reset
 * @property {() => Promise<unknown>} pause
 * @property {(step: number) => Promise<unknown>} runTo  starts only
 * @property {() => Promise<unknown>} still  nothing runs any more
 */

/**
 * Back step by step where that is the shorter way and can be done, else anew from the start:
 * the same steps give the same surface.
 * @param {Moves} moves
 * @param {() => Readonly<PageState>} get
 * @param {number} step  less if the flow ends before
 */
export async function seek(moves, get, step) {
  await moves.pause();
  const at = () => get().reading?.step ?? 0;
  if (step < at() && at() - step <= step) {
    while (at() > step && get().reading?.canStepBack) {
      const before = at();
      await moves.back();
      if (at() >= before) break;
    }
  }
  if (step < at()) await moves.reset();
  if (step > at()) {
    await moves.runTo(step);
    await moves.still();
  }
}
