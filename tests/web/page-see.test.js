// @ts-check
// Seeing the mathematics: Möbius inversion, a vertex with its circles, lines of curvature,
// equations, the histogram.

import assert from "node:assert/strict";
import { test } from "node:test";
import { histogram } from "../../www/ui/histogram.js";
import { nearestVertex } from "../../www/ui/look.js";
import { boxOf } from "../../www/ui/moebius.js";
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

/** Rows of a table, as texts. @param {Page} page @param {string} id  of its body */
const rows = (page, id) =>
  page
    .locator(`${id} tr`)
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));

test("bars hold every finite value, those beyond the colours at the ends", () => {
  const values = Float32Array.from([-90, -1, -0.5, 0, 0, 0.5, 1, 70, Number.NaN, Infinity]);
  const { counts, from, to, least, most, mean, count } = histogram({ values, low: -1, high: 1 });
  assert.equal(count, 8);
  assert.equal(
    counts.reduce((a, b) => a + b, 0),
    8,
  );
  assert.deepEqual([least, most, mean], [-90, 70, -2.5]);
  assert.ok(Math.abs(from + 1.3) < 1e-12 && Math.abs(to - 1.3) < 1e-12);
  assert.deepEqual([counts[0], counts.at(-1)], [1, 1]);
  // All of one value, as on a sphere.
  const same = histogram({ values: new Float32Array(5).fill(2), low: 2, high: 2.000002 });
  assert.equal(
    same.counts.reduce((a, b) => a + b, 0),
    5,
  );
  const corners = Float32Array.from([0, 0, 0, 3, 4, 0, 0, 0, 12]);
  assert.deepEqual(boxOf(corners), { middle: [1.5, 2, 6], size: 13 });
  assert.equal(nearestVertex(corners, [2, 3, 1]), 1);
});

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
  // The step it was made of is back; there is no reading until then.
  await until(page, "Paused at step 1");
  assert.equal(await energy(page), before);
  assert.deepEqual(faults, []);
  await close();
});

test("the centre of an inversion is found a place when the picture comes late", async () => {
  const { page, faults, close } = await site.blank();
  let release = () => {};
  const held = new Promise((resolve) => {
    release = () => resolve(null);
  });
  await page.route(/viewer_bg[^/]*\.wasm$/, (route) => held.then(() => route.continue()));
  await page.goto(`${site.url}?msaa=1#sample=coarse-torus`);
  await until(page, "Ready");
  await page.getByText("Möbius inversion").click();
  const z = page.locator("#moebius").getByLabel("z", { exact: true });
  assert.equal(await z.inputValue(), "0.62", "somewhere, until there is a picture");
  const handle = page.locator("#inversion-centre");
  assert.equal(await handle.isVisible(), false);
  release();
  await handle.waitFor();
  assert.notEqual(await z.inputValue(), "0.62");
  assert.deepEqual(faults, []);
  await close();
});

