// Numbers for people: a fixed count of significant digits, so that they do not jump
// about while they run, and no grouping, so that they can be copied: with a decimal point in
// every language.

/** What would be more zeros than digits is written with a power of ten. @param {number} size */
const isExtreme = (size) => size < 1e-6 || size >= 1e9;

/** @param {number | null | undefined} value @param {number} [digits] significant */
export function formatNumber(value, digits = 5) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0 || !Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (isExtreme(size)) return value.toExponential(digits - 1);
  return size >= 10 ** digits ? value.toFixed() : value.toPrecision(digits);
}

/**
 * For sentences, the ticks of an axis and the ends of a scale: without zeros at the end.
 * @param {number} value @param {number} [digits] significant
 */
export function formatShort(value, digits = 3) {
  if (value === 0) return "0";
  const short = Number(value.toPrecision(digits));
  return isExtreme(Math.abs(short)) ? short.toExponential() : String(short);
}

/** Whether a number is lost in rounding beside one of its kind. @param {number} value @param {number} scale  as the value at the start */
export const isRounding = (value, scale) => Math.abs(value) < 1e-6 * Math.max(Math.abs(scale), 1);

/**
 * A number beside a larger one of its kind: what is lost in rounding beside that shows as 0.
 * @param {number | null | undefined} value @param {number} scale
 */
export function formatBeside(value, scale) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (isRounding(value, scale)) return "0";
  const decimals = Math.min(Math.max(3 - Math.floor(Math.log10(Math.abs(value))), 0), 6);
  return isExtreme(Math.abs(value)) ? value.toExponential(3) : value.toFixed(Math.min(decimals, 4));
}

/** For people alone: with a true minus. @param {number} value */
export const formatSigned = (value) => formatShort(value).replace("-", "−");
