// @ts-check
// The first picture: a sample is on the screen before anything is asked of the page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { canvas, openTab, reading, surface, until, untilDrawn, useSite } from "./support/app.js";
import { picture } from "./support/browser.js";

const site = useSite();

test("the first sample is drawn and described, without a click", async () => {
  const { page, faults, close } = await site.open("");
  await untilDrawn(page);
  assert.match(await surface(page), /^Surface: Bumpy sphere, step 0, energy 114\.0, area /);
  assert.equal(await reading(page, "Vertices"), "2562");
  assert.equal(await page.locator(".absence").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("a page in a dark theme draws the surface on a dark ground", async () => {
  /** @type {number[]} */
  const brightness = [];
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    const { page, faults, close } = await site.open("", { colorScheme });
    await untilDrawn(page);
    const { mean } = await picture(canvas(page));
    brightness.push(mean.reduce((a, b) => a + b) / 3);
    assert.deepEqual(faults, []);
    await close();
  }
  assert.ok(brightness[0] > brightness[1] + 60, `light ${brightness[0]}, dark ${brightness[1]}`);
});

test("every sample opens", async () => {
  const { page, faults, close } = await site.open("sample=pipe");
  await openTab(page, "Surface");
  const samples = page.getByRole("combobox", { name: "Sample" });
  const all = await samples.locator("option:not([hidden])").evaluateAll((options) =>
    options.map((option) => {
      const { value, textContent } = /** @type {HTMLOptionElement} */ (option);
      return { id: value, name: textContent.trim() };
    }),
  );
  assert.ok(all.length >= 5);
  for (const { id, name } of all) {
    await samples.selectOption(id);
    const start = `Surface: ${name}, step 0, energy `;
    await page.locator(`#surface[aria-label^=${JSON.stringify(start)}]`).waitFor();
    await until(page, "Ready");
    assert.match((await surface(page)).slice(start.length), /^-?\d/, id);
  }
  assert.equal(await page.getByRole("alert").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});
