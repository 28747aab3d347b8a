// @ts-check
// Tools are modes: the surface changes on Apply and not before, and Undo brings it back.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  openMesh,
  openTab,
  plotted,
  reading,
  stepOf,
  surface,
  until,
  untilReadingIsNot,
  upload,
  useSite,
} from "./support/app.js";

const site = useSite();

/** What Download would give, of the solver itself. @param {import("playwright-core").Page} page */
const where = async (page) => [await surface(page), await reading(page, "Area")];

test("opening a tab or a tool changes no vertex", async () => {
  const { page, faults, close } = await site.open("sample=pipe");
  const before = await where(page);
  for (const name of ["Surface", "Flow", "Measure", "Compare", "Share"]) await openTab(page, name);
  await openTab(page, "Surface");
  await page.setViewportSize({ width: 1280, height: 720 });
  for (const name of ["Paint", "Fill holes", "Subdivide", "Remesh", "Invert"]) {
    await button(page, name).click();
    const bar = page.getByRole("toolbar", { name });
    await bar.waitFor();
    const { height } = (await bar.boundingBox()) ?? { height: 0 };
    assert.ok(height < 60, `${name}: ${height} px, more than a row`);
  }
  // The centre of an inversion begins well outside, and stays in reach.
  const handle = page.getByRole("button", { name: "Centre of the inversion" });
  await handle.waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.getByRole("toolbar").count(), 0);
  assert.deepEqual(await where(page), before);
  assert.deepEqual(faults, []);
  await close();
});

test("holes are filled and faired, and Undo brings the run of before back", async () => {
  const { page, faults, close } = await site.open("sample=pipe&step=3");
  const before = Number(await reading(page, "Vertices"));
  await openTab(page, "Surface");
  await button(page, "Fill…").click();
  const bar = page.getByRole("toolbar", { name: "Fill holes" });
  await bar.getByText("0 of 2 chosen").waitFor();
  // They are counted from 1; none is chosen yet, and none is offered first.
  assert.equal(await bar.getByRole("button", { name: "0", exact: true }).count(), 0);
  assert.equal(await bar.locator(".primary").count(), 0);
  await bar.getByRole("button", { name: "2", exact: true }).click();
  await bar.getByRole("button", { name: "Fill this one" }).click();
  await until(page, "Ready");
  await page
    .getByText(/Filled 1 loop with \d+ new vertices/)
    .first()
    .waitFor();
  assert.ok(Number(await reading(page, "Vertices")) > before);
  await openTab(page, "Surface");
  await page.getByRole("button", { name: /^Undo the fill/ }).click();
  await until(page, "Paused at step 3");
  assert.equal(Number(await reading(page, "Vertices")), before);
  assert.equal((await plotted(page)).length, 4, "with its steps");
  assert.deepEqual(faults, []);
  await close();
});

test("what is painted moves, and nothing else", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  await openTab(page, "Surface");
  await button(page, "Paint").click();
  const box = await canvas(page).boundingBox();
  assert.ok(box);
  const bar = page.getByRole("toolbar", { name: "Paint" });
  const apply = bar.getByRole("button", { name: "Apply" });
  assert.equal(await apply.getAttribute("aria-disabled"), "true", "nothing is painted yet");
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 30, box.y + box.height / 2, { steps: 3 });
  await page.mouse.up();
  // What lies under the pointer where it stopped is painted a picture later.
  const painted = bar.getByText(/^([6-9]|\d{2,3}) of 2562 move/);
  const free = Number.parseInt((await painted.textContent()) ?? "", 10);
  await bar.getByRole("button", { name: "Grow" }).click();
  await apply.click();
  await until(page, "Ready");
  await openTab(page, "Flow");
  const now =
    (await page
      .getByRole("tabpanel")
      .getByText(/vertices move/)
      .textContent()) ?? "";
  assert.ok(Number(/(\d+) of/.exec(now)?.[1]) >= free, now);
  await page.getByRole("tabpanel").getByRole("button", { name: "Clear paint" }).click();
  await page.getByText(/vertices move/).waitFor({ state: "detached" });
  assert.deepEqual(faults, []);
  await close();
});

