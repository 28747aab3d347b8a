// @ts-check
// The solver's side: one session, a table of what may be asked of it, and a run loop
// that lets messages in after every step.

/** @import { Configured, FieldName, Finding, Pane, Refusal, Request, State, StepReport, Wanted } from "./protocol.js" */

import init, { FigureRun, Session } from "./pkg/solver/solver.js";
import { follow, prepare } from "./recipe.js";
import { sequence, sequenceSize } from "./sequence.js";
import { isOver } from "./standing.js";

/** @type {{ onmessage: ((event: MessageEvent) => void) | null, postMessage: (message: unknown, transfer?: Transferable[]) => void }} */
const page = /** @type {any} */ (self);

/** @type {Session} */
let session;
/** @type {FieldName} */
let field = "none";
/** @type {Wanted | null} what is looked at more closely */
let wanted = null;
let run = 0;
let running = false;
/** @type {number | null} the step to pause at by itself */
let until = null;
/** Whether the page has taken the last frame of the run. */
let taken = true;
/** Whether each step is to be seen: edge flips are far faster than any screen. */
let paced = false;
/** The flow whose options the page knows. */
let toldFlow = 0;
/** Work shorter than this says nothing of its progress. */
const PATIENCE = 500;
let nextProgress = 0;
/** @type {FigureRun | null} that is measured now, on surfaces of its own */
let figureRun = null;
/** @type {StepReport[]} of the steps no frame has told of yet */
let untold = [];

// A message to ourselves, so that the page's messages get their turn after every step;
// a timer would be held back to one step in four milliseconds.
const turns = new MessageChannel();
// A turn of an older run must not join a newer one.
turns.port1.onmessage = ({ data }) => running && data === run && guarded(advance);

/** One step of a run. */
function advance() {
  // Goes on when the page has taken the last frame.
  if (paced && until === null && !taken) return;
  /** @type {StepReport | null} */
  let report = null;
  /** @type {Refusal | null} */
  let fault = null;
  try {
    report = session.step() ?? null;
    if (report) untold.push(report);
  } catch (error) {
    if (isTrap(error)) throw error;
    fault = asRefusal(error);
  }
  const state = session.state();
  // On the way to a step a limit is none: how far a minute goes depends on the machine.
  const isEnd = isOver(state.status) && !(report && until !== null && state.status === "stepLimit");
  if (!report || isEnd || report.step >= (until ?? Infinity)) {
    running = false;
    frame(state);
    page.postMessage({ type: "stopped", run, state, fault });
    return;
  }
  if (taken) frame(state);
  turns.port2.postMessage(run);
}

/** Shows the page where the session stands. @param {State} state */
function frame(state) {
  const positions = session.positions();
  /** @type {Pane[]} */
  const panes = session.panes(field);
  const colours = panes.length > 0 ? null : session.field(field);
  const jump = state.flips ? null : session.curvatureJump();
  const flippedTriangles = session.flippedTriangles();
  const curves = state.flips ? session.curves() : null;
  const look = wanted && session.look(wanted);
  const transfer = [positions.buffer, flippedTriangles.buffer, ...buffersOf(colours)];
  transfer.push(...buffersOf(look));
  for (const pane of panes) transfer.push(...buffersOf(pane));
  const message = { type: "frame", run, state, reports: untold, positions, field: colours };
  const rest = {
    timeline: session.timeline(),
    ...(running ? {} : { story: storyIfKnown() }),
    ...flowIfAnother(),
  };
  page.postMessage({ ...message, flippedTriangles, panes, curves, jump, look, ...rest }, transfer);
  untold = [];
  taken = false;
}

/** The flow that stands where the session does, if it is not the one the page knows of. */
function flowIfAnother() {
  const number = session.flowNumber();
  if (number === toldFlow) return {};
  toldFlow = number;
  const options = session.options();
  return options ? { flow: { options, configured: whole(session.configured()) } } : {};
}

/** @param {Omit<Configured, "heldVertices">} configured @returns {Configured} */
const whole = (configured) => ({ ...configured, heldVertices: session.heldVertices() });

/** How the surface came about; null where positions came from outside. */
function storyIfKnown() {
  try {
    return session.recipe();
  } catch (error) {
    if (isTrap(error)) throw error;
    return null;
  }
}

/**
 * Pictures a single move at once; the page asks for these one by one.
 * @template T
 * @param {number} number  of the run this move is
 * @param {() => T} move
 */
