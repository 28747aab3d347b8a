// The solver's side: one session, of which the page asks by commands, and a run loop that lets
// messages in after every step.

/** @import { Finding } from "./library.js" */
/** @import { Fault as Refusal } from "./generated/types.js" */
/** @import { AnswerOf, CommandName, FieldsOf, Loose } from "./session.js" */

import { provide } from "./deferred.js";
import init, { Session } from "./pkg/solver/solver.js";
import { refusal } from "./refusal.js";
import { isOver, perform } from "./session.js";

/**
 * A request: a command of the session, or one of `own`, with its fields. `run` is the number of
 * the run that it begins, and ends the one at hand; with `shown` a frame follows the answer.
 * `permit` comes with a number: a URL that is revoked where the edit, or a step of that run, is to
 * be given up.
 * Each is answered by one `{ id, ok }` or `{ id, error }`.
 * @typedef {{ id: number, name: string, fields: any, run?: number, shown?: boolean, permit?: string }} Request
 */
/** @typedef {typeof own} Own */
/** @typedef {{ format: string, every: number }} Every */
/** @typedef {keyof Own | CommandName} Name */
/** @template N @typedef {N extends keyof Own ? NonNullable<Parameters<Own[N]>[0]> : N extends CommandName ? Loose<FieldsOf<N>> : never} Asked */
/** @template N @typedef {N extends keyof Own ? Awaited<ReturnType<Own[N]>> : N extends CommandName ? AnswerOf<N> : never} Answered */

/** @type {{ onmessage: ((event: MessageEvent) => void) | null, postMessage: (message: unknown, transfer?: Transferable[]) => void }} */
const page = /** @type {any} */ (self);

/** @type {Session} */
let session;
let run = 0;
let running = false;
/** @type {number | null} the step to pause at by itself */
let until = null;
/** Frames of the run that the page has not taken: every step is shown, so a fast run waits. */
let owed = 0;
const MOST_OWED = 4;
/** Work shorter than this says nothing of its progress. */
const PATIENCE = 500;
let nextProgress = 0;
let nextLife = 0;
/**
 * What is done a piece at a time; whatever begins a run ends it, and for whatever else is asked
 * meanwhile it stands aside.
 * @type {{ end: () => unknown, aside: () => unknown } | null}
 */
let task = null;
/** Milliseconds between two looks at the messages, where pieces are short. */
const TURN = 30;
/** Where a step is not to go on; null where that cannot be told. @type {string | null} */
let permit = null;
/** Milliseconds between two looks at it; more, up to five times as many, where one takes long. */
const LOOK = 40;
let nextLook = 0;

// A message to ourselves, so that the page's messages get their turn after every step;
// a timer would be held back to one step in four milliseconds.
const turns = new MessageChannel();
// A turn of an older run must not join a newer one.
turns.port1.onmessage = ({ data }) => running && data === run && guarded(advance);

/** One step of a run. */
function advance() {
  // Goes on when the page has taken some.
  if (owed >= MOST_OWED) return;
  /** @type {Refusal | null} */
  let fault = null;
  let report = null;
  const permitted = permit;
  try {
    report = perform(session, "step");
  } catch (error) {
    if (isTrap(error)) throw error;
    fault = asRefusal(error);
  }
  if (!report && !fault && permit !== permitted) {
    // A message says why. Where there is none, the URL could not be fetched: then it is left alone.
    setTimeout(() => turns.port2.postMessage(run), LOOK);
    return;
  }
  const state = perform(session, "state");
  // On the way to a step a limit is none: how far a minute goes depends on the machine.
  const isEnd = isOver(state.status) && !(report && until !== null && state.status === "stepLimit");
  if (!report || isEnd || report.step >= (until ?? Infinity)) {
    rest();
    page.postMessage({ type: "stopped", run, state, fault });
    return;
  }
  frame();
  turns.port2.postMessage(run);
}

/** Shows the page where the session stands. @param {boolean} [stored]  and not that it has moved */
function frame(stored = false) {
  const shown = session.frame();
  page.postMessage({ type: "frame", run, stored, ...shown }, buffersOf(shown));
  owed += 1;
}

