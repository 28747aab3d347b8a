// @ts-check
// A link says what energy its scene had; whoever opens it is told whether it came out the
// same. One version of the solver gives the same bits everywhere.

/** @import { Scene } from "./link.js" */
/** @import { PageState } from "./state.js" */

import { t } from "./language.js";
import { isOver } from "./standing.js";
import { formatNumber } from "./ui/number.js";

/** Fewer digits are no proof. */
const FEWEST_DIGITS = 6;
/** How near other versions of the solver come, relative to the energy sent … */
const NEAR = 1e-6;
/** … or, where the flow has brought that down to nothing, to the energy at the start. */
const NOTHING = 1e-12;

/**
 * @param {string} text  of a number
 * @returns {number} its significant digits
 */
const digitsOf = (text) => text.replace(/e.*$/i, "").replace(/\D/g, "").replace(/^0+/, "").length;

/** Whether text is an energy as links carry it. @param {string | null} text */
export const isReading = (text) =>
  text !== null && text.length < 30 && text.trim() === text && Number.isFinite(parseFloat(text))
    ? Number.isFinite(Number(text))
    : false;

/**
 * @param {string} sent    the energy in the link
 * @param {number} energy  the energy here
 * @param {number} start   the energy before the first step
 * @returns {'same' | 'near' | 'off'}
 */
export function compareEnergy(sent, energy, start = 0) {
  const value = Number(sent);
  const digits = digitsOf(sent);
  if (value === energy) return "same";
  // Shortened by hand, all that is left of it must agree.
  if (digits >= FEWEST_DIGITS && digits < 15 && Number(energy.toPrecision(digits)) === value) {
    return "same";
  }
  const apart = Math.abs(value - energy);
  return apart <= NEAR * Math.abs(value) || apart <= NOTHING * Math.abs(start) ? "near" : "off";
}

/**
 * What is to be said of a scene that was restored; null where there is nothing to compare, or
 * the user went on before it was there.
 * @param {Scene} scene
 * @param {Readonly<PageState>} state  at rest
 * @param {string} symbol  of the energy
 * @param {boolean | null} isFile  whether the file is that of the link; null: not known
 * @returns {{ isGood: boolean, message: string, hint: string } | null}
 */
export function verdict({ check, step, version: theirs }, state, symbol, isFile) {
  const { reading, version, history } = state;
  if (!reading || check === null) return null;
  if (reading.step !== step) {
    if (reading.step > step || !isOver(reading.status)) return null;
    const message = t("The link shows step {step}; here the flow ends at step {here}.", {
      step,
      here: reading.step,
    });
    return { isGood: false, message, hint: reason(theirs, version, isFile) };
  }
  const outcome = compareEnergy(check, reading.energy, history[0]?.energy);
  const here = formatNumber(reading.energy, 6);
  if (outcome === "same") {
    const message = t("The scene is as it was sent: {symbol} = {here}.", { symbol, here });
    return { isGood: true, message, hint: "" };
  }
  const sent = formatNumber(Number(check), 6);
  const apart = formatNumber(Math.abs(reading.energy - Number(check)), 2);
  if (outcome === "near") {
    const message = t(
      "The scene is as it was sent to six digits: {symbol} = {here}, {apart} from the {sent} of the link.",
      { symbol, here, apart, sent },
    );
    return { isGood: true, message, hint: reason(theirs, version, isFile) };
  }
  const message = t(
    "The scene is not as it was sent: {symbol} = {here} at step {step}, where the link says {sent}; that is {apart} off.",
    { symbol, here, step, sent, apart },
  );
  return { isGood: false, message, hint: reason(theirs, version, isFile) };
}

/** @param {string | null} theirs @param {string} ours @param {boolean | null} isFile */
function reason(theirs, ours, isFile) {
  if (isFile === false) return t("The mesh is not the file of the link.");
  if (theirs !== null && theirs !== ours) {
    return t("The link was made by version {theirs} of the solver; this is version {ours}.", {
      theirs,
      ours,
    });
  }
  if (isFile === null) return t("Perhaps the file is not the one the link was made with.");
  return t("The same version should give the same numbers; please report this, with the link.");
}
