// Results as text for people.

import { formatShort } from "../number.js";
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

/** What a repair would change. @param {{ message: string | Message, done: boolean }[]} [repairs] */
export const pending = (repairs = []) =>
  repairs.filter(({ done }) => !done).map(({ message }) => say("repair-pending", { message }));

/** The same, and how it is changed. @param {Parameters<typeof pending>[0]} repairs */
export const wanting = (repairs) => {
  const lines = pending(repairs);
  return lines.length > 0 ? [...lines, say("repair-way")] : [];
};

/** Six significant digits; whole numbers in full. @param {unknown} value */
export function format(value) {
  if (typeof value !== "number" || Number.isSafeInteger(value)) return String(value ?? "–");
  return formatShort(value, 6);
}

/**
 * Rows of text in columns: the first few to the left, the others to the right.
 * @param {string[][]} rows @param {number} [left] @returns {string}
 */
export function table(rows, left = 1) {
  const widths = (rows[0] ?? []).map((_, i) => Math.max(...rows.map((row) => row[i].length)));
  const line = (/** @type {string[]} */ row) =>
    row.map((cell, i) => (i < left ? cell.padEnd(widths[i]) : cell.padStart(widths[i])));
  return rows.map((row) => `${line(row).join("  ").trimEnd()}\n`).join("");
}

/** Most boundary loops that are listed. */
const MOST_LOOPS = 20;

/**
 * A result in lines: its sentence, what was before beside what is after, and everything else by its
 * key.
 * @param {Record<string, any>} result @returns {string}
 */
export function print({ message, warnings = [], changes, repairs, loops = [], ...rest }) {
  const { before, after, initial, final, ...others } = rest;
  const sides = before ? { before, after } : initial && { initial, final };
  // A file that was no surface has nothing to stand before it.
  const all = sides || !after ? others : { ...others, ...after };
  const changed = changes?.map((/** @type {{ message: string }} */ one) => one.message);
  const listed = loops.slice(0, MOST_LOOPS).map((/** @type {Record<string, any>} */ loop) => {
    return say("loop-line", { ...loop, length: format(loop.length) });
  });
  const count = loops.length - listed.length;
  const gap = after ? after.gap : rest.gap;
  const parts = [
    message ? [message] : [],
    changed?.length === 0 ? [say("repair-nothing")] : (changed ?? []),
    table(entries(all).map(([key, value]) => [key, format(value)])),
    sides ? compared(sides) : "",
    count > 0 ? [...listed, say("loop-more", { count })] : listed,
    warnings.map((/** @type {string} */ warning) => say("result-warning", { message: warning })),
    wanting(repairs),
    gap === undefined ? [] : [say("repair-gap", { gap: String(gap) })],
  ];
  const texts = parts.map((part) =>
    typeof part === "string"
      ? part
      : part.map((/** @type {string} */ line) => `${line}\n`).join(""),
  );
  return texts.filter((text) => text !== "").join("\n");
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
function entries(object, prefix = "") {
  return Object.entries(object).flatMap(([key, value]) => {
    const name = prefix + key;
    if (Array.isArray(value)) return [];
    if (typeof value === "object" && value !== null) return entries(value, `${name}.`);
    return [/** @type {[string, unknown]} */ ([name, value])];
  });
}
