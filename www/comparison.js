// @ts-check
// Flows side by side, as pure functions: what a pane does otherwise than the first, whose turn
// it is to step, and how far surfaces are apart.

/** @import { Configured, State as Reading } from "./generated/types.js" */
/** @import { Field } from "./state.js" */
/** @import { Options } from "./options.js" */
/** @import { Sample } from "./state.js" */

import { t } from "./language.js";
import { asText, flowOf, toFlow } from "./options.js";

/** Panes at most, that of the surface itself among them. */
export const MOST_PANES = 4;

/**
 * A flow beside that of the page, from the same start, with a solver of its own.
 * @typedef {object} Rival
 * @property {number} id                  for as long as its pane is there
 * @property {Partial<Options>} change    what it does otherwise than the first
 * @property {'loading' | 'ready' | 'lost'} phase
 * @property {string} reason              why it is lost, or its last step was refused; else empty
 * @property {Reading | null} reading
 * @property {Configured | null} configured
 * @property {Picture | null} frame
 * @property {readonly Sample[]} history  from the start to the present step
 * @property {readonly number[]} bending  ∫H² dA by step, where it was measured
 */

/**
 * @typedef {{ positions: Float32Array, field: Field | null, flippedTriangles: Uint32Array }} Picture
 */

/** @typedef {'energy' | 'area' | 'volume' | 'angle' | 'bending'} Quantity */

/**
 * @typedef {object} Comparison
 * @property {readonly Rival[]} rivals    panes B, C, D
 * @property {'step' | 'time'} lockstep
 * @property {'side' | number} shown      side by side, or one pane in the place of all
 * @property {number | null} difference   coloured by the distance to this pane
 * @property {Quantity} quantity          plotted …
 * @property {'step' | 'time'} abscissa   … against this
 * @property {readonly number[]} bending  of the first pane, as of a rival
 */

/** @type {Readonly<Comparison>} */
export const alone = Object.freeze({
  rivals: [],
  lockstep: "step",
  shown: "side",
  difference: null,
  quantity: "energy",
  abscissa: "step",
  bending: [],
});

/** @type {Omit<Rival, "id" | "change">} */
export const unborn = Object.freeze({
  phase: "loading",
  reason: "",
  reading: null,
  configured: null,
  frame: null,
  history: [],
  bending: [],
});

/** @param {number} id @param {Rival["change"]} change @returns {Rival} */
export const newRival = (id, change) => ({ ...unborn, id, change });

/** Another mesh: nobody has begun on it. @param {Comparison} comparison @returns {Comparison} */
export const begunAnew = (comparison) => ({
  ...comparison,
  bending: [],
  rivals: comparison.rivals.map(({ id, change }) => newRival(id, change)),
});

/** The page's own flow, among the ids of rivals. */
export const MAIN = 0;

/** What people call a pane. @param {number} index  0 is the surface of the page */
export const letter = (index) => "ABCD"[index];

/** The same by id. @param {Comparison} comparison @param {number} id */
export const paneOf = ({ rivals }, id) =>
  letter(id === MAIN ? 0 : 1 + rivals.findIndex((one) => one.id === id));

/**
 * What a pane does.
 * @param {Options} main  what the first does
 * @param {Partial<Options>} change
 * @returns {Options}
 */
export function optionsOf(main, change) {
  const { flow } = change;
  const isOther = flow !== undefined && flow !== main.flow;
  return { ...main, ...(isOther ? toFlow(flow) : {}), ...change };
}

/**
 * The change that makes the options of the first pane these.
 * @param {Options} main
 * @param {Options} options
 * @returns {Partial<Options>}
 */
export function changeOf(main, options) {
  const base = optionsOf(main, { flow: options.flow });
  const keys = /** @type {(keyof Options)[]} */ (Object.keys(base));
  const differing = keys.filter(
    (key) => key === "flow" || asText(options[key]) !== asText(base[key]),
  );
  const entries = differing
    .filter((key) => key !== "flow" || options.flow !== main.flow)
    .map((key) => [key, options[key]]);
  return Object.fromEntries(entries);
}

