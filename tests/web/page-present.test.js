// @ts-check
// Presenting from any scene with a clicker; nothing small, no diagnosis.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, colourBy, until, untilDrawn, useSite } from "./support/app.js";

const site = useSite();

/** The smallest text on the screen, in CSS pixels. @param {import("playwright-core").Page} page */
const smallest = (page) =>
  page.evaluate(() => {
    let least = Infinity;
    const walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walk.nextNode(); node; node = walk.nextNode()) {
      const element = node.parentElement;
      if (!element || !node.textContent?.trim() || !element.checkVisibility()) continue;
      if (element.closest("dialog, noscript, .visually-hidden")) continue;
      least = Math.min(least, Number.parseFloat(getComputedStyle(element).fontSize));
    }
    return least;
  });

test("a clicker plays, goes on to the next, and back", async () => {
  // Its run is long: it goes on while keys are pressed.
  const { page, faults, close } = await site.open("sample=coarse-torus", {
    reducedMotion: "reduce",
  });
  await colourBy(page, "Mean curvature H");
  await page.keyboard.press("f");
  await page.locator("#presented").waitFor();
  await untilDrawn(page);
  assert.equal(await page.locator("#presented").textContent(), "Coarse torus");
  assert.ok((await smallest(page)) >= 24, String(await smallest(page)));
  // Marks of the legend stand apart, on a phone too.
  await page.keyboard.press("c");
  for (const [width, height] of [
    [390, 844],
    [1280, 720],
  ]) {
    await page.setViewportSize({ width, height });
    const marks = await page.locator(".ticks span").evaluateAll((all) =>
      all
        .map((one) => one.getBoundingClientRect())
        .map(({ left, right }) => [left, right])
        .sort(([a], [b]) => a - b),
    );
    assert.ok(marks.length >= 3);
    for (let n = 1; n < marks.length; n += 1) assert.ok(marks[n - 1][1] < marks[n][0], `${marks}`);
  }
  await page.keyboard.press("c");
  const text = (await page.locator("body").allInnerTexts()).join("\n");
  assert.doesNotMatch(text, /step \d|Smallest angle|Converged/);
  await page.keyboard.press("PageDown");
  await page.waitForFunction(() => document.querySelector(".present-line .played"));
  await page.keyboard.press("PageDown");
  await page.keyboard.press("PageUp");
  await page.waitForFunction(() => !document.querySelector(".present-line .played"));
  // At the start once more: what stands before; pressed twice at once, two before.
  await page.keyboard.press("PageUp");
  await page.keyboard.press("PageUp");
  await page.locator("#presented").getByText("Bumpy sphere").waitFor();
  await page.keyboard.press("Escape");
  await button(page, "Play").waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("a figure goes on to the next figure", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron&figure=circle-6-adaptive");
  await page.keyboard.press("End");
  await page.keyboard.press("f");
  const title = await page.locator("#presented").textContent();
  await page.keyboard.press("Escape");
  const speed = page.getByRole("button", { name: /^Speed/ });
  while (!/4×/.test((await speed.textContent()) ?? "")) await speed.click();
  await button(page, "Play").click();
  await until(page, /^Converged/);
  await page.keyboard.press("f");
  await page.keyboard.press("PageDown");
  await page.waitForFunction(
    (before) => document.querySelector("#presented")?.textContent !== before,
    title,
  );
  assert.deepEqual(faults, []);
  await close();
});
