// What all actions share: the solver, the clip that its frames make, the queue in which things
// are done one at a time, and how a lost solver is replaced.

import { batch } from "@preact/signals-core";
import { LOST } from "../channel.js";
import { Clip } from "../clip.js";
import { createPlayer } from "../player.js";
import { rangeOf } from "../range.js";
import { isOver } from "../session.js";
import { CANCELLED, createSolver } from "../solver.js";
import { faultOf, say } from "../words.js";

/** @import { Point } from "../clip.js" */
/** @import { Frame as Taken, Loaded, Message, State as Reading } from "../generated/types.js" */
/** @import { Notes } from "../notes.js" */
/** @import { Options } from "../options.js" */
/** @import { Track } from "../player.js" */
/** @import { FieldName, Store } from "../store.js" */
/** @import { Fault } from "../words.js" */

/** Milliseconds that the progress of one step stays, so that *Stop now* can be pressed. */
const LASTS = 2000;

/** @typedef {Taken & { run: number, stored: boolean }} Frame */
/** What helps against a refusal. @typedef {{ label: string, act: () => unknown }} Offer */

/**
 * What a clip takes of a frame. Of a surface with triangles of its own, which remeshing made, these
 * are one object as long as they stay, so that the surface moves from step to step.
 * @param {Frame} frame @param {Point | undefined} before
 */
function surfaceOf({ state, positions, field, panes }, before) {
  if (state.flips || panes.length !== 1) return { positions, field, panes, drawable: null };
  const [made] = panes;
  const known = before?.drawable;
  const isSame =
    known?.triangles.length === made.triangles.length &&
    known.triangles.every((v, n) => v === made.triangles[n]);
  const drawable = isSame ? known : made;
  return { positions: made.positions, field: made.field, panes: [], drawable };
}

/** Puts a frame into a clip. @param {Track} track @param {Frame} frame @param {boolean} follows  whether the display goes there */
export function take(track, frame, follows) {
  const { state, flippedTriangles: marked, timeline, stored } = frame;
  const { clip } = track;
  const shown = clip.points[clip.at(track.u).index]?.state.step;
  // The steps of a half that is shown backwards come one before the other.
  const near = state.step < 0 ? state.step + 1 : state.step - 1;
  const surface = surfaceOf(frame, clip.points[clip.indexOf(near)]);
  clip.add({ state, ...surface, marked }, timeline.last);
  // The display stays at its step while others are put in before it.
  const at = follows ? state.step : stored ? shown : undefined;
  if (at !== undefined) track.u = clip.points[Math.max(clip.indexOf(at), 0)].sum;
}

/**
 * @param {Store} store @param {Notes} notes
 * @param {{ isCalm: () => boolean, nextFrame?: (draw: (time: number) => void) => unknown,
 *   waits?: Parameters<typeof createSolver>[1] }} environment
 */
