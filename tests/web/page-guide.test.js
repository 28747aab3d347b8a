// @ts-check
// The guide: three pages to read, each with a surface that runs, in two languages.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";

const site = useSite();
const german = JSON.parse(
  readFileSync(new URL("../../www/locales/de/guide.json", import.meta.url), "utf8"),
);

for (const [name, title] of [
  ["first-look", "A first look"],
  ["lecture", "For the lecture"],
  ["mesh", "A mesh of your own"],
]) {
  test(`${title}: its surface comes up, plays, and no rule of accessibility is broken`, async () => {
    const { page, faults, close } = await site.blank({ viewport: { width: 1000, height: 700 } });
    await page.goto(`${site.url}www/guide/${name}.html`);
    await page.getByRole("heading", { level: 1, name: title }).waitFor();
    assert.equal(await page.locator("[aria-current=page]").textContent(), title);
    const surface = page.frameLocator("umbilic-surface >> nth=0 >> iframe");
    await surface.getByRole("button", { name: "Play", exact: true }).click();
    await surface.getByRole("button", { name: "Pause", exact: true }).waitFor();
    assert.deepEqual(await accessibilityFaults(page), []);
    // Every way that it points out leads somewhere.
    const ways = await page
      .locator("a")
      .evaluateAll((all) => all.map((one) => /** @type {HTMLAnchorElement} */ (one).href));
    for (const way of ways) assert.equal((await page.request.get(way)).status(), 200, way);
    assert.deepEqual(faults, []);
    await close();
  });

  test(`${title}: in German nothing is left in English`, async () => {
    const { page, close } = await site.blank();
    const texts = () =>
      page.locator("main :is(h1, h2, p, li, td, th, figcaption)").allTextContents();
    await page.goto(`${site.url}www/guide/${name}.html`);
    await page.getByRole("heading", { level: 1, name: title }).waitFor();
    const english = await texts();
    await page.goto(`${site.url}www/guide/${name}.html?lang=de`);
    await page.getByRole("heading", { level: 1, name: german[title] }).waitFor();
    const both = (await texts()).filter((text) => english.includes(text));
    assert.deepEqual(both, []);
    assert.equal(await page.title(), `${german[title]} · Umbilic`);
    await close();
  });
}
