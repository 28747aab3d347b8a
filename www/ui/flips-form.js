// @ts-check
// What is special to edge flips: criterion, length of a step, what stands beside it, and
// what becomes of the mesh; with a table of where each criterion stands.

/** @import { FlipReading } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { t } from "../language.js";
import { choiceLabel, defaults, plainArrangement, rowOf } from "../options.js";
import { byId } from "./element.js";
import { formatNumber } from "./number.js";
import { chosen, dress, show } from "./option-form.js";

/** @param {string} text */
function cell(text) {
  const element = document.createElement("td");
  element.textContent = text;
  return element;
}

/** @param {string} name @param {string} label @param {string[]} numbers */
function row(name, label, numbers) {
  const element = document.createElement("tr");
  const head = document.createElement("th");
  head.scope = "row";
  head.textContent = label;
  element.dataset.curve = name;
  element.append(head, ...numbers.map(cell));
  return element;
}

/** @param {FlipReading} reading */
const runRow = ({ criterion, flips, rejected, area, circle }) =>
  row(criterion, choiceLabel("criterion", criterion), [
    String(flips),
    String(rejected),
    formatNumber(area, 6),
    formatNumber(circle, 5),
  ]);

/** @param {Controller} controller */
export function createFlipsForm(controller) {
  const form = byId("flips", HTMLFormElement);
  const perStep = byId("flips-per-step", HTMLSelectElement);
  const compare = byId("compare", HTMLSelectElement);
  const subdivide = byId("subdivide", HTMLSelectElement);
  const rows = byId("flips-rows", HTMLTableSectionElement);
  dress(form);

  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("change", ({ target }) => {
    const control = /** @type {HTMLInputElement | HTMLSelectElement} */ (target);
    if (control === perStep) {
      controller.arrange({ flipsPerStep: perStep.value === "all" ? null : Number(perStep.value) });
    } else if (control === compare) {
      controller.arrange({ compare: /** @type {any} */ (compare.value) });
    } else if (control === subdivide) controller.arrange({ subdivide: Number(subdivide.value) });
    else controller.configure({ [control.name]: chosen(form, control.name) });
  });
  byId("flips-end", HTMLButtonElement).addEventListener("click", () => controller.finish());

  /** @param {Readonly<PageState>} state */
  function fillTable({ frame, reading }) {
    const first = frame?.curves?.runs[0];
    const start =
      first &&
      row("start", t("Start"), [
        "0",
        "",
        formatNumber(first.area[0], 6),
        formatNumber(first.circle[0], 5),
      ]);
    const order = rowOf("criterion").ids;
    const runs = [...(reading?.flips ?? [])].sort(
      (a, b) => order.indexOf(a.criterion) - order.indexOf(b.criterion),
    );
    rows.replaceChildren(...(start ? [start] : []), ...runs.map(runRow));
  }

  /** @type {Options} */
  let shown = defaults;
  /** @type {PageState["arrangement"] | null} */
  let arrangement = null;
  /** @type {PageState["frame"]} */
  let frame = null;
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.options !== shown) {
        shown = state.options;
        show(form, shown);
        form.hidden = shown.flow !== "flips";
      }
      if (state.arrangement !== arrangement) {
        arrangement = state.arrangement;
        const { flipsPerStep } = arrangement;
        perStep.value = flipsPerStep === null ? "all" : String(flipsPerStep);
        // A number from a link that is not on offer.
        if (perStep.selectedIndex < 0) perStep.value = String(plainArrangement.flipsPerStep);
        compare.value = arrangement.compare;
        subdivide.value = String(arrangement.subdivide);
      }
      if (state.frame !== frame && !form.hidden) {
        frame = state.frame;
        fillTable(state);
      }
    },
  };
}