/**
 * The same panes, told by how they differ from another first flow.
 * @param {Comparison} comparison @param {Options} from @param {Options} to
 * @returns {Comparison}
 */
export function rebased(comparison, from, to) {
  if (from === to || comparison.rivals.length === 0) return comparison;
  const rivals = comparison.rivals.map((rival) => ({
    ...rival,
    change: changeOf(to, optionsOf(from, rival.change)),
  }));
  return { ...comparison, rivals };
}

/**
 * A flow's time is a length to this power.
 * @param {Options} options
 */
export function timeExponent({ flow, p }) {
  const { timePower, timePowerAddsP } = flowOf(flow);
  return timePower + (timePowerAddsP ? p : 0);
}

/** Whether times can be compared. @param {readonly Options[]} all */
export const timeUnitsAgree = (all) => new Set(all.map(timeExponent)).size <= 1;

/**
 * Where a pane stands.
 * @typedef {{ step: number, time: number, mayStep: boolean }} Standing
 */

/**
 * Whose turn it is: those that are behind all others that may still step.
 * @param {readonly Standing[]} standings
 * @param {Comparison["lockstep"]} lockstep
 * @returns {number[]}  their numbers; none when nobody may step
 */
export function nextTurn(standings, lockstep) {
  const least = standings.reduce(
    (low, { mayStep, [lockstep]: value }) => (mayStep ? Math.min(low, value) : low),
    Infinity,
  );
  return standings.flatMap((one, n) => (one.mayStep && one[lockstep] === least ? [n] : []));
}

/**
 * Who goes a step back: those that are before all others.
 * @param {readonly { step: number, time: number, mayGoBack: boolean }[]} standings
 * @param {Comparison["lockstep"]} lockstep
 * @returns {number[]}
 */
export function lastTurn(standings, lockstep) {
  const most = standings.reduce(
    (high, { mayGoBack, [lockstep]: value }) => (mayGoBack ? Math.max(high, value) : high),
    -Infinity,
  );
  return standings.flatMap((one, n) => (one.mayGoBack && one[lockstep] === most ? [n] : []));
}

/**
 * How far each vertex is from the same vertex of another surface.
 * @param {Float32Array} a  3 numbers a vertex
 * @param {Float32Array} b
 */
export function distances(a, b) {
  const values = new Float32Array(a.length / 3);
  for (let v = 0, k = 0; v < values.length; v += 1, k += 3) {
    const [x, y, z] = [a[k] - b[k], a[k + 1] - b[k + 1], a[k + 2] - b[k + 2]];
    values[v] = Math.sqrt(x * x + y * y + z * z);
  }
  return values;
}

/** @param {Float32Array} values */
function largest(values) {
  let high = 0;
  for (const value of values) if (value > high) high = value;
  return high;
}

/**
 * The colours of all panes, on one scale: their own fields, or their distances to one of them.
 * @param {readonly (Picture | null)[]} pictures
 * @param {number | null} difference
 * @returns {(Field | null)[]}
 */
export function sharedFields(pictures, difference) {
  const base = difference === null ? null : pictures[difference]?.positions;
  if (difference !== null && !base) return pictures.map(() => null);
  if (difference !== null && base) {
    const values = pictures.map((one) =>
      one && one.positions.length === base.length ? distances(one.positions, base) : null,
    );
    const high = Math.max(...values.map((list) => (list ? largest(list) : 0)));
    const label = t("Distance to {pane}", { pane: letter(difference) });
    const scale = /** @type {const} */ ({ name: "distance", label, low: 0, high, signed: false });
    return values.map((list) => list && { ...scale, values: list });
  }
  const fields = pictures.map((one) => one?.field ?? null);
  const known = fields.flatMap((field) => field ?? []);
  const low = Math.min(...known.map((field) => field.low));
  const high = Math.max(...known.map((field) => field.high));
  return fields.map((field) =>
    !field || (field.low === low && field.high === high) ? field : { ...field, low, high },
  );
}
