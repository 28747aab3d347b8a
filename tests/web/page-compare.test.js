// @ts-check
// Flows compared: panes from one start that step together, flipped in place, coloured by how
// far they are apart, plotted together; lost solvers; and the way through a link.

import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession } from "../../www/cli/solver.js";
import { button, choice, until, useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** What stands under the panes. @param {Page} page */
const captions = (page) => page.locator("#panes figcaption").allTextContents();

/** @param {Page} page @param {RegExp} pattern  of all captions, one a line */
async function untilCaptions(page, pattern) {
  await page.waitForFunction(
    ([source, flags]) => {
      const all = [...document.querySelectorAll("#panes figcaption")];
      const lines = all.map((caption) => caption.textContent).join("\n");
      return new RegExp(source, flags).test(lines);
    },
    [pattern.source, pattern.flags],
  );
  return captions(page);
}

/** The table of the plot: a row a step, a column a pane. @param {Page} page */
async function table(page) {
  const details = page.locator("#comparison-data");
  if ((await details.getAttribute("open")) === null) await details.locator("summary").click();
  return page
    .locator("#comparison-rows tr")
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent)));
}

/**
 * The same run without a page.
 * @param {object} options @param {number} steps
 */
async function alone(options, steps) {
  const session = await openSession();
  session.sample("icosahedron", { level: 4 });
  const { state } = session.configure(options);
  const energies = [state.energy];
  for (let i = 0; i < steps; i += 1) energies.push(session.step().energy);
  const positions = session.positions();
  session.free();
  return { energies, positions };
}

/** @param {(string | null)[][]} rows @param {number} pane */
const column = (rows, pane) => rows.map((row) => Number(row[pane + 1]));

/** @param {number} value */
const sixDigits = (value) => Number(value.toPrecision(6));

test("two panes step together, and each is what it is by itself", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron");
  await page.locator("#comparison > summary").click();
  await button(page, "Add a pane").click();
  await untilCaptions(page, /^A: .*step 0.*\nB: .*step 0/);
  const epsilon = page.getByLabel("Smoothing ε", { exact: true });
  await epsilon.fill("0.01");
  await epsilon.press("Tab");
  await untilCaptions(page, /^A: ε = 0.1 .*\nB: ε = 0.01 .*step 0/);
  // At the start there is no difference.
  await choice(page, "Panes’ colours").selectOption("Distance to A");
  await page.getByRole("img", { name: "Colours: Distance to A from 0 to 0" }).waitFor();
  for (const step of [1, 2, 3]) {
    await button(page, "Step").click();
    await untilCaptions(page, new RegExp(`^A: .*step ${step},.*\\nB: .*step ${step},`));
  }
  const [a, b] = [await alone({ epsilon: 0.1 }, 3), await alone({ epsilon: 0.01 }, 3)];
  const rows = await table(page);
  assert.deepEqual(column(rows, 0), a.energies.map(sixDigits));
  assert.deepEqual(column(rows, 1), b.energies.map(sixDigits));
  let apart = 0;
  for (let k = 0; k < a.positions.length; k += 3) {
    const [x, y, z] = [0, 1, 2].map((i) => a.positions[k + i] - b.positions[k + i]);
    apart = Math.max(apart, Math.hypot(x, y, z));
  }
  assert.ok(apart > 1e-4);
  const bar = page.getByRole("img", { name: /^Colours: Distance to A from 0 to / });
  const high = Number(/to ([\d.e-]+)$/.exec((await bar.getAttribute("aria-label")) ?? "")?.[1]);
  assert.ok(Math.abs(high - apart) < 0.006 * apart, `${high} on the bar, ${apart} computed`);

  // The same quantity for both: ∫H² dA of the start is one number.
  await choice(page, "Quantity").selectOption({ label: "∫H² dA, for all alike" });
  const bending = await table(page);
  assert.equal(bending[0][1], bending[0][2]);
  assert.notEqual(bending[3][1], bending[3][2]);

  // One step back, and to the start.
  await button(page, "Back").click();
  await untilCaptions(page, /^A: .*step 2,.*\nB: .*step 2,/);
  await button(page, "Reset").click();
  await untilCaptions(page, /^A: .*step 0,.*\nB: .*step 0,/);
  await page.getByRole("img", { name: "Colours: Distance to A from 0 to 0" }).waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);

  // Played, they keep step.
  await button(page, "Play").click();
  await untilCaptions(page, /^A: .*step ([4-9]|\d\d),/);
  await button(page, "Pause").click();
  await until(page, /^Paused at step/);
  const steps = (await captions(page)).map((text) => Number(/step (\d+)/.exec(text)?.[1]));
  assert.equal(steps[0], steps[1]);
  assert.deepEqual(faults, []);
  await close();
});
