// @ts-check
// A scene that is sent: whole at the other end, and told apart where it is not the same.

import assert from "node:assert/strict";
import { test } from "node:test";
import { figures } from "../../www/generated/library.js";
import { figureTitle, sayFigure } from "../../www/library.js";
import {
  button,
  choice,
  download,
  energy,
  openMesh,
  reading,
  surface,
  until,
  upload,
  useSite,
} from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

const allowed = { permissions: ["clipboard-read", "clipboard-write"] };

/** Presses a button of the section, and answers what it copied. @param {Page} page @param {string} name */
async function copied(page, name) {
  await page.evaluate(() => navigator.clipboard.writeText(""));
  await button(page, name).click();
  await page
    .locator("#share-said")
    .getByText(/copied/)
    .waitFor();
  return page.evaluate(() => navigator.clipboard.readText());
}

/** Opens the section, where it is not open. @param {Page} page */
async function openShare(page) {
  if (!(await page.locator("#share").getAttribute("open"))) {
    await page.locator("#share > summary").click();
  }
}

/** @param {string} link */
const words = (link) => new URLSearchParams(new URL(link).hash.slice(1));

/** What the page says of the scene it was sent. @param {Page} page @param {RegExp} pattern */
const said = (page, pattern) => page.locator("#messages").getByText(pattern).waitFor();

test("figure, region, border lines and axis are in the link, and the energy agrees to the bit", async () => {
  const { page, faults, close } = await site.open("", allowed);
  const figure = figures.find(({ id }) => id === "circle-6") ?? figures[0];
  await button(page, "Figures").click();
  await page
    .locator(".card", { hasText: figureTitle(figure) })
    .first()
    .click();
  await page.getByRole("region", { name: new RegExp(`^${sayFigure(figure)}: `) }).waitFor();
  await until(page, "Ready");
  await page.locator("#view > summary").click();
  await page.getByLabel("Border lines").uncheck();
  await choice(page, "Axis").selectOption("log");
  await page.locator("#region > summary").click();
  await page.waitForFunction(() => location.hash.includes("border=false"));
  await page.evaluate(() => {
    const held = Array.from({ length: 400 }, (_, i) => 3 * i);
    const word = btoa(
      String.fromCharCode(
        ...held.reduce((bytes, v) => {
          bytes[v >> 3] |= 1 << (v & 7);
          return bytes;
        }, new Uint8Array(150)),
      ),
    );
    const text = word.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
    location.hash = `${location.hash}&fixed=b${text}&step=2`;
  });
  await until(page, "Paused at step 2");
  await page
    .locator("#region-count")
    .getByText(/^\d+ of \d+ vertices move/)
    .waitFor();
  await openShare(page);
  const link = await copied(page, "Copy link");
  for (const word of [
    "figure=circle-6",
    "border=false",
    "scale=log",
    "fixed=",
    "step=2",
    "version=",
    "check=",
  ]) {
    assert.ok(link.includes(word), `${word} is not in ${link}`);
  }
  const second = await site.open(new URL(link).hash.slice(1));
  await said(second.page, /^The scene is as it was sent: W = \d/);
  assert.equal(await surface(second.page), await surface(page));
  assert.equal(await energy(second.page), await energy(page));
  assert.equal(
    await second.page.locator("#region-count").textContent(),
    await page.locator("#region-count").textContent(),
  );
  await second.page.getByRole("region", { name: new RegExp(`^${sayFigure(figure)}: `) }).waitFor();
  assert.equal(await second.page.locator("#scale").inputValue(), "log");
  assert.equal(await second.page.locator("#view-form [name=boundary]").isChecked(), false);
  for (const one of [faults, second.faults]) assert.deepEqual(one, []);
  await second.close();
  await close();
});

test("edits by hand are in the link, and done again where it is opened", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron", allowed);
  /** @param {Page} on @param {number} from @param {number} to */
  const take = async (on, from, to) => {
    for (let step = from; step < to; step += 1) {
      await button(on, "Step").click();
      await until(on, `Paused at step ${step + 1}`);
    }
  };
  await take(page, 0, 2);
  await button(page, "Keep as new start").click();
  await until(page, "Ready");
  const before = Number(await reading(page, "Vertices"));
  await button(page, "Subdivide").click();
  await page
    .getByRole("log")
    .getByText(/^Subdivided into/)
    .waitFor();
  await until(page, "Ready");
  await take(page, 0, 1);
  const vertices = await reading(page, "Vertices");
  assert.ok(Number(vertices) > 3 * before);
  await openShare(page);
  assert.equal(await page.locator("#share-lacks").isVisible(), false, "nothing is missing");
  const link = await copied(page, "Copy link");
  assert.equal(words(link).get("sample"), "icosahedron");
  assert.ok((words(link).get("edits") ?? "").length < 400, link);

  const second = await site.open(new URL(link).hash.slice(1), allowed);
  await said(second.page, /^The scene is as it was sent: W = \d/);
  assert.equal(await energy(second.page), await energy(page));
  assert.equal(await reading(second.page, "Vertices"), vertices);
  // What came with the link goes on with it, and into a recipe.
  const { bytes } = await download(second.page, "Recipe, JSON");
  const recipe = JSON.parse(bytes.toString("utf8"));
  assert.deepEqual([recipe.mesh.sample, recipe.edits.length, recipe.steps], ["icosahedron", 2, 1]);
  // A run that is more than steps is in the link as what it is.
  await choice(second.page, "Flow").selectOption({ label: "p-Willmore" });
  await until(second.page, "Ready");
  await take(second.page, 0, 1);
  await button(second.page, "Regularise the mesh now").click();
  await second.page.waitForFunction(() => location.hash.includes("path="));
  await take(second.page, 1, 2);
  await openShare(second.page);
  const longer = await copied(second.page, "Copy link");
  const third = await site.open(new URL(longer).hash.slice(1));
  await said(third.page, /^The scene is as it was sent: ∫H² = \d/);
  assert.equal(await energy(third.page), await energy(second.page));

  // Undone, they are out of it again.
  const both = words(link).get("edits") ?? "";
  await button(page, "Undo").click();
  await page.waitForFunction((text) => !location.hash.includes(text), both);
  assert.match(page.url(), /[&]edits=/);
  await button(page, "Undo").click();
  await page.waitForFunction(() => !location.hash.includes("edits="));
  assert.equal(words(page.url()).get("sample"), "icosahedron");
  for (const one of [faults, second.faults, third.faults]) assert.deepEqual(one, []);
  await third.close();
  await second.close();
  await close();
});

