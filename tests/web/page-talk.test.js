// @ts-check
// The page in German, presented in a lecture hall, and on a phone held in one hand.

import assert from "node:assert/strict";
import { test } from "node:test";
import { figures } from "../../www/generated/library.js";
import { figureTitle } from "../../www/library.js";
import { paper } from "../../www/ui/statements.js";
import {
  button,
  canvas,
  stillPicture,
  surface,
  until,
  untilPictured,
  upload,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** Words that are English and not German, so that one of them gives a sentence away. */
const ENGLISH =
  /\b(the|of|and|with|is|are|by|from|this|that|its|or|as|at|mesh|surface|step|steps|flow|vertices|faces|edge|edges|boundary|energy|angle|size|area|open|save|close|play|paused|running|ready|reset|choose|after|each|kept|figure|figures|no)\b/i;

/** What people see or hear of the page and is not German. @param {Page} page @returns {Promise<string[]>} */
async function englishLeft(page) {
  const texts = await page.evaluate(() => {
    /** @type {string[]} */
    const found = [];
    for (const element of document.querySelectorAll("body *")) {
      if (element.matches("option, optgroup") ? false : !element.checkVisibility()) continue;
      for (const name of ["aria-label", "title", "alt", "placeholder"]) {
        found.push(element.getAttribute(name) ?? "");
      }
      for (const node of element.childNodes) {
        if (node.nodeType === Node.TEXT_NODE) found.push(node.nodeValue ?? "");
      }
    }
    return found;
  });
  // Names of elements, and of the solver’s shapes, are names, and titles of papers are titles.
  const own = (/** @type {string} */ text) =>
    Object.values(paper).reduce(
      (rest, title) => rest.replace(title, ""),
      text.replace(/<[\w-]+>/g, ""),
    );
  return [...new Set(texts)].filter((text) => ENGLISH.test(own(text)));
}

/** @param {Page} page @param {string | RegExp} status @param {string} state */
async function checkGerman(page, status, state) {
  await until(page, status);
  assert.deepEqual(await englishLeft(page), [], state);
}

test("in German no English is left, whatever is shown", async () => {
  const { page, faults, close } = await site.blank({ locale: "de-CH" });
  await page.goto(`${site.url}?msaa=1`);
  await checkGerman(page, "Bereit", "at the start");
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await page.evaluate(() => {
    for (const part of document.querySelectorAll("details")) part.open = true;
  });
  await button(page, "Schritt").click();
  await checkGerman(page, "Angehalten bei Schritt 1", "after a step, everything open");

  for (const [flow, sample] of [
    ["p-willmore", "vesicle"],
    ["mmcv", "four-bumps"],
    ["flips", "sampled-torus"],
  ]) {
    await page.locator("#sample").selectOption(sample);
    await page.waitForFunction(
      (wanted) =>
        /** @type {HTMLSelectElement} */ (document.querySelector("#flow")).value === wanted,
      flow,
    );
    await until(page, "Bereit");
    await page.locator("#colour").selectOption("mean-curvature");
    await page.getByRole("img", { name: /^Farben: Mittlere Krümmung H/ }).waitFor();
    if (flow === "mmcv") {
      await page.getByLabel("Alle vier Flüsse nebeneinander").check();
      await page.locator("#flows-rows tr").nth(3).waitFor();
      await page.locator("#loops input").first().waitFor();
    }
    if (flow === "flips") {
      await page.locator("#compare").selectOption("criteria");
      await button(page, "Bis zum Ende flippen").click();
      await checkGerman(page, /^Angehalten bei Schritt \d{3}/, "flipped to the end");
      await page.getByText(/^Auf diesem Netz gilt sie/).waitFor();
      await page.locator("#flip-data-rows tr").nth(90).waitFor();
    }
    assert.deepEqual(await englishLeft(page), [], flow);
  }

  await page.getByLabel("Netz öffnen", { exact: true }).setInputFiles({
    name: "broken.obj",
    mimeType: "text/plain",
    buffer: Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
  });
  const alert = page.getByRole("alert");
  await alert.getByText("OBJ, Zeile 4: Eine Facette nennt Ecke 9, die Datei hat 3").waitFor();
  assert.deepEqual(await englishLeft(page), [], "with an error");
  await alert.getByRole("button", { name: "Ausblenden" }).click();
  await button(page, "Abbildungen").click();
  await page
    .locator(".card")
    .nth(figures.length - 1)
    .waitFor();
  assert.deepEqual(await englishLeft(page), [], "the gallery");
  const cards = await page.locator(".card strong").allTextContents();
  assert.ok(
    cards.every((card) => /^(Abb\.|Satz,?) /.test(card)),
    cards.join(),
  );
  await page.locator(".card").first().click();
  await checkGerman(page, "Bereit", "a figure");
  await button(page, "Hilfe").click();
  assert.deepEqual(await englishLeft(page), [], "the help");
  await page.keyboard.press("Escape");

  // After a step loading the page again takes time: it is said, and done when told to.
  await button(page, "Schritt").click();
  await until(page, "Angehalten bei Schritt 1");
  await page.locator("#language").selectOption("en");
  await page.getByText("Die Seite wechselt ihre Sprache").first().waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  await page.locator("[data-language-note] button").filter({ visible: true }).click();
  await until(page, "Paused at step 1");
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  // At the start nothing is lost, and the choice outlives the page.
  await button(page, "Reset").click();
  await until(page, "Ready");
  await page.locator("#plot canvas").waitFor();
  await page.locator("#view > summary").click();
  await page.getByRole("combobox", { name: "Language / Sprache" }).selectOption("de");
  await until(page, "Bereit");
  await page.locator("#plot canvas").waitFor();
  await page.goto(`${site.url}?msaa=1&lang=en`);
  await until(page, "Ready");
  assert.deepEqual(faults, []);
  await close();
});

/** Texts smaller than 24 px that can be seen. @param {Page} page @returns {Promise<string[]>} */
const smallTexts = (page) =>
  page.evaluate(() => {
    const dialog = document.querySelector("dialog[open]");
    /** @type {string[]} */
    const small = [];
    for (const element of (dialog ?? document).querySelectorAll("*")) {
      const isText = [...element.childNodes].some(
        ({ nodeType, nodeValue }) => nodeType === Node.TEXT_NODE && nodeValue?.trim(),
      );
      const isSeen = element.checkVisibility({ visibilityProperty: true, opacityProperty: true });
      if ((!isText && !element.matches("select")) || !isSeen) continue;
      if (element.matches("script, style, title, option, sub, sup")) continue;
      const { fontSize, clipPath } = getComputedStyle(element);
      if (clipPath !== "none" || Number.parseFloat(fontSize) >= 24) continue;
      small.push(`${fontSize} ${element.localName}#${element.id}: ${element.textContent?.trim()}`);
    }
    return small;
  });

test("presenting: large words, a clicker's keys, controls that come and go", async () => {
  const { page, faults, close } = await site.open("", {
    viewport: { width: 1920, height: 1080 },
    reducedMotion: "reduce",
  });
  const line = page.locator("#presented");
  const [first, second] = figures;
  await button(page, "Figures").click();
  await page.locator(".card").first().click();
  await page.locator("#figure-heading", { hasText: figureTitle(first) }).waitFor();
  await until(page, "Ready");
  await page.locator("#colour").selectOption("mean-curvature");
  await page.locator("#colour-bar").waitFor();
  await page.locator("#colour").blur();
  await page.keyboard.press("f");
  await line
    .filter({ hasText: `W = 188.5 · step 0 · Bobenko and Schröder, ${figureTitle(first)}` })
    .waitFor();
  assert.deepEqual(await smallTexts(page), [], "at the start");

  // They go after a while, come with the pointer, and stay with the focus.
  const controls = () => page.locator(".buttons").evaluate((e) => getComputedStyle(e).opacity);
  await page.locator("html.idle").waitFor();
  assert.equal(await controls(), "0");
  await page.mouse.move(700, 500);
  assert.equal(await controls(), "1");
  await button(page, "Step").focus();
  // An arrow key is for the control that has the focus.
  await page.keyboard.press("ArrowRight");
  await page.locator("html.idle").waitFor();
  assert.equal(await controls(), "1");
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());

  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  await page.keyboard.press("PageUp");
  await until(page, "Ready");
  await page.keyboard.press("PageDown");
  await until(page, /^Converged after \d+ steps$/);
  assert.deepEqual(await smallTexts(page), [], "converged");
  await page.keyboard.press("PageDown");
  await line.filter({ hasText: `step 0 · Bobenko and Schröder, ${figureTitle(second)}` }).waitFor();
  await until(page, "Ready");
  await page.keyboard.press("ArrowLeft");
  await line.filter({ hasText: figureTitle(first) }).waitFor();
  await until(page, "Ready");
  // Before the first there is none.
  await page.keyboard.press("PageUp");
  await page.keyboard.press("h");
  await line.waitFor({ state: "hidden" });
  await page.keyboard.press("h");
  await line.filter({ hasText: figureTitle(first) }).waitFor();

  // An arrow key of the picture turns it; that of nobody plays.
  await canvas(page).focus();
  const camera = page.waitForFunction(() => location.hash.includes("camera="));
  await page.keyboard.press("ArrowRight");
  await camera;
  assert.match(await surface(page), /step 0,/);

  await page.keyboard.press("?");
  const help = page.getByRole("dialog");
  await help.waitFor();
  assert.deepEqual(await smallTexts(page), [], "the help");
  // The dialog only: the presentation goes on.
  await page.keyboard.press("Escape");
  await help.waitFor({ state: "hidden" });
  assert.equal(await page.locator("html.presenting").count(), 1);
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.keyboard.press("g");
  await page.locator(".card").first().waitFor();
  assert.deepEqual(await smallTexts(page), [], "the gallery");
  await page.keyboard.press("Escape");
  await upload(page, "broken.obj", "v 0 0 0\nf 1 2 3\n");
  await page.getByRole("alert").locator(".message").waitFor();
  assert.deepEqual(await smallTexts(page), [], "an error");
  await button(page, "Dismiss").click();

  // A run that lasts: paused by the same key.
  await upload(page, "wavy.obj", obj(wavyTorus(120, 60)));
  await line.filter({ hasText: "step 0 · wavy" }).waitFor();
  await until(page, "Ready");
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.keyboard.press("ArrowRight");
  await until(page, "Running");
  await page.keyboard.press("PageDown");
  await until(page, /^Paused at step \d+$/);
  await page.keyboard.press("Escape");
  await page.locator("html:not(.presenting)").waitFor();
  // Outside of a presentation the keys scroll, as ever.
  await page.keyboard.press("PageUp");
  await until(page, /^Paused at step \d+$/);
  assert.deepEqual(faults, []);
  await close();
});

