// @ts-check
// Energy against step number, as a plot and as a table.

/** @import { PageState, Sample } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { EnergyChart } from "./energy-chart.js" */

import { byId } from "./element.js";
import { formatNumber } from "./number.js";

/** @param {Sample} sample */
function tableRow(sample) {
  const row = document.createElement("tr");
  const { step, time, dt, energy, objective } = sample;
  for (const text of [
    String(step),
    formatNumber(time),
    formatNumber(dt, 4),
    formatNumber(energy, 6),
    formatNumber(objective, 6),
  ]) {
    row.insertCell().textContent = text;
  }
  return row;
}

/**
 * @param {Controller} controller
 * @param {Promise<unknown>} pictured  settled once the viewer is there, or will never be
 */
export function createEnergyPlot(controller, pictured) {
  const root = byId("plot", HTMLElement);
  const rows = byId("plot-rows", HTMLTableSectionElement);
  const table = /** @type {HTMLTableElement} */ (rows.parentElement);
  const scale = byId("scale", HTMLSelectElement);
  scale.addEventListener("change", () =>
    controller.view({ scale: /** @type {PageState["view"]["scale"]} */ (scale.value) }),
  );

  /** @type {EnergyChart | null} */
  let chart = null;
  /** @type {Readonly<PageState> | null} */
  let shown = null;

  /** Keeps the rows that still hold. @param {readonly Sample[]} history */
  function fillTable(history) {
    const before = shown?.history ?? [];
    let same = 0;
    while (same < before.length && before[same] === history[same]) same += 1;
    while (rows.rows.length > same) rows.deleteRow(-1);
    rows.append(...history.slice(same).map(tableRow));
  }

  /** Under the circle flow what is printed is not what never rises. @param {Readonly<PageState>} state */
  const isDouble = ({ options }) => options.flow === "circle";
  /** @param {Readonly<PageState>} state */
  const draw = (state) => chart?.show(state.history, state.view.scale, isDouble(state));

  let asked = false;
  /** Fetches the chart after the first picture, which it would otherwise hold up. */
  async function open() {
    asked = true;
    await pictured;
    // The frame in which the viewer draws, and the next.
    for (let i = 0; i < 2; i += 1) await new Promise(requestAnimationFrame);
    try {
      const { createEnergyChart } = await import("./energy-chart.js");
      chart = createEnergyChart(root);
      if (shown) draw(shown);
    } catch (error) {
      // The table has the same numbers.
      controller.report(error);
    }
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const { history, view } = state;
      // A link brings its own.
      if (scale.value !== view.scale) scale.value = view.scale;
      if (history.length > 0 && !asked) open();
      const same =
        history === shown?.history && view === shown.view && state.options === shown.options;
      table.classList.toggle("single", !isDouble(state));
      if (history !== shown?.history) fillTable(history);
      shown = state;
      // A change of the view may be one of colours, which come from the style sheet.
      if (!same) draw(state);
    },
  };
}
