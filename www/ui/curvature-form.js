// @ts-check
// What is special to the flows by mean curvature and its derivatives: a smooth first guess,
// all four beside each other, and how mean curvature jumps where the patch ends.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { t, translated } from "../language.js";
import { byCurvature, defaults, flowLabel } from "../options.js";
import { standings } from "../standing.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { chosen, show } from "./option-form.js";

/** @param {import("../generated/types.js").CurvatureJump | null | undefined} jump */
export const jumpText = (jump) => (jump ? formatNumber(jump.relative, 3) : "–");

/** @param {Controller} controller */
export function createCurvatureForm(controller) {
  const form = byId("curvature", HTMLFormElement);
  const beside = byId("beside", HTMLInputElement);
  const jump = byId("jump", HTMLElement);
  const table = byId("flows-table", HTMLTableElement);
  const rows = byId("flows-rows", HTMLTableSectionElement);

  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("change", ({ target }) => {
    const control = /** @type {HTMLInputElement} */ (target);
    if (control === beside) controller.arrange({ compare: beside.checked ? "flows" : "none" });
    else controller.configure({ [control.name]: chosen(form, control.name) });
  });

  /** @param {Readonly<PageState>} state */
  function describe({ frame, reading }) {
    const measured = frame?.jump;
    setText(
      jump,
      measured
        ? t(
            "Jump of H where the patch ends: {jump} of H outside, root mean square over {vertices} vertices.",
            { jump: formatNumber(measured.relative, 3), vertices: measured.vertices },
          )
        : t("No jump of H to measure: no patch ends next to what is held, or it is too small."),
    );
    const panes = (frame?.panes ?? []).filter(({ state }) => state !== null);
    table.hidden = panes.length === 0 || !reading;
    rows.replaceChildren(
      ...panes.map(({ name, state, jump }) => {
        const row = document.createElement("tr");
        const head = document.createElement("th");
        head.scope = "row";
        head.textContent = flowLabel(name);
        row.append(head);
        const standing = translated(standings[state?.status ?? "ready"]);
        for (const text of [String(state?.step), jumpText(jump), standing]) {
          row.insertCell().textContent = text;
        }
        return row;
      }),
    );
  }

  /** @type {Options} */
  let shown = defaults;
  /** @type {PageState["frame"]} */
  let frame = null;
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.options !== shown) {
        shown = state.options;
        show(form, shown);
        form.hidden = !byCurvature.includes(shown.flow);
      }
      const all = state.arrangement.compare === "flows";
      if (beside.checked !== all) beside.checked = all;
      if (state.frame !== frame && !form.hidden) {
        frame = state.frame;
        describe(state);
      }
    },
  };
}
