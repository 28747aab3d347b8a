// @ts-check
// What every group of actions is made with. Types only: nothing here runs.

/** @import { Arrangement } from "../generated/types.js" */
/** @import { Frame } from "../state.js" */
/** @import { FieldName } from "../state.js" */
/** @import { Options } from "../options.js" */

/**
 * @typedef {object} Core
 * @property {import("../state.js").Store} store
 * @property {import("../solver.js").Solver} solver
 * @property {import("../controller.js").Voice} voice
 * @property {(job: () => Promise<unknown>) => Promise<void>} enqueue  one thing at a time; a failure is reported
 * @property {() => Promise<void>} rest  pauses, if a flow runs
 * @property {<T>(ask: () => Promise<T>) => Promise<{ answer: T, frame: Frame | undefined }>} framed  asks
 *   for what changes the flow; its frame is not shown yet
 * @property {(options: Options) => Promise<void>} configure  goes back to the start
 * @property {(name: FieldName) => Promise<void>} colour
 * @property {(change: Partial<Arrangement>) => Promise<void>} arrange
 */

export {};
