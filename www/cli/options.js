// Options of a command: what they are, their help, and reading them strictly.

import { parseArgs } from "node:util";
import { flags } from "../generated/schema.js";
import { say } from "../words.js";
import { refused } from "./failure.js";
import { writtenHelp } from "./files.js";
import { loadSolver } from "./solver.js";

/**
 * @typedef {object} Option
 * @property {string} flag            without dashes
 * @property {string | null} value    what follows it, e.g. `FILE`; none for a switch
 * @property {string} help
 * @property {boolean} [isMany]       may be given more than once
 * @property {boolean} [isWritten]    a file that the command writes
 */
/** What was typed: text, lists of text, booleans for switches. @typedef {Record<string, any>} Values */

/** What is also known by a letter. @type {Record<string, string>} */
const letters = { out: "o", help: "h" };

/**
 * The options that a table has, with their help.
 * @param {string} table @returns {Option[]}
 */
export const optionsOf = (table) =>
  (flags[table] ?? []).map(({ of, words, notes, ...row }) => {
    const help = `${of && `${of}: `}${say(`${words}-help`)}${notes && ` (${notes})`}`;
    return { ...row, help };
  });

/**
 * Options that the command line has beside the solver's: what follows each.
 * @param {string} command @param {Record<string, string | null>} own @returns {Option[]}
 */
export const ownOptions = (command, own) =>
  Object.entries(own).map(([flag, value]) => {
    const help = say(`flag-${flag}-help`, { command, formats: writtenHelp });
    return { flag, value, help, isWritten: value?.startsWith("FILE") };
  });

/**
 * @param {string[]} parameters @param {readonly string[]} operands  names of the arguments without
 *   a dash, such as `MESH`, of which `[MESH]` may be left out @param {Option[]} options
 */
export function parse(parameters, operands, options) {
  const { positionals, ...typed } = strictly(parameters, options);
  /** @type {Values} */
  const values = typed.values;
  // A list is of all.
  const needed = operands.filter((name) => !name.startsWith("[") && !values.list);
  if (positionals.length < needed.length || positionals.length > operands.length) {
    const [wanted, given] = [operands, positionals].map((list) => list.join(" ") || "none");
    throw refused("usage-operands", { wanted, given });
  }
  return { operands: positionals, values };
}

/** @param {string[]} parameters @param {Option[]} options */
function strictly(parameters, options) {
  const known = options.map(({ flag, value, isMany: multiple = false }) => {
    const short = letters[flag] && { short: letters[flag] };
    return [flag, { type: value ? "string" : "boolean", multiple, ...short }];
  });
  /** @param {string} flag */
  const taken = (flag) => options.find((one) => one.flag === flag)?.value;
  // Negative numbers, which begin like options, are joined to those that they follow.
  const isJoined = parameters.map((next, i) => {
    return /^-\.?\d/.test(next) && taken((parameters[i - 1] ?? "").slice(2));
  });
  const args = parameters.flatMap((next, i) => {
    if (isJoined[i]) return [];
    return isJoined[i + 1] ? `${next}=${parameters[i + 1]}` : next;
  });
  try {
    const syntax = { options: Object.fromEntries(known), allowPositionals: true };
    return parseArgs({ args, ...syntax, allowNegative: true });
  } catch (error) {
    const { code = "", message } = /** @type {NodeJS.ErrnoException} */ (error);
    if (!code.startsWith("ERR_PARSE_ARGS")) throw error;
    if (code !== "ERR_PARSE_ARGS_UNKNOWN_OPTION") {
      throw refused("usage-syntax", { reason: message });
    }
    const flag = /'--?([^' ]*)/.exec(message)?.[1] ?? "";
    const value = taken(flag.replace(/^no-/, ""));
    if (value) throw refused("usage-takes-value", { flag, value });
    const names = options.map((one) => one.flag);
    throw loadSolver().unknownFlag(flag, names);
  }
}

/**
 * What was typed for the options of a table, by their names; several numbers with commas.
 * @param {string} table @param {Values} values @returns {Record<string, string>}
 */
export function typed(table, values) {
  const given = (flags[table] ?? []).filter(({ flag }) => values[flag] !== undefined);
  return Object.fromEntries(given.map(({ name, flag }) => [name, String(values[flag])]));
}

/**
 * Options of a command by name, as text, read and checked by the solver; what was not given is left
 * out, so that the defaults stay in one place.
 * @param {string} command @param {Record<string, unknown>} words
 */
export const readFlags = (command, words) => loadSolver().readFlags(command, words);

/** Help of a command. @param {string} name @param {readonly string[]} operands @param {Option[]} options */
export function help(name, operands, options) {
  const lines = options.map(({ flag, value, help }) => {
    const short = letters[flag] ? `-${letters[flag]}, ` : "";
    return [`${short}--${flag}${value ? ` ${value}` : ""}`, help];
  });
  const width = Math.min(34, Math.max(...lines.map(([left]) => left.length)));
  const rows = lines.map(([left, right]) => {
    const start = left.length > width ? `${left}\n  ${" ".repeat(width)}` : left.padEnd(width);
    return `  ${start}  ${right}\n`;
  });
  const use = ["umbilic", name, ...operands, "[options]"].join(" ");
  return `${use}\n\n${say(`summary-${name}`)}\n\n${rows.join("")}`;
}
