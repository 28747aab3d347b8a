// @ts-check
// Random walks over the page: whatever was pressed in whatever order, the energy shown is that of
// the mesh that Download gives, and nothing fails on the way. UMBILIC_WALK=10x1000 walks from ten
// seeds, a thousand actions each.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadSolver } from "../../www/cli/solver.js";
import { samples } from "../../www/generated/library.js";
import { formatNumber } from "../../www/number.js";
import { defaults } from "../../www/options.js";
import { perform } from "../../www/session.js";
import { useSite } from "./support/app.js";
import { readScene } from "./support/scene.js";

const site = useSite();
const { Session } = await loadSolver();

const [seeds, actions] = (process.env.UMBILIC_WALK ?? "1x120").split("x").map(Number);

/** Small ones, closed and open; none that brings a selection along, which no file tells. */
const SAMPLES = ["coarse-torus", "pipe", "saddle", "sampled-torus", "counterexample"];
const FLOWS = ["circle", "p-willmore", "mean-curvature", "surface-diffusion", "willmore", "flips"];

/** Uniform numbers below one, the same from the same seed. @param {number} seed */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** @param {() => number} next @param {readonly any[]} list */
const pick = (next, list) => list[Math.floor(next() * list.length)];

/**
 * What is done next: an element, what is done to it, and with which value.
 * @param {() => number} next
 * @returns {[selector: string, how: "click" | "choose" | "type" | "check" | "scrub" | "play", value: string | number]}
 */
function action(next) {
  const share = next();
  if (share < 0.22) return ["#step", "click", 0];
  if (share < 0.36) return ["#play", "play", 1 + Math.floor(4 * next())];
  if (share < 0.46) return ["#back", "click", 0];
  if (share < 0.58) return ["#scrub", "scrub", next()];
  if (share < 0.62) return ["#reset", "click", 0];
  if (share < 0.7) return ["#flow", "choose", pick(next, FLOWS)];
  if (share < 0.74) return ["#boundary", "choose", pick(next, ["fixed", "clamped", "free"])];
  if (share < 0.78)
    return ["#colour", "choose", pick(next, ["none", "mean-curvature", "willmore"])];
  if (share < 0.84) return ["#option-p", "type", pick(next, ["2", "3"])];
  if (share < 0.88) return ["#option-epsilon", "type", pick(next, ["0.1", "0.01"])];
  if (share < 0.91) return [pick(next, ["#keep-area", "#keep-volume"]), "check", 0];
  if (share < 0.94) return ["#adopt", "click", 0];
  if (share < 0.97) return ["#undo", "click", 0];
  return ["#sample", "choose", pick(next, SAMPLES)];
}

/** Does it as a user would, where it can be done. @param {[string, string, string | number]} action @returns {Promise<boolean>} */
async function act([selector, how, value]) {
  const element = /** @type {any} */ (document.querySelector(selector));
  const isIdle = element?.closest("[hidden]") || element?.disabled;
  if (!element || isIdle || element.ariaDisabled === "true") return false;
  const tell = (/** @type {string} */ type) =>
    element.dispatchEvent(new Event(type, { bubbles: true }));
  if (how === "click" || how === "check") element.click();
  else if (how === "play") {
    element.click();
    for (let n = 0; n < Number(value); n += 1) await new Promise(requestAnimationFrame);
    if (element.dataset.running === "true") element.click();
  } else if (how === "scrub") {
    const [low, high] = [Number(element.min), Number(element.max)];
    element.value = String(Math.round(low + Number(value) * (high - low)));
    tell("input");
    tell("change");
  } else {
    const isThere = how === "type" || [...element.options].some((one) => one.value === value);
    if (!isThere) return false;
    element.value = String(value);
    if (how === "type") tell("input");
    tell("change");
  }
  return true;
}

