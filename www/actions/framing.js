// @ts-check
// Frames of a flow whose options are not told yet. They come before the answer that tells them,
// and nobody is to take their energy for that of the flow before.

/** @import { Frame } from "../state.js" */

/** @param {(frame: Frame) => unknown} learn  told of each that is handed out */
export function createFraming(learn) {
  /** @type {Frame[] | null} */
  let held = null;
  return {
    /** @param {Frame} frame @returns {boolean} whether it waits for its flow */
    holds(frame) {
      held?.push(frame);
      return held !== null;
    },
    /**
     * Asks for what changes the flow.
     * @template T
     * @param {() => Promise<T>} ask
     */
    async framed(ask) {
      /** @type {Frame[]} */
      const frames = [];
      held = frames;
      const answer = await ask().finally(() => {
        held = null;
      });
      const frame = frames.at(-1);
      if (frame) learn(frame);
      return { answer, frame };
    },
  };
}
