// @ts-check
// What makes another mesh of the one at hand, and the way back from it.

/** @import { FillOptions, Loaded } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { Core } from "./core.js" */

import { t } from "../language.js";
import { byCurvature, toFlow } from "../options.js";
import { transitions as to } from "../state.js";
import { say } from "../words.js";

/** What going on from a surface takes back when it is undone. @param {number} count */
export const stepsOf = (count) => say("count-steps", { count });

/** @param {Core} core */
export function createEdits(core) {
  const { store, solver, voice, enqueue, rest, framed, configure, colour, arrange } = core;

  /**
   * Makes the surface as it is the start; `undo` takes that back.
   * @param {Options} options  that it goes on with
   * @param {string} what      for people: what undoing takes back
   */
  async function adopt(options, what) {
    if (store.get().mesh) await edited({ loaded: await solver.adopt(), what }, options);
  }

  /**
   * Goes on with a mesh that the solver has made of the one at hand.
   * @param {{ loaded: Loaded, what: string }} edit
   * @param {Options} [options]  those in force unless given
   */
  async function edited({ loaded, what }, options = store.get().options) {
    const { source, options: before, earlier, history, mesh } = store.get();
    if (!source || !mesh) return;
    // No sample any more, and no file either: a link to it can only name it.
    const own = /** @type {const} */ ({ kind: "file", name: mesh.name });
    store.update(to.edited, own, loaded, [...earlier, { source, options: before, history, what }]);
    await configure(options);
    await colour(store.get().colour);
  }

  const actions = {
    /** Regularises the mesh as it is; a step back undoes it. */
    regularise: () =>
      enqueue(async () => {
        await rest();
        if (!store.get().reading) return;
        const { regulariseEpsilon: epsilon } = store.get().options;
        store.update(to.progress, { stage: "regularise", fraction: 0 });
        const outcome = await solver.regularise({ epsilon }).finally(() => {
          store.update(to.progress, null);
        });
        const { passes, before, after, distance, pinned } = outcome;
        voice.answer(
          passes === 0
            ? pinned === 0
              ? t("The mesh is as regular as it gets.")
              : t(
                  "The mesh is as regular as it gets while its vertices on creases stay, {pinned} of them; a finer mesh has more to move.",
                  { pinned },
                )
            : say("regularised", {
                passes,
                angle: before.minAngleDegrees,
                angleNow: after.minAngleDegrees,
                distortion: before.distortion,
                distortionNow: after.distortion,
                distance: 100 * distance,
              }),
        );
      }),
    /** All flips that gain anything, at once. */
    finish: () =>
      enqueue(async () => {
        await rest();
        if (!store.get().reading) return;
        const { flipsPerStep } = store.get().arrangement;
        await solver.arrange({ ...store.get().arrangement, flipsPerStep: null });
        store.update(to.progress, { stage: "flips", fraction: 0 });
        await solver.step().finally(() => store.update(to.progress, null));
        await arrange({ flipsPerStep });
      }),
    /** Makes the surface as it is the start of what comes. */
    adopt: () =>
      enqueue(async () => {
        await rest();
        const { options, reading } = store.get();
        if (reading && reading.step > 0) await adopt(options, stepsOf(reading.step));
      }),
    /** Divides each triangle into four. @param {"linear" | "loop"} scheme */
    subdivide: (scheme) =>
      enqueue(async () => {
        await rest();
        if (!store.get().mesh) return;
        const loaded = await solver.subdivide(scheme);
        // What was held or free, on the finer mesh.
        const free = loaded.free ? [...loaded.free] : null;
        const fixed = loaded.fixed ? [...loaded.fixed] : null;
        const what = t("a subdivision");
        await edited({ loaded, what }, { ...store.get().options, free, fixed });
        voice.answer(
          t("Subdivided into {count} triangles; Undo takes it back.", {
            count: loaded.info.faces,
          }),
        );
      }),
    /** Takes the last edit back: the run stands where it stood. */
    undo: () =>
      enqueue(async () => {
        await rest();
        const { earlier, comparison } = store.get();
        const last = earlier.at(-1);
        if (!last) return;
        const { answer, frame } = await framed(() => solver.undo());
        store.update(to.edited, last.source, answer, earlier.slice(0, -1));
        // Panes beside it begin anew, and so does it.
        if (frame && comparison.rivals.length === 0) {
          store.update(to.resumed, last.history, frame);
          await arrange({});
        } else await configure(last.options);
        await colour(store.get().colour);
      }),
    /**
     * Fills holes, or connects loops; a flow on the new vertices is ready then.
     * @param {Partial<FillOptions>} wanted
     */
    fill: (wanted) =>
      enqueue(async () => {
        await rest();
        const { source, options: before, earlier, history, mesh } = store.get();
        if (!source || !mesh) return;
        store.update(to.progress, { stage: "fill", fraction: 0 });
        const { filled: outcome, loaded } = await solver
          .fill(wanted)
          .finally(() => store.update(to.progress, null));
        const count = outcome.loops.length;
        const what = say("count-fills", { count });
        const own = /** @type {const} */ ({ kind: "file", name: mesh.name });
        store.update(to.edited, own, loaded, [
          ...earlier,
          { source, options: before, history, what },
        ]);
        for (const warning of outcome.warnings) voice.note(say(warning), warning.id);
        const flow = byCurvature.includes(before.flow) ? before.flow : "mmcv";
        const free = loaded.free ? [...loaded.free] : null;
        await configure({ ...before, ...toFlow(flow), fixed: null, prefill: false, free });
        await colour(store.get().colour);
        voice.answer(say("filled", { count, vertices: outcome.verticesAdded }));
      }),
    /** Frees these vertices and holds the others; the surface as it is becomes the start. @param {number[] | null} free */
    select: (free) =>
      enqueue(async () => {
        await rest();
        const { options, reading } = store.get();
        const wanted = { ...options, free, fixed: null };
        if (reading && reading.step > 0) await adopt(wanted, stepsOf(reading.step));
        else await configure(wanted);
      }),
  };
  return { adopt, edited, actions };
}
