// @ts-check
// What leaves the page: links, meshes, numbers, pictures, films, recipes, code.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import {
  button,
  download,
  energy,
  openPart,
  openTab,
  playAndPause,
  playToEnd,
  reading,
  until,
  untilDrawn,
  upload,
  useSite,
} from "./support/app.js";
import { measure } from "./support/browser.js";
import { playFilm } from "./support/film.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();
const cli = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
const clipboard = { permissions: ["clipboard-read", "clipboard-write"] };

/** @param {import("playwright-core").Page} page */
const copied = (page) => page.evaluate(() => navigator.clipboard.readText());

test("a link brings the scene back: flow, step, camera and colours", async () => {
  const scene = "sample=coarse-torus&flow=mean-curvature&step=3&colour=willmore&wireframe=true";
  const { page, faults, close } = await site.open(scene, clipboard);
  const first = await energy(page);
  await openTab(page, "Share");
  await button(page, "Copy link").click();
  await page.getByText("Link copied.").first().waitFor();
  const link = new URL(await copied(page));
  const second = await site.open(link.hash.slice(1));
  assert.equal(await energy(second.page), first);
  assert.equal(await reading(second.page, "Step"), "3");
  await second.page
    .getByText(/The scene is as it was sent/)
    .first()
    .waitFor();
  await second.page.getByRole("img", { name: /^Colours: Willmore energy/ }).waitFor();
  assert.deepEqual([...faults, ...second.faults], []);
  await second.close();
  await close();
});

test("a link to a mesh of one's own waits for the file", async () => {
  const mesh = obj(wavyTorus(24, 12));
  const { page, close } = await site.open("sample=pipe", clipboard);
  await upload(page, "wavy.obj", mesh);
  await page.getByRole("img", { name: /^Surface: wavy/ }).waitFor();
  await until(page, "Ready");
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  const first = await energy(page);
  await openTab(page, "Share");
  await button(page, "Copy link").click();
  await page
    .getByText(/send the file too/)
    .first()
    .waitFor();
  const { hash } = new URL(await copied(page));
  const second = await site.blank();
  await second.page.goto(`${site.url}?msaa=1${hash}`);
  await second.page
    .getByRole("alert")
    .getByText(/shows the mesh “wavy”/)
    .waitFor();
  await upload(second.page, "wavy.obj", mesh);
  await until(second.page, "Paused at step 1");
  assert.equal(await energy(second.page), first);
  await second.close();
  await close();
});

test("what is downloaded is the step that is shown, as the command line measures it", async () => {
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-share-"));
  const { page, faults, close } = await site.open("sample=coarse-torus&step=5");
  await page.keyboard.press(",");
  await until(page, "Paused at step 4");
  const { name, bytes } = await download(page, "PLY");
  assert.equal(name, "coarse-torus-circle-step0004.ply");
  const file = path.join(folder, name);
  writeFileSync(file, bytes);
  const said = JSON.parse(
    execFileSync(process.execPath, [cli, "energy", file, "--json"], { encoding: "utf8" }),
  );
  assert.ok(Math.abs(said.circle - (await energy(page))) <= 1e-5 * said.circle);
  const csv = await download(page, "History, CSV");
  assert.equal(csv.bytes.toString().trim().split("\n").length, 1 + 4, "a head and a row a step");
  // Also where the clip was paused, while the solver was ahead.
  await button(page, "Reset").click();
  await until(page, "Ready");
  const step = await playAndPause(page, 1);
  const paused = await download(page, "PLY");
  assert.equal(paused.name, `coarse-torus-circle-step${String(step).padStart(4, "0")}.ply`);
  const png = await download(page, "Picture, PNG");
  assert.ok(measure(png.bytes).colours > 200);
  assert.deepEqual(faults, []);
  rmSync(folder, { recursive: true });
  await close();
});

test("a recipe does it again, to the last bit", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&step=3");
  const first = await energy(page);
  const { bytes } = await download(page, "Recipe, JSON");
  const second = await site.open("sample=pipe");
  await upload(second.page, "again.recipe.json", bytes);
  await second.page
    .getByText(/to the last bit/)
    .first()
    .waitFor();
  assert.equal(await energy(second.page), first);
  assert.equal(await reading(second.page, "Step"), "3");
  assert.deepEqual([...faults, ...second.faults], []);
  await second.close();
  await close();
});

test("all steps as a ZIP, the clip as a film", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&maxSteps=4");
  await untilDrawn(page);
  await openTab(page, "Share");
  await button(page, "Record film").click();
  await playToEnd(page);
  const [film] = await Promise.all([
    page.waitForEvent("download"),
    button(page, "Stop and save").click(),
  ]);
  assert.match(film.suggestedFilename(), /\.(webm|mp4)$/);
  const { readFileSync } = await import("node:fs");
  const blank = await site.blank();
  const played = await playFilm(blank.page, readFileSync(await film.path()));
  assert.ok(played.width > 300 && played.halves.some((colours) => colours > 50));
  await blank.close();
  await openPart(page, "Share", "All steps as a ZIP");
  const [zip] = await Promise.all([
    page.waitForEvent("download"),
    button(page, "Save the steps").click(),
  ]);
  const names = readFileSync(await zip.path())
    .toString("latin1")
    .match(/coarse-torus-step\d+\.ply/g);
  assert.deepEqual([...new Set(names)].length, 5);
  assert.deepEqual(faults, []);
  await close();
});

test("code for another page is copied", async () => {
  const { page, close } = await site.open("sample=pipe", clipboard);
  await openPart(page, "Share", "In another page");
  await button(page, "Copy the code").click();
  await page.getByText("Code copied.").first().waitFor();
  assert.match(await copied(page), /^<iframe src="[^"]+\?embed#sample=pipe/);
  await close();
});
