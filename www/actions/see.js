// @ts-check
// Looking closer at the surface, and inverting it in a sphere.

/** @import { Wanted } from "../generated/types.js" */
/** @import { Core } from "./core.js" */

import { t } from "../language.js";
import { transitions as to } from "../state.js";

/**
 * @param {Core} core
 * @param {(edit: { loaded: import("../generated/types.js").Loaded, what: string }) => Promise<void>} edited
 *   what is done with a mesh that an edit has made
 */
export const createSeeing = ({ store, solver, voice, enqueue, rest }, edited) => ({
  /** @param {Partial<Wanted>} change */
  inspect: (change) =>
    enqueue(async () => {
      const wanted = { ...store.get().wanted, ...change };
      const look = store.get().mesh ? await solver.look(wanted) : null;
      if (look) store.update(to.looking, wanted, look);
    }),
  /**
   * Shows the surface inverted; refusals are the caller's, who knows where to say them.
   * @param {number[]} centre  from the middle of the surface's box, in diagonals of it
   */
  async preview(centre) {
    const asked = store.get().frame;
    const inverted = await solver.previewInversion(centre);
    // A step meanwhile is the newer picture.
    if (store.get().frame === asked) store.update(to.previewed, inverted);
  },
  endPreview: () => store.update(to.previewed, null),
  /** @param {number[]} centre */
  invert: (centre) =>
    enqueue(async () => {
      await rest();
      const { report, loaded } = await solver.invert(centre);
      await edited({ loaded, what: t("the inversion") });
      const change = Math.abs(report.after.circle - report.before.circle);
      voice.answer(
        t("The surface is inverted; W has changed by {change}. Undo brings the one before back.", {
          change: change.toPrecision(2),
        }),
      );
    }),
});
