// @ts-check
// The history on the page: scrubbed, branched, played, recorded; and recipes.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { unzipSync } from "fflate";
import {
  button,
  choice,
  download,
  energy,
  openMesh,
  plotted,
  reading,
  surface,
  until,
  upload,
  useSite,
} from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { playFilm } from "./support/film.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();
const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

/** @typedef {import("playwright-core").Page} Page */

/** @param {Page} page */
const slider = (page) => page.getByRole("slider", { name: "History", exact: true });

/** Waits until a step is shown. @param {Page} page @param {number} step */
async function untilStep(page, step) {
  await page.waitForFunction(
    (wanted) => document.querySelector("[data-reading=step]")?.textContent === String(wanted),
    step,
  );
}

/** @param {Page} page @param {number} from @param {number} count */
async function take(page, from, count) {
  for (let n = from + 1; n <= from + count; n += 1) {
    await button(page, "Step").click();
    await untilStep(page, n);
  }
}

/** Drags the slider somewhere, as a pointer does. @param {Page} page @param {number[]} steps */
async function scrub(page, ...steps) {
  await slider(page).evaluate((input, values) => {
    const range = /** @type {HTMLInputElement} */ (input);
    for (const value of values) {
      range.value = String(value);
      range.dispatchEvent(new Event("input", { bubbles: true }));
    }
    range.dispatchEvent(new Event("change", { bubbles: true }));
  }, steps);
  await untilStep(page, /** @type {number} */ (steps.at(-1)));
}

