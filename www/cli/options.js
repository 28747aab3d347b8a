// Options of a command: what they are, their help, and reading them strictly.

import { parseArgs } from "node:util";
import * as schema from "../generated/schema.js";
import { say } from "../words.js";
import { failed, orExit, usage } from "./failure.js";
import { loadSolver } from "./solver.js";

/** @typedef {import("../generated/schema.js").Row} Row */

/**
 * @typedef {object} Option
 * @property {string | null} [value]  what follows it, e.g. `FILE`; none for a switch
 * @property {boolean} [many]         may be given more than once
 * @property {boolean} [isWritten]    a file that the command writes
 * @property {string} help
 */
/** @typedef {Record<string, Option>} Options */
/**
 * What a command accepts: a summary in one line, and names of the arguments without a dash, such as
 * `MESH`, of which `[MESH]` may be left out.
 * @typedef {{ summary: string, operands: string[], options: Options }} Syntax
 */
/** What was typed: text, lists of text for `many`, booleans for switches. @typedef {Record<string, any>} Values */

/** @type {Options} */
const common = {
  json: { help: "the result as JSON on standard output" },
  help: { help: "this" },
};

/** What is also known by a letter. @type {Record<string, string>} */
const letters = { out: "o", help: "h" };

const shortOf = (/** @type {string} */ name) => (letters[name] ? { short: letters[name] } : {});

/** @param {string[]} parameters @param {Syntax} syntax */
export function parse(parameters, syntax) {
  const { positionals, ...typed } = strictly(parameters, { ...syntax.options, ...common });
  /** @type {Values} */
  const values = typed.values;
  // A list is of all.
  const needed = syntax.operands.filter((name) => !name.startsWith("[") && !values.list);
  if (positionals.length < needed.length || positionals.length > syntax.operands.length) {
    const wanted = syntax.operands.join(" ") || "none";
    const given = positionals.join(" ") || "none";
    throw usage(`Arguments wanted: ${wanted}; given: ${given}.`, "--help shows how.");
  }
  return { operands: positionals, values };
}

/** @param {string[]} args @param {Options} options */
function strictly(args, options) {
  const kinds = Object.entries(options).map(([name, { value, many = false }]) => [
    name,
    { type: value ? "string" : "boolean", multiple: many, ...shortOf(name) },
  ]);
  try {
    const known = Object.fromEntries(kinds);
    const joined = withNegatives(args, options);
    return parseArgs({ args: joined, options: known, allowPositionals: true, allowNegative: true });
  } catch (error) {
    const { code = "", message } = /** @type {NodeJS.ErrnoException} */ (error);
    if (!code.startsWith("ERR_PARSE_ARGS")) throw error;
    if (code !== "ERR_PARSE_ARGS_UNKNOWN_OPTION") throw usage(message);
    const typed = /'--?([^' ]*)/.exec(message)?.[1] ?? "";
    const taken = options[typed.replace(/^no-/, "")]?.value;
    if (taken) throw usage(`\`--${typed}\`: such an option takes a value, ${taken}.`);
    throw failed(2, loadSolver().unknownFlag(typed, Object.keys(options)));
  }
}

/**
 * With negative numbers joined to their options, as they begin like options themselves.
 * @param {string[]} args @param {Options} options
 */
function withNegatives(args, options) {
  /** @type {string[]} */
  const joined = [];
  for (const arg of args) {
    const [last = ""] = joined.slice(-1);
    const isValue = /^-\.?\d/.test(arg) && options[last.slice(2)]?.value;
    if (isValue) joined.splice(-1, 1, `${last}=${arg}`);
    else joined.push(arg);
  }
  return joined;
}

/**
 * The flags of options that tables know, with their help.
 * @param {readonly Row[]} rows @param {string} words  what the names of their words begin with
 * @param {(of: string) => string} where  what the command says of where an option counts
 */
export function flagsOf(rows, words, where = (of) => of && `${of}: `) {
  const entries = rows.map(({ name, flag, kind }) => {
    const { value, of, notes } = schema.flags[`${words}-${name}`];
    const own = say(`${words}-${name}-help`);
    const help = `${where(of)}${own}${notes && ` (${notes})`}`;
    return [flag, { value, many: kind === "numbers", help }];
  });
  return Object.fromEntries(entries);
}

/**
 * Refuses a word that is none of a few.
 * @param {string} flag @param {string} word @param {readonly string[]} words
 */
export function checkWord(flag, word, words) {
  if (words.includes(word)) return;
  const near = loadSolver().nearest(word, [...words]);
  const all = `It may be one of ${words.join(", ")}.`;
  throw usage(
    `\`--${flag}\` cannot be \`${word}\``,
    near ? `Did you mean \`${near}\`? ${all}` : all,
  );
}

/**
 * What was typed for the options of these rows, by their names; several numbers with commas.
 * @param {readonly Row[]} rows @param {Values} values @returns {Record<string, string>}
 */
export function typed(rows, values) {
  const given = rows.filter(({ flag }) => values[flag] !== undefined);
  return Object.fromEntries(given.map(({ name, flag }) => [name, String(values[flag])]));
}

/**
 * Options of a command by name, as text, read and checked by the solver; what was not given is left
 * out, so that the defaults stay in one place.
 * @param {string} command @param {Record<string, unknown>} words
 */
export const readFlags = (command, words) =>
  orExit(2, () => loadSolver().readFlags(command, words));

/** Help of a command. @param {string} name @param {Syntax} syntax @returns {string} */
export function help(name, { summary, operands, options }) {
  const lines = Object.entries({ ...options, ...common }).map(([option, { value, help }]) => [
    `${letters[option] ? `-${letters[option]}, ` : ""}--${option}${value ? ` ${value}` : ""}`,
    help,
  ]);
  const width = Math.min(34, Math.max(...lines.map(([left]) => left.length)));
  const rows = lines.map(([left, right]) => {
    const start = left.length > width ? `${left}\n  ${" ".repeat(width)}` : left.padEnd(width);
    return `  ${start}  ${right}`;
  });
  const use = ["umbilic", name, ...operands, "[options]"].join(" ");
  return `${use}\n\n${summary}\n\n${rows.join("\n")}\n`;
}
