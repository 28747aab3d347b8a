// Results as text for people.

import { say } from "../words.js";

/** @import { Message, RepairItem } from "../generated/types.js" */

/**
 * Warnings as sentences, their ids beside them.
 * @template {{ warnings: Message[], repairs?: RepairItem[] }} T @param {T} told
 */
export const inWords = (told) => ({
  ...told,
  warnings: told.warnings.map((warning) => say(warning)),
  warningIds: told.warnings.map(({ id }) => id),
  ...(told.repairs && { repairs: told.repairs.map(repairInWords) }),
});

/** A change of a repair as people read it. @param {RepairItem} item */
export const repairInWords = ({ kind, count, message, done }) => ({
  ...{ kind, count, done },
  message: say(message),
});

/** How what a repair would change is changed. */
export const repairWay = "`umbilic repair MESH --out FILE` writes such a surface.";

/** What a repair would change. @param {readonly ReturnType<typeof repairInWords>[]} repairs */
export const pending = (repairs) =>
  repairs.filter(({ done }) => !done).map(({ message }) => `repair: ${message}`);

/** Six significant digits; whole numbers in full. @param {unknown} value @returns {string} */
export function format(value) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e15) return String(value);
  return String(Number(value.toPrecision(6)));
}

/**
 * Rows of text in columns: the first few to the left, the others to the right.
 * @param {string[][]} rows @param {number} [left] @returns {string}
 */
export function table(rows, left = 1) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  const line = (/** @type {string[]} */ row) =>
    row.map((cell, i) => (i < left ? cell.padEnd(widths[i]) : cell.padStart(widths[i])));
  return rows.map((row) => `${line(row).join("  ").trimEnd()}\n`).join("");
}

/**
 * A result in lines: its sentence, what was before beside what is after, and everything else by its
 * key.
 * @param {Record<string, any>} result @returns {string}
 */
export function print({ message, warnings = [], changes, repairs = [], loops = [], ...rest }) {
  const { before, after, initial, final, ...others } = rest;
  const sides = before ? { before, after } : initial && { initial, final };
  // A file that was no surface has nothing to stand before it.
  const all = sides || !after ? others : { ...others, ...after };
  const rows = entries(all).map(([key, value]) => [key, format(value)]);
  const lines = (/** @type {string[]} */ list, kind = "") =>
    list.map((line) => `${kind}${line}\n`).join("");
  const wanting = pending(repairs);
  const said = (/** @type {{ message: string }} */ one) => one.message;
  const gap = after ? after.gap : rest.gap;
  const parts = [
    message ? `${message}\n` : "",
    changes ? lines(changes.map(said)) || "Nothing was to be repaired.\n" : "",
    rows.length > 0 ? table(rows) : "",
    sides ? compared(sides) : "",
    listOf(loops),
    lines(warnings, "warning: "),
    wanting.length > 0 ? lines([...wanting, repairWay]) : "",
    gap === undefined ? "" : `Boundaries run close beside each other: try --weld ${gap}\n`,
  ];
  return parts.filter((part) => part !== "").join("\n");
}

/** Most boundary loops that are listed. */
const MOST_LOOPS = 20;

/** @param {readonly Record<string, any>[]} loops */
function listOf(loops) {
  const said = loops.slice(0, MOST_LOOPS).map((loop) => {
    const { small, length, ...rest } = loop;
    return say("loop-line", { ...rest, length: format(length), small: String(small) });
  });
  const more = loops.length - said.length;
  if (more > 0) said.push(say("loop-more", { count: more }));
  return said.map((line) => `${line}\n`).join("");
}

/** Two objects of the same keys side by side. @param {Record<string, object>} sides */
function compared(sides) {
  const [first, last] = Object.values(sides).map((side) => entries(side));
  const values = new Map(last);
  const rows = first.map(([key, value]) => [key, format(value), format(values.get(key))]);
  return table([["", ...Object.keys(sides)], ...rows]);
}

/**
 * The keys of an object and their values, nested keys dotted, lists left out.
 * @param {object} object @param {string} [prefix] @returns {[string, unknown][]}
 */
export function entries(object, prefix = "") {
  return Object.entries(object).flatMap(([key, value]) => {
    const name = prefix + key;
    if (Array.isArray(value)) return [];
    if (typeof value === "object" && value !== null) return entries(value, `${name}.`);
    return [/** @type {[string, unknown]} */ ([name, value])];
  });
}
