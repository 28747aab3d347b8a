// @ts-check
// The p-Willmore flow on the page: a vesicle deflated live, the exponent switched, a mesh at
// rest regularised, surfaces it cannot take.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  choice,
  download,
  energy,
  openMesh,
  playAndPause,
  reading,
  until,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** The reduced volume in the readings. @param {Page} page */
const reducedVolume = async (page) =>
  Number(/reduced ([\d.]+)/.exec(await reading(page, "Volume"))?.[1]);

/** @param {Page} page */
const smallestAngle = async (page) => Number.parseFloat(await reading(page, "Smallest angle"));

test("a vesicle is deflated while it is watched", async () => {
  const { page, faults, close } = await site.open("sample=vesicle");
  assert.equal(await choice(page, "Flow").inputValue(), "p-willmore");
  assert.equal(await page.getByLabel("Area", { exact: true }).isChecked(), true);
  assert.equal(await page.locator("#boundary").isVisible(), false);
  const [start, area] = [await reducedVolume(page), await reading(page, "Area")];
  const step = await playAndPause(page, 10);
  const paused = await reducedVolume(page);
  assert.ok(paused < start - 0.05, `from ${start} to ${paused} in ${step} steps`);
  assert.equal(await reading(page, "Area"), area, "the area is kept");
  await page.getByText(/Lagrange multipliers: tension -?[\d.e]+, pressure -?[\d.e]+/).waitFor();
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  assert.equal(await reducedVolume(page), 0.6);
  assert.equal(await reading(page, "Area"), area);
  // 4π · 1.9557 of the axisymmetric disc, and what 5120 triangles make of it.
  const ratio = (await energy(page)) / (4 * Math.PI);
  assert.ok(Math.abs(ratio / 1.9557 - 1) < 0.01, `∫H²/4π = ${ratio}`);
  assert.deepEqual(faults, []);
  await close();
});

test("the exponent is switched while paused, and travels in the address", async () => {
  const { page, faults, close } = await site.open("sample=letter-c");
  await playAndPause(page, 2);
  await page.getByRole("spinbutton", { name: "Exponent p" }).fill("0");
  await page.keyboard.press("Tab");
  await until(page, "Ready");
  const area = Number(await reading(page, "Area"));
  assert.equal(await energy(page), area, "with p = 0 the energy is the area");
  await playAndPause(page, 3);
  assert.ok(Number(await reading(page, "Area")) < area, "mean-curvature flow shrinks it");
  await page.waitForFunction(() => location.hash.includes("p=0"));
  await page.getByRole("spinbutton", { name: "Exponent p" }).fill("0.5");
  await page.keyboard.press("Tab");
  await page
    .getByRole("alert")
    .getByText(/`p` cannot be `0.5`/)
    .waitFor();
  assert.equal(await page.getByRole("spinbutton", { name: "Exponent p" }).inputValue(), "0");
  assert.deepEqual(faults, []);
  await close();
});

test("under the volume-preserving flow the area falls, the volume stays, and neither is asked for", async () => {
  const { page, faults, close } = await site.open("sample=spheroid");
  assert.equal(await choice(page, "Flow").inputValue(), "volume-preserving");
  assert.equal(await page.getByRole("spinbutton", { name: "Exponent p" }).isVisible(), false);
  assert.equal(await page.getByLabel("Volume", { exact: true }).isVisible(), false);
  assert.equal(await page.locator("#reduced-volume").isVisible(), false);
  assert.equal(await page.locator("#option-regularise").isVisible(), true);
  const [area, volume] = [await reading(page, "Area"), await reading(page, "Volume")];
  assert.equal(await energy(page), Number(area));
  await playAndPause(page, 3);
  assert.ok(Number(await reading(page, "Area")) < Number(area));
  const digits = (/** @type {string} */ text) => Number.parseFloat(text);
  assert.equal(digits(await reading(page, "Volume")), digits(volume));
  assert.ok((await reducedVolume(page)) > Number(/reduced ([\d.]+)/.exec(volume)?.[1]));
  // What the flow before was told does not stay in its way.
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  assert.equal(await page.getByRole("spinbutton", { name: "Exponent p" }).inputValue(), "2");
  assert.deepEqual(faults, []);
  await close();
});

