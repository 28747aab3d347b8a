// Options of a command: what they are, their help, and reading them strictly.

import { parseArgs } from "node:util";
import * as schema from "../generated/schema.js";
import { say } from "../words.js";
import { failed, orExit, usage } from "./failure.js";
import { loadSolver } from "./solver.js";

/** @typedef {import("../generated/schema.js").Row} Row */

/**
 * @typedef {object} Option
 * @property {string} [value]      what follows it, e.g. `FILE`; absent for a switch
 * @property {boolean} [many]      may be given more than once
 * @property {boolean} [written]   a file that the command writes
 * @property {string} help
 */

/** @typedef {Record<string, Option>} Options */

/**
 * What a command accepts.
 * @typedef {object} Syntax
 * @property {string} summary     one line
 * @property {string[]} operands  names of the arguments without a dash, e.g. `MESH`; `[MESH]` may be left out
 * @property {Options} options
 */

/** The values as typed: text, lists of text for `many`, booleans for switches. */
/** @typedef {Record<string, any>} Values */

/** @type {Options} */
const common = {
  json: { help: "the result as JSON on standard output" },
  help: { help: "this" },
};

/**
 * @param {string[]} parameters @param {Syntax} syntax
 * @returns {Promise<{ operands: string[], values: Values }>}
 * @throws {Failure} usage
 */
export async function parse(parameters, syntax) {
  const { values, positionals } = await strictly(parameters, { ...syntax.options, ...common });
  // A list is of all.
  const needed = syntax.operands.filter((name) => !name.startsWith("["));
  const least = values.list ? 0 : needed.length;
  if (positionals.length < least || positionals.length > syntax.operands.length) {
    const wanted = syntax.operands.join(" ") || "none";
    const given = positionals.join(" ") || "none";
    throw usage(`Arguments wanted: ${wanted}; given: ${given}.`, "--help shows how.");
  }
  return { operands: positionals, values };
}

/** @param {string[]} args @param {Options} options */
async function strictly(args, options) {
  try {
    return parseArgs({
      args,
      options: Object.fromEntries(
        Object.entries(options).map(([name, { value, many = false }]) => [
          name,
          { type: value === undefined ? "boolean" : "string", multiple: many },
        ]),
      ),
      allowPositionals: true,
      allowNegative: true,
    });
  } catch (error) {
    const { code = "", message } = /** @type {NodeJS.ErrnoException} */ (error);
    if (!code.startsWith("ERR_PARSE_ARGS")) throw error;
    if (code !== "ERR_PARSE_ARGS_UNKNOWN_OPTION") throw usage(message);
    const typed = /'--?(?:no-)?([^' ]*)/.exec(message)?.[1] ?? "";
    const { unknownFlag } = await loadSolver();
    throw failed(2, unknownFlag(typed, Object.keys(options)));
  }
}

/** Flows that have a place on the command line's `flow`. */
const moving = schema.flows.filter(({ order }) => order > 0).map(({ id }) => id);

/** @param {Row} row */
function placeholder({ kind, ids, absent, words, range, unit }) {
  if (kind === "vertices") return "FILE.json";
  if (kind === "set" && ids.length > 4) return `${absent ? `${absent}|` : ""}ID,ID`;
  if (kind === "set") return ids.join(",");
  if (kind === "choice") return [...(absent ? [absent] : []), ...ids].join("|");
  const one = unit === "length" ? "LENGTH" : range?.whole ? "N" : "VALUE";
  const value = kind === "numbers" ? `${one},${one}` : one;
  return [...(absent ? [absent] : []), ...words, value].join("|");
}

/** @param {NonNullable<Row["range"]>} range */
function limits({ low, high, lowOpen, also }) {
  const from = lowOpen ? `above ${low}` : `from ${low}`;
  const to = high < 1e4 ? ` to ${high}` : "";
  return `${also === null ? "" : `${also} or `}${from}${to}`;
}

/** What reads an option, where that is not every flow. @param {Row} row */
function readers({ flows, scheme, goal, remesh }) {
  const others = moving.filter((flow) => !flows.includes(flow));
  const of = others.length < flows.length ? others.map((flow) => `not ${flow}`) : flows;
  const only = Object.entries({ scheme, goal, remesh }).filter(([, value]) => value);
  return [...of, ...only.map(([flag, value]) => `--${flag} ${value}`)];
}

/** What its words do not say of an option. @param {Row} row */
function notes({ default: usual, kind, range, absent, flag }) {
  if (kind === "vertices") return [`numbered as in the file, OBJ from 1; default ${absent}`];
  if (kind === "switch") return usual ? [`default; --no-${flag} for not`] : [];
  const isList = ["set", "numbers"].includes(kind);
  const value = isList ? absent : (usual ?? absent);
  const isLimited = kind === "number" && range && range.low > -1e4;
  return [...(value === null ? [] : [`default ${value}`]), ...(isLimited ? [limits(range)] : [])];
}

/**
 * The flags of options that tables know, with their help.
 * @param {readonly Row[]} rows @param {string} words  what the names of their words begin with
 * @returns {Options}
 */
export function flagsOf(rows, words) {
  return Object.fromEntries(
    rows.map((row) => {
      const [of, more] = [readers(row), notes(row)];
      const help = [
        ...(of.length > 0 ? [`${of.join(", ")}:`] : []),
        say(`${words}-${row.name}-help`),
        ...(more.length > 0 ? [`(${more.join("; ")})`] : []),
      ];
      const value = row.kind === "switch" ? {} : { value: placeholder(row) };
      return [row.flag, { ...value, many: row.kind === "numbers", help: help.join(" ") }];
    }),
  );
}

/**
 * What was typed for the options of these rows, by their names; several numbers with commas.
 * @param {readonly Row[]} rows @param {Values} values @returns {Record<string, string>}
 */
export const typed = (rows, values) =>
  Object.fromEntries(
    rows.flatMap(({ name, flag }) =>
      values[flag] === undefined ? [] : [[name, String(values[flag])]],
    ),
  );

/**
 * Options of a command by name, as text, read and checked by the solver; what was not given is left
 * out, so that the defaults stay in one place.
 * @param {string} command @param {Record<string, unknown>} words @returns {Promise<any>}
 */
export async function readFlags(command, words) {
  const solver = await loadSolver();
  return orExit(2, () => solver.readFlags(command, words));
}

/** Help of a command. @param {string} name @param {Syntax} syntax @returns {string} */
export function help(name, { summary, operands, options }) {
  const lines = Object.entries({ ...options, ...common }).map(([option, o]) => {
    return [`--${option}${o.value ? ` ${o.value}` : ""}`, o.help];
  });
  const width = Math.min(34, Math.max(...lines.map(([left]) => left.length)));
  const rows = lines.map(([left, right]) =>
    left.length > width
      ? `  ${left}\n  ${" ".repeat(width)}  ${right}`
      : `  ${left.padEnd(width)}  ${right}`,
  );
  const use = ["umbilic", name, ...operands, "[options]"].join(" ");
  return `${use}\n\n${summary}\n\n${rows.join("\n")}\n`;
}
