// @ts-check
// What may be asked of the solver, and the scene that it has: where its worker is lost, a new one
// is given that scene before it is asked for anything else.

/** @import { Arrangement, FlowOptions } from "./generated/schema.js" */
/** @import { LoopInfo as BoundaryLoop, Configured, ConjectureReport as Conjecture, Diagnosis, FillOutcome as Filled, FillOptions, Frame, InversionReport, Inverted, LabReport as Lab, LinkCheck, LinkScene, Loaded, Look, Message, Origin as MeshOrigin, PageScene, QuadReport as Quadrilateral, RecipeCard, RegulariseOptions, Regularised, RemeshOptions, RemeshOutcome, RepairOptions, ScriptText, SelfIntersections, State, StepReport, StudyReport as Study, StudyOptions, LookOptions, WrittenLink } from "./generated/types.js" */
/** @import { Finding } from "./library.js" */
/** @import { Field, FieldName } from "./store.js" */
/** @import { Fault } from "./words.js" */

import { createChannel, LOST } from "./channel.js";
import { plyOf } from "./ply.js";
import { say, sayFault } from "./words.js";

/**
 * @typedef {object} Listener
 * @property {(version: string) => void} onReady
 * @property {(frame: Frame & { run: number, stored: boolean }) => void} onFrame  `stored`: one of the path, and not where it stands
 * @property {(state: State, fault: Fault | null) => void} onStopped  with the fault of a step that failed
 * @property {(progress: { stage: string, fraction: number }) => void} onProgress
 * @property {(reason: string) => void} onCrashed  the worker is gone; `revive` brings the scene back
 * @property {(isSilent: boolean) => void} onSilent  whether it owes an answer and gives no sign of life
 */

/**
 * How a mesh is made: a command. One that was edited is a file, which knows no selection.
 * @typedef {{ name: string, fields: any, isEdited?: boolean }} Origin
 */

/** What is refused because something else was asked for meanwhile. */
export const CANCELLED = "Cancelled";

/**
 * What a new worker is given, and what the page has of the surface by itself.
 * @typedef {object} Shown
 * @property {Origin | null} origin
 * @property {Loaded | null} loaded     what that gave
 * @property {boolean} isConfigured     whether a flow was chosen for the mesh: before, there is nothing to see
 * @property {FlowOptions} options
 * @property {FieldName} field
 * @property {Arrangement | null} arrangement
 * @property {LookOptions | null} lookOptions  what is looked at more closely
 * @property {Frame | null} last
 */

/** How often in a row the scene is given to a new worker that is lost meanwhile. */
const ATTEMPTS = 6;
/** Milliseconds before the second attempt, doubled for each further one: memory may be freed. */
const PAUSE = 50;

/** Ends the run at hand, and what comes of it is shown. */
const MOVE = { ends: true, shown: true };

/**
 * Options with the selection that a mesh brings along: a file made of it knows none.
 * @template {FlowOptions} Options
 * @param {Options} options @param {Pick<Loaded, "free" | "fixed"> | null} mesh
 * @returns {Options}
 */
export function withSelection(options, mesh) {
  if (options.free || options.fixed) return options;
  const list = (/** @type {Uint32Array | null | undefined} */ some) => (some ? [...some] : null);
  return { ...options, free: list(mesh?.free), fixed: list(mesh?.fixed) };
}

/** Who does not want to know. @type {Listener} */
const deaf = {
  ...{ onReady() {}, onFrame() {}, onStopped() {}, onProgress() {}, onCrashed() {}, onSilent() {} },
};

/**
 * @param {Partial<Listener>} told
 * @param {{ patience?: number, pause?: number }} [waits]  in milliseconds: for a sign of life, and
 *   between attempts to bring the scene back
 */
