// @ts-check
// Both plots of edge flips, and their numbers as a table.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { FlipChart } from "./flip-chart.js" */

import { byId } from "./element.js";
import { createFlipTable } from "./flip-table.js";

/** @param {Controller} controller */
export function createFlipPlots(controller) {
  const table = createFlipTable();
  const roots = [byId("flip-area", HTMLElement), byId("flip-energy", HTMLElement)];
  /** @type {FlipChart[]} */
  let charts = [];
  let asked = false;
  /** @type {NonNullable<PageState["frame"]>["curves"]} */
  let curves = null;
  /** @type {PageState["view"] | null} */
  let view = null;

  async function open() {
    asked = true;
    try {
      const { createFlipChart } = await import("./flip-chart.js");
      charts = [createFlipChart(roots[0], "area"), createFlipChart(roots[1], "circle")];
      if (curves) for (const chart of charts) chart.show(curves);
    } catch (error) {
      // The table has the same numbers.
      controller.report(error);
    }
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const next = state.frame?.curves ?? null;
      if (next && next !== curves) {
        curves = next;
        table.show(next);
        if (!asked) open();
        for (const chart of charts) chart.show(next);
      } else if (state.view !== view) for (const chart of charts) chart.redraw();
      view = state.view;
    },
  };
}
