// @ts-check
// What a user can ask for, as functions: each asks the solver and moves the state on.
// Nothing here touches the document.

/** @import { Arrangement, Fault, FieldName, Frame, Loaded, Stopped } from "./protocol.js" */
/** @import { Scene } from "./link.js" */
/** @import { Options } from "./options.js" */
/** @import { Marks, Source, Store, View } from "./state.js" */

import { createEdits } from "./actions/edits.js";
import { createQuestions } from "./actions/questions.js";
import { createWhyActions } from "./actions/why.js";
import { defaults, plainArrangement } from "./options.js";
import { samples } from "./samples.js";
import { createSolver, LOST } from "./solver.js";
import { transitions as to } from "./state.js";

/**
 * @typedef {object} Voice  how the controller speaks to the user
 * @property {(fault: Pick<Fault, 'message' | 'hint'>) => void} error
 * @property {(text: string) => void} note    worth knowing, said once
 * @property {(text: string) => void} answer  to what was asked for, said every time
 * @property {() => void} clear   a new mesh: what was said of the old one no longer holds
 */

/** @param {Store} store @param {Voice} voice */
export function createController(store, voice) {
  const solver = createSolver({
    onReady: (version) => store.update(to.solverReady, version),
    onFrame,
    onStopped,
    onProgress: (progress) => store.update(to.progress, progress),
    onCrashed: (reason) =>
      revive((step) => ({
        message: `The solver stopped unexpectedly (${reason}); a new one goes on from step ${step}.`,
        hint: "If it was short of memory, close other tabs or use a mesh with fewer faces.",
      })),
  });

  /** @param {Frame} frame */
  function onFrame(frame) {
    store.update(to.frame, frame);
    for (const text of frame.reports.flatMap(({ warnings }) => warnings)) voice.note(text);
  }

  /** @param {Stopped} stopped */
  function onStopped({ state, fault }) {
    store.update(to.stopped, state);
    if (fault) voice.error(fault);
  }

  /** @param {any} error  a `Fault`, or an error of the page's own */
  function report(error) {
    // Whoever ended the solver has said so already.
    if (error?.kind === LOST) return;
    if (error?.kind) voice.error(error);
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
    store.update(to.stopped, await solver.pause());
  }

  /** Goes back to the start. @param {Options} options */
  async function configure(options) {
    store.update(to.configured, options, await solver.configure(options));
  }

  /**
   * @param {string} name  for the status line
   * @param {Source} source
   * @param {() => ReturnType<typeof solver.load>} ask
   * @param {Options} options
   * @param {Options} fallback  for a mesh that the options do not suit
   * @param {Partial<Scene>} [scene]
   * @param {import("./samples.js").Sample["fill"]} [fill]  of what is loaded, before it is shown
   */
  async function load(name, source, ask, options, fallback, scene = {}, fill = undefined) {
    await rest();
    store.update(to.loading, name);
    try {
      const mesh = fill ? await ask().then(() => filled(fill)) : await ask();
      voice.clear();
      store.update(to.loaded, source, mesh);
      for (const warning of mesh.info.warnings) voice.note(warning);
      if (scene.camera) store.update(to.looked, scene.camera);
      if (scene.arrangement) await arrange(scene.arrangement);
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
    if (scene.step) await run(scene.step);
  }

  /** @param {string} id @param {Partial<Scene>} scene */
  function loadSample(id, scene) {
    const sample = samples.find((one) => one.id === id) ?? samples[0];
    const suggested = { ...defaults, ...sample.options };
    const options = { ...suggested, ...scene.options };
    const source = /** @type {const} */ ({ kind: "sample", id: sample.id });
    const ask = () => solver.sample(sample.shape, sample.parameters);
    return load(sample.label, source, ask, options, suggested, scene, sample.fill);
  }

  /** @param {NonNullable<import("./samples.js").Sample["fill"]>} wanted @returns {Promise<Loaded>} */
  async function filled(wanted) {
    if (wanted !== "inner") return (await solver.fill(wanted)).loaded;
    const loops = await solver.loops();
    const longest = Math.max(...loops.map(({ length }) => length));
    const inner = loops.flatMap(({ length }, n) => (length < longest ? [n] : []));
    return (await solver.fill({ loops: inner })).loaded;
  }

  /** @param {Partial<Arrangement>} change */
  async function arrange(change) {
    const arrangement = { ...store.get().arrangement, ...change };
    store.update(to.arranged, arrangement);
    await solver.arrange(arrangement);
  }

  /** @param {FieldName} name */
  async function colour(name) {
    store.update(to.coloured, name, await solver.colour(name));
  }

  /** @param {number | null} until */
  async function run(until) {
    const { phase, reading } = store.get();
    if (!reading || phase === "running" || phase === "loading") return;
    store.update(to.started, until);
    await solver.run(until);
  }

  let reviving = false;
  /** Ends the worker and goes on in a new one. @param {(step: number) => Pick<Fault, 'message' | 'hint'>} tell */
  function revive(tell) {
    // A crash on the way back is reported by the request that met it.
    if (reviving) return queue;
    reviving = true;
    age += 1;
    solver.dismiss();
    return enqueue(async () => {
      store.update(to.reviving);
      try {
        if (store.get().version === "") throw new Error("The solver could not be started.");
        const reading = await solver.revive();
        if (reading) store.update(to.stopped, reading);
        else store.update(to.refused);
        voice.error(tell(reading?.step ?? 0));
      } catch (error) {
        store.update(to.failed);
        const { message } = /** @type {Error} */ (error);
        voice.error({ message, hint: "Reload the page; its address keeps the scene." });
      } finally {
        reviving = false;
      }
    });
  }

  /** @type {import("./actions/core.js").Core} */
  const core = { store, solver, voice, enqueue, rest, configure, colour, arrange };
  const edits = createEdits(core);

  const controller = {
    ...edits.actions,
    ...createQuestions(solver),
    ...createWhyActions(core, edits, run),
    begin: solver.begin,

    /** @param {string} id @param {Partial<Scene>} [scene] */
    sample: (id, scene = {}) => enqueue(() => loadSample(id, scene)),

    /** A figure of a paper: its sample, flow and parameters. @param {import("./figures.js").Figure} figure */
    figure: (figure) =>
      enqueue(async () => {
        const arrangement = { ...plainArrangement, ...figure.arrangement };
        const scene = { options: figure.options, arrangement, colour: figure.colour ?? "none" };
        await loadSample(figure.sample, scene);
        store.update(to.figured, figure);
      }),

    /** @param {File} file @param {Partial<Scene>} [scene] */
    open: (file, scene = {}) =>
      enqueue(async () => {
        const bytes = await file.arrayBuffer();
        const name = file.name.replace(/\.[^.]+$/, "");
        // Of what an earlier mesh was shown with, the choice of flow is the user's; the rest
        // says nothing about this one.
        const { flow, boundary, p, keep, regularise } = store.get().options;
        const plain = { ...defaults, boundary };
        const options = { ...plain, flow, p, keep, regularise, ...scene.options };
        const ask = () => solver.load(file.name, bytes);
        return load(file.name, { kind: "file", name }, ask, options, plain, scene);
      }),

    play: () => enqueue(() => run(null)),
    /** Answered after the step in hand, so not queued behind anything. */
    pause: () => rest().catch(report),
    toggle: () => (store.get().phase === "running" ? controller.pause() : controller.play()),
    step: () => enqueue(() => rest().then(() => store.get().reading && solver.step())),
    back: () =>
      enqueue(async () => {
        await rest();
        if (store.get().reading?.canStepBack) await solver.back();
      }),
    reset: () => enqueue(() => rest().then(() => store.get().reading && solver.reset())),

    /** Ends a step that takes too long. */
    halt: () =>
      revive((step) => ({
        message: `The computation was ended; the surface is as after step ${step}.`,
        hint: "",
      })),

    /** @param {Partial<Options>} change */
    configure: (change) =>
      enqueue(async () => {
        await rest();
        const { options: before, reading } = store.get();
        const options = { ...before, ...change };
        try {
          if (before.flow === "flips" && options.flow !== "flips" && reading && reading.step > 0) {
            // The point of better edges is what is done with them next.
            await edits.adopt(options, `${reading.step} flips`);
            voice.answer(
              "The flow starts from the mesh with its edges flipped; Undo brings the one before back.",
            );
          } else await configure(options);
        } catch (error) {
          // Told again, so that the form shows what is in force.
          store.update((state) => ({ ...state, options: { ...before } }));
          throw error;
        }
      }),
    /** @param {FieldName} name */
    colour: (name) => enqueue(() => colour(name)),
    /** How edge flips are shown; a run goes on. @param {Partial<Arrangement>} change */
    arrange: (change) => enqueue(() => arrange(change)),
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
     * @returns {Promise<Uint8Array<ArrayBuffer> | string>}
     */
    export: (format) => (format === "csv" ? solver.history() : solver.export(format)),
    report,
  };
  return controller;
}

/** @typedef {ReturnType<typeof createController>} Controller */
