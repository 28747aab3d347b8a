// @ts-check
// The page's side of the worker: a promise for every request, events for the rest,
// and a new worker with the old scene in it when the old one is lost.

/** @import { Arrangement, FlowOptions } from "./generated/schema.js" */
/** @import { LoopInfo as BoundaryLoop, Configured, ConjectureReport as Conjecture, Diagnosis, FillOutcome as Filled, FillOptions, InversionReport, Inverted, LabReport as Lab, Loaded, Look, QuadReport as Quadrilateral, RegulariseOptions, Regularised, SelfIntersections, State, StepReport, Recipe as Story, StudyReport as Study, StudyOptions, Wanted } from "./generated/types.js" */
/** @import { Finding } from "./library.js" */
/** @import { Field, FieldName } from "./state.js" */
/** @import { Fault } from "./words.js" */
/** @import { Recipe } from "./recipe.js" */
/** @import { Frame } from "./generated/types.js" */

import { t } from "./language.js";
import { sayFault } from "./words.js";

/**
 * @typedef {object} Listener
 * @property {(version: string) => void} onReady
 * @property {(frame: Frame & { run: number }) => void} onFrame
 * @property {(state: State, fault: Fault | null) => void} onStopped  with the fault of a step that failed
 * @property {(progress: { stage: string, fraction: number }) => void} onProgress
 * @property {(reason: string) => void} onCrashed  the worker is gone; `revive` brings the scene back
 */

/** What every request is answered with that a lost worker can no longer answer. */
export const LOST = "SolverLost";

/** @returns {Worker} @throws {Fault} */
function begun() {
  try {
    return new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
  } catch (error) {
    throw {
      kind: "NoWorker",
      message: t("The solver may not be started here: {reason}", {
        reason: /** @type {Error} */ (error).message,
      }),
      hint: t(
        "If this page is in a frame with `sandbox`, that needs `allow-same-origin` beside `allow-scripts`.",
      ),
      detail: {},
    };
  }
}

/**
 * The end of a run; `fault` where a step was refused.
 * @typedef {{ run: number, state: State, fault: Fault | null }} Stopped
 */
/** How a mesh is made: a command. @typedef {{ name: string, fields: any }} Origin */

