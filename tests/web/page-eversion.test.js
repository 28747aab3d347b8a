// @ts-check
// The sphere turned inside out: one press computes both halves, and they play as one film.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  openPart,
  openTab,
  plotted,
  reading,
  surface,
  until,
  untilDrawn,
  useSite,
} from "./support/app.js";

const site = useSite();

const SPHERE = 4 * Math.PI;
/** The volume of the ball of the area of the round sphere, of radius 1. */
const BALL = (4 * Math.PI) / 3;

test("the film of the eversion: from a sphere over the halfway surface to the sphere inside out", async () => {
  const { page, faults, close } = await site.open("figure=eversion");
  assert.match(await surface(page), /^Surface: Morin’s surface, pushed, step 0, energy/);
  const halfway = Number(await reading(page, "Energy"));
  assert.ok(halfway > 3.8 * SPHERE && halfway < 4.2 * SPHERE, `${halfway}`);
  assert.ok(Number(await reading(page, "Pairs of triangles that cross")) > 300);
  await button(page, "Play").click();
  await until(page, /^Converged/);
  // The whole film is there, one row a step, the steps of the first half counted backwards.
  const rows = await plotted(page);
  const steps = rows.map(([step]) => step);
  const [first, last] = [steps[0], steps[steps.length - 1]];
  assert.ok(first < -50 && last > 50, `${first} to ${last}`);
  assert.ok(
    steps.every((step, n) => n === 0 || step > steps[n - 1]),
    "in order, each once",
  );
  // Energy rises from the sphere to the halfway surface and falls again; a pass may add two per cent.
  const energies = rows.map((row) => row[3]);
  const top = energies.indexOf(Math.max(...energies));
  assert.ok(Math.abs(steps[top]) <= 20, `the highest at step ${steps[top]}`);
  // Of a long run the table has every second step.
  const seam = steps.findIndex((step) => step >= 0);
  assert.ok(energies[top] < 1.03 * energies[seam], "nowhere much above the halfway surface");
  for (const [n, energy] of energies.entries()) {
    const before = n <= top ? energies[n + 1] : energies[n - 1];
    if (n !== top) assert.ok(energy < 1.03 * before, `step ${steps[n]}: ${energy} and ${before}`);
  }
  for (const end of [energies[0], energies[energies.length - 1]]) {
    assert.ok(end < 1.005 * SPHERE && end > 0.985 * SPHERE, `${end}`);
  }
  // The volume goes from that of the ball to its opposite.
  const volumes = rows.map((row) => row[5]);
  const radius = (/** @type {number[]} */ row) => Math.sqrt(row[4] / SPHERE);
  for (const [row, sign] of /** @type {const} */ ([
    [rows[0], 1],
    [rows[rows.length - 1], -1],
  ])) {
    const share = row[5] / (BALL * radius(row) ** 3);
    assert.ok(Math.abs(share - sign) < 0.01, `${share}`);
  }
  const turned = volumes.findIndex((volume) => volume < 0);
  assert.ok(Math.abs(steps[turned]) < 15, `inside out from step ${steps[turned]} on`);
  // At rest at one end and at the other the solver is where the display stands.
  assert.equal(await reading(page, "Pairs of triangles that cross"), "0");
  // The figure is read where the table was.
  await button(page, "Table of all steps").click();
  const figure = page.locator("section.figure .measured");
  await figure.filter({ hasText: "least product of normals" }).waitFor();
  assert.match((await figure.getAttribute("class")) ?? "", /good/);
  const scrubber = page.getByRole("slider", { name: "History" });
  await scrubber.focus();
  await page.keyboard.press("Home");
  await until(page, `Converged after ${-first} steps`);
  assert.equal(await reading(page, "Step"), String(first));
  assert.ok(Number.parseFloat(await reading(page, "Volume")) > 0);
  await page.keyboard.press("End");
  await until(page, `Converged after ${last} steps`);
  assert.ok(Number.parseFloat((await reading(page, "Volume")).replace("−", "-")) < 0);
  // Over the seam the volume changes no more than from step to step elsewhere.
  const jump = Math.abs(volumes[seam] - volumes[seam - 1]);
  assert.ok(jump < 0.06 * BALL, `${jump} over the seam`);
  // It plays again from its beginning.
  await openTab(page, "Flow");
  await button(page, "Play").click();
  await until(page, "Running");
  await button(page, "Pause").click();
  await until(page, /^Paused at step -/);
  await untilDrawn(page);
  // A link to it leads to this step of that half, and no further.
  const at = await reading(page, "Step");
  await page.waitForFunction((step) => location.hash.includes(`&step=${step}&`), at);
  const linked = await site.open(new URL(page.url()).hash.slice(1));
  await until(linked.page, `Paused at step ${at}`);
  await linked.page
    .getByText(/^The scene is as it was sent/)
    .first()
    .waitFor();
  assert.equal(await reading(linked.page, "Energy"), await reading(page, "Energy"));
  assert.deepEqual(linked.faults, []);
  await linked.close();
  await openPart(page, "Measure", "Table of all steps");
  assert.equal((await plotted(page)).length, rows.length);
  assert.deepEqual(faults, []);
  await close();
});
