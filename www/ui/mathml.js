// @ts-check
// Formulae as MathML. Text stands for what it is: numbers, operators, names.

/** @typedef {string | Element} Part */

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";
const OPERATORS = new Set([..."=+−·,;:()[]|‖⟨⟩∫∑∈≤≥<>→↦⇔/¼½→", "max", "min", "arg min"]);

/** @param {string} name @param {Part[]} parts */
function element(name, parts) {
  const made = document.createElementNS(NAMESPACE, name);
  made.append(...parts.map((part) => (typeof part === "string" ? token(part) : part)));
  return made;
}

/** @param {string} text */
function token(text) {
  const isNumber = /^[\d.]+$|^[¼½]$/.test(text);
  const made = document.createElementNS(
    NAMESPACE,
    isNumber ? "mn" : OPERATORS.has(text) ? "mo" : "mi",
  );
  made.textContent = text;
  return made;
}

/** Side by side; words of a text are parts. @param {Part[]} parts */
export function row(...parts) {
  /** @type {Part[]} */
  const words = [];
  for (const part of parts) words.push(...(typeof part === "string" ? part.split(" ") : [part]));
  const made = element("mrow", words);
  // Brackets grow with fractions only.
  const hasFraction = [...made.children].some(({ localName }) => localName === "mfrac");
  for (const part of made.children) {
    if (!hasFraction && part.localName === "mo") part.setAttribute("stretchy", "false");
  }
  return made;
}
/** @param {Part} base @param {Part} below */
export const sub = (base, below) => element("msub", [base, below]);
/** @param {Part} base @param {Part} above */
export const sup = (base, above) => element("msup", [base, above]);
/** @param {Part} base @param {Part} below @param {Part} above */
export const subsup = (base, below, above) => element("msubsup", [base, below, above]);
/** @param {Part} above @param {Part} below */
export const frac = (above, below) => element("mfrac", [above, below]);
/** @param {Part[]} parts */
export const root = (...parts) => element("msqrt", parts);
/** @param {Part} base */
export const dot = (base) => element("mover", [base, token("˙")]);
/** @param {Part} below  what the sum is over */
export const sum = (below) => element("munder", ["∑", below]);

/** @param {Part} formula @param {boolean} [isBlock] */
export function math(formula, isBlock = false) {
  const made = element("math", [formula]);
  if (isBlock) made.setAttribute("display", "block");
  return made;
}
