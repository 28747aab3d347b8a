// @ts-check
// Accessibility: axe on every part of the page in both themes, keys alone, zoom, touch targets.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  colourBy,
  openPart,
  openTab,
  stepOf,
  until,
  upload,
  useSite,
} from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`nothing that axe finds, ${colorScheme}`, async () => {
    const { page, close } = await site.blank({
      colorScheme,
      viewport: { width: 1280, height: 720 },
    });
    await page.goto(`${site.url}?msaa=1`);
    await until(page, "Ready");
    /** @type {string[]} */
    const found = [];
    const look = async (/** @type {string} */ where) =>
      found.push(...(await accessibilityFaults(page)).map((fault) => `${where}: ${fault}`));
    await look("welcome");
    await page.keyboard.press("Escape");
    await page.keyboard.press(".");
    await until(page, "Paused at step 1");
    await colourBy(page, "Mean curvature H");
    await page.getByRole("group", { name: "Legend" }).getByRole("button").last().click();
    await look("legend");
    for (const tab of ["Surface", "Flow", "Measure", "Compare", "Share"]) {
      await openTab(page, tab);
      await look(tab);
    }
    for (const part of [/^Look at one vertex/, /^The equation/, /^Table of all steps/]) {
      await openPart(page, "Measure", part);
      await look(String(part));
    }
    await openTab(page, "Surface");
    await button(page, "Invert").click();
    await look("tool");
    await page.keyboard.press("Escape");
    await button(page, "Why?").click();
    await page.getByRole("region", { name: "Why did it stop?" }).waitFor();
    await look("why");
    await page.keyboard.press("Escape");
    for (const key of ["/", "?", "e", "Control+k"]) {
      await page.keyboard.press(key);
      await page.getByRole("dialog").waitFor();
      await look(key);
      await page.keyboard.press("Escape");
      await page.getByRole("dialog").waitFor({ state: "detached" });
    }
    await page.keyboard.press("f");
    await look("presenting");
    assert.deepEqual(found, []);
    await close();
  });
}

test("everything by keys: tabs, flow, commands, and nothing lost out of sight", async () => {
  const { page, faults, close } = await site.blank();
  /** @type {(value?: unknown) => void} */
  let release = () => {};
  const held = new Promise((resolve) => {
    release = resolve;
  });
  await page.route(/dialogs-[^/]*\.js$/, (route) => held.then(() => route.continue()));
  await page.goto(`${site.url}?msaa=1#sample=coarse-torus`);
  await until(page, "Ready");
  await page.keyboard.press("2");
  await page.getByRole("option", { selected: true }).focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await page.getByRole("option", { name: /^p-Willmore/, selected: true }).waitFor();
  // Over a slow line the list comes late; once it can be seen, it has the focus.
  await page.keyboard.press("Control+k");
  release();
  await page.getByRole("combobox", { name: "Commands" }).waitFor();
  await page.keyboard.type("one step on");
  await page.keyboard.press("Enter");
  await until(page, "Paused at step 1");
  assert.equal(await stepOf(page), 1);
  assert.deepEqual(faults, []);
  await close();
});

