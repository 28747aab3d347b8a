// @ts-check
// The panes of a comparison as words of a link, of characters that an address need not escape:
// panes=epsilon_0.01*scheme_paper_step_7 says that B has another ε than A, and C, at step 7,
// another scheme. `same` stands for a pane that does as the first.

/** @import { Comparison } from "./comparison.js" */
/** @import { Options } from "./options.js" */

import { letter, MOST_PANES } from "./comparison.js";
import { asText, wordOptions } from "./options.js";

const SAME = "same";

/**
 * A comparison as it is written, its options not read yet.
 * @typedef {object} Written
 * @property {{ words: Record<string, string>, step: number | null }[]} panes
 * @property {boolean} byTime
 * @property {number | null} shown
 * @property {number | null} difference
 */

/** @param {string} text  of one pane @returns {Written["panes"][number]} */
function readPane(text) {
  const parts = text.split("_");
  /** @type {Record<string, string>} */
  const words = {};
  let step = null;
  for (let n = 0; n + 1 < parts.length; n += 2) {
    const [key, value] = [parts[n], parts[n + 1]];
    if (key !== "step") words[key] = value;
    else if (/^\d{1,7}$/.test(value)) step = Number(value);
  }
  return { words, step };
}

/** @param {string | null} text @param {number} count  of panes */
function readLetter(text, count) {
  const index = ["A", "B", "C", "D"].indexOf(text ?? "");
  return index >= 0 && index < count ? index : null;
}

/**
 * @param {URLSearchParams} words
 * @returns {Written | null} null where nothing is compared
 */
export function readComparison(words) {
  const text = words.get("panes");
  if (!text) return null;
  const panes = text
    .split("*")
    .slice(0, MOST_PANES - 1)
    .map(readPane);
  return {
    panes,
    byTime: words.get("lockstep") === "time",
    shown: readLetter(words.get("shown"), panes.length + 1),
    difference: readLetter(words.get("difference"), panes.length + 1),
  };
}

/**
 * @param {URLSearchParams} words
 * @param {Readonly<Comparison>} comparison
 * @param {Options} options  of the first pane
 * @param {{ step: number } | null} reading  of the first pane
 */
export function writeComparison(words, comparison, options, reading) {
  const { rivals, lockstep, shown, difference } = comparison;
  if (rivals.length === 0 || options.flow === "flips") return;
  const panes = rivals.map((rival) => {
    const change = /** @type {Record<string, unknown>} */ (rival.change);
    const pairs = wordOptions
      .filter(({ name }) => name in change)
      .map(({ name }) => `${name}_${asText(change[name], name)}`);
    const step = rival.reading?.step ?? 0;
    if (step !== (reading?.step ?? 0)) pairs.push(`step_${step}`);
    return pairs.join("_") || SAME;
  });
  words.set("panes", panes.join("*"));
  if (lockstep === "time") words.set("lockstep", lockstep);
  if (shown !== "side") words.set("shown", letter(shown));
  if (difference !== null) words.set("difference", letter(difference));
}
