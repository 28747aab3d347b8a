// @ts-check
// The turns in which flows that are compared step; the first is the page's own. All of a turn
// step at once, each in a worker of its own, and are shown together when the last is done.

/** @import { Field, Frame } from "../state.js" */
/** @import { Solver } from "../solver.js" */

import { LOST } from "../channel.js";
import { lastTurn, MAIN, nextTurn, paneOf, sharedFields } from "../comparison.js";
import { comparisonTransitions as on } from "../comparison-state.js";
import { t } from "../language.js";
import { isOver } from "../standing.js";
import { transitions as to } from "../state.js";
import { say } from "../words.js";
import { createRivals } from "./rivals.js";

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
  const rivals = createRivals({ store, solver, voice, report, onFrame });
  const { fields, busy, out, begin, dismiss, unfit } = rivals;
  /** Frames of the turn that is being taken. @type {Map<number, Frame> | null} */
  let held = null;
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
  const nameOf = (id) => paneOf(store.get().comparison, id);
  /** @param {number} id */
  const solverOf = (id) => (id === MAIN ? solver : rivals.solverOf(id));

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

  /** A rival's frame. @param {number} id @param {Frame} frame */
  function onFrame(id, frame) {
    if (held) held.set(id, frame);
    else put(id, frame);
  }

  /** @param {number} id @param {Frame} frame */
  function put(id, frame) {
    if (id !== MAIN) return store.update(on.rivalFrame, id, frame);
    store.update(to.frame, frame);
    for (const warning of frame.reports.flatMap(({ warnings }) => warnings)) {
      voice.note(say(warning), warning.id);
    }
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
    const none = { reports: [], panes: [], curves: null, jump: null, look: null };
    const { timeline } = store.get();
    const field = fields.get(id) ?? null;
    held?.set(id, {
      state,
      positions,
      field,
      flippedTriangles,
      timeline,
      ...none,
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
    /** @param {import("../state.js").FieldName} name @param {Field | null} own */
    async colour(name, own) {
      fields.set(MAIN, own);
      await rivals.colour(name);
      if (isOpen()) await show();
    },
    /**
     * Ends steps that take too long.
     * @returns {boolean} whether the page's own is among them
     */
    halt() {
      const isMain = !isOpen() || busy.has(MAIN);
      for (const id of busy) if (id !== MAIN) rivals.halt(id);
      return isMain;
    },
  };
}

/** @typedef {ReturnType<typeof createContest>} Contest */