export function createSolver(told, { patience, pause = PAUSE } = {}) {
  const listener = { ...deaf, ...told };
  const { onSilent } = listener;
  const channel = createChannel({ onEvent, onLost, onSilent }, patience);
  let run = 0;
  /** @type {Shown} */
  let scene = {
    ...{ origin: null, loaded: null, isConfigured: false, options: {}, field: "none" },
    ...{ arrangement: null, lookOptions: null, last: null },
  };
  /** Those of before the edits that can be undone. @type {Pick<Shown, "origin" | "loaded">[]} */
  let origins = [];
  /** Whether the worker has the scene: a new one has not. */
  let isWhole = true;
  /**
   * Of a film of two halves: the figure, whether the half at hand is the one that is shown backwards,
   * and how far each has come. Steps of that half are negative: they count from where both begin.
   * @type {{ figure: string, isBack: boolean, back: number, forth: number } | null}
   */
  let film = null;
  /** The scene on its way to a new worker. @type {Promise<State | null> | null} */
  let revival = null;

  /** @template {State} T @param {T} state @returns {T} */
  const signed = (state) => (film?.isBack ? { ...state, step: -state.step } : state);

  /** A frame of a film, with the steps that the whole of it has. @param {Frame} frame */
  function inFilm(frame) {
    if (!film) return frame;
    film[film.isBack ? "back" : "forth"] = frame.timeline.last;
    const state = signed(frame.state);
    const { back, forth: last } = film;
    const timeline = { ...frame.timeline, start: -back, first: -back, last, at: state.step };
    return { ...frame, state, timeline };
  }

  /** Goes over to a half. @param {boolean} isBack */
  async function turn(isBack) {
    if (!film || film.isBack === isBack) return;
    await ask("turn", { figure: film.figure }, { ends: true });
    film.isBack = isBack;
  }

  /** @param {any} message */
  function onEvent(message) {
    if (message.type === "ready") listener.onReady(message.version);
    else if (message.type === "progress") listener.onProgress(message);
    else if (message.run !== run) return;
    else if (message.type === "frame") {
      scene.options = message.flow?.options ?? scene.options;
      if (!message.stored) scene.last = message;
      // Both halves begin at one place, which is that of the second.
      if (!film?.isBack || message.state.step > 0) {
        const { run: _, stored } = message;
        listener.onFrame({ ...inFilm(message), run, stored });
      }
      channel.acknowledge(message.run);
    } else if (message.type === "stopped") {
      listener.onStopped(signed(message.state), message.fault && sayFault(message.fault));
    }
  }

  function drop() {
    run += 1;
    isWhole = scene.origin === null;
    // A new worker begins with the second half.
    if (film?.isBack) scene.last = null;
    film = null;
    channel.dismiss();
  }

  /** @param {string} reason */
  function onLost(reason) {
    drop();
    // On the way back there is another attempt.
    if (!revival) listener.onCrashed(reason);
  }

  /** Ends the worker; whoever waits for it learns so. The next request starts another. */
  function dismiss() {
    revival = null;
    drop();
  }

  /**
   * @param {string} name  a command of the session, or what the worker itself can do
   * @param {Record<string, unknown>} [fields]
   * @param {{ ends?: boolean, shown?: boolean }} [way]  whether it ends the run at hand; whether a
   *   frame follows the answer
   * @returns {Promise<any>}
   */
  function send(name, fields = {}, { ends = false, shown = false } = {}) {
    if (ends) run += 1;
    return channel.ask({ name, fields, shown, ...(ends ? { run } : {}) });
  }

  /** The same of a worker that has the scene. @type {typeof send} */
  const ask = (...request) => (isWhole ? send(...request) : revive().then(() => send(...request)));

  /** @param {string} name @param {Record<string, unknown>} [fields] @returns {Promise<any>} */
  const move = (name, fields) => ask(name, fields, MOVE);

  /** Gives a new worker the scene. @returns {Promise<State | null>} */
  async function restore() {
    const { origin, loaded, isConfigured, options, field, arrangement, lookOptions, last } = scene;
    if (!origin) return null;
    const again = await send(origin.name, origin.fields, { ends: true });
    let state = null;
    if (isConfigured) {
      const chosen = origin.isEdited ? withSelection(options, loaded) : options;
      await send("configure", { options: chosen });
      if (field !== "none") await send("colour", { field });
      if (arrangement) await send("arrange", { arrangement });
      if (lookOptions) await send("look", { options: lookOptions });
      state = await place(last, loaded ?? again, again);
    }
    isWhole = true;
    return state;
  }

  /**
   * Puts the surface of the last frame in place, in full precision.
   * @param {Frame | null} frame
   * @param {Loaded} before  the mesh that the frame is of
   * @param {Loaded} now     the same, read again
   * @returns {Promise<State>}
   */
  async function place(frame, before, now) {
    const isStart =
      frame?.state.step === 0 &&
      !frame.triangles &&
      frame.positions.every((c, n) => c === now.positions[n]);
    if (!frame || isStart) return send("reset", {}, MOVE);
    // Far from the origin an edited mesh is read into a place of its own.
    const by = before.shift.map((c, n) => c - now.shift[n]);
    const exact = by.some(Boolean) ? frame.exact.map((c, n) => c + by[n % 3]) : frame.exact;
    const { triangles, state } = frame;
    return send("restore", { exact, triangles, step: state.step, time: state.time }, MOVE);
  }

  /**
   * After a crash, or `dismiss`: a new worker with the scene. Lost again on the way, it is tried
   * again.
   * @returns {Promise<State | null>} where the new session stands; null where there is nothing to see
   */
  function revive() {
    if (revival) return revival;
    /** Whether nobody has ended it. */
    const isWanted = () => revival === mine;
    async function attempt() {
      for (let n = 1; ; n += 1) {
        try {
          return await restore();
        } catch (error) {
          const { kind } = /** @type {Fault} */ (error);
          if (kind !== LOST || !isWanted()) throw error;
          if (n === ATTEMPTS) {
            const [message, hint] = [say("solver-lost-again"), say("solver-lost-again.hint")];
            throw { kind: "SolverLostAgain", message, hint, detail: {} };
          }
        }
        await new Promise((resolve) => setTimeout(resolve, pause * 2 ** n));
      }
    }
    const mine = Promise.resolve()
      .then(attempt)
      .finally(() => {
        if (isWanted()) revival = null;
      });
    revival = mine;
    return mine;
  }

  /** @param {string} name @param {Record<string, unknown>} fields @returns {Promise<Loaded>} */
  async function make(name, fields) {
    // The scene is not needed any more: but it must not come after.
    await revival?.catch(() => {});
    const loaded = await send(name, fields, { ends: true });
    isWhole = true;
    origins = [];
    begin(loaded, { name, fields });
    return loaded;
  }

  /** A mesh without a flow. @param {Loaded} loaded @param {Origin} origin */
  function begin(loaded, origin) {
    film = null;
    scene = { ...scene, origin, loaded, isConfigured: false, last: null };
  }

  /**
   * A mesh made of the one at hand: for a new worker it is a file of its own.
   * @param {string} name @param {Record<string, unknown>} [fields]
   * @returns {Promise<Loaded>}
   */
  async function edit(name, fields) {
    const loaded = await ask(name, fields, { ends: true });
    await keep(loaded);
    return loaded;
  }

  /** @param {Loaded} loaded */
  async function keep(loaded) {
    const bytes = await send("export", { format: "ply" });
    origins.push({ origin: scene.origin, loaded: scene.loaded });
    begin(loaded, { name: "load", fields: { name: `${loaded.name}.ply`, bytes }, isEdited: true });
  }

  /** The surface that is shown, of what the page has. @returns {Uint8Array<ArrayBuffer>} */
  function ownCopy() {
    const { loaded, last } = scene;
    if (!loaded) throw { kind: "NoMesh", message: say("no-mesh-yet"), hint: "", detail: {} };
    const triangles = last?.triangles ?? loaded.triangles;
    // Other triangles may be of other vertices.
    const colours = last?.triangles ? null : loaded.colours;
    return plyOf(last?.exact ?? loaded.positions, loaded.shift, triangles, colours);
  }

  return {
    dismiss,
    revive,
    /** Starts the worker, if nothing has been asked of it yet. @throws {Fault} where that may not be */
    begin: () => void channel.begin(),
    /** @param {{ text: string, isOwn: boolean }} link @returns {Promise<LinkScene>} */
    readLink: (link) => ask("readLink", link),
    /** @param {PageScene} scene @returns {Promise<WrittenLink>} */
    writeLink: (scene) => ask("writeLink", { scene }),
    /** @param {string} sent  the energy of a link @param {number} step @returns {Promise<LinkCheck | null>} */
    checkLink: (sent, step) => ask("checkLink", { sent, step }),
    /**
     * @param {string} name @param {Uint8Array<ArrayBuffer>} bytes  kept, so that a lost worker can be replaced
     * @param {Partial<RepairOptions> | null} [repair]  how it is repaired, where it is
     */
    load: (name, bytes, repair = null) => make("load", { name, bytes, repair }),
    /** What the mesh was read from, if it was. @returns {Uint8Array<ArrayBuffer> | null} */
    file: () => scene.origin?.fields.bytes ?? null,
    /** @param {string} name @param {Record<string, number>} parameters */
    sample: (name, parameters) => make("sample", { name, parameters }),
    /** How the mesh was made, so that another solver can make the same. */
    origin: () => scene.origin,
    /** @param {Origin} of  another solver's `origin` */
    same: ({ name, fields }) => make(name, fields),
    /** @param {FlowOptions} wanted @returns {Promise<Configured>} */
    async configure(wanted) {
      const configured = await move("configure", { options: wanted });
      film = null;
      scene.isConfigured = true;
      scene.options = wanted;
      return configured;
    },
    /** From the surface as it is. @param {FlowOptions} wanted @returns {Promise<Configured>} */
    async continueWith(wanted) {
      const configured = await move("continueWith", { options: wanted });
      scene.options = wanted;
      return configured;
    },
    /** @param {FieldName} name @returns {Promise<Field | null>} */
    async colour(name) {
      const shown = (scene.last?.panes.length ?? 0) > 0;
      const answer = await ask("colour", { field: name }, { shown });
      scene.field = name;
      return answer;
    },
    /** @param {number | null} until  the step to pause at */
    async run(until) {
      if (until !== null) await turn(false);
      return /** @type {Promise<true>} */ (ask("run", { until }, { ends: true }));
    },
    /** @returns {Promise<State>} */
    pause: async () => signed(await ask("pause")),
    /**
     * Goes over to a half of a figure that has two.
     * @param {string} figure  its id @param {boolean} isBack  to the one that is shown backwards
     * @returns {Promise<State>}
     */
    async turn(figure, isBack) {
      film ??= { figure, isBack: false, back: 0, forth: (await ask("state")).step };
      await turn(isBack);
      return signed(await ask("state"));
    },
    /** @returns {Promise<StepReport | null>} */
    step: () => move("step"),
    /** @param {Partial<RegulariseOptions>} wanted @returns {Promise<Regularised>} */
    regularise: (wanted) => move("regularise", { options: wanted }),
    /** @param {Arrangement} wanted @returns {Promise<State>} */
    async arrange(wanted) {
      const state = await ask("arrange", { arrangement: wanted }, { shown: scene.isConfigured });
      scene.arrangement = wanted;
      return state;
    },
    /** Makes the surface as it is the start. */
    adopt: () => edit("adopt"),
    /** Takes the last edit back. @returns {Promise<Loaded>} */
    async undo() {
      const loaded = await move("undo");
      film = null;
      scene = { ...scene, ...origins.pop(), isConfigured: true };
      return loaded;
    },
    /** Where there is nothing to repair it is no edit. @param {Partial<RepairOptions>} options */
    async repair(options) {
      const loaded = /** @type {Loaded} */ (await ask("repair", { options }, { ends: true }));
      if (loaded.repaired.length > 0) await keep(loaded);
      return loaded;
    },
    /**
     * Other triangles of the same surface.
     * @param {Partial<RemeshOptions>} wanted
     * @returns {Promise<{ outcome: RemeshOutcome, loaded: Loaded }>}
     */
    async remesh(wanted) {
      const outcome = await ask("remesh", { options: wanted }, { ends: true });
      const loaded = await send("loaded");
      await keep(loaded);
      return { outcome, loaded };
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
    /** @param {number} number @returns {Promise<import("./generated/types.js").Phase | null>} */
    phase: (number) => ask("phase", { number }),
    /** @returns {Promise<BoundaryLoop[]>} */
    loops: () => ask("loops"),
    /**
     * Fills holes, or connects loops.
     * @param {Partial<FillOptions>} wanted
     * @returns {Promise<{ filled: Filled, loaded: Loaded }>}
     */
    async fill(wanted) {
      const filled = await ask("fill", { options: wanted }, { ends: true });
      const loaded = await send("loaded");
      await keep(loaded);
      return { filled, loaded };
    },
    /** @param {LookOptions} options @returns {Promise<Look>} */
    async look(options) {
      const look = await ask("look", { options });
      scene.lookOptions = options;
      return look;
    },
    /** @param {number[]} centre @returns {Promise<Inverted>} */
    previewInversion: (centre) => ask("previewInversion", { centre }),
    /** @param {number[]} centre @returns {Promise<{ report: InversionReport, loaded: Loaded }>} */
    async invert(centre) {
      const report = await ask("invert", { centre }, { ends: true });
      const loaded = await send("loaded");
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
    back: async () => signed(await move("back")),
    /** @returns {Promise<State>} */
    reset: async () => signed(await move("reset")),
    /** Shows a stored step. @param {number} step @returns {Promise<State>} */
    async seek(step) {
      await turn(step < 0);
      return signed(await move("seek", { step: Math.abs(step) }));
    },
    /**
     * Every stored step of the path as a frame, of a film those of both halves.
     * @returns {Promise<boolean>} whether all came
     */
    async stored() {
      const isBack = film?.isBack ?? false;
      const all = await ask("stored");
      if (!film || !all) return all;
      await turn(!isBack);
      const both = await ask("stored");
      await turn(isBack);
      return both;
    },
    /** @param {number} branch @returns {Promise<State>} */
    branch: async (branch) => signed(await move("branch", { branch })),
    /** @param {string} text @returns {Promise<RecipeCard>} */
    readRecipe: (text) => ask("readRecipe", { text }),
    /** @param {MeshOrigin | null} origin @returns {Promise<string>} */
    writeRecipe: (origin) => ask("writeRecipe", { origin }),
    /**
     * Makes the mesh of a recipe or a link.
     * @param {ScriptText} script
     * @param {{ name: string, bytes: Uint8Array<ArrayBuffer> } | null} file  that it begins with
     */
    prepare: (script, file) =>
      make("prepare", { script, bytes: file?.bytes ?? null, name: file?.name ?? "" }),
    /** Does what it says after its edits. @param {ScriptText} script @returns {Promise<State>} */
    async follow(script) {
      const state = await move("follow", { script });
      scene.isConfigured = true;
      return state;
    },
    /** Gives up what is prepared or followed. @returns {Promise<null>} */
    cancel: () => ask("cancelReplay", {}, { ends: true, shown: scene.last !== null }),
    /** @param {string} format @param {number} every @returns {Promise<Uint8Array<ArrayBuffer>>} ZIP */
    sequence: (format, every) => ask("sequence", { format, every }),
    /** @param {string} format @param {number} every @returns {Promise<{ meshes: number, bytes: number }>} */
    sequenceSize: (format, every) => ask("sequenceSize", { format, every }),
    /**
     * The surface as a file; PLY of the page's own copy, where the solver cannot be asked.
     * @param {string} format
     * @returns {Promise<{ format: string, bytes: Uint8Array<ArrayBuffer>, losses: Message[] }>}
     */
    async export(format) {
      try {
        if (isWhole && !channel.isSilent()) {
          const bytes = await send("export", { format });
          return { format, bytes, losses: await send("losses", { format }) };
        }
      } catch (error) {
        if (/** @type {Fault} */ (error).kind !== LOST) throw error;
      }
      return { format: "ply", bytes: ownCopy(), losses: [] };
    },
    /** @returns {Promise<string>} CSV */
    history: () => ask("history"),
    /** @returns {Promise<number>} ∫H² dA of the surface as it is */
    bending: async () => (await ask("energy")).willmore,
  };
}

/** @typedef {ReturnType<typeof createSolver>} Solver */
