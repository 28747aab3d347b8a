// What may be asked of the solver, and the scene that it has: where its worker is lost, a new one
// is given that scene before it is asked for anything else.

/** @import { FlowOptions } from "./generated/schema.js" */
/** @import { Frame, Loaded, ScriptText, State } from "./generated/types.js" */
/** @import { Answered, Asked, Name } from "./worker.js" */
/** @import { Fault } from "./words.js" */

import { createChannel, LOST } from "./channel.js";
import { plyOf } from "./ply.js";
import { fault, sayFault } from "./words.js";

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
 * @typedef {{ name: "load" | "sample" | "prepare", fields: any, isEdited?: boolean }} Origin
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
 * @property {{ [N in typeof kept[number]]?: Asked<N> }} again  what was asked for last of each
 * @property {Frame | null} last
 */

/** What of the solver stays as it was asked for, whatever mesh it has. */
const kept = /** @type {const} */ (["colour", "arrange", "look"]);
/** What moves the surface: it ends the run at hand, and what comes of it is shown. */
const moves = [
  ...["configure", "continueWith", "step", "regularise", "undo", "back", "reset", "seek"],
  ...["branch", "follow"],
];
/** What else ends the run at hand. */
const ends = [
  ...["run", "turn", "load", "sample", "prepare", "cancelReplay"],
  ...["adopt", "repair", "remesh", "subdivide", "fill", "invert"],
];
/** What is answered with where the session stands. */
const places = ["pause", "state", "back", "reset", "seek", "branch"];

/** How often in a row the scene is given to a new worker that is lost meanwhile. */
const ATTEMPTS = 6;
/** Milliseconds before the second attempt, doubled for each further one: memory may be freed. */
const PAUSE = 50;

/**
 * Options with the selection that a mesh brings along: a file made of it knows none.
 * @template {FlowOptions} Options
 * @param {Options} options @param {Pick<Loaded, "free" | "fixed"> | null} mesh @returns {Options}
 */
export function withSelection(options, mesh) {
  if (options.free || options.fixed) return options;
  const list = (/** @type {Uint32Array | null | undefined} */ some) => (some ? [...some] : null);
  return { ...options, free: list(mesh?.free), fixed: list(mesh?.fixed) };
}

/**
 * @param {Partial<Listener>} listener
 * @param {{ patience?: number, pause?: number }} [waits]  in milliseconds: for a sign of life, and
 *   between attempts to bring the scene back
 */
