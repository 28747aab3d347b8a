// @ts-check
// The first picture: a sample is on the screen before anything is asked of the page.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
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

/** Names of all messages. */
function messages() {
  const folder = new URL("../../www/locales/en/", import.meta.url);
  const files = readdirSync(folder).filter((name) => name.endsWith(".ftl"));
  const text = files.map((name) => readFileSync(new URL(name, folder), "utf8")).join("\n");
  return new Set([...text.matchAll(/^([a-z][\w-]*) =/gm)].map(([, id]) => id));
}

test("the page has its words before those that are fetched later", async () => {
  const ids = messages();
  assert.ok(ids.size > 500, String(ids.size));
  for (const [locale, query, button] of [
    ["en", "msaa=1", "Play: Watch it flow"],
    ["de", "msaa=1", "Abspielen: Fließen lassen"],
    ["en", "msaa=1&embed", "Full page"],
  ]) {
    const { page, faults, close } = await site.blank({ locale });
    await page.route(/solver_bg[^/]*\.wasm$/, () => {});
    const first = /(index|first|words|language|offline|viewer|worker|host|save|share)-[^/]*\.js$/;
    await page.route(/assets\/[^/]*\.js$/, (route) =>
      first.test(route.request().url()) ? route.continue() : undefined,
    );
    await page.goto(`${site.url}?${query}`);
    const isPictured = () => performance.getEntriesByName("first-picture").length > 0;
    await page.waitForFunction(isPictured);
    const said = await page.evaluate(() =>
      [...document.querySelectorAll("body *")].flatMap((one) => [
        ...[...one.childNodes].filter(({ nodeType }) => nodeType === 3).map((t) => t.nodeValue),
        ...["title", "aria-label"].map((name) => one.getAttribute(name)),
      ]),
    );
    const texts = said.map((text) => (text ?? "").replace(/ \(.*\)$/, "").trim());
    assert.ok(texts.includes(button), button);
    assert.deepEqual(
      texts.filter((text) => ids.has(text)),
      [],
      `${locale} ${query}`,
    );
    assert.deepEqual(faults, []);
    await close();
  }
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
