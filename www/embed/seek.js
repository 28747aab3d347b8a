// To any step, forwards or backwards.

/** @import { PageState } from "../store.js" */

/**
 * @typedef {object} Moves
 * @property {(step: number) => Promise<unknown>} seek  to a stored step
 * @property {() => Promise<unknown>} pause
 * @property {(step: number) => Promise<unknown>} runTo  starts only
 * @property {() => Promise<unknown>} still  nothing runs any more
 */

/**
 * To the nearest stored step that is not beyond, and on from there: the same steps give the
 * same surface.
 * @param {Moves} moves @param {() => Readonly<PageState>} get
 * @param {number} step  less if the flow ends before
 */
export async function seek(moves, get, step) {
  await moves.pause();
  const { timeline } = get();
  if (!timeline) return;
  const { start, first, last } = timeline;
  await moves.seek(step < first ? start : Math.min(step, last));
  if (step > (get().reading?.step ?? 0)) {
    await moves.runTo(step);
    await moves.still();
  }
}
