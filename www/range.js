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
 * The robust range of a field rounded outwards: about 0 where values are signed, else from 0.
 * @param {Pick<Field, "high" | "signed">} field @returns {[number, number]}
 */
export function rangeOf({ high, signed }) {
  const end = high > 0 ? roundedUp(high) : 1;
  return [signed ? -end : 0, end];
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
