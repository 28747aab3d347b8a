// @ts-check
// A browser without WebGPU that has WebGL2: the same page, the same picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  choice,
  colourBy,
  download,
  energy,
  openMesh,
  openPart,
  openTab,
  playAndPause,
  stillPicture,
  until,
  untilDrawn,
  untilPictured,
  useSite,
} from "./support/app.js";
import { difference, measure, picture } from "./support/browser.js";
import { context as goldenContext, query, scenes, stored, takePicture } from "./support/golden.js";
import { obj, wavyTorus } from "./support/meshes.js";
import { decodePng } from "./support/png.js";

/** Bounds on the difference from WebGPU's golden pictures, of 255: as those have among them. */
const MEAN = 1.5;
const PERCENTILE_95 = 4;

const site = useSite({ webgpu: false });

/** @typedef {import("playwright-core").Page} Page */

/** Takes the graphics away, and gives them back where told so. @param {Page} page */
const graphics = (page) => ({
  lose: () =>
    page.evaluate(() => {
      const context = document.querySelector("canvas")?.getContext("webgl2");
      Object.assign(globalThis, { lost: context?.getExtension("WEBGL_lose_context") });
      /** @type {any} */ (globalThis).lost.loseContext();
    }),
  restore: () => page.evaluate(() => /** @type {any} */ (globalThis).lost.restoreContext()),
});

/** Pixels within a marked edge: in its colour, unlit, unlike marked triangles. @param {Page} page */
async function markedPixels(page) {
  const { channels, data } = decodePng(await canvas(page).screenshot());
  let count = 0;
  for (let n = 0; n < data.length; n += channels) {
    const [r, g, b] = data.subarray(n, n + 3);
    if (Math.abs(r - 0x07) + Math.abs(g - 0x50) + Math.abs(b - 0x4b) <= 3) count += 1;
  }
  return count;
}

