// Numbers for people: a fixed count of significant digits, so that they do not jump
// about while they run, and no grouping, so that they can be copied: with a decimal point in
// every language.

/** @param {number | null | undefined} value @param {number} [digits] significant */
export function formatNumber(value, digits = 5) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 10 ** digits) return value.toExponential(digits - 1);
  return value.toPrecision(digits);
}

/**
 * For sentences, the ticks of an axis and the ends of a scale: without zeros at the end.
 * @param {number} value @param {number} [digits] significant
 */
export function formatShort(value, digits = 3) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  const short = Number(value.toPrecision(digits));
  return size < 1e-3 || size >= 1e5 ? short.toExponential() : String(short);
}

/**
 * A number beside a larger one of its kind: what is lost in rounding beside that shows as 0.
 * @param {number | null | undefined} value @param {number} scale  as the value at the start
 */
export function formatBeside(value, scale) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (Math.abs(value) < 1e-6 * Math.max(Math.abs(scale), 1)) return "0";
  const decimals = Math.min(Math.max(3 - Math.floor(Math.log10(Math.abs(value))), 0), 6);
  return Math.abs(value) >= 1e6 ? value.toExponential(3) : value.toFixed(Math.min(decimals, 4));
}

/** For people alone: with a true minus. @param {number} value */
export const formatSigned = (value) => formatShort(value).replace("-", "−");
