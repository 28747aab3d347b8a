// @ts-check
// Pictures and films of all panes, as they stand beside each other.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { button, download, openTab, until, useSite } from "./support/app.js";
import { measure } from "./support/browser.js";
import { playFilm } from "./support/film.js";
import { decodePng } from "./support/png.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */
/** @typedef {import("./support/png.js").Picture} Picture */

/** Greys and colours in a part of a picture, by shares of its sides. @param {Picture} picture @param {number} left @param {number} right @param {number} top @param {number} bottom */
function colours({ width, height, channels, data }, left, right, top, bottom) {
  const seen = new Set();
  for (let y = Math.ceil(top * height); y < Math.floor(bottom * height); y += 1) {
    for (let x = Math.ceil(left * width); x < Math.floor(right * width); x += 1) {
      const at = channels * (y * width + x);
      seen.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    }
  }
  return seen.size;
}

/** @param {Page} page */
async function untilDrawn(page) {
  const panes = page.locator(".pane canvas");
  for (const pane of await panes.all()) {
    for (let tries = 0; measure(await pane.screenshot()).colours < 200; tries += 1) {
      assert.ok(tries < 100, "no surface on the screen");
    }
  }
}

test("a picture holds all panes and what is said of them", async () => {
  const { page, faults, close } = await site.open("sample=icosahedron&panes=flow_p-willmore");
  await until(page, "Ready");
  await page.locator("#panes figcaption").nth(1).filter({ hasText: "step 0" }).waitFor();
  await untilDrawn(page);
  await openTab(page, "Share");
  const stage = await page.locator("#panes").boundingBox();
  const { name, bytes } = await download(page, "Picture, PNG");
  assert.match(name, /^icosahedron-.*step0000\.png$/);
  const picture = decodePng(bytes);
  assert.ok(Math.abs(picture.width - (stage?.width ?? 0)) <= 1);
  assert.ok(Math.abs(picture.height - (stage?.height ?? 0)) <= 1);
  const seen = [colours(picture, 0, 0.5, 0.1, 0.8), colours(picture, 0.5, 1, 0.1, 0.8)];
  assert.ok(Math.min(...seen) > 200, `${seen} colours`);
  // As it is on the screen, captions too, but for what floats over it.
  const screen = decodePng(await page.locator("#panes").screenshot());
  let [apart, count] = [0, 0];
  for (let y = Math.round(0.2 * screen.height); y < screen.height - 2; y += 1) {
    for (let x = 0; x < Math.min(screen.width, picture.width); x += 1) {
      for (let c = 0; c < 3; c += 1) {
        const a = screen.data[screen.channels * (y * screen.width + x) + c];
        apart += Math.abs(a - picture.data[picture.channels * (y * picture.width + x) + c]);
        count += 1;
      }
    }
  }
  assert.ok(apart / count < 1, `${apart / count} of 255 on average`);
  const caption = await page.locator("#panes figcaption").nth(1).boundingBox();
  assert.ok(caption && stage);
  const [x, y] = [caption.x - stage.x, caption.y - stage.y];
  const { width, height } = picture;
  const text = colours(
    picture,
    x / width,
    (x + caption.width) / width,
    y / height,
    (y + caption.height) / height,
  );
  assert.ok(text > 20, `${text} colours where the caption stands`);

  // In place of each other it is the one that is seen.
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await page.locator("#surface").focus();
  await page.keyboard.press("b");
  await page.locator(".pane:first-child.away").waitFor({ state: "attached" });
  const first = (await download(page, "Picture, PNG")).bytes;
  await page.locator("#surface").focus();
  await page.keyboard.press("b");
  await page.locator(".pane:first-child:not(.away)").waitFor();
  const second = (await download(page, "Picture, PNG")).bytes;
  for (const one of [first, second]) {
    assert.ok(colours(decodePng(one), 0.3, 0.7, 0.2, 0.8) > 200);
  }
  assert.ok(!first.equals(second), "each shows its own");
  assert.deepEqual(faults, []);
  await close();
});

test("a film holds all panes", async () => {
  const { page, faults, close } = await site.open(
    "sample=icosahedron&panes=flow_p-willmore&step=3",
    { viewport: { width: 1000, height: 500 } },
  );
  await page.locator("#panes figcaption").nth(1).filter({ hasText: "step 3" }).waitFor();
  await untilDrawn(page);
  await openTab(page, "Share");
  await page.waitForFunction(() => document.querySelector("#surface")?.clientWidth === 292);
  const stage = await page.locator("#panes").boundingBox();
  await button(page, "Record film").click();
  await button(page, "Step").click();
  await until(page, "Paused at step 4");
  await page.getByText(/^0:0[1-9]$/).waitFor();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    button(page, "Stop and save").click(),
  ]);
  const blank = await site.blank();
  await blank.page.goto("about:blank");
  const played = await playFilm(blank.page, readFileSync(await file.path()));
  await blank.close();
  assert.ok(Math.abs(played.width - (stage?.width ?? 0)) <= 1, `${played.width} pixels wide`);
  assert.ok(Math.abs(played.height - (stage?.height ?? 0)) <= 1, `${played.height} pixels high`);
  assert.ok(Math.min(...played.halves) > 200, `${played.halves} colours`);
  assert.deepEqual(faults, []);
  await close();
});
