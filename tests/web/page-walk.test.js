// @ts-check
// Random walks over the page: whatever was pressed in whatever order, the energy shown is that of
// the mesh that Download gives, nothing fails on the way, and what the page holds in memory does not
// grow. UMBILIC_WALK=10x1000 walks from ten seeds, a thousand actions each.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { loadSolver } from "../../www/cli/solver.js";
import { samples } from "../../www/generated/library.js";
import { formatNumber } from "../../www/number.js";
import { defaults } from "../../www/options.js";
import { perform } from "../../www/session.js";
import { openTab, until, useSite } from "./support/app.js";
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
 * What is done next: how, where, and with which value.
 * @param {() => number} next
 * @returns {[how: "press" | "play" | "scrub" | "click" | "choose" | "type", what: string, value: string | number]}
 */
function action(next) {
  const share = next();
  if (share < 0.22) return ["press", ".", 0];
  if (share < 0.36) return ["play", ".play", 1 + Math.floor(8 * next())];
  if (share < 0.46) return ["press", ",", 0];
  if (share < 0.56) return ["scrub", ".curve [role=slider]", next()];
  if (share < 0.6) return ["press", "r", 0];
  if (share < 0.68) return ["click", `flow ${pick(next, FLOWS)}`, 0];
  if (share < 0.72) return ["choose", "option-boundary", pick(next, ["fixed", "clamped", "free"])];
  if (share < 0.76) return ["press", "c", 0];
  if (share < 0.82) return ["type", "option-p", pick(next, ["2", "3"])];
  if (share < 0.86) return ["type", "option-epsilon", pick(next, ["0.1", "0.01"])];
  if (share < 0.89) return ["click", pick(next, ["keep area", "keep volume"]), 0];
  if (share < 0.93) return ["click", "adopt", 0];
  if (share < 0.96) return ["press", "z", 0];
  return ["choose", "sample", pick(next, SAMPLES)];
}

/** What is in the page for the walk: everything is found by its words. */
function prepare() {
  /** @type {Blob[]} */
  const saved = [];
  const { setTimeout } = globalThis;
  const { createObjectURL } = URL;
  // The link is written at once, and files are looked at where they are made.
  const hurried = (
    /** @type {any} */ work,
    /** @type {number} */ delay,
    /** @type {any[]} */ ...rest
  ) => setTimeout(work, delay === 500 ? 60 : delay, ...rest);
  URL.createObjectURL = (blob) => {
    if (blob instanceof Blob) saved.push(blob);
    return createObjectURL(blob);
  };
  HTMLAnchorElement.prototype.click = () => {};
  const turn = () => new Promise((resolve) => setTimeout(resolve));
  const text = (/** @type {string} */ selector) =>
    document.querySelector(selector)?.textContent ?? "";
  /** @param {string} key @param {boolean} [ctrlKey] */
  const press = (key, ctrlKey = false) =>
    dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey, cancelable: true }));
  /** @param {string} selector @param {string | RegExp} name @returns {any} */
  const named = (selector, name) =>
    [...document.querySelectorAll(selector)].find((one) => {
      const said = one.ariaLabel ?? one.textContent?.trim() ?? "";
      return typeof name === "string" ? said === name : name.test(said);
    });
  /** @param {string} key @param {string} tab */
  async function open(key, tab) {
    const isOpen = () => document.documentElement.dataset.tab === tab;
    if (!isOpen()) press(key);
    while (!isOpen() || !document.querySelector("[role=tabpanel] .body > *")) await turn();
  }
  Object.assign(globalThis, {
    setTimeout: hurried,
    walk: { saved, turn, text, press, named, open },
  });
}

/** Does it as a user would, where it can be done. @param {[string, string, string | number]} action @returns {Promise<boolean>} */
async function act([how, what, value]) {
  const { press, named, open, turn } = /** @type {any} */ (globalThis).walk;
  const flows = {
    circle: "Willmore by circle angles",
    "p-willmore": "p-Willmore",
    "mean-curvature": "Mean curvature",
    "surface-diffusion": "Surface diffusion",
    willmore: "Willmore by fitted operators",
    flips: "Edge flips",
  };
  const labels = {
    "option-boundary": "Boundary",
    "option-p": "Exponent p",
    "option-epsilon": "Angle smoothing ε",
    sample: "Sample",
  };
  /** @param {string} label @returns {any} */
  const control = (label) =>
    named("label", label) && document.getElementById(named("label", label).htmlFor);
  if (how === "press") {
    press(what, what === "z");
    return true;
  }
  if (how === "play") {
    const button = /** @type {HTMLElement} */ (document.querySelector(what));
    if (!button || button.ariaDisabled === "true") return false;
    button.click();
    for (let n = 0; n < Number(value); n += 1) await new Promise(requestAnimationFrame);
    if (button.ariaLabel === "Pause") button.click();
    return true;
  }
  if (how === "scrub") {
    const slider = document.querySelector(what);
    if (!slider) return false;
    slider.scrollIntoView();
    const { left, top, width, height } = slider.getBoundingClientRect();
    const at = { clientX: left + Number(value) * width, clientY: top + height / 2 };
    for (const type of ["pointerdown", "pointermove", "pointerup"])
      slider.dispatchEvent(new PointerEvent(type, { ...at, pointerId: 1, bubbles: true }));
    slider.dispatchEvent(new PointerEvent("lostpointercapture", { pointerId: 1 }));
    return true;
  }
  const isOfSurface = what === "sample" || what === "adopt";
  await open(isOfSurface ? "1" : "2", isOfSurface ? "surface" : "flow");
  await turn();
  if (how === "click") {
    const [kind, name] = what.split(" ");
    const element =
      kind === "flow"
        ? [...document.querySelectorAll("[role=option]")].find(
            (one) => one.querySelector("b")?.textContent === /** @type {any} */ (flows)[name],
          )
        : kind === "keep"
          ? named("label", name === "area" ? "Area" : "Volume")?.querySelector("input")
          : named("button", /^Start from here|^Make this the start/);
    if (!element || element.ariaDisabled === "true") return false;
    element.click();
    return true;
  }
  const element = control(/** @type {any} */ (labels)[what]);
  if (!element) return false;
  if (how === "choose") {
    const option = [...element.options].find((one) => one.value === value);
    if (!option) return false;
  }
  element.value = String(value);
  element.dispatchEvent(new Event("change", { bubbles: true }));
  return true;
}

