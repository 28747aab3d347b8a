// @ts-check
// A browser that has WebGPU and WebGL2: which of the two draws, what that takes to fetch,
// and that the pictures are alike.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import {
  button,
  canvas,
  download,
  stillPicture,
  until,
  untilDrawn,
  untilPictured,
  useSite,
} from "./support/app.js";
import { difference, measure } from "./support/browser.js";
import { site as folder, serve } from "./support/server.js";

/** Of the viewer for WebGL2 with its script, compressed, in kB of 1000 bytes. */
const BOUND = 1000;

/**
 * Bounds on the difference between the two, of 255, with four samples a pixel: where those
 * lie in a pixel is each renderer's own affair.
 */
const MEAN = 1.5;
const PERCENTILE_95 = 4;

const site = useSite();

/** Opens the page by a query. @param {string} query */
async function open(query) {
  const opened = await site.blank();
  /** @type {string[]} */
  const asked = [];
  opened.page.on("request", (request) => asked.push(request.url()));
  await opened.page.goto(`${site.url}?${query}`);
  await until(opened.page, "Ready");
  const drawnBy = async () =>
    (await opened.page.locator("#panes").getAttribute("data-renderer")) ?? "";
  const fetched = (/** @type {RegExp} */ name) => asked.filter((url) => name.test(url)).length;
  return { ...opened, drawnBy, fetched };
}

test("with WebGPU the viewer for WebGL2 is not fetched", async () => {
  for (const query of ["msaa=1", "msaa=1&renderer=webgpu", "msaa=1&renderer=unknown"]) {
    const { page, faults, close, drawnBy, fetched } = await open(query);
    await untilDrawn(page);
    const reason = query.includes("webgpu") ? "the address asks for it" : "this browser offers it";
    assert.equal(await drawnBy(), `Drawn with WebGPU: ${reason}.`);
    assert.equal(fetched(/viewer-webgl/), 0);
    assert.equal(fetched(/viewer_bg[^/]*\.wasm/), 1);
    assert.deepEqual(faults, []);
    await close();
  }
});

test("the address can ask for WebGL2", async () => {
  const { page, faults, close, drawnBy, fetched } = await open("msaa=1&renderer=webgl");
  await untilDrawn(page);
  assert.equal(await drawnBy(), "Drawn with WebGL2: the address asks for it.");
  assert.equal(fetched(/viewer_bg/), 0);
  const kinds = await page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector("#surface"));
    return { webgl: canvas.getContext("webgl2") !== null };
  });
  assert.deepEqual(kinds, { webgl: true });
  assert.deepEqual(faults, []);
  await close();
});

test("an adapter without a device leaves the canvas to WebGL2", async () => {
  const { page, close } = await site.blank();
  await page.addInitScript(() => {
    const { prototype } = /** @type {any} */ (globalThis).GPUAdapter;
    prototype.requestDevice = () => Promise.reject(new Error("made by the test"));
  });
  await page.goto(`${site.url}?msaa=1`);
  await page
    .locator('[data-renderer^="Drawn with WebGL2: the graphics adapter gives no device"]')
    .waitFor();
  await untilDrawn(page);
  await close();
});

test("where WebGPU is lost for good, WebGL2 goes on with the same picture", async () => {
  const { page, close } = await site.blank();
  await page.addInitScript(() => {
    const { prototype } = /** @type {any} */ (globalThis).GPUAdapter;
    const { requestDevice } = prototype;
    /** @type {any[]} */
    const devices = [];
    Object.assign(globalThis, { devices });
    prototype.requestDevice = async function (/** @type {unknown[]} */ ...asked) {
      if (devices.length > 0) throw new Error("made by the test");
      const device = await requestDevice.apply(this, asked);
      devices.push(device);
      return device;
    };
  });
  await page.goto(`${site.url}?msaa=1#sample=bumpy-sphere`);
  await until(page, "Ready");
  await canvas(page).focus();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  const before = await stillPicture(page);
  await page.evaluate(() => /** @type {any} */ (globalThis).devices[0].destroy());
  await page
    .locator('[data-renderer^="Drawn with WebGL2: the graphics device was lost"]')
    .waitFor();
  await untilPictured(page, before, (mean) => mean < MEAN);
  assert.equal(await page.locator(".absence").count(), 0);
  // It is the new canvas that is seen and saved, and the old one that is turned.
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  await canvas(page).focus();
  await page.keyboard.press("ArrowRight");
  await untilPictured(page, before, (mean) => mean > MEAN);
  const { bytes } = await download(page, "Picture, PNG");
  assert.ok(measure(bytes).colours > 200, "the picture saved is the one that is drawn");
  await close();
});

