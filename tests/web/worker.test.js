// @ts-check
// The worker as the page meets it, by messages, on the solver as it is shipped but without a browser.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { after, test } from "node:test";

/** @type {Set<(message: any) => void>} */
const listeners = new Set();

/** @param {(message: any) => boolean} isIt @returns {Promise<any>} */
const arrival = (isIt) =>
  new Promise((resolve) => {
    const listener = (/** @type {any} */ message) => {
      if (!isIt(message)) return;
      listeners.delete(listener);
      resolve(message);
    };
    listeners.add(listener);
  });

/** All that the worker listens to, closed in the end: else Node waits for more. @type {MessagePort[]} */
const ports = [];
after(() => {
  for (const port of ports) port.close();
});

/** The worker's own place, as browsers have it. */
const page = /** @type {any} */ (
  Object.assign(globalThis, {
    self: globalThis,
    MessageChannel: class extends MessageChannel {
      constructor() {
        super();
        ports.push(this.port1);
      }
    },
    onmessage: null,
    postMessage(/** @type {any} */ message) {
      for (const listener of listeners) listener(message);
    },
    fetch: async (/** @type {URL} */ url) =>
      new Response(await readFile(url), { headers: { "content-type": "application/wasm" } }),
    /** As far as the solver's second file asks. */
    XMLHttpRequest: class {
      url = "";
      response = new Uint8Array();
      /** @param {string} _ @param {URL} url */
      open(_, url) {
        this.url = String(url);
      }
      send() {
        this.response = readFileSync(new URL(this.url));
      }
    },
  })
);

let lastId = 0;
/** @param {string} name @param {any} [fields] @param {number} [run]  the number of the run that it begins */
async function ask(name, fields = {}, run) {
  lastId += 1;
  const id = lastId;
  const answered = arrival((message) => message.id === id);
  page.onmessage({ data: { id, name, fields, ...(run === undefined ? {} : { run }) } });
  const { ok, error } = await answered;
  if (error) throw new Error(error.kind);
  return ok;
}

/** The worker, with a surface a few steps on its way. */
async function worker() {
  const ready = arrival(({ type }) => type === "ready");
  await import("../../www/worker.js");
  await ready;
  await ask("sample", { name: "torus", parameters: {} }, 1);
  await ask("configure", { options: { flow: "mean-curvature" } }, 1);
  for (let n = 0; n < 6; n += 1) await ask("step");
}

await worker();

test("what is asked while the stored steps are shown is of the step where it stands", async () => {
  const file = () => ask("export", { format: "ply" });
  const before = Buffer.from(await file());
  const third = arrival(({ type, state }) => type === "frame" && state.step === 2);
  const all = ask("stored");
  await third;
  assert.deepEqual(Buffer.from(await file()), before);
  assert.equal((await ask("state")).step, 6);
  const last = arrival(({ type, state }) => type === "frame" && state.step === 6);
  assert.equal(await all, true, "and those that were not shown yet are");
  await last;
  assert.equal((await ask("state")).step, 6);
});
