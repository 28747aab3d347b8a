// @ts-check
// What a user can ask for, as functions: each asks the solver and moves the state on.
// Nothing here touches the document.

/** @import { Arrangement } from "./generated/schema.js" */
/** @import { Message, State } from "./generated/types.js" */
/** @import { Figure } from "./library.js" */
/** @import { FieldName, Frame } from "./state.js" */
/** @import { Fault } from "./words.js" */
/** @import { Scene } from "./link.js" */
/** @import { Options } from "./options.js" */
/** @import { Marks, Store, View } from "./state.js" */

import { createCompare } from "./actions/compare.js";
import { createContest } from "./actions/contest.js";
import { createEdits } from "./actions/edits.js";
import { createFraming } from "./actions/framing.js";
import { createQuestions } from "./actions/questions.js";
import { createSeeing } from "./actions/see.js";
import { createTime } from "./actions/time.js";
import { createWhyActions } from "./actions/why.js";
import { LOST } from "./channel.js";
import { canStepBack, comparisonTransitions as on } from "./comparison-state.js";
import { sha256 } from "./digest.js";
import { figures, samples } from "./generated/library.js";
import { t } from "./language.js";
import { sampleName } from "./library.js";
import { pageScene, sceneOf } from "./link.js";
import { defaults } from "./options.js";
import { CANCELLED, createSolver } from "./solver.js";
import { goesOn, transitions as to } from "./state.js";
import { say, sayFault } from "./words.js";

/**
 * @typedef {object} Voice  how the controller speaks to the user
 * @property {(fault: Pick<Fault, 'message' | 'hint'>) => void} error
 * @property {(text: string, key?: string) => void} note  worth knowing, said once; of what has
 *   the same key, once for all
 * @property {(text: string) => void} answer  to what was asked for, said every time
 * @property {(text: string) => Promise<boolean>} ask  whether to do what takes long
 * @property {() => void} clear   a new mesh: what was said of the old one no longer holds
 */

/**
 * @param {Store} store
 * @param {Voice} voice
 * @param {Parameters<typeof createSolver>[1]} [waits]
 */