test("WebGPU that is asked for and missing is not replaced", async () => {
  const { page, faults, close } = await site.blank();
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, "gpu", { value: undefined });
  });
  await page.goto(`${site.url}?msaa=1&renderer=webgpu`);
  await page.getByText(/this browser has no WebGPU/i).waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("both renderers draw the same, smoothed edges too", async (context) => {
  const pictures = [];
  for (const renderer of ["webgpu", "webgl"]) {
    const scene = "sample=bumpy-sphere&colour=willmore&wireframe=true";
    const { page, faults, close } = await site.open(
      scene,
      { viewport: { width: 392 + 400, height: 400 } },
      `renderer=${renderer}`,
    );
    await page.getByRole("img", { name: /^Colours: Willmore/ }).waitFor();
    await stillPicture(page);
    pictures.push((await download(page, "Picture, PNG")).bytes);
    assert.deepEqual(faults, []);
    await close();
  }
  const apart = difference(pictures[0], pictures[1]);
  context.diagnostic(
    `mean ${apart.mean.toFixed(3)}, 95th percentile ${apart.percentile95}; ` +
      `at most ${MEAN} and ${PERCENTILE_95}`,
  );
  assert.ok(apart.mean <= MEAN, `mean difference ${apart.mean}`);
  assert.ok(apart.percentile95 <= PERCENTILE_95, `95th percentile ${apart.percentile95}`);
});

test("both renderers can be read back, and give the same pixels", async () => {
  const packages = await serve(path.join(folder, "..", "www", "pkg"));
  const { page, faults, close } = await site.blank();
  await page.route(packages.url, (route) =>
    route.fulfill({ contentType: "text/html", body: '<link rel="icon" href="data:,">' }),
  );
  await page.goto(packages.url);
  const read = (/** @type {string} */ name) =>
    page.evaluate(async (name) => {
      const { default: init, Viewer, firstSurface } = await import(`./${name}/${name}.js`);
      await init();
      const canvas = document.createElement("canvas");
      const viewer = await Viewer.create(canvas, { samples: 1 });
      // No multiple of what rows of a copied texture are padded to.
      viewer.resize(90, 70);
      const { positions, triangles } = firstSurface();
      const none = new Uint32Array();
      viewer.setMesh(positions, triangles, none, none);
      const { width, height, data } = await viewer.readPixels();
      return { width, height, data: [...data] };
    }, name);
  const [webgpu, webgl] = [await read("viewer"), await read("viewer-webgl")];
  assert.deepEqual([webgl.width, webgl.height, webgl.data.length], [90, 70, 4 * 90 * 70]);
  assert.ok(new Set(webgl.data).size > 50, "no surface");
  const apart = webgl.data.reduce((sum, byte, n) => sum + Math.abs(byte - webgpu.data[n]), 0);
  assert.ok(apart / webgl.data.length <= MEAN, `mean difference ${apart / webgl.data.length}`);
  assert.deepEqual(faults, []);
  await close();
  await packages.close();
});

test("the viewer for WebGL2 takes little enough to fetch", (context) => {
  const assets = path.join(folder, "assets");
  const files = readdirSync(assets).filter((name) => name.startsWith("viewer-webgl"));
  assert.equal(files.length, 2, `${files}`);
  const sizes = files.map((name) => gzipSync(readFileSync(path.join(assets, name))).length);
  const total = sizes.reduce((sum, size) => sum + size, 0) / 1000;
  context.diagnostic(`${total.toFixed(1)} kB; at most ${BOUND} kB`);
  assert.ok(total <= BOUND, `${total} kB`);
});
