// @ts-check
// Flows compared: panes from one start that step together, flipped in place, coloured by how
// far they are apart, plotted together; lost solvers; and the way through a link.

import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession } from "../../www/cli/solver.js";
import { perform } from "../../www/session.js";
import { button, choice, playAndPause, until, useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { difference } from "./support/browser.js";
import { decodePng } from "./support/png.js";

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
  // Filled once the table is seen to be open, a task later.
  await page.locator("#comparison-rows tr").first().waitFor();
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
  perform(session, "sample", { name: "icosahedron", parameters: { level: 4 } });
  const { state } = perform(session, "configure", { options });
  const energies = [state.energy];
  for (let i = 0; i < steps; i += 1) {
    energies.push(perform(session, "step")?.energy ?? Number.NaN);
  }
  const positions = session.frame().positions;
  session.free();
  return { energies, positions };
}

/** Whether a surface has the blue of negative values, which it has not by itself. @param {Buffer} png */
function isColoured(png) {
  const { channels, data } = decodePng(png);
  let blue = 0;
  for (let i = 0; i < data.length; i += channels) if (data[i + 2] > data[i] + 15) blue += 1;
  return blue > 100;
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
  const form = page.locator(".pane-form").first();
  const epsilon = form.getByLabel("Angle smoothing ε", { exact: true });
  await epsilon.fill("0.01");
  await epsilon.press("Tab");
  await untilCaptions(page, /^A: ε = 0.1 .*\nB: ε = 0.01 .*step 0/);
  // At the start there is no difference.
  await choice(page, "Colours").selectOption("Distance to A");
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
  // Paused from within the page: from without it the flow may be at rest before.
  await playAndPause(page, 4);
  await until(page, /^Paused at step/);
  const steps = (await captions(page)).map((text) => Number(/step (\d+)/.exec(text)?.[1]));
  assert.equal(steps[0], steps[1]);
  assert.deepEqual(faults, []);
  await close();
});

