// @ts-check
// The picture itself, against pictures that were looked at: `golden/made-on.txt` says which
// browser and adapter made them. UPDATE_GOLDEN=1 makes them anew; look before committing.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { choice, download, until, untilDrawn, useSite } from "./support/app.js";
import { difference } from "./support/browser.js";

/**
 * Bounds on the difference, of 255: rounding and edges a pixel off differ between
 * adapters; a wrong light, colour map, camera or a missing part is many times more.
 */
const MEAN = 1.5;
const PERCENTILE_95 = 4;

const site = useSite();
const update = process.env.UPDATE_GOLDEN === "1";

/** @param {string} name */
const golden = (name) => new URL(`golden/${name}`, import.meta.url);

/** Chromium and its graphics. @param {import("playwright-core").Page} page */
async function system(page) {
  const adapter = await page.evaluate(async () => {
    const gpu = /** @type {any} */ (navigator).gpu;
    const { vendor, architecture, device, description } = (await gpu.requestAdapter()).info;
    return [vendor, architecture, device, description].filter(Boolean).join(" ");
  });
  return `Chromium ${site.browser.version()}, ${adapter || "unnamed adapter"}`;
}

/** What is drawn, and how it is coloured. */
const scenes = {
  "icosahedron-none": { colour: "Nothing", scene: "sample=icosahedron" },
  "icosahedron-mean-curvature": { colour: "Mean curvature H", scene: "sample=icosahedron" },
  "torus-flat-wireframe": {
    colour: "Nothing",
    scene: "sample=coarse-torus&shading=flat&wireframe=true",
  },
  "pipe-clamped": { colour: "Nothing", scene: "sample=pipe" },
};

for (const [name, { colour, scene }] of Object.entries(scenes)) {
  test(`${name} looks as it did`, async (context) => {
    // The canvas is what the panel, of 392 pixels, leaves.
    const viewport = { width: 392 + 320, height: 240 };
    const { page, faults, close } = await site.open(scene, { viewport, colorScheme: "light" });
    await choice(page, "Colour by").selectOption({ label: colour });
    if (colour !== "Nothing") await page.getByRole("img", { name: /^Colours:/ }).waitFor();
    await until(page, "Ready");
    await untilDrawn(page);
    const { bytes } = await download(page, "Picture, PNG");
    if (update) {
      writeFileSync(golden(`${name}.png`), bytes);
      writeFileSync(golden("made-on.txt"), `${await system(page)}\n`);
    }
    const apart = difference(readFileSync(golden(`${name}.png`)), bytes);
    context.diagnostic(
      `mean ${apart.mean.toFixed(3)}, 95th percentile ${apart.percentile95}; here: ` +
        `${await system(page)}; made on: ${readFileSync(golden("made-on.txt"), "utf8").trim()}`,
    );
    assert.ok(apart.mean <= MEAN, `mean difference ${apart.mean}`);
    assert.ok(apart.percentile95 <= PERCENTILE_95, `95th percentile ${apart.percentile95}`);
    assert.deepEqual(faults, []);
    await close();
  });
}
