// @ts-check
// The panes of a comparison as words of a link, of characters that an address need not escape:
// panes=epsilon_0.01*scheme_paper_step_7 says that B has another ε than A, and C, at step 7,
// another scheme. `same` stands for a pane that does as the first.

/** @import { Linked } from "./actions/compare.js" */
/** @import { Comparison } from "./comparison.js" */
/** @import { Options } from "./options.js" */

import { letter, MOST_PANES, optionsOf, timeUnitsAgree } from "./comparison.js";
import { asText, readers } from "./options.js";

const SAME = "same";

/** @param {string} text  of one pane @returns {Linked["panes"][number]} */
function readPane(text) {
  const words = text.split("_");
  /** @type {Record<string, unknown>} */
  const change = {};
  let step = null;
  for (let n = 0; n + 1 < words.length; n += 2) {
    const [key, value] = [words[n], words[n + 1]];
    if (key === "step" && /^\d{1,7}$/.test(value)) step = Number(value);
    const read = Object.hasOwn(readers, key) ? readers[key](value) : undefined;
    // Flips change the mesh: nothing can be beside them.
    if (read !== undefined && read !== "flips") change[key] = read;
  }
  return { change, step };
}

/** @param {string | null} text @param {number} count  of panes */
function readLetter(text, count) {
  const index = ["A", "B", "C", "D"].indexOf(text ?? "");
  return index >= 0 && index < count ? index : null;
}

/**
 * @param {URLSearchParams} words
 * @param {Options} options  of the first pane
 * @returns {Linked | null} null where nothing is compared
 */
export function readComparison(words, options) {
  const text = words.get("panes");
  if (!text || options.flow === "flips") return null;
  const panes = text
    .split("*")
    .slice(0, MOST_PANES - 1)
    .map(readPane);
  const all = [options, ...panes.map(({ change }) => optionsOf(options, change))];
  const byTime = words.get("lockstep") === "time" && timeUnitsAgree(all);
  return {
    panes,
    lockstep: byTime ? "time" : "step",
    shown: readLetter(words.get("shown"), all.length) ?? "side",
    difference: readLetter(words.get("difference"), all.length),
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
    const pairs = Object.entries(rival.change)
      .filter(([key]) => Object.hasOwn(readers, key))
      .map(([key, value]) => `${key}_${asText(value)}`);
    const step = rival.reading?.step ?? 0;
    if (step !== (reading?.step ?? 0)) pairs.push(`step_${step}`);
    return pairs.join("_") || SAME;
  });
  words.set("panes", panes.join("*"));
  if (lockstep === "time") words.set("lockstep", lockstep);
  if (shown !== "side") words.set("shown", letter(shown));
  if (difference !== null) words.set("difference", letter(difference));
}
