// @ts-check
// Numbers: readings against the command line's solver, the histogram, one vertex, the equation, a
// refinement study, figures and the larger plot.

import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession } from "../../www/cli/solver.js";
import { perform } from "../../www/session.js";
import {
  button,
  colourBy,
  openPart,
  openTab,
  playToEnd,
  reading,
  stillPicture,
  until,
  useSite,
} from "./support/app.js";

const site = useSite();

test("the readings are those of the solver, of the step that is shown", async () => {
  const session = await openSession();
  perform(session, "sample", { name: "coarse-torus", parameters: { level: 2 } });
  perform(session, "configure", { options: {} });
  for (let n = 0; n < 4; n += 1) perform(session, "step");
  const state = perform(session, "state");
  const { page, faults, close } = await site.open("sample=coarse-torus&step=4");
  const near = (/** @type {string} */ text, /** @type {number} */ value) =>
    assert.ok(
      Math.abs(Number.parseFloat(text) - value) <= 1e-5 * Math.abs(value),
      `${text} ${value}`,
    );
  near(await reading(page, "Energy"), state.energy);
  near(await reading(page, "W/2"), state.energyNormalised);
  near(await reading(page, "Area"), state.area);
  near(await reading(page, "Volume"), state.volume ?? 0);
  near(await reading(page, "Time"), state.time);
  near(await reading(page, "Smallest angle"), Number(state.minAngleDegrees.toPrecision(4)));
  assert.equal(await reading(page, "Step"), "4");
  assert.match(await reading(page, "Area"), /[−+][\d.]+ %$/, "since the start");
  assert.deepEqual(faults, []);
  await close();
});

test("colours have a histogram, a vertex its circles, a flow its equation", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus");
  await colourBy(page, "Gaussian curvature K");
  await openTab(page, "Measure");
  await page.getByRole("img", { name: "Gaussian curvature K over the surface" }).waitFor();
  await openPart(page, "Measure", "Look at one vertex");
  await page.getByLabel("Number", { exact: true }).fill("5");
  await page.getByLabel("Number", { exact: true }).press("Enter");
  const numbers = page.getByRole("table", { name: "Vertex 5" });
  await numbers.waitFor();
  const sum = /^([\d.]+)/.exec(
    (await numbers.getByRole("row", { name: /^Σβ/ }).getByRole("cell").textContent()) ?? "",
  );
  const own = await numbers.getByRole("row", { name: /^Wᵢ/ }).getByRole("cell").textContent();
  assert.ok(Math.abs(Number(sum?.[1]) - 2 * Math.PI - Number(own)) < 1e-4, "Wᵢ = Σβ − 2π");
  await page.getByRole("checkbox", { name: "Circumcircles" }).check();
  await page.getByText(/circles of \d+ triangles/).waitFor();
  await openPart(page, "Measure", /^The equation/);
  await page.locator("math").nth(2).waitFor();
  await page
    .getByRole("table", { name: /^Symbols/ })
    .getByText("exponent")
    .waitFor({ state: "detached" });
  assert.deepEqual(faults, []);
  await close();
});

test("a refinement study tells orders, and is a solver of its own", async () => {
  const { page, faults, close } = await site.open("sample=clifford-torus");
  await openPart(page, "Measure", "Refinement study");
  await page.getByRole("tabpanel").getByRole("button", { name: "Measure" }).click();
  await page
    .getByText(/observed order [12]\.\d/)
    .first()
    .waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("a point of the phase diagram of vesicles opens the surface of that energy", async () => {
  const { page, faults, close } = await site.open("sample=vesicle");
  await openPart(page, "Measure", "Vesicles: phase diagram");
  await button(page, "Compute the shapes").click();
  // The second point: the branch that is not the least there.
  const point = page.getByRole("button", { name: /^Show the oblate shape of volume 0.950/ });
  await point.waitFor();
  const told = Number(/= ([\d.]+)$/.exec((await point.getAttribute("aria-label")) ?? "")?.[1]);
  assert.ok(Math.abs(told / 1.1061 - 1) < 0.01, `${told}`);
  await button(page, "Cancel").click();
  await point.click();
  await page.waitForFunction(() =>
    document.querySelector("#surface")?.getAttribute("aria-label")?.includes("oblate-0.950"),
  );
  const shown = Number(await reading(page, "Energy")) / (4 * Math.PI);
  assert.ok(Math.abs(shown / told - 1) < 1e-4, `${shown}, ${told}`);
  assert.deepEqual(faults, []);
  await close();
});

test("a surface is cut open, and its double curves are drawn, on request", async () => {
  const { page, faults, close } = await site.open("sample=klein-bottle");
  const title = page.getByRole("group", { name: "Legend" }).getByRole("button").last();
  const curves = page.getByRole("checkbox", { name: "Curves where it crosses itself" });
  const cut = page.getByRole("slider", { name: "Cut open" });
  /** @param {() => Promise<unknown>} change @returns {Promise<Buffer>} the picture after it */
  const after = async (change) => {
    await title.click();
    await change();
    await title.click();
    return stillPicture(page);
  };
  const whole = await after(async () => assert.ok(!(await curves.isChecked())));
  assert.notDeepEqual(await after(() => curves.check()), whole);
  assert.deepEqual(await after(() => curves.uncheck()), whole);
  assert.notDeepEqual(await after(() => cut.fill("40")), whole);
  await page.waitForFunction(() => location.hash.includes("cut=40"));
  assert.deepEqual(faults, []);
  await close();
});

test("a figure of a paper says what is expected and what came of it here", async () => {
  const { page, faults, close } = await site.open("sample=pipe");
  await page.keyboard.press("/");
  await page.getByRole("searchbox").fill("fig 6");
  const cards = page.getByRole("dialog").getByRole("region", { name: "From the papers" });
  await cards.getByRole("button").first().click();
  await until(page, "Ready");
  await playToEnd(page);
  await openTab(page, "Measure");
  await page.getByText(/✓ As expected:/).waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("the curve opens large, against time, on a logarithmic axis", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere&step=8");
  await page.keyboard.press("e");
  const dialog = page.getByRole("dialog");
  const drawing = dialog.getByRole("img", { name: "Energy over the run" });
  await drawing.waitFor();
  // What the axes are of, and where it has come to.
  assert.deepEqual(await drawing.locator(".name").allTextContents(), ["Step", "Willmore energy W"]);
  const last = (await drawing.locator("text.pane-0").textContent()) ?? "";
  assert.equal(last.trim(), await page.locator(".energy b").textContent());
  await dialog.getByRole("radio", { name: "Time" }).check();
  await dialog.getByRole("combobox", { name: "Quantity" }).selectOption({ label: "Area" });
  await dialog.getByRole("img", { name: "Area over the run" }).waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.getByRole("dialog").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("edge flips count, and the conjecture is put to their mesh", async () => {
  const { page, faults, close } = await site.open("sample=sampled-torus");
  await openTab(page, "Flow");
  await button(page, "All flips at once").click();
  await until(page, /^(Converged|Paused|Stopped)/);
  await openPart(page, "Measure", "The conjecture on this mesh");
  await page.getByText(/area and localised energy rise or fall together/).waitFor();
  await openPart(page, "Measure", "Random quadrilaterals");
  await button(page, "Draw quadrilaterals").click();
  await page.getByText(/random tetrahedra/).waitFor();
  await button(page, "Stop").click();
  assert.deepEqual(faults, []);
  await close();
});
