// @ts-check
// The curve with full axes: against steps or time, linear or logarithmic.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { letter } from "../comparison.js";
import { formatShort } from "../number.js";
import { symbol } from "../status.js";
import { say } from "../words.js";
import { pathOf, thinned } from "./curve.js";
import { into, segmented, select } from "./parts.js";

/** @import { Page } from "../actions.js" */
/** @import { Point } from "../clip.js" */

/** A fall by more than this is easier to read on a logarithmic axis. */
const WIDE = 30;
const [WIDTH, HEIGHT, LEFT, BOTTOM, GAP] = [900, 420, 70, 380, 14];

/** @type {Record<string, (state: Point["state"]) => number | null>} */
const quantities = {
  energy: (state) => state.energy,
  monitored: (state) => state.objective,
  area: (state) => state.area,
  volume: (state) => state.volume,
  angle: (state) => state.minAngleDegrees,
  dt: (state) => state.dt,
};

const quantity = signal("energy");
const abscissa = signal("step");

/** @param {import("../store.js").View["scale"]} scale @param {readonly number[]} values */
export function isLogarithmic(scale, values) {
  const positive = values.filter((value) => value > 0);
  if (scale === "linear" || positive.length === 0) return false;
  if (scale === "log") return true;
  const high = positive.reduce((a, b) => Math.max(a, b));
  return high / positive.reduce((a, b) => Math.min(a, b)) > WIDE;
}

/** Round numbers between two. @param {number} low @param {number} high @param {boolean} isLog */
export function ticksOf(low, high, isLog) {
  if (isLog) {
    const [from, to] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
    const stride = Math.max(1, Math.ceil((to - from) / 6));
    return Array.from(
      { length: Math.max(0, Math.floor((to - from) / stride) + 1) },
      (_, n) => 10 ** (from + n * stride),
    );
  }
  const rough = (high - low || 1) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const stride = ([1, 2, 5, 10].find((one) => one * power >= rough) ?? 10) * power;
  const first = Math.ceil(low / stride - 1e-9);
  return Array.from(
    { length: Math.floor(high / stride + 1e-9) - first + 1 },
    (_, n) => (first + n) * stride,
  );
}

/** @param {Page} page */
export function plot(page) {
  page.player.tick.value;
  const s = page.state.value;
  const of = quantities[quantity.value];
  const tracks = [page.lead, ...page.rivals.values()];
  const lines = tracks.map(({ clip }) =>
    thinned(clip.points).flatMap(({ state }) => {
      const value = of(state);
      return value === null ? [] : [[abscissa.value === "time" ? state.time : state.step, value]];
    }),
  );
  const values = lines.flat().map(([, value]) => value);
  const isLog = isLogarithmic(s.view.scale, values);
  const usable = isLog ? values.filter((value) => value > 0) : values;
  const low = Math.min(...usable, isLog ? Infinity : 0);
  const high = Math.max(...usable, isLog ? 0 : 1e-12);
  const right = Math.max(...lines.flat().map(([x]) => x), 1e-12);
  const left = Math.min(...lines.flat().map(([x]) => x), right);
  const f = (/** @type {number} */ value) => (isLog ? Math.log(Math.max(value, low)) : value);
  const y = (/** @type {number} */ value) =>
    BOTTOM - ((BOTTOM - GAP) * (f(value) - f(low))) / (f(high) - f(low) || 1);
  const x = (/** @type {number} */ value) =>
    LEFT + ((WIDTH - LEFT - GAP) * (value - left)) / (right - left || 1);
  const shown = page.shown();
  const here = shown && (abscissa.value === "time" ? shown.time : shown.step);
  const names = Object.keys(quantities).map((id) => ({
    id,
    label: id === "energy" ? `${say("reading-energy")} ${symbol(s)}` : say(`quantity-${id}`),
  }));
  const scales = ["auto", "log", "linear"].map((id) => ({ id, label: say(`scale-${id}`) }));
  return html`<div class="row plot-options">
      ${select(say("quantity"), names, quantity.value, into(quantity))}
      ${segmented(
        say("against"),
        ["step", "time"].map((id) => ({ id, label: say(`against-${id}`) })),
        abscissa.value,
        into(abscissa),
      )}
      ${segmented(say("scale"), scales, s.view.scale, (id) => page.run.view({ scale: /** @type {any} */ (id) }))}
    </div>
    <svg class="large-plot" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label=${say("plot-label", { what: say(`quantity-${quantity.value}`) })}>
      ${ticksOf(low, high, isLog).map((tick) => svg`<line class="grid" x1=${LEFT} x2=${WIDTH - GAP} y1=${y(tick)} y2=${y(tick)} /><text x=${LEFT - 8} y=${y(tick) + 4} text-anchor="end">${formatShort(tick)}</text>`)}
      ${ticksOf(left, right, false).map((tick) => svg`<text x=${x(tick)} y=${BOTTOM + 20} text-anchor="middle">${formatShort(tick)}</text>`)}
      <line class="axis" x1=${LEFT} x2=${WIDTH - GAP} y1=${BOTTOM} y2=${BOTTOM} />
      ${lines.map((list, n) => (list.length < 2 ? nothing : svg`<path class="pane-${n}" d=${pathOf(list.map(([a, b]) => [x(a), y(b)]))} /><text class="pane-${n}" x=${x(list[list.length - 1][0])} y=${y(list[list.length - 1][1]) - 8} text-anchor="end">${lines.length > 1 ? letter(n) : ""}</text>`))}
      ${here === null || here === undefined ? nothing : svg`<line class="here" x1=${x(here)} x2=${x(here)} y1=${GAP} y2=${BOTTOM} />`}
    </svg>`;
}
