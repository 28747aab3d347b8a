// The page's line to a worker: a promise for every request, events for the rest. It knows
// whether there is a worker and whether that gives signs of life, and nothing of what is asked.

/** @import { Fault } from "./words.js" */

import { fault, say, sayFault } from "./words.js";

/** Milliseconds after which a worker that owes an answer and says nothing is called silent. */
const PATIENCE = 10_000;

/** What every request is answered with that a lost worker can no longer answer. */
export const LOST = "SolverLost";

/**
 * @typedef {object} Hearer
 * @property {(message: any) => void} onEvent   what the worker says unasked
 * @property {(reason: string) => void} onLost  it has crashed; `dismiss` it
 * @property {(isSilent: boolean) => void} [onSilent]
 */

/** @param {Hearer} hearer @param {number} [patience] */
export function createChannel({ onEvent, onLost, onSilent }, patience = PATIENCE) {
  /** @type {Worker | null} */
  let worker = null;
  /** Whether it has been loaded: until then it is the network that takes its time. */
  let isReady = false;
  /** Number of the run that goes on. @type {number | null} */
  let running = null;
  let isSilent = false;
  let lastId = 0;
  /** @type {Map<number, { resolve: (ok: any) => void, reject: (fault: Fault) => void }>} */
  const waiting = new Map();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let watch;
  /**
   * A URL that the worker fetches within long steps. It has none of its messages then, and memory
   * is shared with no page that a plain host serves; but that the URL is revoked it notices.
   * @type {string | null}
   */
  let permit = null;

  /** The step at hand is given up. @param {string | null} next */
  function revoke(next) {
    if (permit !== null) URL.revokeObjectURL(permit);
    permit = next;
  }

  /** @param {boolean} now */
  function setSilent(now) {
    if (now === isSilent) return;
    isSilent = now;
    onSilent?.(now);
  }

  /** Waits for a sign of life, where one is owed. */
  function expect() {
    if (watch || isSilent || !isReady || (waiting.size === 0 && running === null)) return;
    watch = setTimeout(() => {
      watch = undefined;
      setSilent(true);
    }, patience);
  }

  /** There was one. */
  function heard() {
    clearTimeout(watch);
    watch = undefined;
    setSilent(false);
  }

  /** @param {any} message  a reply or an event */
  function receive(message) {
    heard();
    if ("id" in message) {
      const request = waiting.get(message.id);
      waiting.delete(message.id);
      if (message.error) request?.reject(sayFault(message.error));
      else request?.resolve(message.ok);
    } else if (message.type === "crashed") onLost(message.message);
    else {
      if (message.type === "ready") isReady = true;
      if (message.type === "stopped" && message.run === running) running = null;
      onEvent(message);
    }
    expect();
  }

  /** @throws {Fault} where the page may start none */
  function begin() {
    if (worker) return worker;
    /** @type {Worker} */
    let started;
    try {
      started = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    } catch (error) {
      const { message: reason } = /** @type {Error} */ (error);
      throw fault("NoWorker", "worker-forbidden", { reason });
    }
    started.onmessage = ({ data }) => started === worker && receive(data);
    started.onerror = (event) => {
      if (started === worker) onLost(event.message || say("worker-not-loaded"));
    };
    worker = started;
    return started;
  }

  return {
    begin,
    isSilent: () => isSilent,

    /** Ends the worker; whoever waits for it learns so. The next request starts another. */
    dismiss() {
      worker?.terminate();
      worker = null;
      isReady = false;
      running = null;
      revoke(null);
      heard();
      const message = "The solver was stopped.";
      for (const { reject } of waiting.values()) {
        reject({ kind: LOST, message, hint: "", detail: {} });
      }
      waiting.clear();
    },

    /** @param {Omit<import("./worker.js").Request, "id">} request @returns {Promise<any>} */
    async ask(request) {
      const asked = begin();
      lastId += 1;
      const id = lastId;
      const { name, run } = request;
      // A request with a number ends the run at hand, as a pause does.
      const ends = run !== undefined || name === "pause";
      if (ends) running = name === "run" ? (run ?? null) : null;
      const next = run === undefined ? null : URL.createObjectURL(new Blob());
      return new Promise((resolve, reject) => {
        waiting.set(id, { resolve, reject });
        asked.postMessage({ id, ...request, ...(next ? { permit: next } : {}) });
        // Afterwards: whoever notices finds the message that says what comes instead.
        if (ends) revoke(next);
        expect();
      });
    },

    /** The page has taken a frame. @param {number} run */
    acknowledge: (run) => worker?.postMessage({ ack: run }),
  };
}
