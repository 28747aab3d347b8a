// @ts-check
// The gallery: a figure of a paper is a click away, and says what was measured.

import assert from "node:assert/strict";
import { test } from "node:test";
import { figures } from "../../www/generated/library.js";
import { figureTitle, sayFigure } from "../../www/library.js";
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
  await page
    .locator(".card", { hasText: figureTitle(figure) })
    .first()
    .click();
  const section = page.getByRole("region", { name: new RegExp(`^${sayFigure(figure)}: `) });
  await section.getByText(sayFigure(figure, "reports")).waitFor();
  await section.getByText(sayFigure(figure, "expected")).waitFor();
  await until(page, "Ready");
  await section.getByText("Play, at least to step 24.").waitFor();
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  await section.getByText(/^✓ W 60π → /).waitFor();
  // Back at the start nothing is claimed.
  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await section.getByText(/^✓ /).count(), 0);
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  assert.equal(await section.isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

test("a figure of more than one run is measured elsewhere, and the surface stays as it is", async () => {
  const { page, faults, close } = await site.open("figure=p-willmore-7");
  await until(page, "Ready");
  await page
    .locator("#figure")
    .getByText(/^✓ inverted \d+ → 0, /)
    .waitFor();
  assert.equal(await page.getByRole("button", { name: "Back", exact: true }).isDisabled(), true);
  await page.goto(`${site.url}?msaa=1#figure=p-willmore-10-p2&step=30`);
  await page.reload();
  await until(page, "Paused at step 30");
  await page
    .locator("#figure")
    .getByText(/^✓ .*: ratio 3\.9/)
    .waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("figures side by side bring their arrangement, and the next one leaves it", async () => {
  const { page, faults, close } = await site.open();
  const beside = figures.find(({ arrangement }) => arrangement?.compare === "flows");
  assert.ok(beside);
  await button(page, "Figures").click();
  await page
    .locator(".card", { hasText: figureTitle(beside) })
    .first()
    .click();
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 4);
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  await page
    .locator("#figure")
    .getByText(/^[✓✗] /)
    .waitFor();
  await button(page, "Figures").click();
  const single = figures[0];
  await page
    .locator(".card", { hasText: figureTitle(single) })
    .first()
    .click();
  await page.waitForFunction(() => document.querySelectorAll(".pane").length === 1);
  await page.waitForFunction(
    () => /** @type {HTMLSelectElement} */ (document.querySelector("#flow")).value === "circle",
  );
  assert.deepEqual(faults, []);
  await close();
});
