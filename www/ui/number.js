// @ts-check
// Numbers for people: a fixed count of significant digits, so that they do not jump
// about while they run, and no grouping, so that they can be copied: with a decimal point in
// every language.

import { plural } from "../language.js";

/** @param {number | null | undefined} value @param {number} [digits] significant */
export function formatNumber(value, digits = 5) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 10 ** digits) return value.toExponential(digits - 1);
  return value.toPrecision(digits);
}

/** @param {number} value  for the ticks of an axis or the ends of a scale */
export function formatShort(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) return String(Number(value.toPrecision(3)).toExponential());
  return String(Number(value.toPrecision(3)));
}

/**
 * @param {number} count
 * @param {{ one: string, other: string }} sentences  whole sentences, `#` stands for the count
 */
export const formatCount = (count, sentences) =>
  plural(count, sentences).replace("#", String(count));
