// @ts-check
// Flows side by side: two different runs from the first click, in step, under one scale.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, choice, openTab, stepOf, until, useSite } from "./support/app.js";

const site = useSite();

/** @param {import("playwright-core").Page} page */
const others = (page) => page.getByRole("img", { name: /^Surface [B-D]:/ });

test("a comparison begins with a difference, and both clips end together", async () => {
  const { page, faults, close } = await site.open(
    "sample=letter-c&colour=mean-curvature&maxSteps=8",
  );
  await openTab(page, "Compare");
  await button(page, "Flow").click();
  await others(page).waitFor();
  assert.match((await others(page).getAttribute("aria-label")) ?? "", /Mean curvature/);
  const differs = page.locator(".panel .chip[aria-pressed=true]");
  assert.deepEqual(await differs.allTextContents(), ["Flow"]);
  // The legend is of both.
  const [stage, legend] = await Promise.all(
    ["#stage", ".legend"].map((one) => page.locator(one).boundingBox()),
  );
  assert.ok(stage && legend);
  assert.ok(Math.abs(stage.x + stage.width / 2 - (legend.x + legend.width / 2)) < 2);
  // Their times have different units, and so time is not on offer.
  await page.getByText(/Their times cannot be compared/).waitFor();
  assert.equal(await page.getByRole("radio", { name: "Time" }).count(), 0);
  await page.getByRole("button", { name: /^Speed/ }).click();
  await button(page, "Play").click();
  await until(page, /^Stopped after 8 steps/);
  await page.getByRole("img", { name: /^Surface B:.*step 8/ }).waitFor();
  assert.deepEqual(await page.locator(".curve .letter").allTextContents(), ["A", "B"]);
  // By step: the other stands where the first does.
  await page.getByRole("radio", { name: "Step", exact: true }).check();
  await page.keyboard.press(",");
  await until(page, "Paused at step 7");
  await page.getByRole("img", { name: /^Surface B:.*step 7/ }).waitFor();
  // In place of all, one after the other.
  await page.keyboard.press("b");
  assert.equal(await others(page).isVisible(), true);
  await page.keyboard.press("b");
  await others(page).waitFor({ state: "hidden" });
  await page.keyboard.press("Escape");
  await others(page).waitFor();
  await choice(page, "Colours").selectOption({ label: "Distance to A" });
  await page.getByRole("img", { name: /^Colours: Distance/ }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("more panes, other options, and back to one", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus");
  await openTab(page, "Compare");
  await button(page, "Flow").click();
  await others(page).waitFor();
  await button(page, "Add C").click();
  await page.getByRole("img", { name: /^Surface C:/ }).waitFor();
  await choice(page, "Flow of B").selectOption({ label: "Surface diffusion" });
  await page.getByRole("img", { name: /^Surface B: Surface diffusion/ }).waitFor();
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  await page.getByRole("img", { name: /^Surface B:.*step 1/ }).waitFor();
  await page.getByRole("button", { name: "Remove C" }).click();
  await page.getByRole("img", { name: /^Surface C:/ }).waitFor({ state: "detached" });
  // One that is added later goes as far as the first has come, and no further.
  await button(page, "Add C").click();
  await page.getByRole("img", { name: /^Surface C:.*step 1 ·/ }).waitFor();
  await page.getByRole("button", { name: "Remove C" }).click();
  await page.getByRole("img", { name: /^Surface C:/ }).waitFor({ state: "detached" });
  await button(page, "Close the comparison").click();
  await others(page).waitFor({ state: "detached" });
  assert.equal(await stepOf(page), 1);
  await button(page, "Then and now").click();
  await page.getByRole("img", { name: /^Surface B: start/ }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("a link carries what is compared", async () => {
  const { page, close } = await site.open("sample=coarse-torus");
  await openTab(page, "Compare");
  await button(page, "Scheme").click();
  await others(page).waitFor();
  await page.waitForFunction(() => /panes=/.test(decodeURIComponent(location.hash)));
  const { hash } = new URL(page.url());
  const second = await site.open(hash.slice(1));
  await others(second.page).waitFor();
  assert.match((await others(second.page).getAttribute("aria-label")) ?? "", /Scheme paper/);
  await second.close();
  await close();
});