/** No more steps for now. */
function rest() {
  running = false;
  frame();
  fetchAhead();
}

/** Gives up what is done a piece at a time. */
function endTask() {
  if (!task) return;
  const { end } = task;
  task = null;
  end();
}

/** Shows every stored step of the path. What is asked between two of them is of where it stood. */
async function stored() {
  endTask();
  const { at, start } = perform(session, "timeline");
  const back = () => perform(session, "seek", { step: at });
  /** @type {number | null} */
  let next = start;
  const piece = () => {
    if (next === null) return true;
    perform(session, "seek", { step: next });
    frame(true);
    ({ next } = perform(session, "timeline"));
    return null;
  };
  const done = await inTurns(piece, { end: back, aside: back });
  if (done) back();
  return done !== null;
}

/**
 * Does pieces of work, letting messages in after each.
 * @template T @param {() => T | null} piece  null until it is the last
 * @param {NonNullable<typeof task>} [begun]  what is to be done where something else comes first
 * @returns {Promise<T | null>} null where something else came first
 */
async function inTurns(
  piece,
  begun = { end: () => perform(session, "cancelReplay"), aside: () => {} },
) {
  const { port1, port2 } = new MessageChannel();
  task = begun;
  try {
    while (task === begun) {
      const done = piece();
      if (done !== null) return done;
      live();
      await new Promise((resolve) => {
        port1.onmessage = resolve;
        port2.postMessage(null);
      });
    }
    return null;
  } finally {
    port1.close();
    if (task === begun) task = null;
  }
}

/** Runs a figure to its end, on surfaces of its own. @param {string} id */
async function measured(id) {
  endTask();
  const run = session.figureRun(id);
  try {
    return await inTurns(() => /** @type {Finding | null} */ (run.advance()));
  } finally {
    run.free();
  }
}

/** Does again what a recipe or a link says. @param {"prepare" | "follow"} name @param {any} fields */
async function replayed(name, fields) {
  endTask();
  perform(session, name, fields);
  const done = await inTurns(() => {
    const end = performance.now() + TURN;
    const permitted = permit;
    do {
      const { share, isDone } = perform(session, "advance");
      tell("replay", share);
      if (isDone) return true;
    } while (permit === permitted && performance.now() < end);
    return null;
  });
  if (!done) throw refusal("Cancelled", "worker-cancelled");
}

/** Fetched when it is first asked for. */
const zipping = () => import("./sequence.js");
/** What is asked of the worker itself. */
const own = {
  /** What a figure comes to: of what is shown, where that is all of it, or of a run of its own. */
  judge: (/** @type {{ figure: string }} */ { figure }) =>
    /** @type {Finding | null} */ (session.judge(figure)) ?? measured(figure),
  /** Steps until then, or until the run is over: ends with one `stopped` unless paused. */
  run(/** @type {{ until: number | null }} */ fields) {
    until = fields.until;
    owed = 0;
    running = true;
    turns.port2.postMessage(run);
    return true;
  },
  /** The step in hand was given up for it: where the session stands. */
  pause() {
    if (running) rest();
    return perform(session, "state");
  },
  /** Makes the mesh of a recipe or a link; the one at hand stays until it is there. */
  prepare: (/** @type {Loose<FieldsOf<"prepare">>} */ fields) =>
    replayed("prepare", fields).then(() => perform(session, "loaded")),
  /** Does what a recipe or a link says after its edits. */
  follow: (/** @type {Loose<FieldsOf<"follow">>} */ fields) =>
    replayed("follow", fields).then(() => perform(session, "state")),
  stored,
  sequence: async (/** @type {Every} */ { format, every }) =>
    (await zipping()).sequence(session, format, every, (share) => tell("sequence", share)),
  sequenceSize: async (/** @type {Every} */ { format, every }) =>
    (await zipping()).sequenceSize(session, format, every),
};

/**
 * Every typed array of an answer is a copy of its own and can be handed over.
 * @param {any} answer @returns {Transferable[]}
 */
function buffersOf(answer) {
  if (ArrayBuffer.isView(answer)) return [answer.buffer];
  if (answer === null || typeof answer !== "object") return [];
  return Object.values(answer).flatMap(buffersOf);
}

