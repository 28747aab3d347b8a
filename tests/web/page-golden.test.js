// @ts-check
// The picture itself, against pictures that were looked at: `golden/made-on.txt` says which
// browser and adapter made them. UPDATE_GOLDEN=1 makes them anew; look before committing.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { useSite } from "./support/app.js";
import { difference } from "./support/browser.js";
import {
  context as browserContext,
  file,
  query,
  scenes,
  stored,
  takePicture,
} from "./support/golden.js";

/**
 * Bounds on the difference, of 255: rounding and edges a pixel off differ between
 * adapters; a wrong light, colour map, camera or a missing part is many times more.
 */
const MEAN = 1.5;
const PERCENTILE_95 = 4;

const site = useSite();
const update = process.env.UPDATE_GOLDEN === "1";

/** Chromium and its graphics. @param {import("playwright-core").Page} page */
async function system(page) {
  const adapter = await page.evaluate(async () => {
    const gpu = /** @type {any} */ (navigator).gpu;
    const { vendor, architecture, device, description } = (await gpu.requestAdapter()).info;
    return [vendor, architecture, device, description].filter(Boolean).join(" ");
  });
  return `Chromium ${site.browser.version()}, ${adapter || "unnamed adapter"}`;
}

for (const [name, { scene }] of Object.entries(scenes)) {
  test(`${name} looks as it did`, async (context) => {
    const { page, faults, close } = await site.open(scene, browserContext, query);
    const bytes = await takePicture(page);
    if (update) {
      writeFileSync(file(`${name}.png`), bytes);
      writeFileSync(file("made-on.txt"), `${await system(page)}\n`);
    }
    const apart = difference(stored(name), bytes);
    context.diagnostic(
      `mean ${apart.mean.toFixed(3)}, 95th percentile ${apart.percentile95}; here: ` +
        `${await system(page)}; made on: ${readFileSync(file("made-on.txt"), "utf8").trim()}`,
    );
    assert.ok(apart.mean <= MEAN, `mean difference ${apart.mean}`);
    assert.ok(apart.percentile95 <= PERCENTILE_95, `95th percentile ${apart.percentile95}`);
    assert.deepEqual(faults, []);
    await close();
  });
}
