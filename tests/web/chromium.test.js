// @ts-check
// The browser itself: that its switches give a WebGPU canvas that reaches the screen. When
// this fails, every other browser test's failure is explained.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { launch, openPage, picture } from "./support/browser.js";
import { serve } from "./support/server.js";

/** A canvas cleared to one colour. */
const page = `<!doctype html>
<link rel="icon" href="data:,">
<canvas width="64" height="64"></canvas>
<script type="module">
  const adapter = await navigator.gpu?.requestAdapter();
  document.title = adapter ? "adapter" : "none";
  if (adapter) {
    const device = await adapter.requestDevice();
    const context = document.querySelector("canvas").getContext("webgpu");
    context.configure({ device, format: navigator.gpu.getPreferredCanvasFormat() });
    const encoder = device.createCommandEncoder();
    const view = context.getCurrentTexture().createView();
    const clearValue = { r: 0.8, g: 0.4, b: 0.2, a: 1 };
    encoder
      .beginRenderPass({ colorAttachments: [{ view, clearValue, loadOp: "clear", storeOp: "store" }] })
      .end();
    device.queue.submit([encoder.finish()]);
    await device.queue.onSubmittedWorkDone();
  }
  document.body.dataset.done = "";
</script>`;

let folder = "";
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
before(async () => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  writeFileSync(path.join(folder, "index.html"), page);
  server = await serve(folder);
});
after(async () => {
  await server.close();
  rmSync(folder, { recursive: true });
});

/** @param {{ webgpu: boolean }} options */
async function show(options) {
  const browser = await launch(options);
  try {
    const { page, faults } = await openPage(browser);
    await page.goto(server.url);
    await page.locator("body[data-done]").waitFor();
    return {
      adapter: await page.title(),
      canvas: await picture(page.locator("canvas")),
      faults,
    };
  } finally {
    await browser.close();
  }
}

test("WebGPU draws on a canvas, and the canvas is on the screen", async () => {
  const { adapter, canvas, faults } = await show({ webgpu: true });
  assert.equal(adapter, "adapter");
  for (const [channel, value] of [204, 102, 51].entries()) {
    assert.ok(Math.abs(canvas.mean[channel] - value) < 2, `mean colour is ${canvas.mean}`);
  }
  assert.deepEqual(faults, []);
});

// Elsewhere Chromium may find a real graphics card by itself.
test("without WebGPU there is no adapter", { skip: process.platform !== "linux" }, async () => {
  const { adapter } = await show({ webgpu: false });
  assert.equal(adapter, "none");
});
