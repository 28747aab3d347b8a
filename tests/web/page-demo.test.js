// @ts-check
// The slides: turned by keys, clicker, buttons, swipe and address; only what is seen runs.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** @param {string} [hash] @param {import("playwright-core").BrowserContextOptions} [context] */
async function openDeck(hash = "", context = {}) {
  const opened = await site.blank(context);
  await opened.page.goto(`${site.url}demo.html${hash}`);
  return opened;
}

/** The slide on the screen, from 1. @param {Page} page */
const shown = (page) =>
  page.evaluate(() => {
    const slides = [...document.querySelectorAll("section")];
    const seen = slides.filter((slide) => slide.checkVisibility());
    return seen.length === 1 ? slides.indexOf(seen[0]) + 1 : 0;
  });

/** What the surface of the slide says of itself. @param {Page} page @param {number} slide */
const state = (page, slide) =>
  page.evaluate(async (n) => {
    await customElements.whenDefined("umbilic-surface");
    const element = document.querySelectorAll("section")[n - 1].querySelector("umbilic-surface");
    return /** @type {any} */ (element).state();
  }, slide);

test("keys, clicker, buttons and address turn the slides, and not beyond the ends", async () => {
  const { page, faults, close } = await openDeck("#/3");
  const count = await page.locator("section").count();
  assert.ok(count >= 8);
  assert.equal(await shown(page), 3);
  const after = /** @type {const} */ ([
    ["ArrowRight", 4],
    ["PageDown", 5],
    ["ArrowLeft", 4],
    ["PageUp", 3],
    ["End", count],
    ["PageDown", count],
    ["Home", 1],
    ["PageUp", 1],
  ]);
  for (const [key, slide] of after) {
    await page.keyboard.press(key);
    assert.equal(await shown(page), slide, key);
    assert.equal(new URL(page.url()).hash, `#/${slide}`);
  }
  await button(page, "Next slide").click();
  assert.equal(await shown(page), 2);
  await page.locator("#place").getByText(`2 / ${count}`).waitFor();
  for (const [hash, slide] of /** @type {const} */ ([
    ["#/4", 4],
    ["#/99", count],
    ["#nonsense", 1],
  ])) {
    await page.evaluate((to) => {
      location.hash = to;
    }, hash);
    await page.waitForFunction((n) => location.hash === `#/${n}`, slide);
    assert.equal(await shown(page), slide, hash);
  }
  await page.evaluate(() => {
    /** @param {string} type @param {number} x */
    const touch = (type, x) => {
      const one = new Touch({ identifier: 1, target: document.body, clientX: x, clientY: 300 });
      const touches = type === "touchstart" ? [one] : [];
      dispatchEvent(new TouchEvent(type, { touches, changedTouches: [one] }));
    };
    for (const [from, to] of [
      [600, 300],
      [600, 580],
    ]) {
      touch("touchstart", from);
      touch("touchend", to);
    }
  });
  assert.equal(await shown(page), 2, "a swipe turns, a touch does not");
  assert.deepEqual(faults, []);
  await close();
});

test("a surface runs while its slide is shown; Space plays, and the clicker works in it too", async () => {
  const { page, faults, close } = await openDeck("#/5");
  // Before a mesh is asked for there is none.
  while (["empty", "loading"].includes((await state(page, 5)).phase)) await page.waitForTimeout(50);
  assert.equal((await state(page, 5)).phase, "ready", "it waits to be played");
  assert.equal(page.workers().length, 1, "no other slide has started");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => {
    const outputs = document.querySelectorAll("section:not([hidden]) output");
    return outputs[0].textContent !== "–" && outputs[1].textContent !== "–";
  });
  await page.waitForFunction(() =>
    /** @type {any} */ (document.querySelector("section:not([hidden]) umbilic-surface"))
      .state()
      .then((/** @type {any} */ { step }) => step > 0),
  );
  await page.keyboard.press("PageDown");
  for (;;) {
    const { phase, isWaiting } = await state(page, 5);
    if (phase !== "running" && isWaiting) break;
    assert.equal(phase, "running");
  }
  const { step } = await state(page, 5);
  await page.keyboard.press("PageUp");
  // It goes on, unless it was at its end already.
  for (;;) {
    const now = await state(page, 5);
    if (!now.isWaiting && (now.step > step || now.phase !== "running")) break;
  }
  // A click into the surface takes the keys; the clicker's still turn the slides.
  await page.locator("section:not([hidden]) umbilic-surface").click();
  await page.keyboard.press("PageDown");
  await page.waitForFunction(() => location.hash === "#/6");
  assert.equal(await shown(page), 6);
  assert.deepEqual(faults, []);
  await close();
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`${colorScheme}: no rule of accessibility is broken, and nothing is cut off`, async () => {
    const { page, faults, close } = await openDeck("", {
      viewport: { width: 1280, height: 720 },
      colorScheme,
      reducedMotion: "reduce",
    });
    const count = await page.locator("section").count();
    for (let n = 1; n <= count; n += 1) {
      assert.equal(await shown(page), n);
      const cut = await page.evaluate(() => {
        const slide = /** @type {HTMLElement} */ (document.querySelector("section:not([hidden])"));
        const text = /** @type {HTMLElement} */ (slide.querySelector(".text"));
        const { top, bottom } = text.getBoundingClientRect();
        return text.scrollWidth > text.clientWidth + 1 || top < 0 || bottom > innerHeight;
      });
      assert.equal(cut, false, `slide ${n}`);
      if (n === 1 || n === 2 || n === count) {
        assert.deepEqual(await accessibilityFaults(page), [], `slide ${n}`);
      }
      await page.keyboard.press("PageDown");
    }
    // Printed, every slide has its page, with a still picture.
    await page.emulateMedia({ media: "print" });
    assert.equal(
      await page.evaluate(
        () =>
          [...document.querySelectorAll("section")].filter((one) => one.checkVisibility()).length,
      ),
      count,
    );
    assert.ok(await page.locator("img.print").first().isVisible());
    assert.deepEqual(
      faults.filter((fault) => !fault.includes("request failed")),
      [],
    );
    await close();
  });
}

test("the slides speak German to whoever asks for it, and so do their surfaces", async () => {
  const { page, faults, close } = await openDeck("?lang=de#/3");
  await page.getByRole("heading", { name: "Kreise statt Krümmungen" }).waitFor();
  assert.equal(await page.locator("html").getAttribute("lang"), "de");
  assert.equal(await page.title(), "Willmore-Fluss auf neun Folien");
  // The readings in a sentence stay in their places.
  const caption = page.locator("figcaption:visible");
  await caption.filter({ hasText: /Hier ist W = 188\.5 nach 0 Schritten\.$/ }).waitFor();
  const surface = page.frameLocator("section:not([hidden]) umbilic-surface iframe");
  await surface.getByRole("button", { name: "Abspielen", exact: true }).waitFor();
  await page.keyboard.press("End");
  await page.getByText("Discrete Willmore Flow").waitFor();
  assert.equal(await page.locator(".papers").getAttribute("lang"), "en");
  assert.deepEqual(faults, []);
  await close();
});
