// @ts-check
// The page without a pointer: every control is reached and shows that it is, the single
// keys work, and they rest while something is typed.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  choice,
  openMesh,
  stillPicture,
  surface,
  until,
  untilPictured,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** Where the focus is, and what can be seen of it. @param {Page} page */
const focused = (page) =>
  page.evaluate(() => {
    const element = /** @type {HTMLElement} */ (document.activeElement);
    const { outlineStyle, outlineWidth } = getComputedStyle(element);
    const box = element.getBoundingClientRect();
    const text = element.textContent?.trim().slice(0, 30);
    return {
      name: element.id || element.getAttribute("name") || `${element.localName} ${text}`,
      body: element === document.body,
      ring: outlineStyle !== "none" && Number.parseFloat(outlineWidth) >= 2,
      inWindow: box.width > 0 && box.bottom > 0 && box.top < innerHeight,
    };
  });

/** What should be reached, in the order of the document: of radio buttons, the chosen one. @param {Page} page */
const reachable = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll("button, select, input, summary, [tabindex='0']")]
      .filter((element) => /** @type {HTMLElement} */ (element).checkVisibility())
      .filter((element) => !element.closest("dialog"))
      .filter((element) => !element.matches("[type=radio]:not(:checked)"))
      .map((element) => {
        const text = element.textContent?.trim().slice(0, 30);
        return element.id || element.getAttribute("name") || `${element.localName} ${text}`;
      }),
  );

test("Tab reaches every control, in order, and shows where it is", async () => {
  const { page, faults, close } = await site.open();
  // Not by a click, after which Tab would go on from there.
  await page.evaluate(() => {
    for (const part of document.querySelectorAll("details")) part.open = true;
  });
  const expected = await reachable(page);
  assert.ok(expected.length > 30, `only ${expected.length} controls`);
  for (const name of ["play", "step", "back", "reset", "sample", "open", "download", "surface"]) {
    assert.ok(expected.includes(name), name);
  }
  /** @type {string[]} */
  const visited = [];
  /** @type {string[]} */
  const unseen = [];
  await page.keyboard.press("Tab");
  for (let i = 0; i < 2 * expected.length; i += 1) {
    const { name, body, ring, inWindow } = await focused(page);
    if (body) break;
    visited.push(name);
    if (!ring || !inWindow) unseen.push(name);
    await page.keyboard.press("Tab");
  }
  assert.deepEqual(visited, expected);
  assert.deepEqual(unseen, [], "no ring, or outside the window");
  assert.deepEqual(faults, []);
  await close();
});

test("single keys play, pause, step, go back, reset, present and help", async () => {
  const { page, faults, close } = await site.open();
  // Large, so that it still runs when the second Space comes.
  await openMesh(page, "wavy.obj", obj(wavyTorus(120, 60)));
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  await page.keyboard.press(".");
  await until(page, "Paused at step 2");
  await page.keyboard.press(",");
  await until(page, "Paused at step 1");
  await page.keyboard.press("Space");
  await until(page, "Running");
  await page.keyboard.press("Space");
  await until(page, /^Paused at step \d+$/);
  await page.keyboard.press("r");
  await until(page, "Ready");

  await page.keyboard.press("f");
  await page.locator("html.presenting").waitFor();
  assert.equal(await page.locator("#panel").isVisible(), false);
  await page.keyboard.press("f");
  await page.locator("html:not(.presenting)").waitFor();

  await page.keyboard.press("?");
  const help = page.getByRole("dialog");
  await help.waitFor();
  // Behind the dialog nothing moves; with it gone, the key works.
  await page.keyboard.press(".");
  await page.keyboard.press("Escape");
  await help.waitFor({ state: "hidden" });
  assert.match(await surface(page), /step 0,/);
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  assert.deepEqual(faults, []);
  await close();
});

test("keys belong to whatever takes them: a number, a list, a pressed button", async () => {
  const { page, faults, close } = await site.open();
  await page.locator("#method > summary").click();
  const steps = page.getByRole("spinbutton", { name: "Step limit" });
  await steps.focus();
  for (const key of [".", ",", "r", "f", "?", " "]) await page.keyboard.press(key);
  await choice(page, "Flow").focus();
  for (const key of [".", ",", "r", "f", "?"]) await page.keyboard.press(key);
  assert.equal(await page.getByRole("dialog").isVisible(), false);
  assert.equal(await page.locator("html.presenting").count(), 0);
  // With the browser's own shortcuts as well.
  await canvas(page).focus();
  await page.keyboard.press("Alt+.");
  // Space presses the button that has the focus, once, and does not play besides.
  await button(page, "Step").focus();
  await page.keyboard.press("Space");
  await until(page, "Paused at step 1");
  assert.match(await surface(page), /step 1,/);
  assert.deepEqual(faults, []);
  await close();
});

test("single keys can be switched off, and stay so", async () => {
  const { page, faults, close } = await site.open();
  await page.keyboard.press("?");
  await page.getByRole("checkbox", { name: "Single-key shortcuts" }).uncheck();
  await page.keyboard.press("Escape");
  // The last thing the page fetches: a reload would cut it off.
  await page.locator("#plot canvas").waitFor();
  await page.reload();
  await until(page, "Ready");
  await page.keyboard.press(".");
  await button(page, "Step").press("Enter");
  await until(page, "Paused at step 1");
  assert.deepEqual(faults, []);
  await close();
});

test("arrow keys turn the surface", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus");
  // The ring of the focus is in both pictures.
  await canvas(page).focus();
  const before = await stillPicture(page);
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("ArrowUp");
  await page.waitForFunction(() => location.hash.includes("camera="));
  await untilPictured(page, before, (mean) => mean > 0.5);
  assert.deepEqual(faults, []);
  await close();
});
