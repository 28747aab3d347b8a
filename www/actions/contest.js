// @ts-check
// The flows that are compared: a solver for each, and the turns in which they step. The first
// is the page's own. All of a turn step at once, each in a worker of its own, and are shown
// together when the last is done.

/** @import { Field, Frame } from "../protocol.js" */
/** @import { Options } from "../options.js" */
/** @import { Solver } from "../solver.js" */

import { isOver, lastTurn, letter, nextTurn, optionsOf, sharedFields } from "../comparison.js";
import { comparisonTransitions as on } from "../comparison-state.js";
import { t } from "../language.js";
import { createSolver, LOST } from "../solver.js";
import { transitions as to } from "../state.js";

/** The page's own flow, among the rivals' ids. */
const MAIN = 0;

/** A turn shorter than this says nothing of whom it waits for. */
const PATIENCE = 700;

/** Where drawing rests, as in a window in the background, turns go on all the same. */
const UNDRAWN_MILLISECONDS = 200;

/** A task of its own, so that none gets long. */
const task = () => new Promise((resolve) => setTimeout(resolve));

/** When what was shown is on the screen. */
const drawn = () =>
  new Promise((resolve) => {
    requestAnimationFrame(resolve);
    setTimeout(resolve, UNDRAWN_MILLISECONDS);
  });

/** @param {Field | null} a @param {Field | null} b */
const sameField = (a, b) => a?.values === b?.values && a?.low === b?.low && a?.high === b?.high;

/**
 * @param {object} page
 * @param {import("../state.js").Store} page.store
 * @param {Solver} page.solver
 * @param {import("../controller.js").Voice} page.voice
 * @param {(error: unknown) => void} page.report
 */