test("on a phone targets are large, and with a sheet open there is still a surface", async () => {
  const { page, faults, close } = await site.open("sample=pipe", {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
  });
  await page.getByRole("tab", { name: "Flow" }).tap();
  await page.getByRole("tabpanel").waitFor();
  const canvas = await page.locator("#surface").boundingBox();
  assert.ok(canvas && canvas.height >= 0.28 * 844, String(canvas?.height));
  const small = await page.evaluate(() =>
    [
      ...document.querySelectorAll(
        "button, select, [role=option], input:not(#file, .segments input)",
      ),
    ]
      .filter(
        (one) =>
          one.checkVisibility() &&
          one.closest("#top, #rail, .transport, .settings, .panel > header, [role=listbox]"),
      )
      .map((one) => ({
        box: one.getBoundingClientRect(),
        text: one.getAttribute("aria-label") ?? one.textContent,
      }))
      .filter(({ box }) => Math.min(box.width, box.height) < 43.5)
      .map(({ box, text }) => `${text}: ${box.width} × ${box.height}`),
  );
  assert.deepEqual(small, []);
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, String(overflow));
  // A tap on the handle makes the sheet tall, and chooses nothing of what is then below the finger.
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  const sheet = page.getByRole("tabpanel");
  await sheet.locator(".grip").tap();
  await page.locator(".panel.tall").waitFor();
  assert.equal(await stepOf(page), 1);
  await page.getByRole("option", { name: /^Willmore by circle/, selected: true }).waitFor();
  // The next tab begins at its beginning.
  await sheet.locator(".body").evaluate((body) => body.scrollTo(0, 200));
  await page.getByRole("tab", { name: "Measure" }).tap();
  await page.getByRole("table", { name: "Readings" }).waitFor();
  assert.equal(await sheet.locator(".body").evaluate((body) => body.scrollTop), 0);
  // So does a dialog; nothing in it is small either.
  const dialog = page.locator("#dialog");
  await page.keyboard.press("/");
  await dialog.getByRole("button", { name: "Start here" }).waitFor();
  const chips = await dialog
    .locator(".chip")
    .evaluateAll((all) => all.map((one) => one.clientHeight));
  assert.ok(Math.min(...chips) >= 41, String(chips));
  await dialog.evaluate((element) => element.scrollTo(0, 300));
  await page.keyboard.press("Escape");
  await page.keyboard.press("?");
  await dialog.getByRole("heading", { name: "Help" }).waitFor();
  assert.equal(await dialog.evaluate((element) => element.scrollTop), 0);
  await page.keyboard.press("Escape");
  // What has no room in the dock is in the list of commands, by touch too.
  await button(page, "List of commands").tap();
  const rows = dialog.getByRole("option");
  await rows.first().waitFor();
  for (const name of ["Faster", "Loop", "Back to the start, forgetting the steps"])
    await dialog.getByRole("option", { name }).waitFor();
  assert.ok(await rows.evaluateAll((all) => all.every((one) => one.clientHeight >= 44)));
  await dialog.getByRole("option", { name: "Larger plot" }).tap();
  await dialog.getByRole("heading", { name: "Larger plot" }).waitFor();
  await page.keyboard.press("Escape");
  // A message has the width of the page, below the status: the surface keeps its room.
  await page.getByRole("tab", { name: "Measure" }).tap();
  await upload(page, "nothing.obj", "v 0 0 0\n");
  const alert = page.getByRole("alert");
  await alert.waitFor();
  const said = await alert.boundingBox();
  assert.ok(said && said.width > 300 && said.height < 110, JSON.stringify(said));
  assert.deepEqual(faults, []);
  await close();
});

for (const [width, height] of [
  [1280, 720],
  [800, 600],
  [320, 256],
]) {
  test(`at ${width} × ${height} nothing lies over the transport, and drawers stay short`, async () => {
    const { page, close } = await site.open("sample=pipe", { viewport: { width, height } });
    const play = button(page, "Play");
    await play.click({ trial: true });
    assert.ok(await play.isVisible());
    if (height >= 700) {
      for (const tab of ["Surface", "Flow", "Measure", "Compare", "Share"]) {
        await openTab(page, tab);
        const tall = await page.locator(".panel .body").evaluate((body) => body.scrollHeight);
        assert.ok(tall <= 1.5 * height, `${tab}: ${tall}`);
      }
      await openTab(page, "Flow");
      const all = page.getByRole("listbox", { name: "Flow" }).getByRole("option");
      assert.ok(await all.last().isVisible());
      const { y = 0, height: own = 0 } = (await all.last().boundingBox()) ?? {};
      const body = await page.locator(".panel .body").boundingBox();
      assert.ok(body && y + own <= body.y + body.height, "all flows without scrolling");
    }
    await close();
  });
}