function moved(number, move) {
  running = false;
  run = number;
  untold = [];
  const answer = move();
  frame(session.state());
  return answer;
}

/**
 * Shows another stored moment; the page learns of the steps after `known` again.
 * @param {number} known  up to here the page knows the path
 * @param {() => unknown} move
 */
function shown(known, move) {
  const answer = move();
  const samples = session.samplesAfter(known);
  for (let i = 0; i < samples.length; i += 5) {
    const [step, time, dt, energy, objective] = samples.subarray(i, i + 5);
    untold.push(/** @type {any} */ ({ step, time, dt, energy, objective, warnings: [] }));
  }
  return answer;
}

/** @param {number} share */
const replayed = (share) => tell("replay", share);

/**
 * Runs a figure to its end, letting messages in after every step.
 * @param {FigureRun} run
 * @returns {Promise<Finding | null>} null where something else came first
 */
async function measured(run) {
  const { port1, port2 } = new MessageChannel();
  figureRun = run;
  try {
    while (figureRun === run) {
      /** @type {Finding | null} */
      const finding = run.advance();
      if (finding) return finding;
      await new Promise((resolve) => {
        port1.onmessage = resolve;
        port2.postMessage(null);
      });
    }
    return null;
  } finally {
    port1.close();
    run.free();
  }
}

/** @type {Record<string, (request: any) => unknown>} */
const actions = {
  load({ bytes, name }) {
    running = false;
    figureRun = null;
    return session.load(new Uint8Array(bytes), name);
  },
  sample({ name, parameters }) {
    running = false;
    figureRun = null;
    return session.sample(name, parameters);
  },
  configure: (request) =>
    moved(request.run, () => {
      const configured = session.configure(request.options);
      paced = request.options.flow === "flips";
      toldFlow = session.flowNumber();
      return whole(configured);
    }),
  continueWith: (request) =>
    moved(request.run, () => {
      const configured = session.continueWith(request.options);
      toldFlow = session.flowNumber();
      return whole(configured);
    }),
  run(request) {
    run = request.run;
    until = request.until;
    untold = [];
    taken = true;
    running = true;
    turns.port2.postMessage(run);
    return true;
  },
  pause() {
    const state = session.state();
    const isMoving = running;
    running = false;
    if (isMoving) frame(state);
    return state;
  },
  step: (request) =>
    moved(request.run, () => {
      const report = session.step() ?? null;
      if (report) untold.push(report);
      return report;
    }),
  regularise: (request) => moved(request.run, () => session.regularise(request.options)),
  arrange({ arrangement }) {
    session.arrange(arrangement);
    const state = session.state();
    // Between a mesh and its flow there is nothing to see yet.
    if (!running && session.heldVertices().length > 0) frame(state);
    return state;
  },
  adopt: () => session.adopt(),
  undo: (request) =>
    moved(request.run, () => {
      const loaded = session.undoEdit();
      toldFlow = 0;
      paced = session.options()?.flow === "flips";
      return loaded;
    }),
  subdivide: ({ options }) => session.subdivide(options),
  loops: () => session.boundaryLoops(),
  fill(request) {
    running = false;
    run = request.run;
    const filled = session.fill(request.options, tell);
    return { filled, loaded: session.loaded() };
  },
  look(request) {
    const look = session.look(request.wanted);
    const { probe, circles, directions } = request.wanted;
    wanted = probe !== null || circles || directions ? request.wanted : null;
    return look;
  },
  previewInversion: ({ centre }) =>
    session.previewInversion(Float64Array.from(centre), field, wanted ?? {}),
  invert({ centre }) {
    running = false;
    const report = session.invert(Float64Array.from(centre));
    return { report, loaded: session.loaded() };
  },
  conjecture: () => session.conjecture(),
  quadrilateral: ({ corners }) => session.quadrilateral(corners),
  lab: ({ pairs }) => session.lab(pairs),
  why: () => session.why(),
  judge: ({ figure }) => session.judge(figure) ?? measured(session.figureRun(figure)),
  selfIntersections: () => session.selfIntersections(),
  study: ({ options }) => session.study(options),
  back: (request) => moved(request.run, () => session.back()),
  reset: (request) => moved(request.run, () => session.reset()),
  seek: ({ run, step }) => moved(run, () => shown(session.state().step, () => session.seek(step))),
  branch: ({ run, branch }) =>
    moved(run, () => shown(session.timeline().start, () => session.branch(branch))),
  story: () => ({
    story: session.recipe(),
    state: session.state(),
    positions: session.positions(),
  }),
  prepare({ recipe, bytes }) {
    running = false;
    // Beside the one at hand, which stays where this comes to nothing.
    const made = new Session();
    try {
      prepare(made, recipe, bytes && new Uint8Array(bytes), replayed);
    } catch (error) {
      if (!isTrap(error)) made.free();
      throw error;
    }
    session.free();
    session = made;
    session.onProgress(tell);
    return session.loaded();
  },
  follow: ({ run, recipe }) =>
    moved(run, () => {
      follow(session, recipe, replayed);
      return shown(session.timeline().start, () => session.state());
    }),
  sequence({ format, every }) {
    running = false;
    return sequence(session, format, every, (share) => tell("sequence", share));
  },
  sequenceSize: ({ format, every }) => sequenceSize(session, format, every),
  colour(request) {
    const colours = session.field(request.field);
    field = request.field;
    const state = session.state();
    if (!running && session.panes("none").length > 0) frame(state);
    return colours;
  },
  export: ({ format }) => session.export(format),
  history: () => session.history(),
  bending: () => session.energy({}).willmore,
  restore: ({ run, positions, step, time }) =>
    moved(run, () => session.restore(positions, step, time)),
};

