// @ts-check
// What the page must do in every browser: a first visit, a flow to its end, a file that is opened.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { measure } from "./browser.js";
import { obj, wavyTorus } from "./meshes.js";
import { decodePng } from "./png.js";
import { serve } from "./server.js";

/** @import { Engine } from "./engine.js" */

/** As {@link ./app.js}'s, in milliseconds. */
const PATIENCE = Number(process.env.UMBILIC_PATIENCE ?? 90_000);
const size = { width: 800, height: 600 };

const status = `document.querySelector("[role=status]")?.textContent ?? ""`;
const label = `document.querySelector("#surface")?.getAttribute("aria-label") ?? ""`;
const surface = `document.querySelector("#surface")`;

/** A button as assistive technology names it, that is seen. @param {string} name */
const button = (name) => `[...document.querySelectorAll("button")].find((button) =>
  (button.getAttribute("aria-label") ?? button.innerText).trim() === ${JSON.stringify(name)} &&
  button.checkVisibility())`;

/** Waits, frame by frame, until an expression holds. @param {Engine} engine @param {string} condition */
async function until(engine, condition) {
  const said = await engine.evaluate(`(async () => {
    const end = performance.now() + ${PATIENCE};
    while (!(${condition})) {
      if (performance.now() > end) return \`\${${status}}; \${${label}}\`;
      await new Promise(requestAnimationFrame);
    }
    return null;
  })()`);
  assert.equal(said, null, `waited for ${condition}`);
}

/** @param {Engine} engine @param {string} name */
async function press(engine, name) {
  await until(engine, button(name));
  await engine.click(await engine.element(button(name)));
}

/**
 * A picture of the surface that reached the screen; a cleared canvas has few colours.
 * @param {Engine} engine
 */
async function drawn(engine) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const picture = await engine.picture(await engine.element(surface));
    const { colours } = measure(picture);
    if (colours > 200) return picture;
    assert.ok(Date.now() < end, `no surface on the screen: ${colours} colours`);
  }
}

/**
 * The share of rows in which the outline, met from the right, has a pixel that is neither
 * ground nor surface.
 * @param {Buffer} png
 */
function softness(png) {
  const { width, height, channels, data } = decodePng(png);
  let [met, soft] = [0, 0];
  for (let y = Math.round(0.2 * height); y < 0.5 * height; y += 1) {
    const at = (/** @type {number} */ x) => data[(y * width + x) * channels];
    for (let x = width - 4; x > 1; x -= 1) {
      const first = Math.abs(at(x + 1) - at(x));
      if (first < 12) continue;
      met += 1;
      if (Math.abs(at(x) - at(x - 1)) >= 12) soft += 1;
      break;
    }
  }
  return soft / met;
}

/** Nothing lies over anything else, and nothing is out of the window. @param {Engine} engine */
async function untangled(engine) {
  const parts = await engine.evaluate(`["#top", "#stage", "#rail", "#dock"].map((name) => {
    const { left, top, right, bottom } = document.querySelector(name).getBoundingClientRect();
    return { name, left, top, right, bottom };
  })`);
  for (const [n, a] of parts.entries()) {
    const isInside = a.left >= 0 && a.top >= 0 && a.right <= size.width && a.bottom <= size.height;
    assert.ok(isInside && a.bottom > a.top, JSON.stringify(a));
    for (const b of parts.slice(n + 1)) {
      const isOver = a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
      assert.ok(!isOver, `${a.name} over ${b.name}: ${JSON.stringify([a, b])}`);
    }
  }
  const play = await engine.evaluate(`(() => {
    const { left, top, width, height } = document.querySelector(".play").getBoundingClientRect();
    const hit = document.elementFromPoint(left + width / 2, top + height / 2);
    return Boolean(hit?.closest(".play"));
  })()`);
  assert.ok(play, "something lies over Play");
}

/**
 * @param {string} name
 * @param {(() => Promise<Engine>) | null} launch  none where it could not be had
 * @param {(engine: Engine) => Promise<void>} [more]  at the first visit
 */
export function journey(name, launch, more = async () => {}) {
  const skip = launch ? false : `${name} is not installed here`;
  test(`${name}: a first visit, a flow to its end, a file`, { skip }, async () => {
    if (!launch) return;
    const server = await serve();
    const engine = await launch();
    const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
    try {
      await engine.resize(size.width, size.height);
      await firstVisit(engine, server.url);
      await more(engine);
      await toTheEnd(engine);
      await openFile(engine, folder);
      assert.equal(await engine.evaluate(`document.querySelectorAll("[role=alert]").length`), 0);
      assert.deepEqual(engine.faults, []);
    } finally {
      rmSync(folder, { recursive: true });
      await engine.close();
      await server.close();
    }
  });
}

/** @param {Engine} engine @param {string} url */
async function firstVisit(engine, url) {
  await engine.open(url);
  await until(engine, `(${status}) === "Ready"`);
  assert.match(await engine.evaluate(label), /^Surface: Bumpy sphere, step 0, energy 114\.0/);
  await drawn(engine);
  const renderer = await engine.evaluate(`document.querySelector("#panes").dataset.renderer`);
  assert.match(renderer, /^Drawn with Web(GL2|GPU)/);
}

/** @param {Engine} engine */
async function toTheEnd(engine) {
  await press(engine, "Play: Watch it flow");
  for (const speed of ["1×", "2×"]) await press(engine, `Speed ${speed}`);
  await untangled(engine);
  const places = await engine.evaluate(`(async () => {
    const end = performance.now() + ${PATIENCE};
    const places = new Set();
    while (!/^(Converged|Stalled|Stopped)/.test(${status}) && performance.now() < end) {
      await new Promise(requestAnimationFrame);
      places.add(document.querySelector(".head")?.getAttribute("style"));
    }
    return places.size;
  })()`);
  assert.match(await engine.evaluate(status), /^Converged after \d+ steps/);
  assert.ok(places > 5, `${places} places of the clip`);
  await untangled(engine);
  const share = softness(await drawn(engine));
  assert.ok(share > 0.5, `a jagged outline: ${share}`);
}

/** @param {Engine} engine @param {string} folder */
async function openFile(engine, folder) {
  const file = path.join(folder, "wavy.obj");
  writeFileSync(file, obj(wavyTorus()));
  const before = await drawn(engine);
  await engine.setFile(await engine.element(`document.querySelector("#file")`), file);
  await until(engine, `/^Surface: wavy, step 0/.test(${label}) && (${status}) === "Ready"`);
  const end = Date.now() + PATIENCE;
  while ((await drawn(engine)).equals(before)) assert.ok(Date.now() < end, "it is not drawn");
}
