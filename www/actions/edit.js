// What makes another mesh of the one at hand, and the way back; what is looked at more closely.

import { flowLabel, flowOf, toFlow } from "../options.js";
import { withSelection } from "../solver.js";
import { sceneTitle } from "../status.js";
import { earlierOf } from "../store.js";
import { say } from "../words.js";
import { stepsOf } from "./run.js";

/** @import { FillOptions, Loaded, RemeshOptions, RepairOptions, LookOptions } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { Mode } from "../store.js" */
/** @import { Core } from "./core.js" */

/** Edits that the session keeps to be undone. */
const MOST_EDITS = 8;

/** @param {Core} core */
export function createEdit(core) {
  const { get, patch, notes, solver, enqueue, rest, anew } = core;

  /** Those in force, with what is held or free on another mesh. @param {Loaded} loaded @returns {Options} */
  const kept = (loaded) => withSelection({ ...get().options, free: null, fixed: null }, loaded);

  /**
   * Goes on with a mesh that the solver has made of the one at hand.
   * @param {Loaded} loaded @param {string} what  undoing takes back @param {Options} options
   */
  async function edited(loaded, what, options) {
    const { mesh, earlier: all, source } = get();
    if (!mesh) return;
    const name = sceneTitle(source) || mesh.name;
    const earlier = [...all, ...earlierOf(get(), what)].slice(-MOST_EDITS);
    // No sample any more, nor what a figure shows, and no file either: a link to it can only name it.
    patch({ source: { kind: "file", name }, mesh: loaded, earlier, mode: null });
    patch({ figure: null });
    patch({ preview: null, reading: null, configured: null, isNew: false });
    anew();
    await core.configure(options);
    if (get().colour !== "none") await core.colour(get().colour);
  }

  /** @param {Options} options @param {string} what */
  const adopt = async (options, what) => edited((await solver.adopt()).loaded, what, options);

  /** Other options on the surface as it is, which becomes the start. @param {Options} options */
  async function restart(options) {
    const { reading } = get();
    if (reading && reading.step !== 0) await adopt(options, stepsOf(Math.abs(reading.step)));
    else await core.configure(options);
  }

  /** @template T @param {string} stage @param {() => Promise<T>} ask */
  const long = (stage, ask) => core.during(stage, () => core.stoppable(ask));

  /**
   * What the solver makes of the mesh at hand.
   * @template {"repair" | "remesh" | "fill"} N @param {N} name @param {object} options
   */
  const made = (name, options) =>
    long(name, () => solver.edit(name, /** @type {any} */ ({ options })));

  /** All flips that gain anything, at once. */
  async function flipAll() {
    const { arrangement } = get();
    await solver.ask("arrange", { arrangement: { ...arrangement, flipsPerStep: null } });
    await long("flips", () => solver.ask("step"));
    await solver.ask("arrange", { arrangement });
  }

  const edits = {
    /** Regularises the mesh as it is; a step back undoes it. */
    async regularise() {
      const { regulariseEpsilon: epsilon } = get().options;
      const outcome = await long("regularise", () =>
        solver.ask("regularise", { options: { epsilon } }),
      );
      const { passes, before, after, distance, pinned } = outcome;
      if (passes === 0) return notes.answer(say("regular-already", { pinned }));
      notes.answer(
        say("regularised", {
          ...{ passes, angle: before.minAngleDegrees, angleNow: after.minAngleDegrees },
          ...{ distortion: before.distortion, distortionNow: after.distortion },
          distance: 100 * distance,
        }),
      );
    },
    finish: flipAll,
    /** Makes the surface as it is the start of what comes. */
    async adopt() {
      const { options, reading } = get();
      if (reading && reading.step !== 0) await adopt(options, stepsOf(Math.abs(reading.step)));
    },
    /** What keeps it from being a whole surface. @param {Partial<RepairOptions>} [wanted] */
    async repair(wanted = {}) {
      const { loaded } = await made("repair", wanted);
      if (loaded.repaired.length > 0) await edited(loaded, say("edit-repair"), kept(loaded));
      core.showRepairs(loaded);
    },
    /** Other triangles of the same surface. @param {Partial<RemeshOptions>} wanted */
    async remesh(wanted) {
      const { outcome, loaded } = await made("remesh", wanted);
      await edited(loaded, say("edit-remesh"), kept(loaded));
      const { before, after } = outcome;
      const [angle, angleNow] = [before.minAngleDegrees, after.minAngleDegrees];
      notes.answer(say("remeshed", { vertices: after.vertices, angle, angleNow }));
    },
    /** Divides each triangle into four. @param {"linear" | "loop"} scheme */
    async subdivide(scheme) {
      const { loaded } = await core.stoppable(() =>
        solver.edit("subdivide", { options: { scheme } }),
      );
      await edited(loaded, say("edit-subdivision"), kept(loaded));
      notes.answer(say("subdivided", { count: loaded.info.faces }));
    },
    /** Takes the last edit back: the run stands where it stood. */
    async undo() {
      const { earlier } = get();
      const last = earlier.at(-1);
      if (!last) return;
      anew();
      const mesh = await solver.undo();
      const { what: _, film, ...before } = last;
      patch({ ...before, mesh, earlier: earlier.slice(0, -1), mode: null, preview: null });
      anew();
      patch({ film });
      await core.refill();
      await core.beside.follow();
      if (get().colour !== "none") await core.colour(get().colour);
    },
    /** Fills holes, or connects loops; a flow on the new vertices is ready then. @param {Partial<FillOptions>} wanted */
    async fill(wanted) {
      const { outcome: filled, loaded } = await made("fill", wanted);
      const count = filled.filled.length;
      const { flow } = get().options;
      // Flows that a new patch is left to.
      const fairs = flowOf(flow).family === "curvature";
      // A flat side is to stay flat.
      const isSide = filled.warnings.some(({ values }) => values.cause === "side");
      const next = isSide ? "mean-curvature" : fairs ? flow : "mmcv";
      const change = { ...toFlow(next), fixed: null, prefill: false };
      const fair = { ...kept(loaded), ...change, free: kept(loaded).free };
      await edited(loaded, say("count-fills", { count }), fair);
      for (const warning of filled.warnings) notes.note(say(warning), warning.id);
      notes.answer(say("filled", { count, vertices: filled.newVertices, flow: flowLabel(next) }));
    },
    /** Frees these vertices and holds the others; the surface as it is becomes the start. @param {number[] | null} free */
    select: (free) => restart({ ...get().options, free, fixed: null }),
    /** @param {number[]} centre  from the middle of the surface's box, in diagonals of it */
    async invert(centre) {
      const { outcome: report, loaded } = await core.stoppable(() =>
        solver.edit("invert", { centre }),
      );
      await edited(loaded, say("edit-inversion"), get().options);
      const { before, after } = report;
      notes.answer(say("inverted", { change: Math.abs(after.circle - before.circle) }));
    },
    /** The stored steps as a ZIP of meshes. @param {string} format @param {number} every */
    sequence: (format, every) =>
      core.during("sequence", () => solver.ask("sequence", { format, every })),
  };

  const edit = {
    ...core.atRest(edits, () => get().mesh !== null),
    /** Shows the surface inverted. @param {number[]} centre @returns {Promise<void>} refusals are the caller's */
    async preview(centre) {
      const asked = get().reading;
      const preview = await solver.ask("previewInversion", { centre });
      // A step meanwhile is the newer picture.
      if (get().reading === asked && get().mode === "invert") patch({ preview });
    },

    /** What a click or a drag on the surface does. @param {Mode | null} mode */
    mode(mode) {
      patch({ mode, preview: null, marks: null });
      if (mode && !core.isStill()) enqueue(rest);
    },
    /** @param {Partial<LookOptions>} change */
    inspect: (change) =>
      enqueue(async () => {
        if (!get().mesh) return;
        const lookOptions = { ...get().lookOptions, ...change };
        const look = await solver.ask("look", { options: lookOptions });
        const extras = get().extras ?? { curves: null, jump: null };
        patch({ lookOptions, extras: { ...extras, look } });
      }),
  };
  return { adopt, restart, flipAll, edit };
}
