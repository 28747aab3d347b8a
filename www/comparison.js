// Flows side by side as data: what a pane does otherwise than the first, and what of two can be
// compared.

import { asText, flowLabel, flowOf, toFlow } from "./options.js";
import { say } from "./words.js";

/** @import { Options } from "./options.js" */
/** @import { Track } from "./player.js" */

/** As many as there is room for. */
export const MOST_PANES = 4;

/** Panes are called by letters, the first A. @param {number} n */
export const letter = (n) => String.fromCharCode(65 + n);

/** What a pane does. @param {Options} main  what the first does @param {Partial<Options>} change */
export function optionsOf(main, change) {
  const { flow } = change;
  const isOther = flow !== undefined && flow !== main.flow;
  return { ...main, ...(isOther ? toFlow(flow) : {}), ...change };
}

/**
 * The change that makes the options of the first pane these.
 * @param {Options} main @param {Options} options @returns {Partial<Options>}
 */
export function changeOf(main, options) {
  const base = optionsOf(main, { flow: options.flow });
  const keys = /** @type {(keyof Options)[]} */ (Object.keys(base));
  const isOther = (/** @type {keyof Options} */ key) =>
    key === "flow" ? options.flow !== main.flow : asText(options[key]) !== asText(base[key]);
  return Object.fromEntries(keys.filter(isOther).map((key) => [key, options[key]]));
}

/** A flow's time is a length to this power. @param {Options} options */
export function timeExponent({ flow, p }) {
  const { timePower, timePowerAddsP } = flowOf(flow);
  return timePower + (timePowerAddsP ? p : 0);
}

/** Whether times can be compared. @param {readonly Options[]} all */
export const timeUnitsAgree = (all) => new Set(all.map(timeExponent)).size <= 1;

/**
 * Puts the others where they belong beside the first.
 * @param {Track} lead @param {Iterable<Track>} others
 * @param {"progress" | "step" | "time"} lockstep
 */
export function align(lead, others, lockstep) {
  const share = lead.clip.total > 0 ? lead.u / lead.clip.total : 0;
  const { index, share: part } = lead.clip.at(lead.u);
  const [a, b] = [lead.clip.points[index], lead.clip.points[index + 1]];
  for (const other of others) {
    const { points, total } = other.clip;
    if (lockstep === "progress" || !a) {
      other.u = share * total;
      continue;
    }
    const between = b ? b.state[lockstep] - a.state[lockstep] : 0;
    const wanted = a.state[lockstep] + part * between;
    const place = other.clip.at(wanted, ({ state }) => state[lockstep]);
    const [p, q] = [points[place.index], points[place.index + 1]];
    other.u = q ? p.sum + place.share * (q.sum - p.sum) : total;
  }
}

/**
 * How far each vertex is from the same vertex of another surface.
 * @param {Float32Array} a  3 numbers a vertex @param {Float32Array} b
 */
export function distances(a, b) {
  const values = new Float32Array(a.length / 3);
  for (let v = 0, k = 0; v < values.length; v += 1, k += 3) {
    values[v] = Math.hypot(a[k] - b[k], a[k + 1] - b[k + 1], a[k + 2] - b[k + 2]);
  }
  return values;
}

/** What a pane does otherwise, in words. @param {Options} main @param {Partial<Options>} change */
export function sayChange(main, change) {
  const { flow, ...others } = change;
  const parts = Object.entries(others).map(
    ([name, value]) => `${say(`option-${name}`)} ${asText(value, name)}`,
  );
  return [flowLabel(flow ?? main.flow), ...parts].join(", ");
}