/** @param {Page} page */
const barColours = (page) =>
  page.locator("#colour-bar-scale").evaluate((bar) => {
    const context = /** @type {HTMLCanvasElement} */ (bar).getContext("2d");
    return [0, 64, 128, 255].map((x) => [...(context?.getImageData(x, 0, 1, 1).data ?? [])].join());
  });

test("high contrast takes other colours, on the surface and in its scale, and stays", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&colour=mean-curvature", {
    viewport: { width: 700, height: 500 },
  });
  await page.locator("#colour-bar").waitFor({ state: "attached" });
  await page.getByRole("img", { name: /^Colours:/ }).waitFor();
  const [before, colours] = [await stillPicture(page), await barColours(page)];
  await page.evaluate(() => {
    const box = /** @type {HTMLInputElement} */ (document.querySelector("[name=contrast]"));
    box.click();
  });
  await untilPictured(page, before, (mean) => mean > 2);
  const strong = await barColours(page);
  assert.ok(
    strong.every((colour, n) => colour !== colours[n]),
    `${colours} and ${strong}`,
  );
  assert.equal(strong[0], "12,24,66,255");
  await page.locator("#plot canvas").waitFor({ state: "attached" });
  await page.reload();
  await page.getByRole("img", { name: /^Colours:/ }).waitFor();
  assert.deepEqual(await barColours(page), strong);
  assert.deepEqual(faults, []);
  await close();
});

