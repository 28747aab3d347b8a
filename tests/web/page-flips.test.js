// @ts-check
// Edge flips on the page: played, taken back, three criteria side by side, kept and undone;
// the conjecture with its counterexample.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  choice,
  download,
  energy,
  openMesh,
  playAndPause,
  reading,
  stillPicture,
  until,
  untilPictured,
  upload,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";
import { decodePng } from "./support/png.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** Rows of the table of criteria: name, flips, refused, area, W. @param {Page} page */
const table = (page) =>
  page
    .locator("#flips-rows tr")
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));

/** @param {Page} page @param {number} step */
const untilStep = (page, step) =>
  page.waitForFunction(
    (wanted) => Number(document.querySelector("[data-reading=step]")?.textContent) === wanted,
    step,
  );

/** Edges of a downloaded OBJ, as text. @param {Page} page */
async function edges(page) {
  const { bytes } = await download(page, "OBJ");
  const all = new Set();
  for (const line of bytes.toString().split("\n")) {
    if (!line.startsWith("f ")) continue;
    const corners = line.trim().slice(2).split(/\s+/).map(Number);
    corners.forEach((a, n) => {
      const b = corners[(n + 1) % corners.length];
      all.add(`${Math.min(a, b)} ${Math.max(a, b)}`);
    });
  }
  return [...all].sort().join();
}

/**
 * Where on the canvas something is marked, once it is.
 * @param {Page} page
 * @returns {Promise<{ x: number, y: number }>}
 */
async function marked(page) {
  const end = Date.now() + 60_000;
  for (;;) {
    const { width, channels, data } = decodePng(await canvas(page).screenshot());
    let [x, y, count] = [0, 0, 0];
    for (let n = 0; n * channels < data.length; n += 1) {
      const [r, g, b] = data.subarray(n * channels, n * channels + 3);
      if (r > 215 && g < 130 && b < 90 && r > 2 * g) {
        x += n % width;
        y += Math.floor(n / width);
        count += 1;
      }
    }
    if (count > 5) return { x: x / count, y: y / count };
    assert.ok(Date.now() < end, "nothing is marked");
  }
}

test("flips are stepped, played, and taken back to the start", async () => {
  const { page, faults, close } = await site.open("sample=uneven-torus&wireframe=true");
  assert.equal(await choice(page, "Flow").inputValue(), "flips");
  const start = await edges(page);
  const [before, atStart] = [await energy(page), await stillPicture(page)];
  await button(page, "Step").click();
  await untilStep(page, 1);
  assert.ok((await energy(page)) < before);
  const one = await edges(page);
  assert.notEqual(one, start);
  // The flipped edge is seen.
  await untilPictured(page, atStart, (mean) => mean > 0.05);
  await choice(page, "A step is").selectOption("10 flips");
  await button(page, "Step").click();
  await untilStep(page, 11);
  assert.equal(await reading(page, "Step size"), "10 flips");
  await button(page, "Back").click();
  await untilStep(page, 1);
  assert.equal(await edges(page), one);
  const step = await playAndPause(page, 30);
  assert.ok(step >= 31 && step < 240, `paused at ${step}`);
  await button(page, "Flip to the end").click();
  await untilStep(page, 240);
  assert.equal(Number((await energy(page)).toFixed(3)), 108.351);
  await button(page, "Step").click();
  await until(page, /^Converged after 240 steps$/);
  await page.getByText("No flip lowers the localised Willmore energy any more").waitFor();
  await button(page, "Reset").click();
  await untilStep(page, 0);
  assert.equal(await edges(page), start);
  assert.deepEqual(faults, []);
  await close();
});

test("three criteria run side by side, under one camera", async () => {
  const { page, faults, close } = await site.open("sample=uneven-torus&compare=criteria");
  const panes = page.locator("main").getByRole("img", { name: /^Surface:/ });
  assert.equal(await panes.count(), 3);
  await button(page, "Flip to the end").click();
  await untilStep(page, 240);
  const rows = await table(page);
  assert.deepEqual(
    rows.map((row) => row.slice(0, 2)),
    [
      ["Start", "0"],
      ["Area", "240"],
      ["Willmore energy", "235"],
      ["Localised Willmore energy", "240"],
    ],
  );
  const [area, willmore, localised] = rows.slice(1).map((row) => Number(row[4]));
  assert.ok(area === localised && willmore < area, `${rows}`);
  await page.getByRole("img", { name: /Willmore energy: 235 flips, area 15.5635/ }).waitFor();
  // Turning one turns the others.
  const other = page.getByRole("img", { name: /^Surface: .*Area: 240 flips/ });
  const still = await other.screenshot();
  await canvas(page).first().focus();
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => location.hash.includes("camera="));
  const end = Date.now() + 60_000;
  while ((await other.screenshot()).equals(still)) assert.ok(Date.now() < end, "it does not turn");
  // Figure 6: the Gaussian curvature of the limit surface, before and after.
  await choice(page, "Beside it").selectOption("The start");
  await choice(page, "Subdivide").selectOption("Twice");
  await choice(page, "Colour by").selectOption("Gaussian curvature K");
  await page.getByRole("img", { name: /Start: area 15\./ }).waitFor();
  await page.getByRole("img", { name: /^Colours: Gaussian curvature K from/ }).waitFor();
  assert.equal(await panes.count(), 2);
  await choice(page, "Beside it").selectOption("Nothing");
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 1);
  await page.waitForFunction(() => location.hash.includes("subdivide=2"));
  assert.deepEqual(faults, []);
  await close();
});