export function createContest({ store, solver, voice, report }) {
  /** @type {Map<number, { solver: Solver, mesh: unknown }>} */
  const rivals = new Map();
  /** Fields as the solvers gave them, before they share a scale. @type {Map<number, Field | null>} */
  const fields = new Map();
  /** Frames of the turn that is being taken. @type {Map<number, Frame> | null} */
  let held = null;
  /** Whose answer is waited for. @type {Set<number>} */
  const busy = new Set();
  /** Whose solver was lost in this run: it would be lost again. @type {Set<number>} */
  const out = new Set();
  /** Whose budget starts anew, as Play says it does. @type {Set<number>} */
  const renewed = new Set();
  /** @type {{ isStopped: boolean, done: Promise<void> } | null} */
  let playing = null;

  const isOpen = () => store.get().comparison.rivals.length > 0;

  /** All that are compared, the first first. */
  function contenders() {
    const { reading, frame, comparison } = store.get();
    return [{ id: MAIN, phase: "ready", reading, frame }, ...comparison.rivals];
  }

  /** @param {number} id */
  const nameOf = (id) => letter(contenders().findIndex((one) => one.id === id));
  /** @param {number} id */
  const solverOf = (id) => (id === MAIN ? solver : rivals.get(id)?.solver);

  const standings = () =>
    contenders().map(({ id, phase, reading }) => ({
      step: reading?.step ?? 0,
      time: reading?.time ?? 0,
      mayStep:
        reading !== null &&
        phase === "ready" &&
        !out.has(id) &&
        (!isOver(reading.status) || (reading.status === "stepLimit" && renewed.has(id))),
      mayGoBack: phase === "ready" && (reading?.canStepBack ?? false),
    }));

  /** Those that stopped at their limit may go on for as many steps again. */
  function renew() {
    out.clear();
    renewed.clear();
    for (const { id, reading } of contenders()) {
      if (reading?.status === "stepLimit") renewed.add(id);
    }
  }

  /** @param {number} id @param {Frame} frame */
  function put(id, frame) {
    if (id !== MAIN) return store.update(on.rivalFrame, id, frame);
    store.update(to.frame, frame);
    for (const text of frame.reports.flatMap(({ warnings }) => warnings)) voice.note(text);
  }

  /** Shows frames, and all panes in colours on one scale. @param {ReadonlyMap<number, Frame>} [frames] */
  async function show(frames = new Map()) {
    const all = contenders();
    const pictures = all.map(({ id, frame }) => {
      const now = frames.get(id) ?? frame;
      return now && { ...now, field: fields.get(id) ?? null };
    });
    const colours = sharedFields(pictures, store.get().comparison.difference);
    for (const [n, { id, frame }] of all.entries()) {
      const next = frames.get(id);
      const field = colours[n];
      if (next) put(id, { ...next, field });
      else if (!frame || sameField(frame.field, field)) continue;
      else if (id === MAIN) store.update(to.coloured, store.get().colour, field);
      else store.update(on.rivalColoured, id, field);
      await task();
    }
  }

  /** Notes ∫H² dA. @param {number} id */
  async function measure(id) {
    const one = contenders().find((each) => each.id === id);
    const step = held?.get(id)?.state.step ?? one?.reading?.step;
    if (step === undefined) return;
    const value = await solverOf(id)?.bending();
    if (value !== undefined) store.update(on.bent, id === MAIN ? null : id, step, value);
  }

  /**
   * Asks some to move, and shows where all came to.
   * @param {readonly number[]} numbers  of the contenders
   * @param {(solver: Solver) => Promise<unknown>} ask
   */
  async function move(numbers, ask) {
    const all = contenders();
    held = new Map();
    const frames = held;
    const patience = setTimeout(tellWait, PATIENCE);
    const began = performance.now();
    await Promise.all(
      numbers.map(async (n) => {
        const { id, phase } = all[n];
        const own = solverOf(id);
        if (!own || phase !== "ready") return;
        busy.add(id);
        try {
          await ask(own);
          await measure(id);
        } catch (error) {
          await refused(id, own, error);
        } finally {
          busy.delete(id);
          if (performance.now() - began > PATIENCE) tellWait();
        }
      }),
    );
    clearTimeout(patience);
    held = null;
    quiet();
    await show(frames);
  }

  /** Who is waited for, so that a long step can be ended. */
  function tellWait() {
    const pane = [...busy].map(nameOf).sort().join(", ");
    if (pane === "") return;
    const share = 1 - busy.size / (busy.size + (held?.size ?? 0));
    store.update(to.progress, { stage: t("Waiting for pane {pane}", { pane }), fraction: share });
  }

  /** Nothing is waited for any more. */
  function quiet() {
    if (store.get().progress) store.update(to.progress, null);
  }

  /** A step that could not be taken: it stays where it is. @param {number} id @param {Solver} own @param {any} error */
  async function refused(id, own, error) {
    // Whoever ended the solver says so.
    if (error?.kind === LOST) return void out.add(id);
    if (!error?.kind) return report(error);
    const reason = error.message;
    const message = isOpen() ? t("Pane {pane}: {reason}", { pane: nameOf(id), reason }) : reason;
    voice.error({ message, hint: error.hint });
    const state = await own.pause().catch(() => null);
    const frame = contenders().find((one) => one.id === id)?.frame;
    if (!state || !frame) return;
    const { positions, flippedTriangles } = frame;
    const none = { reports: [], panes: [], curves: null, jump: null };
    const field = fields.get(id) ?? null;
    held?.set(id, { type: "frame", run: 0, state, positions, field, flippedTriangles, ...none });
  }

  /** @param {number} id @param {string} reason  why its solver is no more */
  async function revive(id, reason) {
    const own = rivals.get(id)?.solver;
    if (!own) return;
    const pane = nameOf(id);
    const isAgain = out.has(id);
    out.add(id);
    store.update(on.rivalLost, id, t("Its solver stopped: {reason}", { reason }));
    // Lost again on the way back.
    if (isAgain) return;
    try {
      const reading = await own.revive();
      if (!reading) throw new Error("no mesh");
      store.update(on.rivalRevived, id, reading);
      voice.error({
        message: t(
          "The solver of pane {pane} stopped ({reason}); a new one stands at step {step}. The other panes go on.",
          { pane, reason, step: reading.step },
        ),
        hint: t("Play or Step takes the pane along again; Remove closes it."),
      });
    } catch {
      voice.error({
        message: t("The solver of pane {pane} could not be started again ({reason}).", {
          pane,
          reason,
        }),
        hint: t("Reset tries once more; the other panes go on without it."),
      });
    }
  }

  /** @param {number} id */
  function employ(id) {
    const made = createSolver({
      onReady() {},
      onStopped() {},
      onProgress({ stage, fraction }) {
        if (busy.has(id)) store.update(to.progress, { stage, fraction, pane: nameOf(id) });
      },
      onCrashed: (reason) => revive(id, reason),
      onFrame(frame) {
        fields.set(id, frame.field);
        if (held) held.set(id, frame);
        else put(id, frame);
      },
    });
    const rival = { solver: made, mesh: /** @type {unknown} */ (null) };
    rivals.set(id, rival);
    return rival;
  }

  /** @param {Partial<Options>} change */
  function wanted(change) {
    const { options, mesh } = store.get();
    const all = optionsOf(options, change);
    if (all.free || all.fixed) return all;
    // A mesh that was edited goes over as a file, which knows no selection.
    const list = (/** @type {Uint32Array | null | undefined} */ some) => (some ? [...some] : null);
    return { ...all, free: list(mesh?.free), fixed: list(mesh?.fixed) };
  }

  /**
   * Puts a rival at the start, with a mesh if it has none.
   * @param {number} id @param {Partial<Options>} change
   */
  async function begin(id, change) {
    const { mesh, colour, comparison } = store.get();
    const isLost = comparison.rivals.find((one) => one.id === id)?.phase === "lost";
    const rival = rivals.get(id) ?? employ(id);
    out.delete(id);
    busy.add(id);
    try {
      if (rival.mesh !== mesh || isLost) {
        const origin = solver.origin();
        if (!origin) return;
        store.update(on.rivalLoading, id);
        await rival.solver.same(origin);
        rival.mesh = mesh;
        fields.set(id, await rival.solver.colour(colour));
      }
      const configured = await rival.solver.configure(wanted(change));
      store.update(on.rivalConfigured, id, change, configured);
    } finally {
      busy.delete(id);
    }
  }

  /** Ends the solvers of panes that are no more. */
  function dismiss() {
    const ids = store.get().comparison.rivals.map(({ id }) => id);
    for (const [id, rival] of rivals) {
      if (ids.includes(id)) continue;
      rival.solver.dismiss();
      rivals.delete(id);
      fields.delete(id);
    }
  }

  /** What could not begin stays in its pane, saying why. @param {number} id @param {any} error */
  function unfit(id, error) {
    if (error?.kind === LOST) return;
    if (!error?.kind) report(error);
    store.update(on.rivalLost, id, String(error?.message ?? error));
    voice.error({
      message: t("Pane {pane}: {reason}", { pane: nameOf(id), reason: error?.message ?? error }),
      hint: error?.hint ?? "",
    });
  }

  /** Puts all rivals, or some, at the start. @param {readonly number[]} [ids] */
  async function follow(ids) {
    const { comparison, options } = store.get();
    if (options.flow === "flips" && isOpen()) {
      store.update(on.compared, { rivals: [] });
      voice.answer(t("Edge flips change the mesh itself: the panes beside it were closed."));
    }
    dismiss();
    if (!isOpen()) return;
    await Promise.all(
      comparison.rivals
        .filter(({ id }) => !ids || ids.includes(id))
        .map(({ id, change }) => begin(id, change).catch((error) => unfit(id, error))),
    );
    quiet();
    await settle();
  }

  /** Shows and measures all as they stand. */
  async function settle() {
    await show();
    const able = contenders().filter(({ phase }) => phase === "ready");
    await Promise.all(able.map(({ id }) => measure(id).catch(() => {})));
  }

  /**
   * Steps in turns until all have come where they should, or to an end of their own.
   * @param {(standing: { step: number, time: number }, n: number) => boolean} isThere
   */
  function play(isThere) {
    renew();
    const run = { isStopped: false, done: Promise.resolve() };
    playing = run;
    run.done = (async () => {
      try {
        while (!run.isStopped && store.get().phase === "running") {
          const all = standings().map((one, n) => ({
            ...one,
            mayStep: one.mayStep && !isThere(one, n),
          }));
          const turn = nextTurn(all, store.get().comparison.lockstep);
          if (turn.length === 0) break;
          for (const n of turn) renewed.delete(contenders()[n].id);
          await move(turn, (own) => own.step());
          await drawn();
        }
      } catch (error) {
        report(error);
      }
      playing = null;
      const { phase, reading } = store.get();
      if (phase === "running" && reading) store.update(to.stopped, reading);
    })();
  }

  const everybody = () => contenders().map((_, n) => n);

  return {
    isOpen,
    begin,
    dismiss,
    follow,
    show,
    settle,
    play,
    standings,
    isPlaying: () => playing !== null,
    /** Ends the run after the turn in hand. */
    async pause() {
      if (!playing) return;
      playing.isStopped = true;
      await playing.done;
    },
    /** One turn. @returns {Promise<void>} */
    async step() {
      if (!isOpen()) return void (await solver.step());
      renew();
      const turn = nextTurn(standings(), store.get().comparison.lockstep);
      if (turn.length > 0) await move(turn, (own) => own.step());
      else voice.answer(t("No pane can step on; Reset takes all back to the start."));
    },
    async back() {
      if (!isOpen()) return void (await solver.back());
      const turn = lastTurn(standings(), store.get().comparison.lockstep);
      await move(turn, (own) => own.back());
    },
    async reset() {
      if (!isOpen()) return void (await solver.reset());
      const lost = store.get().comparison.rivals.filter(({ phase }) => phase === "lost");
      await move(everybody(), (own) => own.reset());
      if (lost.length > 0) await follow(lost.map(({ id }) => id));
    },
    /**
     * A frame of the page's own flow.
     * @param {Frame} frame
     * @returns {boolean} whether it waits for the others of its turn
     */
    holds(frame) {
      fields.set(MAIN, frame.field);
      held?.set(MAIN, frame);
      return held !== null;
    },
    /** @param {import("../protocol.js").FieldName} name @param {Field | null} own */
    async colour(name, own) {
      fields.set(MAIN, own);
      await Promise.all(
        [...rivals].map(async ([id, rival]) => {
          if (rival.mesh) fields.set(id, await rival.solver.colour(name).catch(() => null));
        }),
      );
      if (isOpen()) await show();
    },
    /**
     * Ends steps that take too long.
     * @returns {boolean} whether the page's own is among them
     */
    halt() {
      const isMain = !isOpen() || busy.has(MAIN);
      for (const id of busy) {
        if (id === MAIN) continue;
        rivals.get(id)?.solver.dismiss();
        revive(id, t("it was ended"));
      }
      return isMain;
    },
  };
}

/** @typedef {ReturnType<typeof createContest>} Contest */
