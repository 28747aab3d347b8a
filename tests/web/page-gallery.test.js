// @ts-check
// The gallery: a figure of a paper is a click away, and says what was measured.

import assert from "node:assert/strict";
import { test } from "node:test";
import { figures } from "../../www/figures.js";
import { button, openMesh, until, useSite } from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

test("every figure has a card with a picture, grouped by paper", async () => {
  const { page, faults, close } = await site.open();
  await button(page, "Figures").click();
  const dialog = page.getByRole("dialog", { name: "Figures of the papers" });
  await dialog.getByRole("heading", { level: 3 }).nth(3).waitFor();
  const cards = dialog.locator(".card");
  assert.equal(await cards.count(), figures.length);
  for (let i = 0; i < figures.length; i += 1) {
    const picture = cards.nth(i).locator("img");
    await picture.scrollIntoViewIfNeeded();
    await page.waitForFunction((n) => {
      const image = document.querySelectorAll(".card img")[n];
      return image instanceof HTMLImageElement && image.complete && image.naturalWidth > 100;
    }, i);
  }
  await page.keyboard.press("Escape");
  assert.equal(await dialog.isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

test("a figure is loaded, played, and judged; another mesh ends it", async () => {
  const { page, faults, close } = await site.open();
  await button(page, "Figures").click();
  const figure = figures.find(({ id }) => id === "circle-6") ?? figures[0];
  await page.locator(".card", { hasText: figure.title }).first().click();
  const section = page.getByRole("region", { name: new RegExp(`^${figure.figure}: `) });
  await section.getByText(figure.reports).waitFor();
  await section.getByText(figure.expected).waitFor();
  await until(page, "Ready");
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  await section.getByText(/^✓ /).waitFor();
  // Back at the start nothing is claimed.
  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await section.getByText(/^✓ /).count(), 0);
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  assert.equal(await section.isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

test("figures side by side bring their arrangement, and the next one leaves it", async () => {
  const { page, faults, close } = await site.open();
  const beside = figures.find(({ arrangement }) => arrangement?.compare === "flows");
  assert.ok(beside);
  await button(page, "Figures").click();
  await page.locator(".card", { hasText: beside.title }).first().click();
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 4);
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  await page
    .locator("#figure")
    .getByText(/^[✓✗] /)
    .waitFor();
  await button(page, "Figures").click();
  const single = figures.find(({ paper }) => paper === "circle");
  await page.locator(".card", { hasText: single?.title }).first().click();
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 1);
  await page.waitForFunction(
    () => /** @type {HTMLSelectElement} */ (document.querySelector("#flow")).value === "circle",
  );
  assert.deepEqual(faults, []);
  await close();
});