test("WebGL2 draws, and the page says so and why", async () => {
  const { page, faults, close } = await site.blank();
  /** @type {string[]} */
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await untilDrawn(page);
  assert.equal(asked.filter((url) => /viewer-webgl_bg[^/]*\.wasm$/.test(url)).length, 1);
  const line = /^Drawn with WebGL2: .*WebGPU/;
  assert.match((await page.locator("#panes").getAttribute("data-renderer")) ?? "", line);
  await button(page, "Help").click();
  await page.getByRole("dialog").getByText(line).waitFor();
  assert.equal(await page.locator(".absence").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("with WebGL2 the picture follows flow, colours, wireframe and camera", async () => {
  const { page, faults, close } = await site.open();
  // More vertices than a row of the texture that carries them.
  await openMesh(page, "wavy.obj", obj(wavyTorus(72, 48)));
  await openTab(page, "Measure");
  let before = await stillPicture(page);
  const atStart = await energy(page);
  await playAndPause(page, 3);
  assert.ok((await energy(page)) < atStart);
  await untilPictured(page, before, (mean) => mean > 0.5);

  before = await stillPicture(page);
  await colourBy(page, "Mean curvature H");
  await untilPictured(page, before, (mean) => mean > 5);

  before = await stillPicture(page);
  await page.keyboard.press("m");
  await untilPictured(page, before, (mean) => mean > 1);

  before = await stillPicture(page);
  const box = await canvas(page).boundingBox();
  if (!box) throw new Error("no canvas");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 90, { steps: 3 });
  await page.mouse.up();
  await untilPictured(page, before, (mean) => mean > 1);
  await page.waitForFunction(() => location.hash.includes("camera="));

  // Saved without anything new to draw, twice: what is on the screen, and not an empty buffer.
  await stillPicture(page);
  for (let n = 0; n < 2; n += 1) {
    const { bytes } = await download(page, "Picture, PNG");
    assert.ok(measure(bytes).colours > 200, "the saved picture is empty");
  }
  assert.deepEqual(faults, []);
  await close();
});

test("with WebGL2 each pane has its picture, and one camera turns them all", async () => {
  const { page, faults, close } = await site.blank();
  // All contexts ever made, kept so that none is freed by garbage collection.
  await page.addInitScript(() => {
    /** @type {WebGL2RenderingContext[]} */
    const contexts = [];
    const { getContext } = HTMLCanvasElement.prototype;
    Object.assign(globalThis, { contexts });
    HTMLCanvasElement.prototype.getContext = /** @type {any} */ (
      /** @this {HTMLCanvasElement} @param {any[]} parameters */
      function (...parameters) {
        const context = Reflect.apply(getContext, this, parameters);
        if (parameters[0] === "webgl2" && !contexts.includes(context)) contexts.push(context);
        return context;
      }
    );
  });
  await page.goto(`${site.url}?msaa=1#sample=uneven-torus&compare=criteria`);
  await until(page, "Ready");
  await openTab(page, "Flow");
  await button(page, "All flips at once").click();
  const panes = page.locator(".pane canvas");
  await page.getByRole("img", { name: /Willmore energy, 235 flips/ }).waitFor();
  assert.equal(await panes.count(), 3);
  const end = Date.now() + 60_000;
  for (let pane = 0; pane < 3; pane += 1) {
    while ((await picture(panes.nth(pane))).colours <= 200) {
      assert.ok(Date.now() < end, `pane ${pane} is not drawn`);
    }
  }
  const other = page.getByRole("img", { name: /Area, 240 flips/ });
  const still = await other.screenshot();
  await canvas(page).first().focus();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => location.hash.includes("camera="));
  while (difference(still, await other.screenshot()).mean < 1) {
    assert.ok(Date.now() < end, "it does not turn");
  }
  // Panes come and go without using up the contexts a browser allows, mostly 16.
  for (let n = 0; n < 3; n += 1) {
    await choice(page, "Beside it").selectOption("Nothing");
    await page.waitForFunction(() => document.querySelectorAll(".pane").length === 1);
    await choice(page, "Beside it").selectOption("The other criteria");
    await page.waitForFunction(() => document.querySelectorAll(".pane").length === 3);
  }
  for (let pane = 0; pane < 3; pane += 1) {
    while ((await picture(panes.nth(pane))).colours <= 200) {
      assert.ok(Date.now() < end, `pane ${pane} is gone`);
    }
  }
  const alive = await page.evaluate(
    () =>
      /** @type {any} */ (globalThis).contexts.filter(
        (/** @type {WebGL2RenderingContext} */ context) => !context.isContextLost(),
      ).length,
  );
  assert.equal(alive, 3);
  assert.deepEqual(faults, []);
  await close();
});

test("with WebGL2 a counterexample is marked on the surface", async () => {
  const { page, faults, close } = await site.open("sample=creased-face", { colorScheme: "light" });
  await untilDrawn(page);
  assert.equal(await markedPixels(page), 0);
  await openPart(page, "Measure", "The conjecture on this mesh");
  await page.getByText(/and not at 1\./).waitFor();
  const end = Date.now() + 60_000;
  while ((await markedPixels(page)) < 6) assert.ok(Date.now() < end, "nothing is marked");
  assert.deepEqual(faults, []);
  await close();
});

test("a WebGL context that is lost and comes back brings the picture back", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere&colour=willmore");
  await page.getByRole("img", { name: /^Colours: Willmore/ }).waitFor();
  await canvas(page).focus();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  const before = await stillPicture(page);
  for (let n = 0; n < 2; n += 1) {
    await graphics(page).lose();
    await untilPictured(page, before, (mean) => mean > 5);
    await graphics(page).restore();
    await untilPictured(page, before, (mean) => mean < 0.05);
  }
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await untilPictured(page, before, (mean) => mean > 0.3);
  assert.deepEqual(faults, []);
  await close();
});

test("a WebGL context that does not come back is reported, and the flow runs on", async () => {
  const { page, faults, close } = await site.blank();
  // What is waited for in vain is not waited for in full.
  await page.addInitScript(() => {
    const { setTimeout } = globalThis;
    globalThis.setTimeout = /** @type {any} */ (
      (/** @type {any} */ work, /** @type {number} */ delay) =>
        setTimeout(work, delay >= 1000 ? delay / 20 : delay)
    );
  });
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await untilDrawn(page);
  await graphics(page).lose();
  await page.getByText(/the graphics device was lost/i).waitFor();
  assert.equal(await page.locator("#surface").isVisible(), false);
  await playAndPause(page, 2);
  assert.deepEqual(faults, []);
  await close();
});

for (const [name, { scene }] of Object.entries(scenes)) {
  test(`${name} looks with WebGL2 as it does with WebGPU`, async (context) => {
    const { page, faults, close } = await site.open(scene, goldenContext, query);
    const apart = difference(stored(name), await takePicture(page));
    const bound = `at most ${MEAN} and ${PERCENTILE_95}`;
    context.diagnostic(
      `mean ${apart.mean.toFixed(3)}, 95th percentile ${apart.percentile95}; ${bound}`,
    );
    assert.ok(apart.mean <= MEAN, `mean difference ${apart.mean}`);
    assert.ok(apart.percentile95 <= PERCENTILE_95, `95th percentile ${apart.percentile95}`);
    assert.deepEqual(faults, []);
    await close();
  });
}