/**
 * Every typed array of an answer is a copy of its own and can be handed over.
 * @param {any} answer
 * @returns {Transferable[]}
 */
function buffersOf(answer) {
  if (ArrayBuffer.isView(answer)) return [answer.buffer];
  if (typeof answer !== "object") return [];
  return Object.values(answer ?? {}).flatMap((value) =>
    ArrayBuffer.isView(value)
      ? [value.buffer]
      : value?.positions || value?.values || value?.ends
        ? buffersOf(value)
        : [],
  );
}

/** @param {unknown} error  whether the wasm instance is dead, and not just unwilling */
const isTrap = (error) => error instanceof WebAssembly.RuntimeError || error instanceof RangeError;

/** @param {any} error @returns {Refusal} */
function asRefusal(error) {
  if (typeof error?.kind === "string") {
    const { kind, message, hint, detail } = error;
    return { kind, message, hint, detail };
  }
  return {
    kind: "Internal",
    message: { id: "worker-internal", values: { reason: String(error?.message ?? error) } },
    hint: { id: "worker-internal.hint" },
    detail: {},
  };
}

/** Nothing may be asked of a session after a trap. @param {() => void} work */
function guarded(work) {
  nextProgress = performance.now() + PATIENCE;
  try {
    work();
  } catch (error) {
    running = false;
    page.onmessage = null;
    page.postMessage({
      type: "crashed",
      message: String(/** @type {any} */ (error)?.message ?? error),
    });
  }
}

/** @param {Request} request */
function answer(request) {
  if (request.type === "ack") {
    if (request.run !== run || taken) return;
    taken = true;
    if (running && paced && until === null) turns.port2.postMessage(run);
    return;
  }
  /** @param {unknown} ok */
  const reply = (ok) => page.postMessage({ id: request.id, ok }, buffersOf(ok));
  /** @param {unknown} error */
  const refuse = (error) => {
    if (isTrap(error)) throw error;
    page.postMessage({ id: request.id, error: asRefusal(error) });
  };
  try {
    const ok = actions[request.type](request);
    if (ok instanceof Promise) ok.then(reply, (error) => guarded(() => refuse(error)));
    else reply(ok);
  } catch (error) {
    refuse(error);
  }
}

/** @param {string} stage @param {number} fraction */
function tell(stage, fraction) {
  const now = performance.now();
  if (now < nextProgress) return;
  nextProgress = now + 100;
  page.postMessage({ type: "progress", run, stage, fraction });
}

const wasm = new URL("./pkg/solver/solver_bg.wasm", import.meta.url);
const started = init({ module_or_path: wasm }).then(() => {
  session = new Session();
  session.onProgress(tell);
  Session.warmUp();
  page.postMessage({ type: "ready", version: Session.version() });
});
started.catch((error) =>
  page.postMessage({ type: "crashed", message: String(error?.message ?? error) }),
);

page.onmessage = ({ data }) =>
  started.then(
    () => guarded(() => answer(data)),
    () => {},
  );
