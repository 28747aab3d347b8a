// @ts-check
// The numbers of both plots of edge flips: at most a hundred rows, the first and last among them.

/** @import { Curves } from "../generated/types.js" */

import { t } from "../language.js";
import { choiceLabel } from "../options.js";
import { byId } from "./element.js";
import { formatNumber } from "./number.js";

const MOST = 100;

/** Indices from the first to the last, evenly thinned. @param {number} count */
export function thinned(count) {
  const rows = Math.min(count, MOST);
  return Array.from({ length: rows }, (_, n) =>
    Math.round((n * (count - 1)) / Math.max(rows - 1, 1)),
  );
}

/** @param {string[]} texts @param {"th" | "td"} kind */
function tableRow(texts, kind) {
  const row = document.createElement("tr");
  for (const [n, text] of texts.entries()) {
    const cell = document.createElement(n === 0 ? "th" : kind);
    if (cell instanceof HTMLTableCellElement && (n === 0 || kind === "th")) {
      cell.scope = kind === "th" ? "col" : "row";
    }
    cell.textContent = text;
    row.append(cell);
  }
  return row;
}

export function createFlipTable() {
  const section = byId("flip-data", HTMLDetailsElement);
  const head = byId("flip-data-head", HTMLTableSectionElement);
  const rows = byId("flip-data-rows", HTMLTableSectionElement);
  /** @type {Curves | null} */
  let curves = null;
  /** @type {Curves | null} */
  let shown = null;

  function fill() {
    if (!section.open || !curves || curves === shown) return;
    shown = curves;
    const { flips, runs } = curves;
    const titles = runs.flatMap(({ criterion }) => {
      const by = choiceLabel("criterion", criterion);
      return [
        t("Area by {criterion}", { criterion: by }),
        t("W by {criterion}", { criterion: by }),
      ];
    });
    head.replaceChildren(tableRow([t("Flips"), ...titles], "th"));
    rows.replaceChildren(
      ...thinned(flips.length).map((n) => {
        const numbers = runs.flatMap(({ area, circle }) => [
          formatNumber(area[n], 6),
          formatNumber(circle[n], 5),
        ]);
        return tableRow([String(flips[n]), ...numbers], "td");
      }),
    );
  }
  section.addEventListener("toggle", fill);

  return {
    /** @param {Curves} now */
    show(now) {
      curves = now;
      fill();
    },
  };
}