/** Waits until nothing runs; what is shown then, and the mesh as a file. */
async function rest() {
  const { saved, turn, text, open, named } = /** @type {any} */ (globalThis).walk;
  const status = () => text("[role=status]");
  const isBusy = () =>
    /^(Running|Pausing|Loading|Restoring|Starting)/.test(status()) ||
    document.querySelector(".play")?.getAttribute("aria-label") === "Pause";
  do await turn();
  while (isBusy());
  await open("5", "share");
  saved.length = 0;
  named("button", "Download")?.click();
  while (saved.length === 0 && !document.querySelector("[role=alert]")) await turn();
  const bytes = saved[0] ? new Uint8Array(await saved[0].arrayBuffer()) : new Uint8Array();
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  const alerts = [...document.querySelectorAll("[role=alert]")].map((one) => {
    const said = one.textContent ?? "";
    named("button", "Dismiss")?.click();
    return said;
  });
  const label = document.querySelector("#surface")?.getAttribute("aria-label") ?? "";
  const energy = /energy (\S+?),/.exec(label)?.[1] ?? "–";
  return {
    ...{ status: status(), label, energy, hash: location.hash },
    ...{ file: btoa(binary), isBusy: isBusy(), alerts },
  };
}

/** The energy of a mesh as the page would show it, by the options of a link; NaN where its flow refuses the mesh. @param {string} file @param {string} hash */
function energyOf(file, hash) {
  const { sample, options: read } = readScene({ search: "", hash });
  const first = { ...samples.find(({ id }) => id === sample)?.options, ...read };
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

/**
 * Megabytes of its own that the process of a page and its worker holds, after collecting garbage;
 * where the system tells.
 * @param {import("playwright-core").Page} page
 */
async function held(page) {
  await page.requestGC();
  const session = await site.browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  const sizes = processInfo
    .filter(({ type }) => type === "renderer")
    .map(({ id }) => {
      try {
        return Number(/RssAnon:\s*(\d+)/.exec(readFileSync(`/proc/${id}/status`, "utf8"))?.[1]);
      } catch {
        return Number.NaN;
      }
    })
    .filter(Number.isFinite);
  return Math.round(Math.max(...sizes) / 1024);
}

/** Whether a number shows as this text, up to a unit in its last digit. @param {number} value @param {string} text */
const shows = (value, text) =>
  formatNumber(value, 4) === text ||
  Math.abs(value - Number(text.replace("−", "-"))) <= 1.5e-3 * Math.abs(value);

for (let seed = 1; seed <= seeds; seed += 1) {
  test(`${actions} random actions from seed ${seed}: no fault, and no energy that is not the mesh’s`, async (context) => {
    const { page, faults, close } = await site.blank({ viewport: { width: 1000, height: 640 } });
    await page.addInitScript(prepare);
    await page.goto(`${site.url}?msaa=1#sample=coarse-torus`);
    await until(page, "Ready");
    await openTab(page, "Share");
    const next = random(seed);
    /** @type {string[]} */
    const trace = [];
    /** @type {number[]} */
    const memory = [];
    let done = 0;
    for (let n = 0; n < actions; n += 1) {
      if (n % 50 === 0) memory.push(await held(page));
      const wanted = action(next);
      if (await page.evaluate(act, wanted)) done += 1;
      else continue;
      trace.push(wanted.join(" "));
      const told = () => `after ${trace.slice(-12).join("; ")}`;
      // What was asked for may just have begun.
      for (let tries = 0; ; tries += 1) {
        const { status, energy, label, hash, file, isBusy, alerts } = await page.evaluate(rest);
        // A flow may refuse a mesh; the solver may not fail.
        const fault = alerts.find((said) => /stopped|program|no mesh|internal/i.test(said));
        assert.equal(fault, undefined, told());
        if (!isBusy && energy !== "–" && shows(energyOf(file, hash), energy)) break;
        if (energy === "–" && /cannot start/.test(status)) break;
        assert.ok(
          tries < 40,
          `${status}: ${label}, and the mesh has ${energyOf(file, hash)} (${hash}) ${told()}`,
        );
      }
    }
    context.diagnostic(`${done} of ${actions} actions could be done; MB held: ${memory.join(" ")}`);
    assert.ok(done > actions / 2, `${done} actions`);
    // By the third quarter everything has been there once, and the solver's memory, which never
    // shrinks, is as large as it gets; garbage of the worker comes and goes.
    const least = (/** @type {number} */ from, /** @type {number} */ to) =>
      Math.min(...memory.slice(from * memory.length, to * memory.length));
    if (memory.length >= 12) assert.ok(least(0.75, 1) <= 1.25 * least(0.5, 0.75), memory.join(" "));
    assert.deepEqual(faults, []);
    await close();
  });
}