test("a link brings criterion, flips and arrangement back", async () => {
  const scene = "sample=sampled-torus&criterion=area&flipsPerStep=10&compare=start&step=50";
  const { page, faults, close } = await site.open(scene);
  assert.equal(await choice(page, "Criterion").inputValue(), "area");
  assert.equal(await choice(page, "A step is").inputValue(), "10");
  assert.equal(await reading(page, "Step"), "50");
  assert.equal(await page.locator(".pane").count(), 2);
  await page.waitForFunction(
    (all) => all.every((word) => location.hash.includes(word)),
    ["criterion=area", "flipsPerStep=10", "compare=start", "step=50"],
  );
  assert.deepEqual(faults, []);
  await close();
});

test("a flow goes on from the flipped mesh, and Undo brings the old one back", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "wavy.obj", obj(wavyTorus(32, 16)));
  await choice(page, "Flow").selectOption("Edge flips");
  const start = await edges(page);
  await button(page, "Flip to the end").click();
  await page.waitForFunction(
    () => Number(document.querySelector("[data-reading=step]")?.textContent) > 20,
  );
  const flipped = await edges(page);
  const low = await energy(page);
  await choice(page, "Flow").selectOption("Willmore by circle angles");
  await page
    .getByRole("log")
    .getByText(/Undo brings the one before back/)
    .waitFor();
  await until(page, "Ready");
  assert.equal(await energy(page), low);
  assert.equal(await edges(page), flipped);
  await playAndPause(page, 2);
  assert.ok((await energy(page)) < low);
  await button(page, "Keep as new start").click();
  await until(page, "Ready");
  await button(page, "Undo").click();
  await page.waitForFunction(() =>
    document.querySelector("#undo-note")?.textContent?.includes("flips"),
  );
  await button(page, "Undo").click();
  await page.waitForFunction(
    () => /** @type {HTMLSelectElement} */ (document.querySelector("#flow")).value === "flips",
  );
  await until(page, /^Paused at step \d\d/);
  assert.equal(await edges(page), flipped);
  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await edges(page), start);
  assert.equal(await button(page, "Undo").isVisible(), false);
  // A mesh that cannot be flipped is refused in words.
  await upload(
    page,
    "quads.obj",
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n",
  );
  await page
    .getByRole("alert")
    .getByText(/face 0 has 4 corners/)
    .waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("the conjecture is refuted by an edge that can be looked at", async () => {
  const { page, faults, close } = await site.open("sample=counterexample");
  await page.getByText("The conjecture: area against localised energy").click();
  await page.getByText("That is refuted.").waitFor();
  await page.getByText("On this mesh it holds for 0.00 % of 1 edges and fails for 1.").waitFor();
  const numbers = page.locator("#quadrilateral");
  await numbers.getByText("−0.0454177 of 7.5000").waitFor();
  await numbers.getByText("+0.00679115").waitFor();
  await numbers.getByText("(0, 4, 0)").waitFor();
  assert.equal(await page.locator("#quadrant-localised").textContent(), "1");
  await page
    .getByRole("img", { name: /1 edges: 0 lower both, 0 neither, 0 only the area, 1 only/ })
    .waitFor();
  // Flipped, the edge is one whose flip back raises the localised energy and lowers the area.
  await button(page, "Step").click();
  await untilStep(page, 1);
  await numbers.getByText("+0.0454177 of").waitFor();
  assert.equal(await page.locator("#quadrant-area").textContent(), "1");
  // The lab, which needs no mesh.
  await page.getByText("Random quadrilaterals", { exact: true }).click();
  await button(page, "Draw quadrilaterals").click();
  await page.getByText(/^[1-9][\d,]* random tetrahedra, [\d,]+ against: 0\.\d+ %/).waitFor();
  const drawn = () => page.locator("#lab-rows td:nth-child(2)").first().textContent();
  const first = await drawn();
  await page.waitForFunction(
    (before) => document.querySelector("#lab-rows td:nth-child(2)")?.textContent !== before,
    first,
  );
  await button(page, "Stop").click();
  await button(page, "Draw quadrilaterals").waitFor();
  assert.equal(await page.locator("#lab-rows tr").count(), 10);
  assert.deepEqual(faults, []);
  await close();
});

test("counterexamples are found on the surface by a click", async () => {
  const { page, faults, close } = await site.open("sample=creased-face");
  await page.getByText("The conjecture: area against localised energy").click();
  await page
    .getByText(/On this mesh it holds for 99\.9\d+ % of \d+ edges and fails for 1\./)
    .waitFor();
  const list = page.getByRole("listbox", { name: /Counterexamples/ });
  const name = (await list.locator("option").first().textContent()) ?? "";
  assert.match(name, /^Edge \d+–\d+: f_a \+2\.24849e-4, f_l −0\.00196692$/);
  const place = await marked(page);
  // Another dot, by its place in the plot: the lower left is full of edges that agree.
  const dots = page.locator("#scatter");
  const box = await dots.boundingBox();
  if (!box) throw new Error("no plot");
  const numbers = page.locator("#quadrilateral");
  await numbers.getByText("f_a, area gained").waitFor();
  const before = await numbers.textContent();
  await dots.click({ position: { x: box.width * 0.44, y: box.height * 0.56 } });
  await page.waitForFunction(
    (text) => document.querySelector("#quadrilateral")?.textContent !== text,
    before,
  );
  assert.equal(await list.inputValue(), "");
  await canvas(page).click({ position: place });
  await page.waitForFunction(
    (text) => document.querySelector("#quadrilateral")?.textContent === text,
    before,
  );
  assert.equal(await list.inputValue(), "0");
  assert.deepEqual(faults, []);
  await close();
});