test("A and B are flipped in place, by key and by button", async () => {
  const { page, faults, close } = await site.open(
    "sample=icosahedron&panes=epsilon_0.01&difference=A&step=2",
  );
  await untilCaptions(page, /^A: ε = 0.1 · step 2,.*\nB: ε = 0.01 · step 2,/);
  await page.getByRole("img", { name: /^Colours: Distance to A from 0 to (?!0$)/ }).waitFor();
  const shown = page.locator("#panes figure").filter({ visible: true });
  assert.equal(await shown.count(), 2);
  /** A picture of what is in place, once it differs from another. @param {Buffer} [other] */
  const pictured = async (other) => {
    const end = Date.now() + 60_000;
    for (;;) {
      const one = await shown.locator("canvas").screenshot();
      const again = await shown.locator("canvas").screenshot();
      if (one.equals(again) && !(other && difference(one, other).mean < 0.5)) return one;
      assert.ok(Date.now() < end, "the picture does not change");
    }
  };
  const said = page.locator("#comparison-said");
  await page.keyboard.press("b");
  await said.filter({ hasText: /^In place: A: ε = 0.1/ }).waitFor();
  assert.equal(await shown.count(), 1);
  const box = await shown.boundingBox();
  const first = await pictured();
  await page.keyboard.press("b");
  await said.filter({ hasText: /^In place: B: ε = 0.01/ }).waitFor();
  // In the same place, and another picture.
  assert.deepEqual(await shown.boundingBox(), box);
  await pictured(first);
  assert.equal(await shown.locator("figcaption").textContent(), (await captions(page))[1]);
  await page.waitForFunction(() => location.hash.includes("shown=B"));
  await page.keyboard.press("Escape");
  await said.filter({ hasText: "All panes side by side." }).waitFor();
  assert.equal(await shown.count(), 2);
  await button(page, "Flip A and B").click();
  assert.equal(await shown.count(), 1);
  await button(page, "Side by side").click();
  assert.equal(await shown.count(), 2);

  await page.waitForFunction(() =>
    location.hash.includes("&panes=epsilon_0.01&difference=A&step=2"),
  );
  // A pane that goes takes its solver along.
  await page.locator(".pane-form").filter({ visible: true }).waitFor();
  assert.equal(page.workers().length, 2);
  await button(page, "Remove pane B").click();
  await page.waitForFunction(() => document.querySelectorAll("#panes figure").length === 1);
  const end = Date.now() + 30_000;
  while (page.workers().length > 1) {
    assert.ok(Date.now() < end, "its worker lives on");
    await page.waitForTimeout(50);
  }
  await page.waitForFunction(() => !location.hash.includes("panes="));
  await page.locator("#colour-bar").waitFor({ state: "hidden" });
  await button(page, "Step").click();
  await until(page, "Paused at step 3");
  await page.keyboard.press("b");
  await page.getByRole("log").getByText("There is no pane to flip to yet").waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("by time the smaller steps are more; a link brings both back to their steps", async () => {
  const scene = "sample=icosahedron&scheme=paper&tau=0.01&panes=tau_0.005&lockstep=time";
  const { page, faults, close } = await site.blank();
  await page.goto(`${site.url}?msaa=1#${scene}`);
  await untilCaptions(page, /^A: τ = 0.01 · step 0,.*\nB: τ = 0.005 · step 0,/);
  const standing = [
    [1, 1],
    [1, 2],
    [2, 3],
    [2, 4],
  ];
  for (const [a, b] of standing) {
    await button(page, "Step").click();
    await untilCaptions(page, new RegExp(`^A: .*step ${a},.*\\nB: .*step ${b},`));
  }
  const times = (await captions(page)).map((text) => /t = (\S+)/.exec(text)?.[1]);
  assert.equal(times[0], times[1]);
  await button(page, "Back").click();
  await untilCaptions(page, /^A: .*step 1,.*\nB: .*step 3,/);
  await page.waitForFunction(() => /panes=tau_0.005_step_3.*&step=1(&|$)/.test(location.hash));
  const link = new URL(page.url()).hash.slice(1);
  assert.deepEqual(faults, []);
  await close();
  const again = await site.open(link);
  await untilCaptions(again.page, /^A: .*step 1,.*\nB: .*step 3,/);
  assert.equal(await choice(again.page, "In lockstep").inputValue(), "time");

  // A flow whose time has another unit can only be kept in step by step.
  const form = again.page.locator(".pane-form");
  await form.getByLabel("Flow", { exact: true }).selectOption("p-willmore");
  await untilCaptions(again.page, /\nB: .*p-Willmore, p = 2.* step 1,/);
  assert.equal(await choice(again.page, "In lockstep").inputValue(), "step");
  await again.page.getByText("these have A: length², B: length⁴.").waitFor();
  assert.deepEqual(again.faults, []);
  await again.close();
});

test("a lost solver costs its pane nothing, and the others go on", async () => {
  const { page, faults, close } = await site.open(
    "sample=icosahedron&panes=epsilon_0.01*epsilon_0.3&step=2",
    { viewport: { width: 390, height: 844 }, hasTouch: true, colorScheme: "dark" },
  );
  await untilCaptions(page, /^A: .*step 2,.*\nB: .*step 2,.*\nC: .*step 2,/);
  await until(page, "Paused at step 2");
  const before = await captions(page);
  // The page's own solver came first.
  await page.workers()[1].evaluate(() => {
    setTimeout(() => {
      throw new Error("made by the test");
    });
  });
  const alert = page.getByRole("alert");
  await alert.getByText(/The solver of pane B stopped .*made by the test.* at step 2/).waitFor();
  assert.deepEqual(await captions(page), before);
  await button(page, "Step").click();
  const after = await untilCaptions(page, /^A: .*step 3,.*\nB: .*step 3,.*\nC: .*step 3,/);
  assert.equal(page.workers().length, 3);
  assert.notDeepEqual(after, before);
  // What does not fit under a small picture is in the panel.
  const seen = await page.locator("#panes figcaption").allInnerTexts();
  assert.match(seen[0], /^A · step 3, energy [\d.]+, t = [\d.e-]+$/);
  await button(page, "Dismiss").click();
  await button(page, "Panel").click();
  await page.locator("#comparison-data > summary").click();
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(
    faults.filter((fault) => !fault.includes("made by the test")),
    [],
  );
  await close();
});

test("a pane opens beside a coloured run whose flow was changed on the way", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere&colour=mean-curvature");
  for (const n of [1, 2, 3]) {
    await button(page, "Step").click();
    await until(page, `Paused at step ${n}`);
  }
  await button(page, "Back").click();
  await until(page, "Paused at step 2");
  await choice(page, "Flow").selectOption("p-willmore");
  await page.locator("#p-willmore").waitFor();
  await button(page, "Step").click();
  await until(page, "Paused at step 3");
  await page.locator("#comparison > summary").click();
  await button(page, "Add a pane").click();
  // One has come by the other flow, the other by this one alone.
  const [a, b] = await untilCaptions(page, /^A: p-Willmore.*step 3,.*\nB: p-Willmore.*step 3,/);
  assert.notEqual(/energy (\S+),/.exec(a)?.[1], /energy (\S+),/.exec(b)?.[1]);
  for (const pane of await page.locator(".pane canvas").all()) {
    for (let tries = 0; !isColoured(await pane.screenshot()); tries += 1) {
      assert.ok(tries < 100, "not coloured");
    }
  }
  // A link brings both back.
  await page.waitForFunction(() => /path=/.test(location.hash));
  const link = await page.evaluate(() => location.hash);
  const again = await site.open(link.slice(1));
  assert.deepEqual(
    await untilCaptions(again.page, /^A: p-Willmore.*step 3,.*\nB: p-Willmore.*step 3,/),
    [a, b],
  );
  assert.deepEqual(again.faults, []);
  await again.close();

  // Back to the flow before, the pane beside is told for what it does, which is another now.
  await button(page, "Back").click();
  await button(page, "Back").click();
  await untilCaptions(
    page,
    /^A: Willmore by circle angles.*step 2,.*\nB: p-Willmore, p = 2 · step 1,/,
  );
  // The one that is behind steps first.
  for (const step of [2, 3]) {
    await button(page, "Step").click();
    const both = `^A: Willmore by circle angles.*step ${step},.*\nB: p-Willmore, p = 2 · step ${step},`;
    await untilCaptions(page, new RegExp(both));
  }
  assert.equal(await page.getByRole("alert").textContent(), "");
  assert.deepEqual(faults, []);
  await close();
});

test("panes follow the mesh and the first flow; one that cannot says why", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron&panes=epsilon_0.01");
  await untilCaptions(page, /^A: ε = 0.1 · step 0,.*\nB: ε = 0.01 · step 0,/);
  await button(page, "Step").click();
  await untilCaptions(page, /^A: .*step 1,.*\nB: .*step 1,/);
  // What the first does anew, the others do too; they all are at the start again.
  await page.locator("#method > summary").click();
  await page.locator("#option-scheme").selectOption("paper");
  await untilCaptions(page, /^A: .*step 0,.*\nB: .*step 0,/);
  // A new pane comes to where the others are.
  await button(page, "Step").click();
  await untilCaptions(page, /^A: .*step 1,.*\nB: .*step 1,/);
  await button(page, "Add a pane").click();
  await untilCaptions(page, /^A: .*step 1,.*\nB: .*step 1,.*\nC: .*step 1,/);
  await until(page, "Paused at step 1");

  // Kept as the start, and that undone: the start of all.
  const energies = async () =>
    (await captions(page)).map((text) => /energy (\S+),/.exec(text)?.[1]);
  await button(page, "Keep as new start").click();
  await untilCaptions(page, /^A: .*step 0,.*\nB: .*step 0,.*\nC: .*step 0,/);
  await until(page, "Ready");
  const [kept, ...others] = await energies();
  assert.deepEqual([kept, kept], others);
  assert.notEqual(kept, "188.5");
  await button(page, "Undo").click();
  await untilCaptions(page, /^A: .*energy 188\..*\nB: .*energy 188\..*\nC: .*energy 188\./);

  await choice(page, "Sample").selectOption({ label: "Saddle, boundary free" });
  await untilCaptions(page, /^A: .*step 0, energy .*\nB: .*step 0,.*\nC: .*step 0,/);
  await until(page, "Ready");
  const [a, b] = await captions(page);
  assert.notEqual(/energy (\S+),/.exec(a)?.[1], "188.5");
  assert.equal(/energy (\S+),/.exec(a)?.[1], /energy (\S+),/.exec(b)?.[1]);
  const flow = page.locator(".pane-form").first().getByLabel("Flow", { exact: true });
  await flow.selectOption("p-willmore");
  await page
    .getByRole("alert")
    .getByText(/closed/)
    .waitFor();
  const exponents = page.locator("#preset option").filter({ hasText: "p = 1, 2, 3, 4" });
  assert.match((await exponents.textContent()) ?? "", /closed surfaces only/);
  // Refused: what was before is in force.
  await page.waitForFunction(
    () => /** @type {any} */ (document.querySelector(".pane-form select")).value === "circle",
  );
  // From a link it stays in its pane, saying why, and the first steps without it.
  assert.deepEqual(faults, []);
  await close();
  const linked = await site.open("sample=saddle&boundary=free&panes=flow_p-willmore");
  await untilCaptions(linked.page, /\nB: p-Willmore, p = 2 · .*closed/i);
  await button(linked.page, "Step").click();
  await untilCaptions(linked.page, /^A: .*step 1,/);
  assert.deepEqual(linked.faults, []);
  await linked.close();
});
