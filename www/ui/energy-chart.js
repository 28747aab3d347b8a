// @ts-check
// The plot itself, a file of its own because uPlot weighs more than the rest of the page:
// it is fetched after the first picture.

/** @import { PageState, Sample } from "../state.js" */

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { formatShort } from "./number.js";

/** A fall by more than this is easier to read on a logarithmic axis. */
const WIDE = 30;

/** @param {PageState["view"]["scale"]} scale @param {readonly number[]} values */
export function isLogarithmic(scale, values) {
  const positive = values.filter((value) => value > 0);
  if (scale === "linear" || positive.length === 0) return false;
  if (scale === "log") return true;
  const high = positive.reduce((a, b) => Math.max(a, b));
  return high / positive.reduce((a, b) => Math.min(a, b)) > WIDE;
}

/** Powers of ten, at most six. @param {number} low @param {number} high */
function decades(low, high) {
  const [from, to] = [Math.ceil(Math.log10(low) - 1e-9), Math.floor(Math.log10(high) + 1e-9)];
  const stride = Math.max(1, Math.ceil((to - from) / 5));
  const count = Math.max(0, Math.floor((to - from) / stride) + 1);
  return Array.from({ length: count }, (_, i) => 10 ** (to - i * stride)).reverse();
}

/**
 * @typedef {object} Line
 * @property {() => string} stroke
 * @property {number[]} [dash]    of more than one, told apart without colours too
 */

/** @param {HTMLElement} root @param {boolean} logarithmic @param {readonly Line[]} lines @param {boolean} [byStep] */
export function makePlot(root, logarithmic, lines, byStep = true) {
  // Colours come from the style sheet through properties the element does not use itself.
  const style = () => getComputedStyle(root);
  const text = () => style().color;
  const rules = () => style().outlineColor;
  const font = `12px ${style().fontFamily}`;
  const axis = { stroke: text, font, grid: { stroke: rules, width: 1 }, ticks: { show: false } };
  return new uPlot(
    {
      width: Math.max(root.clientWidth, 80),
      height: Math.max(root.clientHeight, 80),
      legend: { show: false },
      cursor: { show: false },
      padding: [10, 10, 0, 0],
      scales: {
        x: {
          time: false,
          range: (_, low, high) => [
            low ?? 0,
            byStep ? Math.max(high ?? 0, (low ?? 0) + 5) : high || 1,
          ],
        },
        y: logarithmic ? { distr: 3 } : {},
      },
      axes: [
        {
          ...axis,
          size: 26,
          gap: 4,
          ...(byStep
            ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1e3, 1e4, 1e5, 1e6] }
            : {
                values: (/** @type {uPlot} */ _, /** @type {number[]} */ ticks) =>
                  ticks.map(formatShort),
              }),
        },
        {
          ...axis,
          size: 52,
          gap: 6,
          // Between the decades uPlot would draw a line for every digit.
          ...(logarithmic
            ? {
                splits: (/** @type {uPlot} */ _, /** @type {number} */ __, low, high) =>
                  decades(low, high),
                filter: (/** @type {uPlot} */ _, /** @type {number[]} */ ticks) => ticks,
                grid: { ...axis.grid, filter: (_, ticks) => ticks },
              }
            : {}),
          values: (_, ticks) => ticks.map((tick) => (tick === null ? "" : formatShort(tick))),
        },
      ],
      series: [
        {},
        ...lines.map(({ stroke, dash }) => ({
          ...{ stroke, dash, width: 2 },
          points: { show: dash ? false : undefined, size: 5, fill: stroke },
          // Steps by time of one pane are not those of another.
          spanGaps: true,
        })),
      ],
    },
    [[], ...lines.map(() => [])],
    root,
  );
}

/** The energy, and dashed what never rises. @param {HTMLElement} root @returns {Line[]} */
const styles = (root) => [
  { stroke: () => getComputedStyle(root).borderTopColor },
  { stroke: () => getComputedStyle(root).color, dash: [5, 4] },
];

/** @param {HTMLElement} root */
export function createEnergyChart(root) {
  /** @type {uPlot | null} */
  let plot = null;
  let logarithmic = false;
  let lines = 0;

  new ResizeObserver(() => {
    if (root.clientWidth > 0) plot?.setSize({ width: root.clientWidth, height: root.clientHeight });
  }).observe(root);

  return {
    /**
     * @param {readonly Sample[]} history
     * @param {PageState["view"]["scale"]} scale
     * @param {boolean} isDouble  whether the functional that never rises has a curve of its own
     */
    show(history, scale, isDouble) {
      const curves = [history.map(({ energy }) => energy)];
      if (isDouble) curves.push(history.map(({ objective }) => objective));
      const wanted = isLogarithmic(scale, curves.flat());
      if (!plot || wanted !== logarithmic || curves.length !== lines) {
        plot?.destroy();
        logarithmic = wanted;
        lines = curves.length;
        plot = makePlot(root, logarithmic, styles(root).slice(0, lines));
      }
      const shown = curves.map((values) =>
        values.map((value) => (logarithmic && value <= 0 ? null : value)),
      );
      const steps = history.map(({ step }) => step);
      // Room for the first few steps, so that the axis does not jump with each.
      const first = steps[0] ?? 0;
      plot.setData([steps, ...shown], false);
      plot.setScale("x", { min: first, max: Math.max(steps.at(-1) ?? 0, first + 5) });
    },
  };
}

/** @typedef {ReturnType<typeof createEnergyChart>} EnergyChart */