export function createController(store, voice, waits) {
  const solver = createSolver(
    {
      onReady: (version) => store.update(to.solverReady, version),
      onFrame,
      onStopped,
      onProgress: (progress) => store.update(to.progress, progress),
      onSilent: (isSilent) => store.update(to.silent, isSilent),
      onCrashed: (reason) =>
        revive((step) => ({
          message: t(
            "The solver stopped unexpectedly ({reason}); a new one goes on from step {step}.",
            { reason, step },
          ),
          hint: t("If it was short of memory, close other tabs or use a mesh with fewer faces."),
        })),
    },
    waits,
  );

  /** A warning: with other values it is the same. @param {Message} warning */
  const note = (warning) => voice.note(say(warning), warning.id);

  /** @param {Frame} frame */
  function onFrame(frame) {
    if (framing.holds(frame) || contest.holds(frame)) return;
    store.update(to.frame, frame);
    for (const { warnings } of frame.reports) warnings.forEach(note);
  }

  /** @param {State} state @param {Fault | null} fault */
  function onStopped(state, fault) {
    store.update(to.stopped, state);
    if (fault) voice.error(fault);
  }

  /** @param {any} error  a `Fault`, a `Refusal`, or an error of the page's own */
  function report(error) {
    // Whoever ended the solver has said so already.
    if (error?.kind === LOST || error?.kind === CANCELLED) return;
    // A worker that could not be asked refuses in no language.
    if (error?.kind) voice.error(typeof error.message === "string" ? error : sayFault(error));
    else voice.error({ message: String(error?.message ?? error), hint: "" });
    if (!error?.kind) console.error(error);
  }

  // One thing at a time: a load followed by its options must not mix with another load.
  let queue = Promise.resolve();
  // What was asked of a solver that is gone is not asked of the next one.
  let age = 0;
  /** @param {() => Promise<unknown>} job */
  function enqueue(job) {
    const asked = age;
    queue = queue.then(() => (asked === age ? job() : null)).then(() => {}, report);
    return queue;
  }

  async function rest() {
    if (store.get().phase !== "running") return;
    store.update(to.pausing);
    if (contest.isPlaying()) await contest.pause();
    else store.update(to.stopped, await solver.pause());
  }

  /**
   * @param {Options} options
   * @param {"configure" | "continueWith"} [way]  back to the start, or on from where it stands
   */
  async function configure(options, way = "configure") {
    const { answer, frame } = await framed(() => solver[way](options));
    store.update(to.configured, options, answer, frame);
    await contest.follow();
  }

  /** @param {import("./actions/time.js").Loading} loading */
  async function load(loading) {
    const { name, source, origin = source, ask, options, fallback, scene = {}, fill } = loading;
    await rest();
    store.update(to.loading, name);
    try {
      const shape = await ask();
      const mesh = fill ? (await solver.fill(fill)).loaded : shape;
      voice.clear();
      store.update(to.loaded, source, mesh, origin);
      mesh.info.warnings.forEach(note);
      if (scene.camera) store.update(to.looked, scene.camera);
      compare.prepare(scene.comparison);
      // A new solver knows of none.
      await arrange(scene.arrangement ?? {});
      const suits = await configure(options).then(
        () => true,
        async (error) => {
          if (error?.kind === LOST) throw error;
          // A mesh without a flow would be a dead end: said, and another flow in its place.
          report(error);
          await configure(fallback);
          return false;
        },
      );
      await colour(scene.colour ?? store.get().colour);
      if (!suits) return;
    } catch (error) {
      store.update(to.refused);
      throw error;
    }
    const steps = scene.comparison?.panes.map(({ step }) => step) ?? [];
    if (scene.figure) showFigure(scene.figure);
    if (scene.follows) await follow(scene.follows);
    const isThere = scene.follows && steps.length === 0;
    if ((scene.step && !isThere) || steps.some(Boolean)) await run(scene.step ?? 0, steps);
  }

  /**
   * Does again what a recipe or a link says; *Stop now* gives it up.
   * @template T
   * @param {() => Promise<T>} ask
   */
  async function replayed(ask) {
    replaying = "on";
    store.update(to.progress, { stage: "replay", fraction: 0 });
    return ask().finally(() => {
      replaying = null;
      store.update(to.progress, null);
    });
  }

  /** @param {import("./generated/types.js").ScriptText} script  whose flow is configured */
  const follow = (script) => replayed(() => solver.follow(script));

  /** The figure that a link belongs to, if its sample is the one shown. @param {string} id */
  function showFigure(id) {
    const { source } = store.get();
    const figure = figures.find((one) => one.id === id);
    if (source?.kind === "sample" && figure?.sample === source.id) store.update(to.figured, figure);
  }

  /** @param {string} id @param {Partial<Scene>} scene */
  function loadSample(id, scene) {
    const sample = samples.find((one) => one.id === id) ?? samples[0];
    const suggested = { ...defaults, ...sample.options };
    const options = { ...suggested, ...scene.options };
    const source = /** @type {const} */ ({ kind: "sample", id: sample.id });
    if (scene.prepares) {
      const made = { origin: source, name: sample.shape, isPlain: false };
      return time.replay(scene.prepares, made, null, { options, fallback: suggested, scene });
    }
    const ask = () => solver.sample(sample.shape, sample.parameters);
    const { fill } = sample;
    const name = sampleName(sample.id);
    return load({ name, source, ask, options, fallback: suggested, scene, fill });
  }

  /** @param {Partial<Arrangement>} change */
  async function arrange(change) {
    const arrangement = { ...store.get().arrangement, ...change };
    store.update(to.arranged, arrangement);
    await solver.arrange(arrangement);
  }

  /** @param {FieldName} name */
  async function colour(name) {
    const field = await solver.colour(name);
    store.update(to.coloured, name, field);
    await contest.colour(name, field);
  }

  /** @param {number | null} until @param {readonly (number | null)[]} [steps]  of the panes beside */
  async function run(until, steps = []) {
    const { phase, reading } = store.get();
    if (!reading || phase === "running" || phase === "loading") return;
    store.update(to.started, until);
    if (!contest.isOpen()) await solver.run(until);
    else
      contest.play(({ step }, n) => step >= ((n > 0 ? steps[n - 1] : null) ?? until ?? Infinity));
  }

  /** What is being done again, and whether that was asked to end. @type {"on" | "ending" | null} */
  let replaying = null;

  /** What went with a solver and has not been said. @type {Set<"steps" | "edits">} */
  const losses = new Set();
  function noteLosses() {
    const { timeline, earlier } = store.get();
    if (timeline && timeline.stored > 1) losses.add("steps");
    if (earlier.length > 0) losses.add("edits");
  }
  function sayLosses() {
    const [what] = losses.size > 1 ? ["both"] : losses;
    losses.clear();
    return what ? say("lost-with-solver", { what }) : "";
  }

  /** Ends the worker and goes on in a new one. @param {(step: number) => Pick<Fault, 'message' | 'hint'>} tell */
  function revive(tell) {
    age += 1;
    time.stop();
    solver.dismiss();
    return enqueue(async () => {
      noteLosses();
      store.update(to.reviving);
      try {
        if (store.get().version === "") {
          const hint = t("Reload the page; its address keeps the scene.");
          throw { kind: "NoSolver", message: t("The solver could not be started."), hint };
        }
        const reading = await solver.revive();
        if (reading) store.update(to.stopped, reading);
        else store.update(to.refused);
        const { message, hint } = tell(reading?.step ?? 0);
        voice.error({ message, hint: [sayLosses(), hint].filter(Boolean).join(" ") });
      } catch (error) {
        // Ended once more: then another one is on its way.
        if (/** @type {any} */ (error)?.kind === LOST) return;
        store.update(to.failed);
        report(error);
      }
    });
  }

  const contest = createContest({ store, solver, voice, report });
  const framing = createFraming(contest.holds);
  const { framed } = framing;
  /** @type {import("./actions/core.js").Core} */
  const core = { store, solver, voice, enqueue, rest, framed, configure, colour, arrange };
  const edits = createEdits(core);
  const compare = createCompare(core, contest);
  const time = createTime({ ...core, load, replayed });

  /** A move of its own ends the playing of stored steps. @param {() => Promise<unknown>} job */
  function alone(job) {
    time.stop();
    return enqueue(job);
  }

  const controller = {
    ...edits.actions,
    ...compare.actions,
    ...createQuestions(solver),
    ...createSeeing(core, edits.edited),
    ...time.actions,
    ...createWhyActions(core, edits, run),
    /** Starts the solver, where that is allowed. @throws {Fault} where it is not */
    begin() {
      try {
        solver.begin();
      } catch (error) {
        store.update(to.failed);
        throw error;
      }
    },

    /**
     * The scene of a link; where a word in it cannot be, there is none.
     * @param {{ text: string, isOwn: boolean }} link  as `linkIn` finds it
     * @returns {Promise<Scene>}
     */
    readLink: async (link) => sceneOf(await solver.readLink(link)),
    /**
     * The scene as a link, of which `text` is what comes after `#`.
     * @param {boolean} [shared]  sent to somebody, so that there is always an energy to compare
     */
    writeLink: (shared = false) => solver.writeLink(pageScene(store.get(), shared)),
    /** @param {string} sent  the energy of a link @param {number} step */
    checkLink: (sent, step) => solver.checkLink(sent, step),

    /** @param {string} id @param {Partial<Scene>} [scene] */
    sample: (id, scene = {}) => enqueue(() => loadSample(id, scene)),

    /** A figure of a paper: its sample, flow and parameters. @param {Figure} figure */
    figure: (figure) =>
      enqueue(async () => {
        const { options, arrangement, colour } = figure;
        const scene = { options, arrangement, colour, comparison: null };
        await loadSample(figure.sample, scene);
        store.update(to.figured, figure);
      }),

    /** @param {File} file @param {Partial<Scene>} [scene] */
    open: (file, scene = {}) =>
      enqueue(async () => {
        const bytes = new Uint8Array(await file.arrayBuffer());
        const name = file.name.replace(/\.[^.]+$/, "");
        // Of what an earlier mesh was shown with, the choice of flow is the user's; the rest
        // says nothing about this one.
        const { flow, boundary, p, keep, regularise } = store.get().options;
        const plain = { ...defaults, boundary };
        const options = { ...plain, flow, p, keep, regularise, ...scene.options };
        const hash = await sha256(bytes);
        const ask = () => solver.load(file.name, bytes);
        const own = { name, file: file.name, sha256: hash, bytes: bytes.byteLength };
        const source = /** @type {const} */ ({ kind: "file", ...own });
        if (scene.prepares) {
          const made = { origin: source, name, isPlain: false };
          const given = { name: file.name, bytes };
          return time.replay(scene.prepares, made, given, { options, fallback: plain, scene });
        }
        return load({ name: file.name, source, ask, options, fallback: plain, scene });
      }),

    play: () => alone(() => run(null)),
    /** Starts, and pauses by itself there. @param {number} step */
    runTo: (step) => alone(() => run(step)),
    /** Answered after the step in hand, so not queued behind anything. */
    pause: () => rest().catch(report),
    toggle() {
      const { phase, playing } = store.get();
      if (playing !== 0) return time.stop();
      return phase === "running" ? controller.pause() : controller.play();
    },
    step: () => alone(() => rest().then(() => store.get().reading && contest.step())),
    back: () =>
      alone(async () => {
        await rest();
        if (canStepBack(store.get())) await contest.back();
      }),
    reset: () => alone(() => rest().then(() => store.get().reading && contest.reset())),

    /** Ends a step that takes too long, or a solver that is silent; starts one that is gone. */
    halt() {
      const { isSilent, phase } = store.get();
      if (replaying === "on" && !isSilent) {
        replaying = "ending";
        return solver.cancel().catch(report);
      }
      if (!contest.halt() && !isSilent && phase !== "failed") return;
      revive((step) => ({
        message: t("The computation was ended; the surface is as after step {step}.", { step }),
        hint: "",
      }));
    },

    /**
     * Whether a change of the flow goes on from the step that is shown; null: where it is not
     * the last one.
     * @param {boolean | null} goesOn
     */
    goOn: (goesOn) => store.update(to.goingOn, goesOn),
    /**
     * @param {Partial<Options>} change
     * @param {{ fromStart?: boolean }} [how]
     */
    configure: (change, { fromStart = false } = {}) =>
      enqueue(async () => {
        await rest();
        const { options: before, reading, timeline } = store.get();
        const options = { ...before, ...change };
        const way = !fromStart && goesOn(store.get(), options.flow) ? "continueWith" : "configure";
        try {
          if (before.flow === "flips" && options.flow !== "flips" && reading && reading.step > 0) {
            // The point of better edges is what is done with them next.
            const count = say("count-flips", { count: reading.step });
            await edits.adopt(options, count);
            voice.answer(
              t(
                "The flow starts from the mesh with its edges flipped; Undo brings the one before back.",
              ),
            );
          } else await configure(options, way);
          if (way === "continueWith" && timeline && timeline.at < timeline.last) {
            voice.note(
              t("The flow goes on from there; the steps that were to come are kept as a branch."),
            );
          }
        } catch (error) {
          // Told again, so that the form shows what is in force.
          store.update((state) => ({ ...state, options: { ...before } }));
          throw error;
        }
      }),
    /** @param {FieldName} name */
    colour: (name) =>
      enqueue(() => {
        store.update(on.compared, { difference: null });
        return colour(name);
      }),
    /** How edge flips are shown; a run goes on. @param {Partial<Arrangement>} change */
    arrange: (change) =>
      enqueue(() => {
        if ((change.compare ?? "none") !== "none") compare.close();
        return arrange(change);
      }),
    /** @param {Marks | null} marks */
    mark: (marks) => store.update(to.marked, marks),

    /** @param {Float32Array} camera */
    look: (camera) => store.update(to.looked, camera),
    /** @param {Partial<View>} change */
    view: (change) => store.update(to.viewed, change),
    /** @param {boolean} [presenting] */
    present: (presenting) => store.update(to.presenting, presenting ?? !store.get().presenting),

    /**
     * @param {string} format  of a mesh, or `csv`
     * @returns {Promise<{ format: string, bytes: Uint8Array<ArrayBuffer> | string }>}  the format
     *   is another where the solver cannot be asked
     */
    async export(format) {
      if (format === "csv") return { format, bytes: await solver.history() };
      const file = await solver.export(format);
      if (file.format !== format) voice.answer(say("saved-own-copy"));
      return file;
    },
    report,
  };
  return controller;
}

/** @typedef {ReturnType<typeof createController>} Controller */
