// @ts-check
// The curves of all panes in one plot. Fetched when it is needed, with the plotting library.

/** @import { PageState } from "../state.js" */

import uPlot from "uplot";
import { isLogarithmic, makePlot } from "./energy-chart.js";

/** Told apart without colours too. @type {readonly (number[] | undefined)[]} */
export const dashes = [undefined, [7, 4], [2, 3], [9, 3, 2, 3]];

/** @typedef {{ x: number[], y: (number | null)[] }} Curve */

/** @param {HTMLElement} root */
export function createComparisonChart(root) {
  /** @type {uPlot | null} */
  let plot = null;
  let kind = "";
  new ResizeObserver(() => {
    if (root.clientWidth > 0) plot?.setSize({ width: root.clientWidth, height: root.clientHeight });
  }).observe(root);

  /** @param {number} n */
  const line = (n) => ({
    stroke: () => getComputedStyle(root).getPropertyValue(`--curve-${n}`),
    dash: dashes[n],
  });

  return {
    /** @param {readonly Curve[]} curves @param {PageState["view"]["scale"]} scale @param {boolean} byStep */
    show(curves, scale, byStep) {
      const values = curves.flatMap(({ y }) => y.filter((value) => value !== null));
      const logarithmic = isLogarithmic(scale, values);
      const wanted = `${curves.length} ${logarithmic} ${byStep}`;
      if (!plot || wanted !== kind) {
        plot?.destroy();
        kind = wanted;
        plot = makePlot(
          root,
          logarithmic,
          curves.map((_, n) => line(n)),
          byStep,
        );
      }
      const tables = curves.map(({ x, y }) => {
        const shown = y.map((value) => (logarithmic && (value ?? 0) <= 0 ? null : value));
        return /** @type {uPlot.AlignedData} */ ([x, shown]);
      });
      const joined = uPlot.join(tables);
      plot.setData(joined, false);
      const ends = curves.flatMap(({ x }) => [x[0] ?? 0, x.at(-1) ?? 0]);
      const [low, high] = [Math.min(...ends), Math.max(...ends)];
      // Room for the first few steps, so that the axis does not jump with each.
      plot.setScale("x", { min: low, max: byStep ? Math.max(high, low + 5) : high || 1 });
    },
    /** Colours come from the style sheet. */
    redraw: () => plot?.redraw(),
  };
}

/** @typedef {ReturnType<typeof createComparisonChart>} ComparisonChart */