test("a vertex is looked at, circles are drawn, equation and histogram tell of the flow", async () => {
  const { page, faults, close } = await site.open();
  const start = await stillPicture(page);
  await page.getByText("Look closer").click();
  const number = page.getByLabel("Vertex number");
  await number.fill("100");
  await number.press("Tab");
  const edges = page.locator("#probe-edge-rows tr");
  await edges.first().waitFor();
  /** @returns {Promise<Record<string, string>>} */
  const numbers = async () => Object.fromEntries(await rows(page, "#probe-rows"));
  // In closed form: on an edge of the subdivided icosahedron only the two edges along it have
  // another β than 60°, all of them 2π/5 or π/3, and the vertex is flat.
  const told = await numbers();
  assert.equal(told.Valence, "6");
  const angles = (await rows(page, "#probe-edge-rows")).map(([, , text]) =>
    Number.parseFloat(text),
  );
  const sum = (angles.reduce((a, b) => a + b, 0) * Math.PI) / 180;
  assert.ok(Math.abs(Number.parseFloat(told.Σβ) - sum) < 1e-4);
  const w = Number(told["Wᵢ = Σβ − 2π"]);
  assert.ok(Math.abs(w - (sum - 2 * Math.PI)) < 1e-4);
  assert.ok(Math.abs(w - (2 * Math.PI) / 15) < 1e-6, `W_i ${w}`);
  assert.ok(Math.abs(Number.parseFloat(told["Kᵢ, angle defect"])) < 1e-12);
  // Numbers are those of the present step.
  const still = await page.locator("#probe-rows").textContent();
  await button(page, "Step").click();
  await page.waitForFunction(
    (text) => document.querySelector("#probe-rows")?.textContent !== text,
    still,
  );
  assert.notEqual((await numbers())["Wᵢ = Σβ − 2π"], told["Wᵢ = Σβ − 2π"]);
  await button(page, "Reset").click();
  await until(page, "Ready");
  // To a neighbour by the table, and by a click on the surface.
  await page.getByRole("button", { name: "Go to vertex 2454" }).click();
  await page.getByRole("button", { name: "Go to vertex 100", exact: true }).waitFor();
  await button(page, "Pick a vertex").click();
  const surface = await page.locator("#surface").boundingBox();
  assert.ok(surface);
  const [x, y] = [surface.x + surface.width / 2, surface.y + surface.height / 2];
  await page.mouse.click(x, y);
  await page
    .getByRole("button", { name: "Go to vertex 100", exact: true })
    .waitFor({ state: "hidden" });
  const picked = Number(await number.inputValue());
  // Arrow keys walk to where they point.
  await button(page, "Pick a vertex").press("ArrowRight");
  await page.waitForFunction(
    (was) => document.querySelector("#probe-edge-rows")?.textContent?.includes(String(was)),
    picked,
  );
  assert.notEqual(Number(await number.inputValue()), picked);
  await number.fill("999999");
  await number.press("Tab");
  await page.getByText("There is no vertex 999999.").waitFor();
  await button(page, "None").click();
  await page.getByLabel("Circumcircles of all triangles").check();
  await page.getByText("5120 circles of 5120 triangles.").waitFor();
  const circled = await untilPictured(page, start, (mean) => mean > 3);
  await page.getByLabel("Circumcircles of all triangles").uncheck();
  await page.getByLabel("Lines of curvature").check();
  await page.getByText(/of the edges lie within 5° of a line of curvature/).waitFor();
  await untilPictured(page, circled, (mean) => mean > 3);
  await page.getByLabel("Lines of curvature").uncheck();

  await choice(page, "Colour by").selectOption({ label: "Mean curvature H" });
  await page.locator("#histogram-table tr").first().waitFor();
  await page.locator("#histogram-bins > summary").click();
  const bars = await rows(page, "#histogram-bin-rows");
  const counted = bars.reduce((all, row) => all + Number(row[2]), 0);
  assert.equal(counted, Number(await reading(page, "Vertices")));

  await page.locator("#equation > summary").click();
  await page.locator("#equation math").first().waitFor();
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  const exponent = page
    .locator("#equation tr")
    .filter({ hasText: "exponent" })
    .locator("td")
    .last();
  await exponent.filter({ hasText: /^2$/ }).waitFor();
  await page.getByLabel("Exponent p").fill("4");
  await page.getByLabel("Exponent p").press("Tab");
  await exponent.filter({ hasText: /^4$/ }).waitFor();
  await page.getByLabel("Volume", { exact: true }).check();
  await page.locator("#equation").getByText("pressure that keeps or leads the volume").waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test("on an open mesh the boundary is told apart", async () => {
  const { page, faults, close } = await site.open("sample=pipe", {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    colorScheme: "dark",
  });
  await button(page, "Panel").click();
  await page.getByText("Möbius inversion").click();
  await page.locator("#moebius-rows tr").nth(3).waitFor();
  const told = await rows(page, "#moebius-rows");
  assert.deepEqual(
    told.map(([name]) => name),
    ["W of interior vertices", "W closed at infinity", "∫H² dA", "Area"],
  );
  assert.ok(Math.abs(Number(told[0][3])) < 1e-9 && Math.abs(Number(told[1][3])) > 1e-3);
  await button(page, "Cancel").click();
  await page.locator("#inversion-centre").waitFor({ state: "hidden" });
  await page.getByText("Look closer").click();
  const number = page.getByLabel("Vertex number");
  // Some vertex of the boundary.
  for (let vertex = 0; vertex < 40; vertex += 1) {
    await number.fill(String(vertex));
    await number.press("Enter");
    await page.locator("#probe-rows").getByText("Valence").waitFor();
    await page.waitForFunction(
      (v) => document.querySelector("#probe-table")?.getAttribute("data-vertex") === String(v),
      vertex,
    );
    if (await page.getByText(/A boundary vertex/).isVisible()) break;
  }
  assert.match(
    (await page.locator("#probe-said").textContent()) ?? "",
    /2 boundary edges have one circle/,
  );
  assert.match((await page.locator("#probe-rows").textContent()) ?? "", /not part of the energy/);
  assert.equal((await rows(page, "#probe-edge-rows")).filter((row) => row[2] === "none").length, 2);
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(faults, []);
  await close();
});