export function createCore(store, notes, { isCalm, nextFrame, waits }) {
  const { get, patch } = store;
  let lastProgress = 0;
  /** Whether the display stays where it is. */
  let isHeld = false;
  /** @type {Track} */
  const lead = { clip: new Clip(), u: 0, isOpen: () => get().running };
  /** With those that go on beside it. */
  const tracks = () => [lead, ...get().comparison.rivals];

  const solver = createSolver(
    {
      onReady: (version) => patch({ version }),
      onFrame,
      onStopped(reading, fault) {
        const { film, goal } = get();
        const isHalf = film === "back" && goal === null && isOver(reading.status) && !fault;
        patch({ reading, running: isHalf, goal: null, progress: null });
        if (isHalf) return void enqueue(forth);
        if (fault) notes.error(fault, core.offers(fault));
        // The last step's own report does not know that it was the last.
        const { last } = lead.clip;
        if (last?.state.step === reading.step) last.state = reading;
        player.redraw();
        if (isStill()) show(reading.step);
      },
      onProgress(progress) {
        lastProgress = performance.now();
        patch({ progress });
      },
      onSilent: (isSilent) => patch({ isSilent }),
      onCrashed: (reason) => revive((step) => ({ id: "solver-crashed", values: { reason, step } })),
    },
    waits,
  );

  const player = createPlayer({
    tracks,
    lockstep: () => get().comparison.lockstep,
    isCalm,
    nextFrame,
    // What is asked of the solver is of what is shown.
    onEnd: () => void enqueue(settle),
  });
  const isStill = () => player.motion.peek() === "still";

  /** @param {Frame} frame */
  function onFrame(frame) {
    const { state, stored, timeline, curves, jump, look, flow, reports } = frame;
    batch(() => {
      const isFollowed = !stored && !isHeld && isStill();
      take(lead, frame, isFollowed);
      if (isFollowed) player.place(lead.u);
      const { range, options, extras, lookOptions } = get();
      const isShown = isFollowed || !extras;
      // A remeshing gives what was picked another number.
      const probe = look?.probe?.vertex ?? lookOptions.probe;
      const first = lead.clip.points[0]?.field;
      patch({
        timeline,
        ...(!stored && { reading: state, preview: null }),
        ...(performance.now() - lastProgress > LASTS && { progress: null }),
        ...(isShown && { extras: { curves, jump, look }, lookOptions: { ...lookOptions, probe } }),
        ...(range === null && first && { range: rangeOf(first) }),
        ...(flow && { options: { ...options, ...flow.options }, configured: flow.configured }),
      });
      player.arrived();
    });
    const warnings = reports.flatMap((report) => report.warnings);
    unsaid.push(...warnings.map((warning) => ({ warning, step: state.step })));
    // Not before the display is there.
    if (isStill()) sayWarnings();
  }

  /** Warnings of steps that are not shown yet. @type {{ warning: Message, step: number }[]} */
  let unsaid = [];
  function sayWarnings() {
    const step = shown()?.step ?? 0;
    for (const one of unsaid) if (one.step <= step) notes.note(say(one.warning), one.warning.id);
    unsaid = unsaid.filter((one) => one.step > step);
  }

  /** Shows a step of the clip. @param {number} step */
  function show(step) {
    const point = lead.clip.points[Math.max(lead.clip.indexOf(step), 0)];
    if (point) player.place(point.sum);
  }

  /** The clip of another path, and where the solver stands on it. */
  async function refill() {
    await solver.stored();
    show(get().reading?.step ?? 0);
  }

  /** The step that is shown: while it plays the last that was passed. */
  const shownIndex = () =>
    player.motion.peek() === "playing" ? lead.clip.at(lead.u).index : lead.clip.nearest(lead.u);
  /** @returns {Reading | null} */
  const shown = () => lead.clip.points[shownIndex()]?.state ?? get().reading;

  /** @param {any} error  a `Fault`, a refusal, or an error of the page's own */
  function report(error) {
    // Whoever ended the solver has said so already.
    if (error?.kind === LOST || error?.kind === CANCELLED) return;
    const fault = faultOf(error);
    notes.error(fault, fault.kind ? core.offers(fault) : []);
    if (!fault.kind) console.error(error);
  }

  // One thing at a time: a load followed by its options must not mix with another load.
  /** @type {Promise<unknown>} */
  let queue = Promise.resolve();
  // What was asked of a solver that is gone is not asked of the next one.
  let age = 0;
  /** @template T @param {() => T | Promise<T>} job @returns {Promise<T | void>} */
  function enqueue(job) {
    const asked = age;
    const done = queue.then(() => (asked === age ? job() : undefined)).catch(report);
    queue = done;
    return done;
  }

  /**
   * What changes the run is done once all is at rest, and where it may be.
   * @template {Record<string, (...given: any[]) => unknown>} T
   * @param {T} jobs @param {() => boolean} [may]
   * @returns {{ [K in keyof T]: (...given: Parameters<T[K]>) => Promise<Awaited<ReturnType<T[K]>> | void> }}
   */
  function atRest(jobs, may = () => true) {
    const queued = Object.entries(jobs).map(([name, job]) => {
      const done = async (/** @type {any[]} */ given) => {
        await rest();
        if (may()) return job(...given);
      };
      return [name, (/** @type {any[]} */ ...given) => enqueue(() => done(given))];
    });
    return Object.fromEntries(queued);
  }

  /** How what is in hand is given up. @type {(() => Promise<unknown>) | null} */
  let ending = null;

  /**
   * Does what solvers can give up in its middle, a single step or an edit.
   * @template T @param {() => Promise<T>} ask @param {(typeof solver)[]} [solvers] @returns {Promise<T>}
   */
  async function stoppable(ask, solvers = [solver]) {
    ending = () => Promise.all(solvers.map((one) => one.ask("pause")));
    try {
      return await ask();
    } finally {
      ending = null;
      patch({ progress: null });
    }
  }

  /** Says what is under way until it is done. @template T @param {string} stage @param {() => Promise<T>} ask */
  function during(stage, ask) {
    patch({ progress: { stage, fraction: 0 } });
    return ask().finally(() => patch({ progress: null }));
  }

  /** Gives it up, and all stays as it was. @returns {Promise<boolean>} whether there was something */
  async function giveUp() {
    if (!ending) return false;
    await ending().catch(report);
    return true;
  }

  /** Lets the solver go elsewhere while the display stays where it is. @template T @param {() => Promise<T>} ask */
  function held(ask) {
    isHeld = true;
    return ask().finally(() => {
      isHeld = false;
    });
  }

  /** Ends a run, and puts the solver where the display stands: at a true step. */
  async function settle() {
    if (get().running) {
      const reading = await held(() => solver.ask("pause"));
      patch({ reading, running: false, goal: null, progress: null });
    }
    await core.beside.settle();
    if (player.motion.peek() === "playing") return;
    player.stop();
    const wanted = shown();
    const { reading } = get();
    if (wanted && reading && wanted.step !== reading.step) await solver.seek(wanted.step);
    else if (wanted) show(wanted.step);
    sayWarnings();
  }

  /** The display and the solver come to rest. */
  async function rest() {
    if (!isStill()) player.stop();
    await settle();
  }

  /** A clip of another surface, or of the same from its start. @param {boolean} [isSame] */
  function anew(isSame = false) {
    player.stop();
    lead.clip.clear(get().mesh?.triangles);
    lead.u = 0;
    unsaid = [];
    patch({ extras: null, marks: null, film: null, ...(!isSame && { range: null }) });
    player.redraw();
  }

  /** Another flow, from the start or on from what is shown. @param {Options} options @param {"configure" | "continueWith"} [way] */
  async function configure(options, way = "configure") {
    const before = get().options;
    // Its frame comes before its answer, and is of this flow.
    patch({ options });
    try {
      if (way === "configure") anew(true);
      const configured = await solver.configure(options, way);
      patch({ configured, reading: configured.state, running: false });
      notes.settle();
    } catch (error) {
      patch({ options: { ...before } });
      // Where it is refused the run is as it was, and the display is to be so too.
      if (way === "configure" && get().reading) await refill().catch(() => {});
      throw error;
    }
    await core.beside.follow();
  }

  /** Colours of all steps that are kept. @param {FieldName} name */
  async function colour(name) {
    const field = await solver.ask("colour", { field: name });
    const { clip } = lead;
    patch({ colour: name, range: null });
    for (const point of clip.points) point.field = null;
    const point = clip.points[clip.indexOf(get().reading?.step ?? 0)];
    if (point) point.field = field;
    if (clip.points.length === 1 && field) patch({ range: rangeOf(field) });
    player.redraw();
    await core.beside.colour(name);
    if (clip.points.length > 1 && name !== "none") await solver.stored();
  }

  /** Ends the worker and goes on in a new one. @param {(step: number) => { id: string, values: any }} tell */
  function revive(tell) {
    age += 1;
    solver.dismiss();
    player.stop();
    return enqueue(async () => {
      const { timeline, earlier, mesh, version } = get();
      const isEdited = earlier.length > 0;
      const steps = (timeline?.stored ?? 0) > 1 ? "steps" : "";
      const what = steps && isEdited ? "both" : isEdited ? "edits" : steps;
      // The new solver has a mesh edited here as a file of its own.
      const origin = isEdited ? null : get().origin;
      const lost = { running: false, goal: null, progress: null, timeline: null };
      patch({ ...lost, phase: "loading", loadingName: null, earlier: [], origin });
      try {
        if (version === "") {
          const [message, hint] = [say("solver-not-started"), say("solver-not-started.hint")];
          throw { kind: "NoSolver", message, hint };
        }
        const reading = await solver.revive();
        if (reading) {
          const { film } = get();
          lead.clip.keep(reading.step, film ? reading.step : Number.POSITIVE_INFINITY);
          patch({ film: film && "cut" });
          show(reading.step);
        }
        patch({ phase: mesh ? "ready" : "empty", reading });
        const { id, values } = tell(reading?.step ?? 0);
        const hint = `${what && say("lost-with-solver", { what })} ${say(`${id}.hint`)}`.trim();
        notes.error({ message: say(id, values), hint });
      } catch (error) {
        // Ended once more: then another one is on its way.
        if (/** @type {any} */ (error)?.kind === LOST) return;
        patch({ phase: "failed" });
        report(error);
      }
    });
  }

  /** Steps until told to pause, while the display follows at its own pace. */
  async function run() {
    const { film, figure, reading } = get();
    const isBack = film === "back";
    const end = isBack ? lead.clip.points[0] : lead.clip.last;
    const isNew = end !== null && end.state.step >= 0;
    if (isBack && figure && isNew) await solver.turn(figure.id, true);
    else if (end && reading?.step !== end.state.step) await held(() => solver.seek(end.state.step));
    patch({ running: true });
    await solver.run(null);
  }

  /** Where some of a film was lost, its figure begins anew. */
  async function mend() {
    const { film, figure, options } = get();
    if (film !== "cut" || !figure) return;
    await solver.turn(figure.id, false);
    await configure(options);
  }

  /** The half that is shown backwards is there: the film begins, and goes on into the other one. */
  async function forth() {
    const { film, figure } = get();
    if (film !== "back" || !figure) return;
    patch({ film: "whole" });
    patch({ reading: await solver.turn(figure.id, false) });
    if (!core.isOver()) await run();
    player.begin(true);
  }

  const nothing = async () => {};
  const core = {
    ...{ store, state: store.state, get, patch, notes, solver, player, lead, tracks },
    ...{ enqueue, atRest, rest, settle, anew, refill, show, shown, shownIndex, isStill },
    ...{ configure, colour, run, mend, revive, report, stoppable, during, giveUp },
    /** Whether the last step is the last there will be. */
    isOver: () => isOver(lead.clip.last?.state.status ?? "ready"),
    // What the groups of actions know, and put in their place.
    /** @type {(fault: Fault) => readonly Offer[]} */
    offers: () => [],
    /** Marks what a repair changed, and says so. @type {(loaded: Loaded) => void} */
    showRepairs: () => {},
    /** What goes on beside. @type {Record<"settle" | "follow" | "run", () => Promise<unknown>> & { colour: (name: FieldName) => Promise<unknown> }} */
    beside: { settle: nothing, follow: nothing, run: nothing, colour: nothing },
  };
  return core;
}

/** @typedef {ReturnType<typeof createCore>} Core */
