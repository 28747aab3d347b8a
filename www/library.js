// @ts-check
// The words of samples and figures; what they are stands in `generated/library.js`.

import { say } from "./words.js";

/** @import { Figure } from "./protocol.js" */

/** @type {readonly Figure["paper"][]} in the order of the gallery */
export const papers = ["circle", "p-willmore", "flips", "curvature"];

/** @param {string} id */
export const sampleName = (id) => say(`sample-${id}`);

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
