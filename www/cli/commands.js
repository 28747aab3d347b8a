// @ts-check
// The commands there are.

import { bench } from "./bench.js";
import { energy } from "./energy.js";
import { fill } from "./fill.js";
import { flips } from "./flips.js";
import { flow } from "./flow.js";
import { info } from "./info.js";
import { regularise } from "./regularise.js";
import { replay } from "./replay.js";
import { shape } from "./shape.js";

/** @typedef {import("./solver.js").Session} Session */

/**
 * What a command is given.
 * @typedef {object} Call
 * @property {string[]} parameters  what follows the command's name
 * @property {import("./terminal.js").Terminal} io
 * @property {() => Promise<Session>} open
 */

/**
 * @typedef {object} Command
 * @property {import("./options.js").Syntax} syntax
 * @property {(call: Call) => Promise<number>} run  answers the exit code
 */

/** @type {Record<string, Command>} */
export const commands = { info, energy, flow, flips, regularise, fill, replay, shape, bench };

/** Named by the design, in a coming version. @type {string[]} */
export const laterCommands = [];

/** @returns {string} */
export function overview() {
  const rows = Object.entries(commands).map(
    ([name, { syntax }]) => `  ${[name, ...syntax.operands].join(" ").padEnd(17)}${syntax.summary}`,
  );
  return `umbilic <command> [options]

Willmore-type geometric flows on triangle meshes.

${rows.join("\n")}

MESH is an OBJ, OFF, PLY or STL file, or - for standard input.
umbilic <command> --help lists a command's options; --version tells the version.
Exit codes: 0 done, 2 bad usage, 3 refused input, 4 the surface could not be kept good: a failure,
a singularity or a collapse.
`;
}
