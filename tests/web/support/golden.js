// @ts-check
// The golden pictures: what is drawn on them, and how such a picture is taken.

import { readFileSync } from "node:fs";
import { choice, download, until, untilDrawn } from "./app.js";

/** What is drawn, and how it is coloured. */
export const scenes = {
  "icosahedron-none": { colour: "Nothing", scene: "sample=icosahedron" },
  "icosahedron-mean-curvature": { colour: "Mean curvature H", scene: "sample=icosahedron" },
  "torus-flat-wireframe": {
    colour: "Nothing",
    scene: "sample=coarse-torus&shading=flat&wireframe=true",
  },
  "pipe-clamped": { colour: "Nothing", scene: "sample=pipe" },
};

/** The canvas is what the panel, of 392 pixels, leaves. */
export const context = /** @type {const} */ ({
  viewport: { width: 392 + 320, height: 240 },
  colorScheme: "light",
});

/** @param {string} name */
export const file = (name) => new URL(`../golden/${name}`, import.meta.url);

/** @param {string} name */
export const stored = (name) => readFileSync(file(`${name}.png`));

/**
 * The picture of a page that has been opened with {@link context}, as a PNG.
 * @param {import("playwright-core").Page} page
 * @param {string} colour  as the page names it
 */
export async function takePicture(page, colour) {
  await choice(page, "Colour by").selectOption({ label: colour });
  if (colour !== "Nothing") await page.getByRole("img", { name: /^Colours:/ }).waitFor();
  await until(page, "Ready");
  await untilDrawn(page);
  return (await download(page, "Picture, PNG")).bytes;
}
