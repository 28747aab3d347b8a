// @ts-check
// The golden pictures: what is drawn on them, and how such a picture is taken.

import { readFileSync } from "node:fs";
import { stillPicture, until } from "./app.js";

/** What is drawn. */
export const scenes = {
  "icosahedron-none": { scene: "sample=icosahedron" },
  "icosahedron-mean-curvature": { scene: "sample=icosahedron&colour=mean-curvature" },
  "torus-flat-wireframe": {
    scene: "sample=coarse-torus&shading=flat&wireframe=true",
  },
  "pipe-clamped": { scene: "sample=pipe" },
};

/** The canvas is all there is of the page. */
export const context = /** @type {const} */ ({
  viewport: { width: 320, height: 240 },
  colorScheme: "light",
});
export const query = "msaa=1&embed&controls=none";

/** @param {string} name */
export const file = (name) => new URL(`../golden/${name}`, import.meta.url);

/** @param {string} name */
export const stored = (name) => readFileSync(file(`${name}.png`));

/**
 * The picture of a page that has been opened with {@link context} and {@link query}, as a PNG.
 * @param {import("playwright-core").Page} page
 */
export async function takePicture(page) {
  await until(page, "Ready");
  return stillPicture(page);
}
