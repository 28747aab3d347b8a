// @ts-check
// Why did this happen: said when a flow stops, shown on the surface, and mended by a button.
// A refinement study fills its table while the flow stays where it is.

import assert from "node:assert/strict";
import { test } from "node:test";
import { facing } from "../../www/facing.js";
import {
  button,
  choice,
  energy,
  reading,
  stillPicture,
  until,
  untilPictured,
  useSite,
} from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page @param {RegExp} wanted */
const said = (page, wanted) => page.locator("#why-sentence").filter({ hasText: wanted }).waitFor();

/** Cells of the study's table. @param {Page} page @returns {Promise<string[][]>} */
const cells = (page) =>
  page
    .locator("#study-rows tr")
    .evaluateAll((rows) =>
      rows.map((row) => [...row.children].map((cell) => cell.firstChild?.textContent ?? "")),
    );

test("a camera turns to a direction and stays where it was otherwise", () => {
  const axis = [0, 1, 0];
  const camera = Float32Array.from([0.1, 0.2, 0.3, 5, 0, 0, 0, 1, ...axis]);
  for (const direction of /** @type {[number, number, number][]} */ ([
    [1, 2, 3],
    [-1, 0.1, -2],
    [0, -0.4, 1],
    [0.2, -3, -0.1],
  ])) {
    const turned = facing(camera, direction);
    assert.ok(turned);
    assert.deepEqual([...turned.slice(0, 4)], [...camera.slice(0, 4)]);
    const [x, y, z, w] = turned.slice(4, 8);
    // Third column of the rotation: the backward axis; second: up, in the plane of the axis.
    const backward = [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)];
    const length = Math.hypot(...direction);
    backward.forEach((part, k) => {
      assert.ok(Math.abs(part - direction[k] / length) < 1e-6);
    });
    assert.ok(Math.abs(2 * (x * y + z * w)) < 1e-6, "the right axis is horizontal");
    assert.ok(1 - 2 * (x * x + z * z) > 0, "and up is up");
  }
  assert.equal(facing(camera, [0, 0, 0]), null);
  assert.equal(facing(camera, [0, 2, 0]), null);
});

test("a stalled flow says why, shows where, and a remedy makes it go on", async () => {
  const { page, faults, close } = await site.open("sample=clifford-torus&epsilon=0");
  assert.equal(await page.locator("#why").isVisible(), false, "nothing has happened yet");
  const before = await stillPicture(page);
  await button(page, "Play").click();
  await until(page, /^Stalled/);
  await said(page, /At 1024 edges the four points .* lie on one circle.*ε = 0 no step descends/);
  const show = button(page, "Show");
  await show.click();
  assert.equal(await show.getAttribute("aria-pressed"), "true");
  await untilPictured(page, before, (mean) => mean > 1);
  assert.deepEqual(await accessibilityFaults(page), []);
  await show.click();
  assert.equal(await show.getAttribute("aria-pressed"), "false");
  // The answer can be folded away, and comes back.
  await button(page, "Why?").click();
  assert.equal(await page.locator("#why-answer").isVisible(), false);
  await button(page, "Why?").click();
  await button(page, "Set ε to 0.01").click();
  await page.waitForFunction(
    () => Number(document.querySelector("[data-reading=step]")?.textContent) > 3,
  );
  assert.equal(await page.locator("#option-epsilon").inputValue(), "0.01");
  assert.equal(await page.locator("#why").isVisible(), false, "a flow that runs has no reasons");
  await page.locator("#play").click();
  assert.deepEqual(faults, []);
  await close();
});

test("a mesh that folds is mended, and a refusal offers what helps", async () => {
  const { page, faults, close } = await site.open("sample=bad-mesh");
  for (let step = 1; step <= 3; step += 1) {
    await button(page, "Step").click();
    await until(page, `Paused at step ${step}`);
  }
  await said(page, /\d+ faces are folded over.*go astray\.$/);
  const angle = Number.parseFloat(await reading(page, "Smallest angle"));
  const folded = await energy(page);
  await button(page, "Regularise the mesh and go on").click();
  await until(page, /^(Running|Converged)/);
  await page.waitForFunction(
    (least) => Number(document.querySelector("[data-reading=energy]")?.textContent) < least,
    folded / 2,
  );
  assert.ok(Number.parseFloat(await reading(page, "Smallest angle")) > angle + 5);
  await choice(page, "Sample").selectOption({ label: "Pipe with clamped ends" });
  await until(page, "Ready");
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  const refusal = page.getByRole("alert").locator(".message");
  await refusal.filter({ hasText: "2 boundary loops" }).waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);
  await refusal.getByRole("button", { name: "Fill holes", exact: true }).click();
  await page.locator("#loops input").first().waitFor();
  assert.equal(await page.locator("#holes").getAttribute("open"), "");
  assert.deepEqual(faults, []);
  await close();
});

test("a refinement study tells what converges, and leaves the surface alone", async () => {
  const { page, faults, close } = await site.open("sample=clifford-torus");
  const [area, start] = [await reading(page, "Area"), await energy(page)];
  const study = page.locator("#study");
  await study.getByText("Refinement study").first().click();
  await button(page, "Run the study").click();
  const findings = page.locator("#study-findings");
  await findings.getByText(/arXiv 1901\.09990/).waitFor();
  const rows = await cells(page);
  assert.deepEqual(
    rows.map(([vertices]) => vertices),
    ["1024", "4096", "16384", "65536"],
  );
  // W/2 and both ∫H² against 2π².
  const last = rows.at(-1)?.map(Number) ?? [];
  for (const value of last.slice(3)) {
    assert.ok(Math.abs(value / (2 * Math.PI ** 2) - 1) < 2e-3, `${value}`);
  }
  assert.match(
    (await findings.textContent()) ?? "",
    /W\/2 tends to the smooth value 19\.739; observed order (1\.9|2\.0)/,
  );
  assert.ok((await page.locator("#study-plot path").count()) > 4);
  assert.deepEqual(await accessibilityFaults(page), []);
  // Of the surface as it is, by Loop's scheme; ended on the way.
  await choice(page, "Surface").selectOption({ label: "The surface as it is now" });
  await button(page, "Run the study").click();
  await page.locator("#study-manner").filter({ hasText: "Loop’s scheme" }).waitFor();
  const cancel = button(page, "Cancel");
  if (await cancel.isVisible()) {
    await cancel.click();
    await page
      .locator("#study-status")
      .filter({ hasText: /Cancelled|Done/ })
      .waitFor();
  }
  assert.deepEqual([await reading(page, "Area"), await energy(page)], [area, start]);
  assert.deepEqual(faults, []);
  await close();
});
