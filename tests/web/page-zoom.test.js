// @ts-check
// Small windows: a desk at 400 %, where the page is scrolled as a whole; and a phone, where
// drawers are sheets.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, canvas, openMesh, stepOf, until, untilDrawn, useSite } from "./support/app.js";

/** 1280 × 720 at 400 %. */
const zoomed = { viewport: { width: 320, height: 180 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true };

const site = useSite({ webgpu: false });

/** @typedef {import("playwright-core").Page} Page */

/**
 * What cannot be brought into sight, whole in its width, with nothing over it; and words that
 * are cut.
 * @param {Page} page
 */
const lost = (page) =>
  page.evaluate(() => {
    const open = [...document.querySelectorAll("dialog[open]")].at(-1) ?? document.body;
    const controls = open.querySelectorAll(
      "button, select, a[href], summary, [role=option], input:not(#file, .segments input), h1, h2",
    );
    /** @type {string[]} */
    const lost = [];
    for (const control of controls) {
      if (!control.checkVisibility({ visibilityProperty: true, contentVisibilityAuto: true }))
        continue;
      control.scrollIntoView({ block: "center", inline: "nearest", behavior: "instant" });
      const { left, top, right, bottom } = control.getBoundingClientRect();
      if (right - left < 2) continue;
      const [x, y] = [(left + right) / 2, (Math.max(0, top) + Math.min(innerHeight, bottom)) / 2];
      const hit = document.elementFromPoint(x, y);
      const isSeen = left >= -1 && right <= innerWidth + 1 && y >= 0 && y <= innerHeight;
      const isHit =
        hit !== null && (control.contains(hit) || hit.closest("label")?.contains(control));
      if (isSeen && isHit) continue;
      const name = control.getAttribute("aria-label") ?? control.textContent;
      const over = `under ${hit?.tagName}.${hit?.className}`;
      lost.push(`${name} at ${[left, top, right, bottom].map(Math.round)} ${over}`);
    }
    for (const one of open.querySelectorAll("#top *, .status *, .panel *")) {
      const isCut = getComputedStyle(one).textOverflow === "ellipsis";
      if (isCut && one.checkVisibility() && one.scrollWidth > one.clientWidth) {
        lost.push(`cut: ${one.textContent}`);
      }
    }
    const wider = document.documentElement.scrollWidth - innerWidth;
    if (wider > 0) lost.push(`${wider} px wider than the window`);
    return lost;
  });

/** Brought into sight as by who scrolls, and clicked. @param {import("playwright-core").Locator} control */
async function press(control) {
  await control.scrollIntoViewIfNeeded();
  await control.click();
}

for (const lang of ["en", "de"]) {
  test(`at 400 % everything is reached by scrolling, lang=${lang}`, async () => {
    const first = await site.blank(zoomed);
    await first.page.goto(`${site.url}?msaa=1&lang=${lang}`);
    await until(first.page, /^(Ready|Bereit)/);
    assert.deepEqual(await lost(first.page), [], "first visit");
    await first.close();
    const { page, faults, close } = await site.blank(zoomed);
    await page.goto(`${site.url}?msaa=1&lang=${lang}#sample=pipe`);
    await until(page, /^(Ready|Bereit)/);
    assert.deepEqual(await lost(page), [], "a scene");
    for (const tab of await page.getByRole("tab").all()) {
      await press(tab);
      await page.locator(".panel .body > *").first().waitFor();
      assert.deepEqual(await lost(page), [], (await tab.textContent()) ?? "");
    }
    for (const opener of [/^(Help|Hilfe)$/, /^(Pipe|Rohr)/]) {
      await press(page.locator("#top").getByRole("button", { name: opener }));
      await page.locator("dialog[open] h2").waitFor();
      assert.deepEqual(await lost(page), [], String(opener));
      await page.keyboard.press("Escape");
    }
    assert.deepEqual(faults, []);
    await close();
  });
}

test("at 400 % a flow is played and a mesh is opened", async () => {
  const { page, faults, close } = await site.blank(zoomed);
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  await press(button(page, "Play: Watch it flow"));
  await page.waitForFunction(() =>
    /step [1-9]/.test(document.querySelector("#surface")?.ariaLabel ?? ""),
  );
  await press(button(page, "Pause"));
  await until(page, /^(Paused|Converged)/);
  assert.ok((await stepOf(page)) > 0);
  const seen = await canvas(page).boundingBox();
  assert.ok(seen && seen.height >= 90, `${seen?.height} px of a surface`);
  await openMesh(
    page,
    "tetra.obj",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n",
  );
  await untilDrawn(page);
  assert.deepEqual(faults, []);
  await close();
});

test("on a phone a sheet is dragged to its full height, back, and away", async () => {
  const { page, faults, close } = await site.open("sample=pipe", phone);
  await page.getByRole("tab", { name: "Measure" }).tap();
  const panel = page.getByRole("tabpanel");
  const handle = page.getByRole("button", { name: "Full height" });
  /** @param {number} by  in CSS pixels, upwards */
  const drag = async (by) => {
    const box = await handle.boundingBox();
    if (!box) throw new Error("no handle");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x, y - by, { steps: 4 });
    await page.mouse.up();
  };
  const top = async () => {
    // Where it comes to rest, not where it is on its way there.
    await handle.click({ trial: true });
    return (await panel.boundingBox())?.y ?? 0;
  };
  const bar = await page.locator("#top").evaluate((bar) => bar.getBoundingClientRect().bottom);
  const low = await top();
  assert.ok(low > bar + 150, `the surface is seen above it: ${low}`);
  await drag(200);
  assert.equal(await handle.getAttribute("aria-pressed"), "true");
  assert.ok(Math.abs((await top()) - bar) < 1, `to the bar, ${bar}: ${await top()}`);
  await button(page, "Play").click({ trial: true });
  await drag(-150);
  assert.ok(Math.abs((await top()) - low) < 1);
  // A tap does the same, and so does a key.
  await handle.tap();
  assert.ok(Math.abs((await top()) - bar) < 1);
  await handle.focus();
  await page.keyboard.press("Enter");
  assert.ok(Math.abs((await top()) - low) < 1);
  await drag(-150);
  await panel.waitFor({ state: "detached" });
  assert.deepEqual(faults, []);
  await close();
});
