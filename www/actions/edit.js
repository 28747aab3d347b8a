// @ts-check
// What makes another mesh of the one at hand, and the way back; what is looked at more closely.

import { flowOf, toFlow } from "../options.js";
import { say } from "../words.js";
import { stepsOf } from "./run.js";

/** @import { FillOptions, Loaded, RemeshOptions, RepairOptions, LookOptions } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { Marks, Mode } from "../store.js" */
/** @import { Core } from "./core.js" */

/** Edits that the session keeps to be undone. */
const MOST_EDITS = 8;

/** Flows that a new patch is left to. @param {string} flow */
const fairs = (flow) => flowOf(flow).family === "curvature";

/** @param {Core} core */
export function createEdit(core) {
  const { get, patch, notes, solver, enqueue, rest, anew } = core;

  /**
   * Goes on with a mesh that the solver has made of the one at hand.
   * @param {Loaded} loaded @param {string} what  undoing takes back
   * @param {Options} [options]  those in force unless given
   */
  async function edited(loaded, what, options = get().options) {
    const { source, options: before, earlier, mesh } = get();
    if (!source || !mesh) return;
    const kept = [...earlier, { source, options: before, what }].slice(-MOST_EDITS);
    // No sample any more, and no file either: a link to it can only name it.
    patch({ source: { kind: "file", name: mesh.name }, mesh: loaded, earlier: kept, mode: null });
    patch({ preview: null, reading: null, configured: null, isNew: false });
    anew();
    await core.configure(options);
    if (get().colour !== "none") await core.colour(get().colour);
  }

  /** @param {Options} options @param {string} what */
  const adopt = async (options, what) => edited(await solver.adopt(), what, options);

  /** @template T @param {string} stage @param {() => Promise<T>} ask */
  const long = (stage, ask) => {
    patch({ progress: { stage, fraction: 0 } });
    return ask().finally(() => patch({ progress: null }));
  };

  /** @param {(mesh: Loaded) => Promise<unknown>} job */
  const change = (job) =>
    enqueue(async () => {
      await rest();
      const { mesh } = get();
      if (mesh) await job(mesh);
    });

  const edit = {
    /** Regularises the mesh as it is; a step back undoes it. */
    regularise: () =>
      change(async () => {
        const { regulariseEpsilon: epsilon } = get().options;
        const outcome = await long("regularise", () => solver.regularise({ epsilon }));
        const { passes, before, after, distance, pinned } = outcome;
        if (passes === 0) return notes.answer(say("regular-already", { pinned }));
        notes.answer(
          say("regularised", {
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
      change(async () => {
        const { arrangement } = get();
        await solver.arrange({ ...arrangement, flipsPerStep: null });
        await long("flips", () => solver.step());
        await solver.arrange(arrangement);
      }),
    /** Makes the surface as it is the start of what comes. */
    adopt: () =>
      change(async () => {
        const { options, reading } = get();
        if (reading && reading.step > 0) await adopt(options, stepsOf(reading.step));
      }),
    /** What keeps it from being a whole surface. @param {Partial<RepairOptions>} [wanted] */
    repair: (wanted = {}) =>
      change(async () => {
        const loaded = await long("repair", () => solver.repair(wanted));
        if (loaded.repaired.length > 0) {
          const free = loaded.free ? [...loaded.free] : null;
          const fixed = loaded.fixed ? [...loaded.fixed] : null;
          await edited(loaded, say("edit-repair"), { ...get().options, free, fixed });
        }
        core.showRepairs(loaded);
      }),
    /** Other triangles of the same surface. @param {Partial<RemeshOptions>} wanted */
    remesh: (wanted) =>
      change(async () => {
        const { outcome, loaded } = await long("remesh", () => solver.remesh(wanted));
        const free = loaded.free ? [...loaded.free] : null;
        const fixed = loaded.fixed ? [...loaded.fixed] : null;
        await edited(loaded, say("edit-remesh"), { ...get().options, free, fixed });
        const { before, after } = outcome;
        notes.answer(
          say("remeshed", {
            vertices: after.vertices,
            angle: before.minAngleDegrees,
            angleNow: after.minAngleDegrees,
          }),
        );
      }),
    /** Divides each triangle into four. @param {"linear" | "loop"} scheme */
    subdivide: (scheme) =>
      change(async () => {
        const loaded = await solver.subdivide(scheme);
        // What was held or free, on the finer mesh.
        const free = loaded.free ? [...loaded.free] : null;
        const fixed = loaded.fixed ? [...loaded.fixed] : null;
        await edited(loaded, say("edit-subdivision"), { ...get().options, free, fixed });
        notes.answer(say("subdivided", { count: loaded.info.faces }));
      }),
    /** Takes the last edit back: the run stands where it stood. */
    undo: () =>
      change(async () => {
        const { earlier } = get();
        const last = earlier.at(-1);
        if (!last) return;
        anew();
        const loaded = await solver.undo();
        patch({ source: last.source, mesh: loaded, earlier: earlier.slice(0, -1), mode: null });
        patch({ options: last.options, preview: null });
        anew();
        await core.refill();
        await core.followRivals();
        if (get().colour !== "none") await core.colour(get().colour);
      }),
    /** Fills holes, or connects loops; a flow on the new vertices is ready then. @param {Partial<FillOptions>} wanted */
    fill: (wanted) =>
      change(async () => {
        const { options } = get();
        const { outcome: filled, loaded } = await long("fill", () => solver.fill(wanted));
        const count = filled.filled.length;
        const flow = fairs(options.flow) ? options.flow : "mmcv";
        const free = loaded.free ? [...loaded.free] : null;
        const fair = { ...options, ...toFlow(flow), fixed: null, prefill: false, free };
        await edited(loaded, say("count-fills", { count }), fair);
        for (const warning of filled.warnings) notes.note(say(warning), warning.id);
        notes.answer(say("filled", { count, vertices: filled.newVertices }));
      }),
    /** Frees these vertices and holds the others; the surface as it is becomes the start. @param {number[] | null} free */
    select: (free) =>
      change(async () => {
        const { options, reading } = get();
        const wanted = { ...options, free, fixed: null };
        if (reading && reading.step > 0) await adopt(wanted, stepsOf(reading.step));
        else await core.configure(wanted);
      }),
    /** @param {number[]} centre  from the middle of the surface's box, in diagonals of it */
    invert: (centre) =>
      change(async () => {
        const { outcome: report, loaded } = await solver.invert(centre);
        await edited(loaded, say("edit-inversion"));
        notes.answer(
          say("inverted", { change: Math.abs(report.after.circle - report.before.circle) }),
        );
      }),
    /** Shows the surface inverted. @param {number[]} centre @returns {Promise<void>} refusals are the caller's */
    async preview(centre) {
      const asked = get().reading;
      const preview = await solver.previewInversion(centre);
      // A step meanwhile is the newer picture.
      if (get().reading === asked && get().mode === "invert") patch({ preview });
    },

    /** What a click or a drag on the surface does. @param {Mode | null} mode */
    mode(mode) {
      patch({ mode, preview: null, marks: null });
      if (mode) core.player.motion.peek() !== "still" && enqueue(rest);
    },
    /** @param {Marks | null} marks */
    mark: (marks) => patch({ marks }),
    /** @param {Partial<LookOptions>} change */
    inspect: (change) =>
      enqueue(async () => {
        const lookOptions = { ...get().lookOptions, ...change };
        if (!get().mesh) return;
        const look = await solver.look(lookOptions);
        const { extras } = get();
        patch({ lookOptions, extras: { curves: null, jump: null, ...extras, look } });
      }),
    // Questions that change nothing.
    loops: () => solver.loops(),
    selfIntersections: () => solver.selfIntersections(),
    conjecture: () => solver.conjecture(),
    /** @param {number[]} corners */
    quadrilateral: (corners) => solver.quadrilateral(corners),
    /** @param {number} pairs */
    lab: (pairs) => solver.lab(pairs),
    /** @param {import("../library.js").Figure} figure */
    judge: ({ id }) => solver.judge(id),
    /** @param {string} format @param {number} every */
    sequenceSize: (format, every) => solver.sequenceSize(format, every),
    /** The stored steps as a ZIP of meshes. @param {string} format @param {number} every @returns {Promise<Uint8Array<ArrayBuffer> | null>} */
    async sequence(format, every) {
      /** @type {Uint8Array<ArrayBuffer> | null} */
      let zip = null;
      await change(async () => {
        zip = await long("sequence", () => solver.sequence(format, every));
      });
      return zip;
    },
  };
  return { adopt, edited, edit };
}