test("a phone in one hand: the sheet leaves the picture room, and a swipe closes it", async () => {
  for (const query of ["msaa=1&lang=en", "msaa=1&lang=de"]) {
    const { page, faults, close } = await site.blank({
      viewport: { width: 390, height: 844 },
      hasTouch: true,
    });
    await page.goto(`${site.url}?${query}`);
    await page
      .locator("#status")
      .filter({ hasText: /^(Ready|Bereit)$/ })
      .waitFor();
    const panel = page.locator("#panel");
    await page.locator("#panel-toggle").click();
    await panel.waitFor();
    await page.evaluate(() => {
      for (const part of document.querySelectorAll("details")) part.open = true;
    });
    const measured = await page.evaluate(() => {
      const box = (/** @type {string} */ of) => document.querySelector(of)?.getBoundingClientRect();
      const sheet = /** @type {HTMLElement} */ (document.querySelector("#panel"));
      const buttons = [...document.querySelectorAll(".buttons button")];
      return {
        picture: (box("#surface")?.height ?? 0) / innerHeight,
        buttons: Math.min(...buttons.map((b) => b.getBoundingClientRect().height)),
        lowest: Math.max(...buttons.map((b) => b.getBoundingClientRect().bottom)),
        sideways: document.documentElement.scrollWidth - innerWidth,
        sheetSideways: sheet.scrollWidth - sheet.clientWidth,
        // What is hidden from sight in the sheet must not make the page scroll.
        downwards: document.documentElement.scrollHeight - innerHeight,
      };
    });
    assert.ok(measured.picture >= 0.4, JSON.stringify(measured));
    assert.ok(measured.buttons >= 44 && measured.lowest <= 844, JSON.stringify(measured));
    assert.deepEqual([measured.sideways, measured.sheetSideways], [0, 0], query);
    assert.equal(measured.downwards, 0, query);

    const handle = await page.locator("#panel-handle").boundingBox();
    assert.ok(handle && handle.height >= 44);
    const [x, y] = [handle.x + handle.width / 2, handle.y + handle.height / 2];
    /** @param {number} down  pixels */
    const swipe = async (down) => {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x, y + down, { steps: 4 });
      await page.mouse.up();
    };
    // Not far, and let go: it stays where it was.
    await swipe(30);
    assert.equal(await panel.evaluate((sheet) => sheet.style.translate), "");
    assert.equal(await panel.isVisible(), true);
    await swipe(130);
    await panel.waitFor({ state: "hidden" });
    await page.locator("#panel-toggle").click();
    await panel.waitFor();
    await page.locator("#panel-handle").press("Enter");
    await panel.waitFor({ state: "hidden" });
    const focused = await page.evaluate(() => document.activeElement?.id);
    assert.equal(focused, "panel-toggle");
    assert.deepEqual(faults, []);
    await close();
  }
});
