// The words of samples and figures; what they are stands in `generated/library.js`.

import { say } from "./words.js";

/** @typedef {import("./generated/library.js").Figure} Figure */
/** @typedef {import("./generated/library.js").Sample} Sample */

/**
 * What a run of a figure came to: whether as expected, and what was measured.
 * @typedef {{ ok: boolean, message: import("./generated/types.js").Message }} Finding
 */

/** Samples that one begins with. */
export const firsts = ["bumpy-sphere", "vesicle", "coarse-torus", "six-sided-hole"];

/** Shelves of the library, in their order. */
export const shelves = /** @type {const} */ ([
  "first",
  "closed",
  "tubes",
  "boundary",
  "repair",
  "flips",
  "papers",
]);

export const sampleName = (/** @type {string} */ id) => say(`sample-${id}`);

/**
 * A figure as its paper numbers it, or what is said of it.
 * @param {Pick<Figure, "id" | "number">} figure
 * @param {"title" | "reports" | "expected" | "shortfall"} [part]
 */
export function sayFigure({ id, number }, part) {
  // A point in a name would begin a part of it.
  const name = `figure-${id.replaceAll(".", "-")}`;
  return part ? say(`${name}.${part}`) : say(name, { number });
}

/** @param {Figure} figure */
export const figureTitle = (figure) => `${sayFigure(figure)}: ${sayFigure(figure, "title")}`;
