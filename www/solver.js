// @ts-check
// The page's side of the worker: a promise for every request, events for the rest,
// and a new worker with the old scene in it when the old one is lost.

/** @import { Arrangement, BoundaryLoop, Configured, Conjecture, Diagnosis, Fault, Field, FieldName, Filled, FillOptions, Finding, FlowOptions, Frame, InversionReport, Inverted, Lab, Loaded, Look, Quadrilateral, RegulariseOptions, Regularised, SelfIntersections, State, StepReport, Story, Study, StudyOptions, Wanted } from "./protocol.js" */
/** @import { Recipe } from "./recipe.js" */

import { t } from "./language.js";
import { sayFault } from "./words.js";

/**
 * @typedef {object} Listener
 * @property {(version: string) => void} onReady
 * @property {(frame: Frame) => void} onFrame
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

/** @param {Listener} listener */
export function createSolver(listener) {
  /** @type {Worker | null} */
  let worker = null;
  let lastId = 0;
  let run = 0;
  /** @type {Map<number, { resolve: (ok: any) => void, reject: (fault: Fault) => void }>} */
  const waiting = new Map();
  // The scene, for a new worker: how the mesh was made, its options, and where it stands.
  /** @type {Record<string, unknown> | null} */
  let origin = null;
  /** Those of before the edits that can be undone. @type {(Record<string, unknown> | null)[]} */
  let origins = [];
  /** @type {FlowOptions} */
  let options = {};
  /** @type {FieldName} */
  let field = "none";
  /** @type {Arrangement | null} */
  let arrangement = null;
  /** @type {Wanted | null} */
  let lookedAt = null;
  /** @type {{ positions: Float32Array, step: number, time: number } | null} */
  let last = null;

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

  /** @param {Frame} frame */
  function take(frame) {
    const { step, time } = frame.state;
    options = frame.flow?.options ?? options;
    last = { positions: frame.positions, step, time };
    listener.onFrame(frame);
    // Only when the page has had its turn to draw may the next one come.
    requestAnimationFrame(() => worker?.postMessage({ id: 0, type: "ack", run: frame.run }));
  }

  /** @param {string} type @param {Record<string, unknown>} [fields] @returns {Promise<any>} */
  function ask(type, fields = {}) {
    lastId += 1;
    const id = lastId;
    worker ??= start();
    const asked = worker;
    return new Promise((resolve, reject) => {
      waiting.set(id, { resolve, reject });
      asked.postMessage({ id, type, ...fields });
    });
  }

  /** @param {string} type @param {Record<string, unknown>} fields @returns {Promise<Loaded>} */
  async function make(type, fields) {
    const loaded = await ask(type, fields);
    origin = { type, ...fields };
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
    const loaded = await ask(type, fields);
    await keep(loaded);
    return loaded;
  }

  /** @param {Loaded} loaded */
  async function keep(loaded) {
    const bytes = await ask("export", { format: "ply" });
    origins.push(origin);
    origin = { type: "load", name: `${loaded.name}.ply`, bytes: bytes.buffer };
    last = null;
  }

  /** @param {string} type @param {Record<string, unknown>} [fields] @returns {Promise<any>} */
  function move(type, fields) {
    run += 1;
    return ask(type, { ...fields, run });
  }

  return {
    dismiss,
    /** Starts the worker, if nothing has been asked of it yet. */
    begin() {
      worker ??= start();
    },
    /** @param {string} name @param {ArrayBuffer} bytes  kept, so that a lost worker can be replaced */
    load: (name, bytes) => make("load", { name, bytes }),
    /** What the mesh was read from, if it was. @returns {ArrayBuffer | null} */
    file: () => /** @type {ArrayBuffer | undefined} */ (origin?.bytes) ?? null,
    /** @param {string} name @param {Record<string, number>} parameters */
    sample: (name, parameters) => make("sample", { name, parameters }),
    /** How the mesh was made, so that another solver can make the same. */
    origin: () => origin,
    /** @param {Record<string, unknown>} of  another solver's `origin` */
    same: ({ type, ...fields }) => make(/** @type {string} */ (type), fields),
    /** @param {FlowOptions} wanted @returns {Promise<Configured>} */
    async configure(wanted) {
      const configured = await move("configure", { options: wanted });
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
      const answer = await ask("colour", { field: name });
      field = name;
      return answer;
    },
    /** @param {number | null} until  the step to pause at */
    run: (until) => /** @type {Promise<true>} */ (move("run", { until })),
    /** @returns {Promise<State>} */
    pause: () => ask("pause"),
    /** @returns {Promise<StepReport | null>} */
    step: () => move("step"),
    /** @param {RegulariseOptions} wanted @returns {Promise<Regularised>} */
    regularise: (wanted) => move("regularise", { options: wanted }),
    /** @param {Arrangement} wanted @returns {Promise<State>} */
    async arrange(wanted) {
      const state = await ask("arrange", { arrangement: wanted });
      arrangement = wanted;
      return state;
    },
    /** Makes the surface as it is the start. */
    adopt: () => edit("adopt"),
    /** Takes the last edit back. @returns {Promise<Loaded>} */
    async undo() {
      // Its frame tells where that run had come to.
      last = null;
      const loaded = await move("undo", {});
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
    /** @param {StudyOptions | null} options  null for the next resolution @returns {Promise<Study>} */
    study: (options) => ask("study", { options }),
    /** @returns {Promise<BoundaryLoop[]>} */
    loops: () => ask("loops"),
    /**
     * Fills holes, or connects loops.
     * @param {FillOptions} wanted
     * @returns {Promise<{ filled: Filled, loaded: Loaded }>}
     */
    async fill(wanted) {
      const answer = await move("fill", { options: wanted });
      await keep(answer.loaded);
      return answer;
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
      const answer = await ask("invert", { centre });
      await keep(answer.loaded);
      return answer;
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
    story: () => ask("story"),
    /** @param {Pick<Recipe, "mesh" | "edits">} recipe @param {ArrayBuffer | null} bytes  of its mesh */
    prepare: (recipe, bytes) => make("prepare", { recipe, bytes }),
    /** @param {Pick<Recipe, "flow" | "steps" | "path">} recipe @returns {Promise<State>} */
    follow: (recipe) => move("follow", { recipe }),
    /** @param {string} format @param {number} every @returns {Promise<Uint8Array<ArrayBuffer>>} ZIP */
    sequence: (format, every) => ask("sequence", { format, every }),
    /** @param {string} format @param {number} every @returns {Promise<{ meshes: number, bytes: number }>} */
    sequenceSize: (format, every) => ask("sequenceSize", { format, every }),
    /** @param {string} format @returns {Promise<Uint8Array<ArrayBuffer>>} */
    export: (format) => ask("export", { format }),
    /** @returns {Promise<string>} CSV */
    history: () => ask("history"),
    /** @returns {Promise<number>} ∫H² dA of the surface as it is */
    bending: () => ask("bending"),

    /**
     * After `dismiss` or a crash: a new worker with the mesh, options and positions of
     * the last frame.
     * @returns {Promise<State | null>} where the new session stands; null when there was no mesh
     */
    async revive() {
      if (!origin) return null;
      origins = [];
      const { type, ...fields } = origin;
      await ask(/** @type {string} */ (type), fields);
      // As part of no run: its frame, of the start, must not be taken for the last one.
      await ask("configure", { options, run: 0 });
      if (field !== "none") await ask("colour", { field });
      if (arrangement) await ask("arrange", { arrangement });
      if (lookedAt) await ask("look", { wanted: lookedAt });
      return last && last.step > 0 ? move("restore", last) : move("reset");
    },
  };
}

/** @typedef {ReturnType<typeof createSolver>} Solver */
