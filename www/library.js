// The words of samples and figures; what they are stands in `generated/library.js`.

/** @import { FlowOptions } from "./generated/schema.js" */
/** @import { Arrangement } from "./generated/types.js" */
/** @import { FillOptions } from "./generated/types.js" */
/** @import { FieldName } from "./store.js" */

import { say } from "./words.js";

/**
 * A surface to begin with; the words are `sample-<id>`.
 * @typedef {object} Sample
 * @property {string} id
 * @property {'closed' | 'tubes' | 'boundary' | 'repair' | 'flips'} group
 * @property {string} shape        name of the solver's shape …
 * @property {Record<string, number>} parameters  … and its parameters
 * @property {FlowOptions} options  over the defaults
 * @property {Partial<FillOptions>} [fill]   holes filled at once
 */

/**
 * A figure of a paper; the words are `figure-<id>`.
 * @typedef {object} Figure
 * @property {string} id
 * @property {string} paper        the words are `paper-<paper>`
 * @property {string} number       as the paper has it
 * @property {string} sample       id of the sample it begins with
 * @property {FlowOptions} options  over those of the sample
 * @property {Arrangement} arrangement
 * @property {FieldName} colour
 * @property {number | 'rest'} steps  how far it runs; 0 for a figure without a flow
 * @property {Record<string, number>} [back]  parameters of the surface from which the same is run
 *   first, to be shown backwards ahead of it
 * @property {boolean} quick       a few seconds at most
 * @property {boolean} fallsShort  known not to come out as the paper has it
 */

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