test("subdivided, inverted, started from here, and back again", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus");
  const faces = Number(await reading(page, "Faces"));
  await openTab(page, "Surface");
  await button(page, "Subdivide").click();
  await button(page, "Split only").click();
  await page
    .getByText(/Subdivided into/)
    .first()
    .waitFor();
  assert.equal(Number(await reading(page, "Faces")), 4 * faces);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(
    (wanted) => document.querySelector("[data-reading=faces]")?.textContent === String(wanted),
    faces,
  );
  await openTab(page, "Surface");
  await button(page, "Invert").click();
  const note = page.getByRole("toolbar", { name: "Invert" }).getByRole("note");
  await note.getByText(/W .* → /).waitFor();
  await page.getByLabel("x", { exact: true }).fill("0.2");
  await page.getByLabel("x", { exact: true }).press("Enter");
  await button(page, "Apply").click();
  await page
    .getByText(/The surface is inverted/)
    .first()
    .waitFor();
  await until(page, "Ready");
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  await openTab(page, "Surface");
  await button(page, "Start from here").click();
  await until(page, "Ready");
  assert.equal(await stepOf(page), 0);
  await button(page, "Even out triangles").click();
  await page
    .getByText(/Regularised in|as even as they get/)
    .first()
    .waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("a surface is given other triangles, as many as wanted, and gets its own back", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  const before = await reading(page, "Vertices");
  const area = /area (\S+)$/.exec(await surface(page))?.[1];
  await openTab(page, "Surface");
  await button(page, "Remesh").click();
  await page.getByLabel("Vertices", { exact: true }).fill("1500");
  await page.getByLabel("Vertices", { exact: true }).press("Tab");
  await button(page, "Remesh by curvature").click();
  await page.getByText(/smallest angle .* before and .* now. Undo takes it back/).waitFor();
  const after = Number(await reading(page, "Vertices"));
  assert.ok(Math.abs(after - 1500) < 150, `${after} vertices`);
  assert.equal(/area (\S+)$/.exec(await surface(page))?.[1], area);
  await openTab(page, "Surface");
  await button(page, "Undo the remeshing").click();
  // “Ready” stood there before.
  await page.getByText(new RegExp(`^${before} vertices`)).waitFor();
  assert.equal(await reading(page, "Vertices"), before);
  assert.deepEqual(faults, []);
  await close();
});

/** The unit cube in triangles. @param {number} [sides]  of six */
function cube(sides = 6) {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1} ${(k >> 1) & 1} ${k >> 2}`);
  const squares = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"];
  const triangles = squares.slice(0, sides).map((square) => {
    const [a, b, c, d] = square.split(" ");
    return `f ${a} ${b} ${c}\nf ${a} ${c} ${d}`;
  });
  return [...corners, ...triangles].join("\n");
}

test("a missing side comes back flat, with a flow that leaves it so", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron");
  await upload(page, "box.obj", cube(5));
  // Its rim is all there is, and that is held.
  await until(page, "The flow cannot start");
  await page.getByRole("alert").waitFor();
  await openTab(page, "Surface");
  await button(page, "Fill…").click();
  await button(page, "Fill it").click();
  await page
    .getByText(/Play fairs them by the flow Mean curvature/)
    .first()
    .waitFor();
  assert.equal(Number(await reading(page, "Volume")), 1);
  // What was refused before is past.
  assert.equal(await page.getByRole("alert").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("edges of the shape stay when it is remeshed, unless they are to be rounded", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron");
  await openMesh(page, "cube.obj", cube());
  const remesh = async (/** @type {boolean} */ rounds) => {
    await openTab(page, "Surface");
    await button(page, "Remesh").click();
    if (rounds) await page.getByLabel("Keep edges").uncheck();
    await page.getByLabel("Vertices", { exact: true }).fill("600");
    await page.getByLabel("Vertices", { exact: true }).press("Tab");
    await button(page, "Remesh evenly").click();
    await page.getByText(/smallest angle .* before and .* now. Undo takes it back/).waitFor();
  };
  await remesh(false);
  assert.equal(Number(await reading(page, "Volume")), 1);
  await remesh(true);
  await untilReadingIsNot(page, "Volume", "1");
  assert.deepEqual(faults, []);
  await close();
});

test("Why? says what is the matter and offers what helps", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&scheme=paper&tau=5");
  await button(page, "Step").click();
  await until(page, /^(Paused|Stalled|Failed|Converged)/);
  await button(page, "Why?").click();
  const card = page.getByRole("region", { name: "Why did it stop?" });
  await card.waitFor();
  assert.ok(((await card.locator("#why-sentence").textContent()) ?? "").length > 20);
  assert.ok((await card.getByRole("button").count()) >= 2);
  await page.keyboard.press("Escape");
  assert.equal(await card.count(), 0);
  assert.deepEqual(faults, []);
  await close();
});
