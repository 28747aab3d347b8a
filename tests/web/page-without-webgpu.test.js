// @ts-check
// A browser with neither WebGPU nor WebGL2: told so in plain words, and everything but the picture works.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  download,
  energy,
  openMesh,
  playAndPause,
  plotted,
  reading,
  until,
  useSite,
} from "./support/app.js";
import { picture } from "./support/browser.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite({ webgpu: false, webgl: false });

// Elsewhere Chromium may find a real graphics card by itself.
const skip = process.platform !== "linux" && "this system may have graphics all the same";

test("without graphics the page says what is missing and what to do", { skip }, async () => {
  const { page, faults, close } = await site.blank();
  /** @type {string[]} */
  const asked = [];
  page.on("request", (request) => asked.push(request.url()));
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  const said = page.locator(".absence");
  await said.waitFor();
  const text = (await said.textContent()) ?? "";
  assert.match(text, /WebGPU.* no WebGL2/s);
  assert.match(text, /Chrome.*Edge.*Firefox.*Safari/s, "browsers that have it");
  assert.match(text, /works without it/);
  assert.doesNotMatch(text, /undefined|\[object|TypeError/);
  assert.equal(await page.locator("#surface").isVisible(), false);
  assert.deepEqual(
    asked.filter((url) => url.includes("viewer-webgl")),
    [],
    "fetched in vain",
  );
  assert.deepEqual(faults, []);
  await close();
});

test("without graphics the flow runs, is read, plotted and saved", { skip }, async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  const atStart = await energy(page);
  const step = await playAndPause(page, 3);
  assert.ok((await energy(page)) < atStart);
  assert.equal(await reading(page, "Faces"), "2304");
  assert.ok((await plotted(page)).length > step);
  const plot = await picture(page.locator(".curve"));
  assert.ok(plot.colours > 10, `the curve shows ${plot.colours} colours`);
  const { name, bytes } = await download(page, "OBJ");
  assert.equal(name, `wavy-circle-step${String(step).padStart(4, "0")}.obj`);
  assert.equal(bytes.toString().match(/^v /gm)?.length, 1152);
  assert.equal(bytes.toString().match(/^f /gm)?.length, 2304);
  assert.deepEqual(faults, []);

  await page.getByRole("combobox", { name: "Save as" }).selectOption({ label: "Picture, PNG" });
  await button(page, "Download").click();
  await page.getByRole("alert").getByText("There is no picture to save").waitFor();
  assert.deepEqual(faults, []);
  await close();
});