/** @param {Listener} listener */
export function createSolver(listener) {
  /** @type {Worker | null} */
  let worker = null;
  let lastId = 0;
  let run = 0;
  /** @type {Map<number, { resolve: (ok: any) => void, reject: (fault: Fault) => void }>} */
  const waiting = new Map();
  // The scene, for a new worker: how the mesh was made, its options, and where it stands.
  /** @type {Origin | null} */
  let origin = null;
  /** Those of before the edits that can be undone. @type {(Origin | null)[]} */
  let origins = [];
  /** @type {FlowOptions} */
  let options = {};
  /** @type {FieldName} */
  let field = "none";
  /** @type {Arrangement | null} */
  let arrangement = null;
  /** @type {Wanted | null} */
  let lookedAt = null;
  /** @type {Frame | null} */
  let last = null;
  /** Whether a flow was chosen for the mesh: before, there is nothing to see. */
  let isConfigured = false;

  /** @param {string} reason */
  function lost(reason) {
    dismiss();
    listener.onCrashed(reason);
  }

  /** @throws {Fault} where the page may start none */
  function start() {
    const started = begun();
    started.onmessage = ({ data }) => started === worker && receive(data);
    started.onerror = (event) => {
      if (started === worker) lost(event.message || t("it could not be loaded"));
    };
    return started;
  }

  /** Ends the worker; whoever waits for it learns so. The next request starts another. */
  function dismiss() {
    worker?.terminate();
    worker = null;
    run += 1;
    /** @type {Fault} */
    const fault = { kind: LOST, message: "The solver was stopped.", hint: "", detail: {} };
    for (const { reject } of waiting.values()) reject(fault);
    waiting.clear();
  }

  /** @param {any} message  a `Reply` or an `Event` of the protocol */
  function receive(message) {
    if ("id" in message) {
      const request = waiting.get(message.id);
      waiting.delete(message.id);
      if (message.error) request?.reject(sayFault(message.error));
      else request?.resolve(message.ok);
    } else if (message.type === "ready") listener.onReady(message.version);
    else if (message.type === "crashed") lost(message.message);
    else if (message.type === "progress") listener.onProgress(message);
    else if (message.run !== run) return;
    else if (message.type === "frame") take(message);
    else if (message.type === "stopped") {
      const { state, fault } = message;
      listener.onStopped(state, fault && sayFault(fault));
    }
  }

  /** @param {Frame & { run: number }} frame */
  function take(frame) {
    options = frame.flow?.options ?? options;
    last = frame;
    listener.onFrame(frame);
    // Only when the page has had its turn to draw may the next one come.
    requestAnimationFrame(() => worker?.postMessage({ ack: frame.run }));
  }

  /**
   * @param {string} name  a command of the session, or what the worker itself can do
   * @param {Record<string, unknown>} [fields]
   * @param {{ run?: number, shown?: boolean }} [way]  see the worker's `Request`
   * @returns {Promise<any>}
   */
  function ask(name, fields = {}, way = {}) {
    lastId += 1;
    const id = lastId;
    worker ??= start();
    const asked = worker;
    return new Promise((resolve, reject) => {
      waiting.set(id, { resolve, reject });
      asked.postMessage({ id, name, fields, ...way });
    });
  }

  /** Ends the run at hand. @param {string} name @param {Record<string, unknown>} [fields] @returns {Promise<any>} */
  function stop(name, fields) {
    run += 1;
    return ask(name, fields, { run });
  }

  /** @param {string} name @param {Record<string, unknown>} fields @returns {Promise<Loaded>} */
  async function make(name, fields) {
    const loaded = await stop(name, fields);
    isConfigured = false;
    origin = { name, fields };
    origins = [];
    last = null;
    return loaded;
  }

  /**
   * A mesh made of the one at hand: for a new worker it is a file of its own.
   * @param {"adopt" | "subdivide"} type
   * @param {Record<string, unknown>} [fields]
   * @returns {Promise<Loaded>}
   */
  async function edit(type, fields) {
    const loaded = await stop(type, fields);
    await keep(loaded);
    return loaded;
  }

  /** @param {Loaded} loaded */
  async function keep(loaded) {
    const bytes = await ask("export", { format: "ply" });
    origins.push(origin);
    isConfigured = false;
    origin = { name: "load", fields: { name: `${loaded.name}.ply`, bytes } };
    last = null;
  }

  /** The same, and what comes of it is shown. @param {string} name @param {Record<string, unknown>} [fields] @returns {Promise<any>} */
  function move(name, fields) {
    run += 1;
    return ask(name, fields, { run, shown: true });
  }

  return {
    dismiss,
    /** Starts the worker, if nothing has been asked of it yet. */
    begin() {
      worker ??= start();
    },
    /**
     * Options of a link or a recipe with their types, or the refusal of one.
     * @param {import("./link.js").Asked} asked @returns {Promise<import("./link.js").Given>}
     */
    readOptions: (asked) => ask("readOptions", { asked }),
    /** @param {string} name @param {Uint8Array<ArrayBuffer>} bytes  kept, so that a lost worker can be replaced */
    load: (name, bytes) => make("load", { name, bytes }),
    /** What the mesh was read from, if it was. @returns {Uint8Array<ArrayBuffer> | null} */
    file: () => origin?.fields.bytes ?? null,
    /** @param {string} name @param {Record<string, number>} parameters */
    sample: (name, parameters) => make("sample", { name, parameters }),
    /** How the mesh was made, so that another solver can make the same. */
    origin: () => origin,
    /** @param {Origin} of  another solver's `origin` */
    same: ({ name, fields }) => make(name, fields),
    /** @param {FlowOptions} wanted @returns {Promise<Configured>} */
    async configure(wanted) {
      const configured = await move("configure", { options: wanted });
      isConfigured = true;
      options = wanted;
      return configured;
    },
    /** From the surface as it is. @param {FlowOptions} wanted @returns {Promise<Configured>} */
    async continueWith(wanted) {
      const configured = await move("continueWith", { options: wanted });
      options = wanted;
      return configured;
    },
    /** @param {FieldName} name @returns {Promise<Field | null>} */
    async colour(name) {
      const shown = (last?.panes.length ?? 0) > 0;
      const answer = await ask("colour", { field: name }, { shown });
      field = name;
      return answer;
    },
    /** @param {number | null} until  the step to pause at */
    run: (until) => /** @type {Promise<true>} */ (stop("run", { until })),
    /** @returns {Promise<State>} */
    pause: () => ask("pause"),
    /** @returns {Promise<StepReport | null>} */
    step: () => move("step"),
    /** @param {Partial<RegulariseOptions>} wanted @returns {Promise<Regularised>} */
    regularise: (wanted) => move("regularise", { options: wanted }),
    /** @param {Arrangement} wanted @returns {Promise<State>} */
    async arrange(wanted) {
      const state = await ask("arrange", { arrangement: wanted }, { shown: isConfigured });
      arrangement = wanted;
      return state;
    },
    /** Makes the surface as it is the start. */
    adopt: () => edit("adopt"),
    /** Takes the last edit back. @returns {Promise<Loaded>} */
    async undo() {
      // Its frame tells where that run had come to.
      last = null;
      const loaded = await move("undo");
      isConfigured = true;
      origin = origins.pop() ?? origin;
      return loaded;
    },
    /** Divides each triangle into four. @param {"linear" | "loop"} scheme */
    subdivide: (scheme) => edit("subdivide", { options: { scheme } }),
    /** @returns {Promise<SelfIntersections | null>} */
    selfIntersections: () => ask("selfIntersections"),
    /** @returns {Promise<Diagnosis | null>} */
    why: () => ask("why"),
    /** @param {string} figure  its id @returns {Promise<Finding | null>} */
    judge: (figure) => ask("judge", { figure }),
    /** @param {Partial<StudyOptions> | null} options  null for the next resolution @returns {Promise<Study>} */
    study: (options) => ask("study", { options }),
    /** @returns {Promise<BoundaryLoop[]>} */
    loops: () => ask("loops"),
    /**
     * Fills holes, or connects loops.
     * @param {Partial<FillOptions>} wanted
     * @returns {Promise<{ filled: Filled, loaded: Loaded }>}
     */
    async fill(wanted) {
      const filled = await stop("fill", { options: wanted });
      const loaded = await ask("loaded");
      await keep(loaded);
      return { filled, loaded };
    },
    /** @param {Wanted} wanted @returns {Promise<Look>} */
    async look(wanted) {
      const look = await ask("look", { wanted });
      lookedAt = wanted;
      return look;
    },
    /** @param {number[]} centre @returns {Promise<Inverted>} */
    previewInversion: (centre) => ask("previewInversion", { centre }),
    /** @param {number[]} centre @returns {Promise<{ report: InversionReport, loaded: Loaded }>} */
    async invert(centre) {
      const report = await stop("invert", { centre });
      const loaded = await ask("loaded");
      await keep(loaded);
      return { report, loaded };
    },
    /** @returns {Promise<Conjecture>} */
    conjecture: () => ask("conjecture"),
    /** @param {number[]} corners @returns {Promise<Quadrilateral>} */
    quadrilateral: (corners) => ask("quadrilateral", { corners }),
    /** @param {number} pairs @returns {Promise<Lab>} */
    lab: (pairs) => ask("lab", { pairs }),
    /** @returns {Promise<State>} */
    back: () => move("back"),
    /** @returns {Promise<State>} */
    reset: () => move("reset"),
    /** Shows a stored step. @param {number} step @returns {Promise<State>} */
    seek: (step) => move("seek", { step }),
    /** @param {number} branch @returns {Promise<State>} */
    branch: (branch) => move("branch", { branch }),
    /** @returns {Promise<{ story: Story, state: State, positions: Float32Array<ArrayBuffer> }>} */
    async story() {
      const [story, state] = [await ask("recipe"), await ask("state")];
      return {
        story,
        state,
        positions: /** @type {Float32Array<ArrayBuffer>} */ (last?.positions),
      };
    },
    /** @param {Pick<Recipe, "mesh" | "edits">} recipe @param {Uint8Array<ArrayBuffer> | null} bytes  of its mesh */
    prepare: (recipe, bytes) => make("prepare", { recipe, bytes }),
    /** @param {Pick<Recipe, "flow" | "steps" | "path">} recipe @returns {Promise<State>} */
    async follow(recipe) {
      const state = await move("follow", { recipe });
      isConfigured = true;
      return state;
    },
    /** @param {string} format @param {number} every @returns {Promise<Uint8Array<ArrayBuffer>>} ZIP */
    sequence: (format, every) => ask("sequence", { format, every }),
    /** @param {string} format @param {number} every @returns {Promise<{ meshes: number, bytes: number }>} */
    sequenceSize: (format, every) => ask("sequenceSize", { format, every }),
    /** @param {string} format @returns {Promise<Uint8Array<ArrayBuffer>>} */
    export: (format) => ask("export", { format }),
    /** @returns {Promise<string>} CSV */
    history: () => ask("history"),
    /** @returns {Promise<number>} ∫H² dA of the surface as it is */
    bending: async () => (await ask("energy")).willmore,

    /**
     * After `dismiss` or a crash: a new worker with the mesh, options and positions of
     * the last frame.
     * @returns {Promise<State | null>} where the new session stands; null when there was no mesh
     */
    async revive() {
      if (!origin) return null;
      origins = [];
      await ask(origin.name, origin.fields);
      await ask("configure", { options });
      if (field !== "none") await ask("colour", { field });
      if (arrangement) await ask("arrange", { arrangement });
      if (lookedAt) await ask("look", { wanted: lookedAt });
      if (!last || last.state.step === 0) return move("reset");
      const { exact, state } = last;
      return move("restore", { exact, step: state.step, time: state.time });
    },
  };
}

/** @typedef {ReturnType<typeof createSolver>} Solver */