export function createSolver(listener, { patience, pause = PAUSE } = {}) {
  const { onSilent } = listener;
  const channel = createChannel({ onEvent, onLost, onSilent }, patience);
  let run = 0;
  /** @type {Shown} */
  let scene = {
    ...{ origin: null, loaded: null, last: null },
    ...{ isConfigured: false, options: {}, again: {} },
  };
  /** Those of before the edits that can be undone. @type {(Pick<Shown, "origin" | "loaded"> & { film: typeof film })[]} */
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
    await ask("turn", { figure: film.figure });
    film.isBack = isBack;
    // The last frame is of the other one.
    scene.last = null;
  }

  /** @param {any} message */
  function onEvent(message) {
    if (message.type === "ready") listener.onReady?.(message.version);
    else if (message.type === "progress") listener.onProgress?.(message);
    else if (message.run !== run) return;
    else if (message.type === "frame") {
      scene.options = message.flow?.options ?? scene.options;
      if (!message.stored) scene.last = message;
      // Both halves begin at one place, which is that of the second.
      if (!film?.isBack || message.state.step > 0) {
        const { run: _, stored } = message;
        listener.onFrame?.({ ...inFilm(message), run, stored });
      }
      channel.acknowledge(message.run);
    } else if (message.type === "stopped") {
      listener.onStopped?.(signed(message.state), message.fault && sayFault(message.fault));
    }
  }

  function drop() {
    run += 1;
    isWhole = scene.origin === null;
    // Of a film only the step that is shown is left.
    if (film) film = { ...film, back: 0, forth: 0 };
    channel.dismiss();
  }

  /** @param {string} reason */
  function onLost(reason) {
    drop();
    // On the way back there is another attempt.
    if (!revival) listener.onCrashed?.(reason);
  }

  /** Ends the worker; whoever waits for it learns so. The next request starts another. */
  function dismiss() {
    revival = null;
    drop();
  }

  /**
   * @template {Name} N @param {N} name @param {Asked<N>} [fields]
   * @param {boolean} [isEnd]  whether it ends the run at hand
   * @param {boolean} [shown]  whether a frame follows the answer @returns {Promise<Answered<N>>}
   */
  function send(name, fields, isEnd = false, shown = false) {
    if (isEnd) run += 1;
    return channel.ask({ name, fields: fields ?? {}, shown, ...(isEnd ? { run } : {}) });
  }

  /**
   * The same of a worker that has the scene.
   * @template {Name} N @param {N} name @param {Asked<N>} [fields] @returns {Promise<Answered<N>>}
   */
  async function ask(name, fields) {
    if (!isWhole) await revive();
    const isMove = moves.includes(name);
    const isSeen =
      (name === "arrange" && scene.isConfigured) ||
      (name === "colour" && (scene.last?.panes.length ?? 0) > 0) ||
      (name === "cancelReplay" && scene.last !== null);
    const answer = await send(name, fields, isMove || ends.includes(name), isMove || isSeen);
    if (kept.some((one) => one === name)) scene.again = { ...scene.again, [name]: fields };
    return places.includes(name) ? signed(/** @type {any} */ (answer)) : answer;
  }

  /** Gives a new worker the scene. @returns {Promise<State | null>} */
  async function restore() {
    const { origin, loaded, isConfigured, options, again, last } = scene;
    if (!origin) return null;
    const made = await send(origin.name, origin.fields, true);
    let state = null;
    if (isConfigured) {
      const chosen = origin.isEdited ? withSelection(options, loaded) : options;
      await send("configure", { options: chosen });
      for (const name of kept) if (again[name]) await send(name, again[name]);
      // A new worker begins with the second half.
      if (film?.isBack) await send("turn", { figure: film.figure });
      state = signed(await place(last, loaded ?? made, made));
    }
    isWhole = true;
    return state;
  }

  /**
   * Puts the surface of the last frame in place, in full precision.
   * @param {Frame | null} frame @param {Loaded} before  the mesh that the frame is of
   * @param {Loaded} now     the same, read again @returns {Promise<State>}
   */
  async function place(frame, before, now) {
    const isStart =
      frame?.state.step === 0 &&
      !frame.triangles &&
      frame.positions.every((c, n) => c === now.positions[n]);
    if (!frame || isStart) return send("reset", {}, true, true);
    // Far from the origin an edited mesh is read into a place of its own.
    const apart = before.shift.map((c, n) => c - now.shift[n]);
    const isApart = apart.some(Boolean);
    const exact = isApart ? frame.exact.map((c, n) => c + apart[n % 3]) : frame.exact;
    const { triangles, state } = frame;
    return send("restore", { exact, triangles, step: state.step, time: state.time }, true, true);
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
          if (n === ATTEMPTS) throw fault("SolverLostAgain", "solver-lost-again");
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

  /** @param {Origin["name"]} name @param {any} fields @returns {Promise<Loaded>} */
  async function make(name, fields) {
    // The scene is not needed any more: but it must not come after.
    await revival?.catch(() => {});
    const loaded = await send(name, fields, true);
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
   * A mesh made of the one at hand, and what is told of that: for a new worker it is a file of its
   * own. Where there is nothing to repair it is no edit.
   * @template {"adopt" | "subdivide" | "repair" | "remesh" | "fill" | "invert"} N
   * @param {N} name @param {Asked<N>} [fields]
   */
  async function edit(name, fields) {
    const outcome = await ask(name, fields);
    const isMesh = ["adopt", "subdivide", "repair"].includes(name);
    const loaded = isMesh ? /** @type {any} */ (outcome) : await send("loaded");
    if (name === "repair" && loaded.repaired.length === 0) return { outcome, loaded };
    const bytes = await send("export", { format: "ply" });
    origins.push({ origin: scene.origin, loaded: scene.loaded, film });
    const file = { name: `${loaded.name}.ply`, bytes };
    begin(loaded, { name: "load", fields: file, isEdited: true });
    return { outcome, loaded };
  }

  /** The surface that is shown, of what the page has. @returns {Uint8Array<ArrayBuffer>} */
  function ownCopy() {
    const { loaded, last } = scene;
    if (!loaded) throw fault("NoMesh", "no-mesh-yet", {}, "");
    const triangles = last?.triangles ?? loaded.triangles;
    // Other triangles may be of other vertices.
    const colours = last?.triangles ? null : loaded.colours;
    return plyOf(last?.exact ?? loaded.positions, loaded.shift, triangles, colours);
  }

  return {
    dismiss,
    revive,
    /** Whatever leaves mesh, flow and half of a film as they are. */
    ask,
    /** Starts the worker, if nothing has been asked of it yet. @throws {Fault} where that may not be */
    begin: () => void channel.begin(),

    // Meshes to begin with, and what they were made of: another solver can make the same.
    /**
     * @param {string} name @param {Uint8Array<ArrayBuffer>} bytes  kept, so that a lost worker can be replaced
     * @param {Asked<"load">["repair"]} [repair]  how it is repaired, where it is
     */
    async load(name, bytes, repair = null) {
      const before = { origin: scene.origin, loaded: scene.loaded, film };
      const loaded = await make("load", { name, bytes, repair });
      // Of a file that is no surface undoing the repair brings back what was there before.
      if (repair && before.origin) origins.push(before);
      return loaded;
    },
    /** @param {string} name @param {Record<string, number>} parameters */
    sample: (name, parameters) => make("sample", { name, parameters }),
    /**
     * Makes the mesh of a recipe or a link.
     * @param {ScriptText} script
     * @param {{ name: string, bytes: Uint8Array<ArrayBuffer> } | null} file  that it begins with
     */
    prepare: (script, file) =>
      make("prepare", { script, bytes: file?.bytes ?? null, name: file?.name ?? "" }),
    origin: () => scene.origin,
    /** @param {Origin} of  another solver's `origin` */
    same: ({ name, fields }) => make(name, fields),
    /** What the mesh was read from, if it was. @returns {Uint8Array<ArrayBuffer> | null} */
    file: () => scene.origin?.fields.bytes ?? null,

    // What changes it.
    edit,
    adopt: () => edit("adopt"),
    /** Takes the last edit back: the mesh that there was, which a flow may have remeshed since. */
    async undo() {
      await ask("undo");
      const before = origins.pop();
      film = before?.film ?? null;
      scene = { ...scene, origin: null, loaded: null, ...before, isConfigured: true, last: null };
      return /** @type {Loaded} */ (scene.loaded);
    },

    // The flow, and where it stands.
    /**
     * @param {FlowOptions} options
     * @param {"configure" | "continueWith"} [way]  from the start, or from the surface as it is
     */
    async configure(options, way = "configure") {
      const configured = await ask(way, { options });
      if (way === "configure") film = null;
      scene = { ...scene, isConfigured: true, options };
      return configured;
    },
    /** @param {number | null} until  the step to pause at */
    async run(until) {
      if (until !== null) await turn(until < 0);
      return ask("run", { until: until && Math.abs(until) });
    },
    /** Shows a stored step. @param {number} step */
    async seek(step) {
      await turn(step < 0);
      return ask("seek", { step: Math.abs(step) });
    },
    /**
     * Goes over to a half of a figure that has two.
     * @param {string} figure  its id @param {boolean} isBack  to the one that is shown backwards
     */
    async turn(figure, isBack) {
      film ??= { figure, isBack: false, back: 0, forth: (await ask("state")).step };
      await turn(isBack);
      return ask("state");
    },
    /** Every stored step of the path as a frame, of a film those of both halves: whether all came. */
    async stored() {
      const isBack = film?.isBack ?? false;
      const all = await ask("stored");
      if (!film || !all) return all;
      await turn(!isBack);
      const both = await ask("stored");
      await turn(isBack);
      return both;
    },
    /** Does what a recipe or a link says after its edits. @param {ScriptText} script */
    async follow(script) {
      const state = await ask("follow", { script });
      scene.isConfigured = true;
      return state;
    },
    /** As a file; PLY of the page's own copy, where it cannot be asked. @param {string} format */
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
  };
}

/** @typedef {ReturnType<typeof createSolver>} Solver */
