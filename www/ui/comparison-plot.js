// @ts-check
// One quantity of all panes against steps or time: as curves, a legend in words and a table.

/** @import { Quantity } from "../comparison.js" */
/** @import { PageState, Sample } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { ComparisonChart, Curve } from "./comparison-chart.js" */

import { letter, optionsOf } from "../comparison.js";
import { t } from "../language.js";
import { differences } from "./comparison-words.js";
import { byId, fillSelect, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** As in the chart, for the legend: lengths of line and gap. */
const dashes = ["", "7 4", "2 3", "9 3 2 3"];

/** @returns {{ id: Quantity, label: string }[]} */
const quantities = () => [
  { id: "energy", label: t("Each flow’s own energy") },
  { id: "bending", label: t("∫H² dA, for all alike") },
  { id: "area", label: t("Area") },
  { id: "volume", label: t("Volume") },
  { id: "angle", label: t("Smallest angle, degrees") },
];

/** @param {Quantity} quantity @param {Sample} sample @param {readonly number[]} bending @returns {number | null} */
function measuredOf(quantity, sample, bending) {
  switch (quantity) {
    case "energy":
      return sample.energy;
    case "area":
      return sample.area;
    case "volume":
      return sample.volume;
    case "angle":
      return sample.minAngleDegrees;
    case "bending":
      return bending[sample.step] ?? null;
  }
}

/**
 * @typedef {{ step: number, time: number, value: number | null }} Point
 * @param {Readonly<PageState>} state
 * @returns {Point[][]} of each pane
 */
export function curvesOf({ history, comparison }) {
  const { rivals, bending, quantity } = comparison;
  return [{ history, bending }, ...rivals].map((one) =>
    one.history.map((sample) => ({
      step: sample.step,
      time: sample.time,
      value: measuredOf(quantity, sample, one.bending),
    })),
  );
}

/** @param {Readonly<PageState>} state */
function quantityNote({ options, comparison }) {
  const all = [options, ...comparison.rivals.map(({ change }) => optionsOf(options, change))];
  if (comparison.quantity === "bending") {
    return t("The Willmore energy ∫H² dA by cotangents, the same for every flow: 4π for a sphere.");
  }
  if (comparison.quantity !== "energy") return "";
  const kinds = new Set(all.map(({ flow, p }) => (flow === "p-willmore" ? `${flow} ${p}` : flow)));
  return kinds.size > 1
    ? t("These flows have different energies: compare their course, and values by ∫H² dA.")
    : "";
}

/** A table row of texts. @param {string[]} texts @param {"td" | "th"} kind */
function row(texts, kind) {
  const element = document.createElement("tr");
  for (const text of texts) {
    const cell = document.createElement(kind);
    if (cell instanceof HTMLTableCellElement && kind === "th") cell.scope = "col";
    cell.textContent = text;
    element.append(cell);
  }
  return element;
}

/** @param {number} n */
function swatch(n) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
  svg.setAttribute("viewBox", "0 0 32 10");
  svg.setAttribute("aria-hidden", "true");
  svg.dataset.curve = String(n);
  line.setAttribute("d", "M0 5h32");
  line.setAttribute("stroke-dasharray", dashes[n]);
  svg.append(line);
  return svg;
}

/** @param {Controller} controller */
export function createComparisonPlot(controller) {
  const root = byId("comparison-plot", HTMLElement);
  const legend = byId("comparison-legend", HTMLUListElement);
  const quantity = byId("quantity", HTMLSelectElement);
  const note = byId("quantity-note", HTMLElement);
  const abscissa = byId("abscissa", HTMLSelectElement);
  const data = byId("comparison-data", HTMLDetailsElement);
  const head = byId("comparison-head", HTMLTableSectionElement);
  const rows = byId("comparison-rows", HTMLTableSectionElement);
  fillSelect(quantity, quantities());

  quantity.addEventListener("change", () =>
    controller.plotPanes({ quantity: /** @type {Quantity} */ (quantity.value) }),
  );
  abscissa.addEventListener("change", () =>
    controller.plotPanes({ abscissa: abscissa.value === "time" ? "time" : "step" }),
  );
  data.addEventListener("toggle", () => draw());

  /** @type {ComparisonChart | null} */
  let chart = null;
  let asked = false;
  /** @type {Readonly<PageState> | null} */
  let shown = null;
  let waiting = false;

  async function open() {
    asked = true;
    try {
      const { createComparisonChart } = await import("./comparison-chart.js");
      chart = createComparisonChart(root);
      draw();
    } catch (error) {
      // The table has the same numbers.
      controller.report(error);
    }
  }

  /** @param {Point[][]} curves */
  function fillTable(curves) {
    const byTime = shown?.comparison.abscissa === "time";
    head.replaceChildren(row([t("Step"), ...curves.map((_, n) => letter(n))], "th"));
    const steps = [...new Set(curves.flatMap((curve) => curve.map(({ step }) => step)))];
    steps.sort((a, b) => a - b);
    const found = curves.map((curve) => new Map(curve.map((point) => [point.step, point])));
    const texts = steps.map((step) => [
      String(step),
      ...found.map((points) => {
        const point = points.get(step);
        if (!point) return "–";
        const value = formatNumber(point.value, 6);
        return byTime
          ? t("{value} at {time}", { value, time: formatNumber(point.time, 4) })
          : value;
      }),
    ]);
    // Rows that still hold are kept.
    let same = 0;
    const holds = (/** @type {number} */ n) =>
      n < rows.rows.length &&
      rows.rows[n].cells.length === texts[n].length &&
      texts[n].every((text, k) => rows.rows[n].cells[k].textContent === text);
    while (same < texts.length && holds(same)) same += 1;
    while (rows.rows.length > same) rows.deleteRow(-1);
    rows.append(...texts.slice(same).map((list) => row(list, "td")));
  }

  function draw() {
    waiting = false;
    if (!shown || shown.comparison.rivals.length === 0) return;
    const curves = curvesOf(shown);
    if (data.open) fillTable(curves);
    const byStep = shown.comparison.abscissa === "step";
    /** @type {Curve[]} */
    const points = curves.map((curve) => ({
      x: curve.map(({ step, time }) => (byStep ? step : time)),
      y: curve.map(({ value }) => value),
    }));
    chart?.show(points, shown.view.scale, byStep);
  }

  /** @param {Readonly<PageState>} state */
  function describe(state) {
    const { options, comparison } = state;
    const words = differences(
      options,
      comparison.rivals.map(({ change }) => change),
    );
    const texts = words.map((text, n) => `${letter(n)}: ${text}`);
    if (texts.join("\n") !== [...legend.children].map((item) => item.textContent).join("\n")) {
      legend.replaceChildren(
        ...texts.map((text, n) => {
          const item = document.createElement("li");
          item.append(swatch(n), text);
          return item;
        }),
      );
    }
    quantity.value = comparison.quantity;
    abscissa.value = comparison.abscissa;
    setText(note, quantityNote(state));
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const before = shown;
      shown = state;
      const { comparison, history, view, options } = state;
      if (comparison.rivals.length === 0) return;
      if (!asked) open();
      const same =
        comparison === before?.comparison && history === before.history && view === before.view;
      if (comparison !== before?.comparison || options !== before.options) describe(state);
      if (same || waiting) return;
      // A turn changes the state a few times.
      waiting = true;
      requestAnimationFrame(draw);
    },
  };
}