test("a bad mesh at rest is regularised, and Back undoes it", async () => {
  const { page, faults, close } = await site.open();
  const rough = wavyTorus(32, 16);
  rough.positions.forEach((p, i) => {
    p[0] += 0.12 * Math.sin(37 * i);
    p[1] += 0.12 * Math.cos(53 * i);
  });
  await openMesh(page, "rough.obj", obj(rough));
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  await page.waitForFunction(() => location.hash.includes("flow=p-willmore"));
  const before = await smallestAngle(page);
  // Twice: what was asked for is answered every time.
  for (const round of [1, 2]) {
    await button(page, "Regularise the mesh now").click();
    const answer = page.getByRole("log").getByText(/Regularised in \d passes?: smallest angle/);
    await answer.waitFor();
    const after = await smallestAngle(page);
    assert.ok(after > 1.5 * before, `round ${round}: smallest angle ${before}° → ${after}°`);
    await page.getByRole("log").getByRole("button", { name: "Dismiss" }).first().click();
    await answer.waitFor({ state: "detached" });
    await button(page, "Back").click();
    await untilAngle(page, before);
  }
  assert.deepEqual(faults, []);
  await close();
});

/** @param {Page} page @param {number} wanted */
const untilAngle = (page, wanted) =>
  page.waitForFunction(
    (angle) =>
      Number.parseFloat(document.querySelector("[data-reading=angle]")?.textContent ?? "") ===
      angle,
    wanted,
  );

test("a link that does not suit its mesh is said to, and leads to a flow that does", async () => {
  const { page, faults, close } = await site.blank();
  await page.goto(`${site.url}?msaa=1#sample=klein-bottle&flow=p-willmore&step=2`);
  await page
    .getByRole("alert")
    .getByText(/one-sided/)
    .waitFor();
  await until(page, "Ready");
  assert.equal(await choice(page, "Flow").inputValue(), "circle");
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await page.goto(`${site.url}?msaa=1#sample=vesicle&p=0.5`);
  await page
    .getByRole("alert")
    .getByText(/`p` cannot be `0.5`/)
    .waitFor();
  // The scene stays.
  await until(page, "Paused at step 1");
  assert.equal(await choice(page, "Sample").inputValue(), "klein-bottle");
  assert.deepEqual(faults, []);
  await close();
});

test("the flow that was chosen stays when another mesh is opened", async () => {
  const { page, faults, close } = await site.open("sample=letter-c&p=3");
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  assert.equal(await choice(page, "Flow").inputValue(), "p-willmore");
  assert.equal(await page.getByRole("spinbutton", { name: "Exponent p" }).inputValue(), "3");
  // A value that is refused does not stay beside the one in force.
  await page.getByRole("spinbutton", { name: "Exponent p" }).fill("20");
  await page.keyboard.press("Tab");
  await page.waitForFunction(
    () => /** @type {HTMLInputElement} */ (document.querySelector("#option-p")).value === "3",
  );
  const { positions, triangles } = wavyTorus(24, 12);
  await openMesh(page, "open.obj", obj({ positions, triangles: triangles.slice(9) }));
  await page
    .getByRole("alert")
    .getByText(/this flow is for closed surfaces/)
    .waitFor();
  assert.equal(await choice(page, "Flow").inputValue(), "circle");
  assert.deepEqual(faults, []);
  await close();
});

test("an open surface is refused in words, and stays under its own flow", async () => {
  const { page, faults, close } = await site.open("sample=pipe");
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  const alert = page.getByRole("alert");
  await alert.getByText(/2 boundary loops; this flow is for closed surfaces/).waitFor();
  await alert.getByText(/circle-angle Willmore flow, which takes boundaries/).waitFor();
  await until(page, "Ready");
  assert.equal(await choice(page, "Flow").inputValue(), "circle");
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  assert.deepEqual(faults, []);
  await close();
});

test("quadrilaterals flow, are drawn and saved as quadrilaterals", async () => {
  const { page, faults, close } = await site.open();
  const { positions } = wavyTorus(24, 12);
  const at = (/** @type {number} */ i, /** @type {number} */ j) => 12 * (i % 24) + (j % 12) + 1;
  const faces = positions.map((_, k) => {
    const [i, j] = [Math.floor(k / 12), k % 12];
    return `f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}\n`;
  });
  const text = [...positions.map((p) => `v ${p.join(" ")}\n`), ...faces].join("");
  await openMesh(page, "quads.obj", text);
  await page
    .getByRole("log")
    .getByText(/the p-Willmore flow keeps them/)
    .waitFor();
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  await page.waitForFunction(() => location.hash.includes("flow=p-willmore"));
  const atStart = await energy(page);
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  assert.ok((await energy(page)) < atStart);
  const { bytes } = await download(page, "OBJ");
  const saved = bytes
    .toString()
    .split("\n")
    .filter((line) => line.startsWith("f "));
  assert.equal(saved.length, 288);
  assert.ok(saved.every((line) => line.trim().split(/\s+/).length === 5));
  assert.deepEqual(faults, []);
  await close();
});