test("an energy that does not come out is said, with what it may be", async () => {
  const { page, faults, close } = await site.open(
    "sample=icosahedron&step=1&check=90.1234567&version=0.0.9",
  );
  await said(page, /not as it was sent: W = [\d.]+ at step 1, where the link says 90\.12/);
  await said(page, /made by version 0\.0\.9 of the solver; this is version/);
  assert.deepEqual(faults, []);
  await close();
});

test("somebody's file is told apart by what is in it", async () => {
  const { page, faults, close } = await site.open("", allowed);
  const mesh = obj(wavyTorus(16, 8));
  await openMesh(page, "theirs.obj", mesh);
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await button(page, "Keep as new start").click();
  await until(page, "Ready");
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await openShare(page);
  await page
    .locator("#share-lacks")
    .getByText(/send the file along/)
    .waitFor();
  const link = await copied(page, "Copy link");
  assert.match(words(link).get("hash") ?? "", /^[\da-f]{16}$/);
  assert.match(link, /&edits=/);
  assert.ok(link.length < 600, "and nothing of what is in it");

  const second = await site.blank();
  await second.page.goto(`${site.url}?msaa=1${new URL(link).hash}`);
  await second.page.getByRole("alert").getByText("theirs").waitFor();
  await until(second.page, "Open a mesh to begin");
  // Another file of that name: opened, told apart, and its energy is not the one sent.
  await upload(second.page, "theirs.obj", obj(wavyTorus(18, 8)));
  await said(second.page, /“theirs\.obj” is not the file of the link, which shows “theirs”/);
  await said(second.page, /not as it was sent/);
  await said(second.page, /The mesh is not the file of the link\./);
  assert.match(await surface(second.page), /^Surface: theirs, step 1/);
  // The file itself, whatever it is called.
  await upload(second.page, "renamed.obj", mesh);
  await said(second.page, /^The scene is as it was sent: W = \d/);
  assert.match(await surface(second.page), /^Surface: renamed, step 1/);
  for (const one of [faults, second.faults]) assert.deepEqual(one, []);
  await second.close();
  await close();
});

test("a figure can be asked for by its name alone; one there is not, is said", async () => {
  const { page, faults, close } = await site.open("figure=circle-7-fixed");
  await page.locator("#figure").getByText("The paper reports").waitFor();
  assert.equal(await choice(page, "Sample").inputValue(), "saddle");
  await page.evaluate(() => {
    location.hash = "#figure=circle-99";
  });
  await page.getByRole("alert").getByText("there is no figure `circle-99`").waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("code to embed is copied; where nothing may be copied, the text is selected", async () => {
  const { page, faults, close } = await site.open("sample=pipe", allowed);
  await openShare(page);
  const element = await copied(page, "Copy embed code");
  assert.match(
    element,
    /^<script type="module" src="http.*\/embed\.js"><\/script>\n<umbilic-surface sample="pipe"/,
  );
  assert.match(element, /width: 640px; height: 480px/);
  await choice(page, "Embed as").selectOption("iframe");
  await choice(page, "Size").selectOption("960x600");
  assert.match(
    await copied(page, "Copy embed code"),
    /^<iframe src="http.*\?embed#sample=pipe.*width="960" height="600"/,
  );
  await page.evaluate(() => {
    navigator.clipboard.writeText = () => Promise.reject(new Error("no"));
  });
  await button(page, "Copy link").click();
  const field = page.getByRole("textbox", { name: "Text to copy" });
  await field.waitFor();
  await page
    .locator("#share-said")
    .getByText(/copy it with Ctrl\+C/)
    .waitFor();
  const selected = await field.evaluate((/** @type {HTMLTextAreaElement} */ one) =>
    one.value.slice(one.selectionStart, one.selectionEnd),
  );
  assert.match(selected, /^http.*#sample=pipe&flow=circle&.*check=/);
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(faults, []);
  await close();
});