/** Waits until nothing runs; what is shown then, and the mesh as a file. */
async function rest() {
  const text = (/** @type {string} */ selector) =>
    document.querySelector(selector)?.textContent ?? "";
  const isBusy = () => /^(Running|Pausing|Loading|Restoring|Starting)/.test(text("#status"));
  do await new Promise((resolve) => setTimeout(resolve));
  while (isBusy());
  const { saved } = /** @type {any} */ (globalThis);
  saved.length = 0;
  /** @type {HTMLElement | null} */ (document.querySelector("#download"))?.click();
  while (saved.length === 0) await new Promise((resolve) => setTimeout(resolve));
  const bytes = new Uint8Array(await saved[0].arrayBuffer());
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  const alerts = [...document.querySelectorAll("#errors .message")].map((one) => {
    const said = one.textContent ?? "";
    one.querySelector("button")?.click();
    return said;
  });
  return {
    ...{ status: text("#status"), energy: text("[data-reading=energy]"), hash: location.hash },
    ...{ file: btoa(binary), isBusy: isBusy(), alerts },
  };
}

/** The energy of a mesh as the page would show it, by the options of a link; NaN where its flow refuses the mesh. @param {string} file @param {string} hash */
function energyOf(file, hash) {
  const { sample, options: told } = readScene({ search: "", hash });
  const first = { ...samples.find(({ id }) => id === sample)?.options, ...told };
  // The flow may have been changed on the way; the path names what is not usual of it.
  const path = new URLSearchParams(hash.slice(1)).get("path");
  const actions = path ? JSON.parse(Buffer.from(path, "base64url").toString()) : [];
  const changed = actions.findLast((/** @type {any} */ action) => action.flow);
  const options = changed ? { ...defaults, ...changed.flow } : first;
  const session = new Session();
  try {
    perform(session, "load", { bytes: Buffer.from(file, "base64"), name: "walk.ply" });
    const { state } = perform(session, "configure", { options });
    return state.energy;
  } catch (error) {
    if (/** @type {any} */ (error).kind === undefined) throw error;
    return Number.NaN;
  } finally {
    session.free();
  }
}

/** Whether a number shows as this text, up to a unit in its last digit. @param {number} value @param {string} text */
const shows = (value, text) =>
  formatNumber(value, 6) === text || Math.abs(value - Number(text)) <= 1.5e-5 * Math.abs(value);

for (let seed = 1; seed <= seeds; seed += 1) {
  test(`${actions} random actions from seed ${seed}: no fault, and no energy that is not the mesh’s`, async (context) => {
    const { page, faults, close } = await site.blank({ viewport: { width: 700, height: 420 } });
    await page.addInitScript(() => {
      const { setTimeout } = globalThis;
      const { createObjectURL } = URL;
      /** @type {Blob[]} */
      const saved = [];
      // The link is written at once, and files are looked at where they are made.
      Object.assign(globalThis, {
        saved,
        setTimeout: (
          /** @type {any} */ work,
          /** @type {number} */ delay,
          /** @type {any[]} */ ...rest
        ) => setTimeout(work, delay === 500 ? 60 : delay, ...rest),
      });
      URL.createObjectURL = (blob) => {
        if (blob instanceof Blob) saved.push(blob);
        return createObjectURL(blob);
      };
      HTMLAnchorElement.prototype.click = () => {};
    });
    await page.goto(`${site.url}?msaa=1#sample=coarse-torus`);
    await page.locator("#status").getByText("Ready").waitFor();
    const next = random(seed);
    /** @type {string[]} */
    const trace = [];
    let done = 0;
    for (let n = 0; n < actions; n += 1) {
      const wanted = action(next);
      if (await page.evaluate(act, wanted)) done += 1;
      else continue;
      trace.push(wanted.join(" "));
      const told = () => `after ${trace.slice(-12).join("; ")}`;
      // What was asked for may just have begun.
      for (let tries = 0; ; tries += 1) {
        const { status, energy, hash, file, isBusy, alerts } = await page.evaluate(rest);
        // A flow may refuse a mesh; the solver may not fail.
        const fault = alerts.find((said) => /stopped|program|no mesh|internal/i.test(said));
        assert.equal(fault, undefined, told());
        if (!isBusy && energy !== "–" && shows(energyOf(file, hash), energy)) break;
        if (energy === "–" && /cannot start/.test(status)) break;
        assert.ok(
          tries < 40,
          `${status}: ${energy} is shown, the mesh has ${energyOf(file, hash)} (${hash}) ${told()}`,
        );
      }
    }
    context.diagnostic(`${done} of ${actions} actions could be done`);
    assert.ok(done > actions / 3, `${done} actions`);
    assert.deepEqual(faults, []);
    await close();
  });
}
