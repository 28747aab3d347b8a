// Plots with full axes: the large curve, against steps or time, linear or logarithmic.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { letter } from "../comparison.js";
import { formatBeside, formatShort } from "../number.js";
import { named } from "../options.js";
import { symbol } from "../status.js";
import { say } from "../words.js";
import { pathOf, thinned } from "./curve.js";
import { page } from "./page.js";
import { into, segmented, select } from "./parts.js";

/** @import { Point } from "../clip.js" */

/** A fall by more than this is easier to read on a logarithmic axis. */
const WIDE = 30;

/** @type {Record<string, (state: Point["state"]) => number | null>} */
const quantities = {
  energy: (state) => state.energy,
  monitored: (state) => state.objective,
  area: (state) => state.area,
  volume: (state) => state.volume,
  angle: (state) => state.minAngleDegrees,
  dt: (state) => state.dt,
};

/** CSS pixels of a page on which letters of the usual drawing would be tiny. */
const NARROW = 700;

const quantity = signal("energy");
const abscissa = signal(/** @type {"step" | "time"} */ ("step"));

/** @param {import("../store.js").View["scale"]} scale @param {readonly number[]} values */
export function isLogarithmic(scale, values) {
  const positive = values.filter((value) => value > 0);
  if (scale === "linear" || positive.length === 0) return false;
  if (scale === "log") return true;
  const high = positive.reduce((a, b) => Math.max(a, b));
  return high / positive.reduce((a, b) => Math.min(a, b)) > WIDE;
}

/** So many numbers at even distances. @param {number} first @param {number} last @param {number} stride */
const every = (first, last, stride) =>
  Array.from(
    { length: Math.max(0, Math.floor((last - first) / stride) + 1) },
    (_, n) => first + n * stride,
  );

/** Round numbers between two. @param {number} low @param {number} high @param {boolean} isLog */
export function ticksOf(low, high, isLog) {
  if (isLog) {
    const [from, to] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
    const stride = Math.max(1, Math.ceil((to - from) / 6));
    return every(from, to, stride).map((exponent) => 10 ** exponent);
  }
  const rough = (high - low || 1) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const stride = ([1, 2, 5, 10].find((one) => one * power >= rough) ?? 10) * power;
  const [from, to] = [Math.ceil(low / stride - 1e-9), Math.floor(high / stride + 1e-9)];
  return every(from, to, 1).map((n) => n * stride);
}

/**
 * Axes with round numbers; where a point lies between them, and what is drawn there.
 * @param {{ size: readonly [number, number], left: number, x: readonly number[], y: readonly number[], isLog?: boolean }} axes
 *   the two ends of each
 */
export function axesOf({ size: [width, height], left, x: [from, to], y: [low, high], isLog }) {
  const [gap, end, bottom] = [30, width - 52, height - 44];
  const scaled = (/** @type {number} */ y) => (isLog ? Math.log(Math.max(y, low)) : y);
  const x = (/** @type {number} */ value) =>
    left + ((end - left) * (value - from)) / (to - from || 1);
  const y = (/** @type {number} */ value) =>
    bottom - ((bottom - gap) * (scaled(value) - scaled(low))) / (scaled(high) - scaled(low) || 1);
  /** @param {string} label @param {string} role @param {unknown} drawn @param {readonly string[]} names  of what is along, and upright */
  const drawing = (label, role, drawn, names) =>
    html`<svg class="large-plot" viewBox="0 0 ${width} ${height}" role=${role} aria-label=${label}>
      ${ticksOf(low, high, isLog ?? false).map((tick) => svg`<line class="grid" x1=${left} x2=${end} y1=${y(tick)} y2=${y(tick)} /><text x=${left - 8} y=${y(tick) + 4} text-anchor="end">${formatShort(tick)}</text>`)}
      ${ticksOf(from, to, false).map((tick) => svg`<text x=${x(tick)} y=${bottom + 20} text-anchor="middle">${formatShort(tick)}</text>`)}
      <line class="axis" x1=${left} x2=${end} y1=${bottom} y2=${bottom} />
      <text class="name" x=${end} y=${bottom + 40} text-anchor="end">${names[0]}</text><text class="name" x="0" y="14">${names[1]}</text>${drawn}</svg>`;
  /** @param {number} value */
  const upright = (value) =>
    svg`<line class="here" x1=${x(value)} x2=${x(value)} y1=${gap} y2=${bottom} />`;
  return { x, y, drawing, upright };
}

export function plot() {
  page.player.tick.value;
  const s = page.state.value;
  const lines = page.tracks().map(({ clip }) =>
    thinned(clip.points).flatMap(({ state }) => {
      const value = quantities[quantity.value](state);
      return value === null ? [] : [[state[abscissa.value], value]];
    }),
  );
  const values = lines.flat().map(([, value]) => value);
  const isLog = isLogarithmic(s.view.scale, values);
  const usable = isLog ? values.filter((value) => value > 0) : values;
  const along = lines.flat().map(([x]) => x);
  const right = Math.max(...along, 1e-12);
  const { x, y, drawing, upright } = axesOf({
    ...{
      size: innerWidth < NARROW ? [380, 360] : [900, 420],
      left: 70,
      x: [Math.min(...along, right), right],
      isLog,
    },
    y: [Math.min(...usable, isLog ? Infinity : 0), Math.max(...usable, isLog ? 0 : 1e-12)],
  });
  const curves = lines.map((list, n) => {
    const points = list.map(([a, b]) => [x(a), y(b)]);
    const [endX, endY] = points.at(-1) ?? [];
    const last = formatBeside(list.at(-1)?.[1], list[0]?.[1] ?? 0);
    return points.length < 2
      ? nothing
      : svg`<path class="pane-${n}" d=${pathOf(points)} /><text class="pane-${n}" x=${endX + 6} y=${endY + 4}>${lines.length > 1 ? letter(n) : ""} ${last}</text>`;
  });
  const shown = page.shown();
  /** @param {string} id */
  const nameOf = (id) => (id === "energy" ? symbol(s) : say(`quantity-${id}`));
  const choices = Object.keys(quantities).map((id) => ({ id, label: nameOf(id) }));
  const names = [say(`against-${abscissa.value}`), nameOf(quantity.value)];
  return html`<div class="row plot-options">
      ${select(say("quantity"), choices, quantity.value, into(quantity))}
      ${segmented(say("against"), named(["step", "time"], "against"), abscissa.value, into(abscissa))}
      ${segmented(say("scale"), named(["auto", "log", "linear"], "scale"), s.view.scale, (scale) => page.run.view({ scale }))}
    </div>
    ${drawing(say("plot-label", { what: say(`quantity-${quantity.value}`) }), "img", [curves, shown ? upright(shown[abscissa.value]) : nothing], names)}`;
}
