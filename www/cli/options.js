// @ts-check
// Options of a command: what they are, their help, and reading them strictly.

import { parseArgs } from "node:util";
import { usage } from "./failure.js";

/**
 * @typedef {object} Option
 * @property {string} [value]      what follows it, e.g. `FILE`; absent for a switch
 * @property {string[]} [choices]  the only values there are
 * @property {boolean} [many]      may be given more than once
 * @property {string} help
 */

/** @typedef {Record<string, Option>} Options */

/**
 * What a command accepts.
 * @typedef {object} Syntax
 * @property {string} summary     one line
 * @property {string[]} operands  names of the arguments without a dash, e.g. `MESH`; `[MESH]` may be left out
 * @property {Options} options
 * @property {string[]} [later]   options of a coming version
 */

/** The values as typed: text, lists of text for `many`, booleans for switches. */
/** @typedef {Record<string, any>} Values */

/** @type {Options} */
const common = {
  json: { help: "the result as JSON on standard output" },
  help: { help: "this" },
};

/**
 * @param {string[]} parameters
 * @param {Syntax} syntax
 * @returns {{ operands: string[], values: Values }}
 * @throws {import("./failure.js").Failure} usage
 */
export function parse(parameters, syntax) {
  const options = { ...syntax.options, ...common };
  const { values, positionals } = strictly(parameters, options, syntax.later ?? []);
  for (const [name, { choices }] of Object.entries(options)) {
    const value = values[name];
    if (choices && value !== undefined && !choices.includes(String(value))) {
      throw usage(`--${name} cannot be \`${value}\`.`, `It is one of: ${choices.join(", ")}.`);
    }
  }
  const least = syntax.operands.filter((name) => !name.startsWith("[")).length;
  if (positionals.length < least || positionals.length > syntax.operands.length) {
    const wanted = syntax.operands.join(" ") || "none";
    const given = positionals.join(" ") || "none";
    throw usage(`Arguments wanted: ${wanted}; given: ${given}.`, "--help shows how.");
  }
  return { operands: positionals, values };
}

/**
 * @param {string[]} args
 * @param {Options} options
 * @param {string[]} later
 */
function strictly(args, options, later) {
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
    const name = /'--?(?:no-)?([^' ]*)/.exec(message)?.[1] ?? "";
    if (later.includes(name)) throw usage(`--${name} is not in this version.`);
    const near = similar(name, Object.keys(options));
    throw usage(
      `There is no option --${name}.`,
      near ? `Did you mean --${near}?` : "--help lists the options.",
    );
  }
}

/**
 * A number given as an option.
 * @param {Values} values
 * @param {string} name
 * @param {{ low?: number, integer?: boolean }} [limits]
 * @returns {number | undefined}  undefined when the option is absent
 */
export function number(values, name, { low = -Infinity, integer = false } = {}) {
  const text = values[name];
  if (text === undefined) return undefined;
  const value = text.trim() === "" ? Number.NaN : Number(text);
  if (Number.isFinite(value) && value >= low && (!integer || Number.isInteger(value))) return value;
  const kind = integer ? "a whole number" : "a number";
  throw usage(`--${name} is \`${text}\`, not ${kind}${low > -Infinity ? ` from ${low}` : ""}.`);
}

/**
 * The nearest of `names`, when it is near enough to be a slip of the hand.
 * @param {string} typed
 * @param {string[]} names
 * @returns {string | undefined}
 */
export function similar(typed, names) {
  const ranked = names
    .map((name) => ({ name, distance: editDistance(typed, name) }))
    .sort((a, b) => a.distance - b.distance);
  return ranked[0]?.distance <= 2 ? ranked[0].name : undefined;
}

/**
 * Levenshtein's distance.
 * @param {string} a
 * @param {string} b
 */
function editDistance(a, b) {
  let row = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const replaced = row[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1);
      next.push(Math.min(replaced, row[j] + 1, next[j - 1] + 1));
    }
    row = next;
  }
  return row[b.length];
}

/**
 * Help of a command.
 * @param {string} name
 * @param {Syntax} syntax
 * @returns {string}
 */
export function help(name, { summary, operands, options }) {
  const lines = Object.entries({ ...options, ...common }).map(([option, o]) => {
    const value = o.choices ? o.choices.join("|") : o.value;
    return [`--${option}${value ? ` ${value}` : ""}`, o.help];
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
