// @ts-check
// The ends of a scale of colours, held for a whole run.

/** @import { Field } from "./store.js" */

/** What stands at the end of a scale, over a power of ten. */
const NICE = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** A round number that is not smaller. @param {number} value  positive */
export function roundedUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const nice = NICE.find((one) => one * power >= value * (1 - 1e-9)) ?? 10;
  return Number((nice * power).toPrecision(6));
}

/**
 * From the 2nd to the 98th percentile of the values, rounded outwards; about 0 where they are
 * signed, from 0 where they are not.
 * @param {Pick<Field, "values" | "signed">} field
 * @returns {[number, number]}
 */
export function rangeOf({ values, signed }) {
  const sorted = values.filter(Number.isFinite).sort();
  const at = (/** @type {number} */ share) => sorted[Math.round(share * (sorted.length - 1))] ?? 0;
  const [low, high] = [at(0.02), at(0.98)];
  const most = signed ? Math.max(Math.abs(low), Math.abs(high)) : high;
  const end = most > 0 && Number.isFinite(most) ? roundedUp(most) : 1;
  return signed ? [-end, end] : [0, end];
}

/**
 * Values of the field in a histogram over a range; what is beyond counts at the ends.
 * @param {Float32Array} values @param {readonly [number, number]} range @param {number} bins
 * @returns {number[]} shares of all
 */
export function histogram(values, [low, high], bins) {
  const counts = new Array(bins).fill(0);
  let all = 0;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    const bin = Math.floor(((value - low) / (high - low || 1)) * bins);
    counts[Math.min(Math.max(bin, 0), bins - 1)] += 1;
    all += 1;
  }
  return counts.map((count) => count / Math.max(all, 1));
}
