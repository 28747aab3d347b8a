// @ts-check
// Seeing the mathematics: Möbius inversion, a vertex with its circles, lines of curvature,
// equations, the histogram.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, energy, stillPicture, until, untilPictured, useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** Rows of a table, as texts. @param {Page} page @param {string} id  of its body */
const rows = (page, id) =>
  page
    .locator(`${id} tr`)
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));

test("an inversion changes the shape and not W, is kept and undone", async () => {
  const { page, faults, close } = await site.open();
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  const before = await energy(page);
  const start = await stillPicture(page);
  await page.getByText("Möbius inversion").click();
  await page.locator("#moebius-rows tr").first().waitFor();
  const first = await rows(page, "#moebius-rows");
  const seen = await untilPictured(page, start, (mean) => mean > 1);
  // Dragged by the pointer, then by arrow keys: each tells of another shape, and the same W.
  const handle = page.getByRole("button", { name: "Centre of the inversion" });
  const box = await handle.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x - 60, box.y + 30, { steps: 5 });
  await page.mouse.up();
  const told = (/** @type {string[][]} */ was) =>
    page.waitForFunction(
      (text) => document.querySelector("#moebius-rows tr:nth-child(2)")?.textContent !== text,
      was[1].join(""),
    );
  await told(first);
  await untilPictured(page, seen, (mean) => mean > 0.1);
  const dragged = await rows(page, "#moebius-rows");
  await handle.press("Shift+ArrowRight");
  await told(dragged);
  const [w, lumped] = await rows(page, "#moebius-rows");
  assert.equal(w[0], "W");
  assert.ok(Math.abs(Number(w[3])) < 1e-10, `ΔW ${w[3]}`);
  assert.ok(Math.abs(Number(w[1]) - before) < 1e-4 * before);
  assert.ok(Math.abs(Number(lumped[3])) > 1e-4, `Δ∫H² ${lumped[3]}`);
  assert.deepEqual(await accessibilityFaults(page), []);
  // A centre that will not do is refused in words, and the last picture stays.
  const inputs = page.locator("#moebius input");
  const x = await inputs.first().inputValue();
  await inputs.first().fill("2000");
  const refusal = page.getByText(/the centre is more than 1000 times the size/);
  await refusal.waitFor();
  await inputs.first().fill(x);
  await refusal.waitFor({ state: "hidden" });
  await button(page, "Keep").click();
  await page
    .getByRole("log")
    .getByText(/The surface is inverted; W has changed by/)
    .waitFor();
  await until(page, "Ready");
  assert.ok(Math.abs((await energy(page)) - before) < 1e-4 * before, "W is kept");
  await button(page, "Undo").click();
  await page.waitForFunction(() => document.querySelector("#undo")?.closest("[hidden]"));
  assert.ok(Math.abs((await energy(page)) - 188.496) < 1e-2, "the start is back");
  assert.deepEqual(faults, []);
  await close();
});