/** @param {Page} page @param {string} name */
async function saved(page, name) {
  const [file] = await Promise.all([page.waitForEvent("download"), button(page, name).click()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

test("steps are scrubbed, branched and played, on the keyboard too", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  assert.equal(await slider(page).isVisible(), false, "there is nothing to scrub");
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  await choice(page, "Regularise").selectOption({ label: "Never" });
  await page.locator("#p-willmore").waitFor();
  await until(page, "Ready");
  await take(page, 0, 6);
  const energies = (await plotted(page)).map(([, , , value]) => value);
  assert.equal(energies.length, 7);

  // Where several are asked for at once, the last one is shown.
  await scrub(page, 5, 1, 4, 2);
  assert.match(await surface(page), /step 2,/);
  assert.equal(await energy(page), energies[2]);
  assert.deepEqual(
    (await plotted(page)).map(([step]) => step),
    [0, 1, 2],
  );
  assert.equal(await slider(page).getAttribute("aria-valuetext"), "Step 2 of 6");
  await slider(page).focus();
  await page.keyboard.press("ArrowRight");
  await untilStep(page, 3);
  await page.keyboard.press("End");
  await untilStep(page, 6);
  assert.deepEqual(
    (await plotted(page)).map(([, , , value]) => value),
    energies,
  );
  await page.keyboard.press("Home");
  await untilStep(page, 0);

  // Played to the end, and half of the way back.
  await choice(page, "Steps a second").selectOption("25");
  await button(page, "Play history forwards").click();
  await untilStep(page, 6);
  await page.locator("#history-forth[aria-pressed=false]").waitFor();
  await choice(page, "Steps a second").selectOption("2");
  await button(page, "Play history backwards").click();
  await untilStep(page, 4);
  await button(page, "Step").click();
  await page.locator("#history-back[aria-pressed=false]").waitFor();
  // A step from here is the last of its path.
  await page.waitForFunction(() => {
    const range = /** @type {HTMLInputElement} */ (document.querySelector("#scrub"));
    return range.value === range.max;
  });
  const at = Number(await reading(page, "Step"));

  // The same steps again are a branch only until the path has come to its end.
  const branches = choice(page, "Branches");
  await branches.waitFor();
  await take(page, at, 6 - at);
  await branches.waitFor({ state: "hidden" });

  // Another way on from step 2.
  await scrub(page, 2);
  await button(page, "Regularise the mesh now").click();
  await branches.waitFor();
  await take(page, 2, 1);
  const other = await energy(page);
  const [, name] = await branches.locator("option").allTextContents();
  assert.match(name, /^Branch from step 2 \(4 steps, energy [\d.]+\)$/);
  await branches.selectOption({ label: name });
  await untilStep(page, 6);
  assert.deepEqual(
    (await plotted(page)).map(([, , , value]) => value),
    energies,
  );
  const back = (await branches.locator("option").allTextContents()).at(-1);
  assert.match(back ?? "", /^Branch from step 2 \(1 steps/);
  await branches.selectOption({ label: back });
  await untilStep(page, 3);
  assert.equal(await energy(page), other);
  assert.deepEqual(await accessibilityFaults(page), []);

  // A change takes the surface back to the start, and there is no history any more.
  await choice(page, "Flow").selectOption({ label: "Willmore by circle angles" });
  await until(page, "Ready");
  assert.equal(await slider(page).isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

test("the flow is changed on the way, and the way before stays", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  await until(page, "Ready");
  await take(page, 0, 4);
  const plain = (await plotted(page)).map(([, , , value]) => value);
  const goesOn = page.getByLabel("Change the flow from here on");
  const note = page.locator("#method-form .change-note");
  const notes = page.getByRole("log");
  assert.equal(await goesOn.isChecked(), false, "at the end a change begins anew");
  assert.equal(await note.textContent(), "A change takes the surface back to the start.");

  // Whoever has looked back goes on from there.
  await scrub(page, 2);
  await page.locator("#go-on:checked").waitFor();
  await page.locator("#method > summary").click();
  assert.match((await note.textContent()) ?? "", /goes on from step 2; .* kept as a branch/);
  await choice(page, "Scheme").selectOption("paper");
  const branches = choice(page, "Branches");
  await branches.waitFor();
  await notes.getByText(/goes on from there/).waitFor();
  assert.equal(await reading(page, "Step"), "2");
  await take(page, 2, 1);
  const other = await energy(page);
  assert.notEqual(other, plain[3]);
  assert.deepEqual(
    (await plotted(page)).map(([, , , value]) => value),
    [...plain.slice(0, 3), other],
  );

  // Switched to the way before and back, the form shows what is in force there.
  const [, before] = await branches.locator("option").allTextContents();
  assert.match(before, /^Branch from step 2 \(2 steps/);
  await branches.selectOption({ label: before });
  await untilStep(page, 4);
  assert.equal(await energy(page), plain[4]);
  assert.equal(await choice(page, "Scheme").inputValue(), "auto");
  const [, after] = await branches.locator("option").allTextContents();
  await branches.selectOption({ label: after });
  await untilStep(page, 3);
  assert.equal(await energy(page), other);
  assert.equal(await choice(page, "Scheme").inputValue(), "paper");

  // At the end of a path it is a choice; another flow has an energy of its own.
  await goesOn.check();
  await choice(page, "Flow").selectOption({ label: "p-Willmore" });
  await page.locator("#p-willmore").waitFor();
  await take(page, 3, 1);
  const last = await energy(page);
  assert.deepEqual(await accessibilityFaults(page), []);

  // A link and a recipe hold all of it.
  await page.waitForFunction(() => /step=4.*path=/.test(location.hash));
  const link = await page.evaluate(() => location.hash);
  assert.match(link, /^#sample=bumpy-sphere&flow=circle&/);
  const { name, bytes } = await download(page, "Recipe, JSON");
  const recipe = JSON.parse(bytes.toString("utf8"));
  const legs = recipe.path.map((/** @type {any} */ leg) => leg.steps ?? leg.flow.flow);
  assert.deepEqual(legs, [2, "circle", 1, "p-willmore", 1]);
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  try {
    writeFileSync(path.join(folder, name), bytes);
    const replayed = [program, "replay", path.join(folder, name), "--json"];
    const result = spawnSync(process.execPath, replayed, { encoding: "utf8" });
    assert.equal(result.status, 0, result.stdout + result.stderr);
  } finally {
    rmSync(folder, { recursive: true });
  }
  const again = await site.open(link.slice(1));
  await untilStep(again.page, 4);
  assert.equal(await energy(again.page), last);
  assert.equal(await choice(again.page, "Flow").inputValue(), "p-willmore");
  await button(again.page, "Back").click();
  await button(again.page, "Back").click();
  await again.page.waitForFunction(
    () => /** @type {HTMLSelectElement} */ (document.querySelector("#flow")).value === "circle",
  );
  assert.equal(await energy(again.page), other);
  assert.deepEqual(again.faults, []);
  await again.close();

  // From the start again, with the flow in force; what was done is a branch.
  await button(page, "Reset").click();
  await untilStep(page, 0);
  assert.equal(await choice(page, "Flow").inputValue(), "p-willmore");
  const kept = (await branches.locator("option").allTextContents()).at(-1) ?? "";
  assert.match(kept, /^Branch from step 0 \(4 steps/);
  await branches.selectOption({ label: kept });
  await untilStep(page, 4);
  assert.equal(await energy(page), last);
  assert.deepEqual(faults, []);
  await close();
});

test("a film is recorded, and all steps are saved as meshes", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  await take(page, 0, 5);
  await page.locator("#record > summary").click();
  await button(page, "Record film").click();
  await button(page, "Play history backwards").click();
  await untilStep(page, 0);
  await page.waitForFunction(() => document.querySelector("#film-time")?.textContent !== "0:00");
  const film = await saved(page, "Stop and save");
  assert.equal(film.name, "wavy-circle-step0005.webm");
  const blank = await site.blank();
  await blank.page.goto("about:blank");
  const played = await playFilm(blank.page, film.bytes);
  await blank.close();
  const canvas = await page.locator("#surface").boundingBox();
  // Codecs take even sizes.
  assert.ok(Math.abs(played.width - (canvas?.width ?? 0)) <= 1, `${played.width} pixels wide`);

  const size = page.locator("#sequence-size");
  await size.filter({ hasText: /^6 meshes, about [\d.]+ kB/ }).waitFor();
  await choice(page, "Each step as").selectOption({ label: "OBJ" });
  await page.getByLabel("Every", { exact: true }).fill("2");
  await size.filter({ hasText: /^4 meshes/ }).waitFor();
  const { name, bytes } = await saved(page, "Save all steps (ZIP)");
  assert.equal(name, "wavy-circle-step0000.zip");
  const meshes = unzipSync(bytes);
  assert.deepEqual(
    Object.keys(meshes),
    [0, 2, 4, 5].map((step) => `wavy-step000${step}.obj`),
  );
  await scrub(page, 4);
  const { bytes: alone } = await download(page, "OBJ");
  assert.ok(alone.equals(Buffer.from(meshes["wavy-step0004.obj"])));
  assert.deepEqual(faults, []);
  await close();
});

test("a recipe is made, done again by the command line, and opened", async () => {
  const { page, faults, close } = await site.open();
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  const mesh = obj(wavyTorus(24, 12));
  try {
    await openMesh(page, "wavy.obj", mesh);
    await take(page, 0, 2);
    await button(page, "Keep as new start").click();
    await until(page, "Ready");
    await take(page, 0, 3);
    await scrub(page, 1);
    await take(page, 1, 1);
    const { name, bytes } = await download(page, "Recipe, JSON");
    assert.equal(name, "wavy-circle-step0002.recipe.json");
    const recipe = JSON.parse(bytes.toString("utf8"));
    assert.deepEqual([recipe.mesh.name, recipe.mesh.bytes], ["wavy.obj", mesh.length]);
    assert.deepEqual([recipe.edits.length, recipe.steps], [1, 2]);
    writeFileSync(path.join(folder, name), bytes);
    writeFileSync(path.join(folder, "wavy.obj"), mesh);
    const result = spawnSync(
      process.execPath,
      [program, "replay", path.join(folder, name), "--json"],
      { encoding: "utf8" },
    );
    assert.equal(result.status, 0, result.stdout + result.stderr);
    const shown = await energy(page);
    assert.ok(Math.abs(JSON.parse(result.stdout).got.energy / shown - 1) < 1e-4);

    // Opened here it asks for its mesh, and gives the same surface.
    const notes = page.getByRole("log");
    await upload(page, name, bytes);
    await notes.getByText(/is for the mesh “wavy\.obj”/).waitFor();
    await upload(page, "wavy.obj", mesh);
    await notes.getByText(/the energy that it promised, to the last bit/).waitFor();
    assert.equal(await energy(page), shown);
    assert.equal(await reading(page, "Step"), "2");
    // Where the mesh is open already it need not be asked for; another one is not taken for it.
    await openMesh(page, "wavy.obj", mesh);
    await upload(page, name, bytes);
    await untilStep(page, 2);
    assert.equal(await energy(page), shown);
    await openMesh(page, "other.obj", obj(wavyTorus(16, 8)));
    await upload(page, name, bytes);
    await notes.getByText(/is for the mesh “wavy\.obj”/).waitFor();
    await upload(page, "wavy.obj", obj(wavyTorus(16, 8)));
    await notes.getByText(/not the mesh “wavy\.obj” of the recipe/).waitFor();
    await until(page, "Ready");

    // One that is wrong is refused by its key, and nothing is lost.
    const wrong = Buffer.from(bytes.toString("utf8").replace('"steps"', '"step"'));
    await upload(page, "bad.json", wrong);
    await page
      .getByRole("alert")
      .getByText(/“edits\[0\]\.path\[0\]” must be/)
      .waitFor();
    assert.equal(await reading(page, "Vertices"), "128");
  } finally {
    rmSync(folder, { recursive: true });
  }
  assert.deepEqual(faults, []);
  await close();
});

test("on a phone the history is under the thumb", async () => {
  const phone = { viewport: { width: 390, height: 844 }, hasTouch: true };
  const { page, faults, close } = await site.blank(phone);
  // A browser that cannot record says so.
  await page.addInitScript(() => Reflect.deleteProperty(globalThis, "MediaRecorder"));
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  await take(page, 0, 3);
  await slider(page).waitFor();
  const box = await slider(page).boundingBox();
  assert.ok(box && box.width > 120 && box.x >= 0 && box.x + box.width <= 390);
  assert.ok(box.y + box.height <= 844, "on the screen");
  const panel = button(page, "Panel");
  if ((await panel.getAttribute("aria-expanded")) === "false") await panel.click();
  await page.locator("#record > summary").click();
  await page.getByText("This browser cannot record films.").waitFor();
  assert.equal(await button(page, "Record film").getAttribute("aria-disabled"), "true");
  assert.deepEqual(faults, []);
  await close();
});
