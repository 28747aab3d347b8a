// @ts-check
// Every figure of the four papers that shows a result: what the paper reports, what is to be
// expected here, how it is run, and how its end is measured. Pure data and formulas: the
// command line and the page run them.

import { circle } from "./figures/circle.js";
import { curvature } from "./figures/curvature.js";
import { flips } from "./figures/flips.js";
import { pWillmore } from "./figures/p-willmore.js";

/** @import { Arrangement, CurvatureJump, FieldName, FlowOptions, Info, Loaded, Pane, RegulariseOptions, Regularised, State } from "./protocol.js" */

/**
 * @typedef {object} Figure
 * @property {string} id
 * @property {'circle' | 'p-willmore' | 'flips' | 'curvature'} paper
 * @property {string} figure    as the paper numbers it, e.g. `Fig. 6`
 * @property {string} title
 * @property {string} reports   what the paper says, one sentence
 * @property {string} expected  what ours should give
 * @property {string} sample    id in `samples.js`
 * @property {FlowOptions} [options]  over those of the sample
 * @property {Partial<Arrangement>} [arrangement]
 * @property {FieldName} [colour]
 * @property {number | 'rest'} steps  how far it runs; 0 for a figure without a flow
 * @property {RegulariseOptions} [regularise]  regularisation after the steps
 * @property {Record<string, number>[]} [refine]  parameters of coarser meshes, coarsest first, on
 *                               which the same is run before
 * @property {{ shape: string, parameters: Record<string, number> }} [reference]  undamaged surface
 * @property {boolean} quick    a few seconds at most
 * @property {string} [shortfall]  why what is expected does not come out, where it does not
 * @property {(run: Run) => Measured} measure
 */

/** @typedef {{ value: string, ok: boolean }} Measured */

/**
 * What a run came to.
 * @typedef {object} Run
 * @property {State} first
 * @property {State} last
 * @property {number} steps
 * @property {Info} info                    of the surface at the end
 * @property {CurvatureJump | null} jump
 * @property {Record<string, number>} jumps  relative, of flows side by side, by name
 * @property {Float32Array} start           positions before the first step
 * @property {Float32Array} positions       positions at the end
 * @property {Pane[]} panes
 * @property {Regularised | null} regularised
 * @property {State[]} refined              ends on the coarser meshes of `refine`
 * @property {Pick<Loaded, "positions" | "triangles" | "boundaryEdges"> | null} reference  the undamaged surface
 */

/** @type {readonly Figure[]} */
export const figures = [...circle, ...pWillmore, ...flips, ...curvature];
