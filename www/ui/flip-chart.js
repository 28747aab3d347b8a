// @ts-check
// Area and Willmore energy against the number of flips, a curve a criterion, as in figures 7
// and 8 of Brink & Alboul. Fetched when it is needed, with the plotting library.

/** @import { Curves } from "../generated/types.js" */

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { formatShort } from "./number.js";

/** Told apart without colours too. */
const dashes = { area: [], willmore: [7, 4], localised: [2, 3] };

/** With as many digits as tell neighbours apart. @param {number[]} ticks */
function labels(ticks) {
  const step = ticks.length > 1 ? Math.abs(ticks[1] - ticks[0]) : 1;
  const places = Math.min(8, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
  return ticks.map((tick) => (Math.abs(tick) < 1e5 ? tick.toFixed(places) : formatShort(tick)));
}

/** @param {HTMLElement} root @param {Curves["runs"]} runs */
function makePlot(root, runs) {
  const style = () => getComputedStyle(root);
  const colour = (/** @type {string} */ name) => () => style().getPropertyValue(`--curve-${name}`);
  const font = `12px ${style().fontFamily}`;
  const axis = {
    stroke: () => style().color,
    font,
    grid: { stroke: () => style().outlineColor, width: 1 },
    ticks: { show: false },
  };
  return new uPlot(
    {
      width: Math.max(root.clientWidth, 80),
      height: Math.max(root.clientHeight, 80),
      legend: { show: false },
      cursor: { show: false },
      padding: [8, 10, 0, 0],
      scales: { x: { time: false, range: (_, low, high) => [low ?? 0, Math.max(high ?? 0, 5)] } },
      axes: [
        {
          ...axis,
          size: 26,
          gap: 4,
          incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1e3, 2e3, 5e3, 1e4, 1e5],
        },
        { ...axis, size: 56, gap: 6, values: (_, ticks) => labels(ticks) },
      ],
      series: [
        {},
        ...runs.map(({ criterion }) => ({
          stroke: colour(criterion),
          width: 2,
          dash: dashes[criterion],
          points: { show: false },
        })),
      ],
    },
    [[], ...runs.map(() => [])],
    root,
  );
}

/** @param {HTMLElement} root @param {"area" | "circle"} cost */
export function createFlipChart(root, cost) {
  /** @type {uPlot | null} */
  let plot = null;
  let kind = "";
  new ResizeObserver(() => {
    if (root.clientWidth > 0) plot?.setSize({ width: root.clientWidth, height: root.clientHeight });
  }).observe(root);

  return {
    /** @param {Curves} curves */
    show({ flips, runs }) {
      const wanted = runs.map(({ criterion }) => criterion).join();
      if (!plot || wanted !== kind) {
        plot?.destroy();
        kind = wanted;
        plot = makePlot(root, runs);
      }
      const finite = (/** @type {Float64Array} */ values) =>
        Array.from(values, (value) => (Number.isNaN(value) ? null : value));
      plot.setData([Array.from(flips), ...runs.map((run) => finite(run[cost]))]);
    },
    /** Colours come from the style sheet. */
    redraw: () => plot?.redraw(),
  };
}

/** @typedef {ReturnType<typeof createFlipChart>} FlipChart */