/** @param {unknown} error  whether the wasm instance is dead, and not just unwilling */
const isTrap = (error) => error instanceof WebAssembly.RuntimeError || error instanceof RangeError;

/** @param {any} error @returns {Refusal} */
const asRefusal = (error) =>
  typeof error?.kind === "string"
    ? error
    : refusal("Internal", "worker-internal", { reason: String(error?.message ?? error) });

/** Nothing may be asked of a session after a trap. @param {() => unknown} work */
async function guarded(work) {
  nextProgress = performance.now() + PATIENCE;
  nextLook = performance.now() + LOOK;
  try {
    await work();
  } catch (error) {
    running = false;
    page.onmessage = null;
    crashed(error);
  }
}

const crashed = (/** @type {any} */ error) =>
  page.postMessage({ type: "crashed", message: String(error?.message ?? error) });

/** The page has taken a frame of a run. @param {number} number */
function acknowledge(number) {
  if (number !== run || owed === 0) return;
  const waited = owed >= MOST_OWED;
  owed -= 1;
  if (running && waited) turns.port2.postMessage(run);
}

/** @param {Request} request */
async function answer({ id, name, fields, run: number, shown, permit: given }) {
  if (number !== undefined) {
    running = false;
    run = number;
    permit = given ?? null;
    endTask();
  }
  try {
    task?.aside();
    const ok = await (Object.hasOwn(own, name)
      ? /** @type {any} */ (own)[name](fields)
      : perform(session, /** @type {CommandName} */ (name), fields));
    // While a run goes on its next frame shows it.
    if (shown && !running) frame();
    page.postMessage({ id, ok }, buffersOf(ok));
  } catch (error) {
    if (isTrap(error)) throw error;
    page.postMessage({ id, error: asRefusal(error) });
  }
}

/**
 * Within long work.
 * @param {string} stage  none where there is no more to tell than that it goes on
 * @param {number} fraction @returns {boolean} whether it is to be given up
 */
function progressed(stage, fraction) {
  if (stage) tell(stage, fraction);
  else live();
  return isRevoked();
}

/** Whether the page has revoked what it gave with the run. */
function isRevoked() {
  const before = performance.now();
  if (permit === null || before < nextLook) return false;
  try {
    const request = new XMLHttpRequest();
    request.open("GET", permit, false);
    request.send();
  } catch {
    permit = null;
    return true;
  }
  const after = performance.now();
  nextLook = after + Math.min(Math.max(LOOK, 10 * (after - before)), 5 * LOOK);
  return false;
}

/** @param {string} stage @param {number} fraction */
function tell(stage, fraction) {
  const now = performance.now();
  if (now < nextProgress) return;
  nextProgress = now + 100;
  page.postMessage({ type: "progress", run, stage, fraction });
}

/** A sign of life, once a second at most, where nothing else is said between steps. */
function live() {
  const now = performance.now();
  if (now < nextLife) return;
  nextLife = now + 1000;
  page.postMessage({ type: "alive" });
}

const second = new URL("./pkg/solver/split_deferred.wasm", import.meta.url);
/** The solver's second file, once it has come. @type {WebAssembly.Module | null} */
let deferred = null;
let isAhead = false;

/** Fetches it while there is time: after the first run. */
async function fetchAhead() {
  if (isAhead) return;
  isAhead = true;
  // Where that fails it is fetched when it is needed.
  deferred = await WebAssembly.compileStreaming(fetch(second)).catch(() => null);
}

provide(() => {
  if (deferred) return deferred;
  const request = new XMLHttpRequest();
  request.open("GET", second, false);
  request.responseType = "arraybuffer";
  request.send();
  return new WebAssembly.Module(request.response);
});

const wasm = new URL("./pkg/solver/solver_bg.wasm", import.meta.url);
const started = init({ module_or_path: wasm }).then(() => {
  session = new Session();
  session.onProgress(progressed);
  Session.warmUp();
  page.postMessage({ type: "ready", version: Session.version() });
});
started.catch(crashed);

page.onmessage = ({ data }) =>
  started.then(
    () => guarded(() => (data.ack === undefined ? answer(data) : acknowledge(data.ack))),
    () => {},
  );
