// @ts-check
// Goal and method: every option of the flow but those with a place of their own.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { t } from "../language.js";
import { defaults, flowOf, smoothingTau } from "../options.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { chosen, dress, show } from "./option-form.js";

/** @param {Controller} controller */
export function createMethodForm(controller) {
  const form = byId("method-form", HTMLFormElement);
  dress(form);
  const detail = byId("detail", HTMLInputElement);
  const count = byId("option-smoothSteps", HTMLInputElement);
  const tau = byId("tau", HTMLInputElement);
  const tauAuto = byId("tau-auto", HTMLInputElement);
  const detailValue = byId("detail-value", HTMLOutputElement);
  const tauValue = byId("tau-value", HTMLOutputElement);
  const note = byId("step-note", HTMLElement);

  /** Mean edge length at the start, and dt/τ; 0 until a mesh is there. */
  let h = 0;
  let unit = 0;

  /** What the sliders say, while they move and after. @param {Options} options @param {number} [used] τ in force */
  function describe({ flow, goal }, used) {
    const wanted =
      goal === "smooth"
        ? smoothingTau(detail.valueAsNumber, count.valueAsNumber || 1)
        : 10 ** tau.valueAsNumber;
    const length = formatNumber(detail.valueAsNumber * h, 3);
    const edges = detail.valueAsNumber.toFixed(1);
    setText(detailValue, t("L = {edges} mean edge lengths = {length}", { edges, length }));
    setText(tauValue, `τ = ${formatNumber(wanted, 3)}`);
    const value = used ?? wanted;
    const ratio = flowOf(flow).tau;
    const numbers = `τ = ${ratio} = ${formatNumber(value, 3)}, dt = ${formatNumber(value * unit, 3)}`;
    const first = goal === "relax" && tauAuto.checked;
    setText(note, first ? t("First time step: {numbers}", { numbers }) : numbers);
  }

  form.addEventListener("input", () => describe(shown));
  form.addEventListener("change", ({ target }) => {
    const control = /** @type {HTMLInputElement | HTMLSelectElement} */ (target);
    if (!control.reportValidity()) return;
    if (control === tau || control === tauAuto) {
      controller.configure({ tau: tauAuto.checked ? null : 10 ** tau.valueAsNumber, dt: null });
    } else controller.configure({ [control.name]: chosen(form, control.name) });
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  // A value that was refused must not stay beside the one in force.
  form.addEventListener("focusout", ({ target }) => {
    if (target instanceof HTMLInputElement && !target.checkValidity()) restore();
  });
  byId("recommended", HTMLButtonElement).addEventListener("click", () => {
    const { flow, boundary, free, fixed, p, keep } = shown;
    controller.configure({ ...defaults, flow, boundary, free, fixed, p, keep });
  });

  /** @param {Options} options */
  function fill(options) {
    show(form, options);
    // Steps of a fourth-order flow are small next to L⁴, those of the circle flow are not
    // next to h².
    const range = options.flow === "circle" ? [-4, 1.5] : [-8, 2];
    [tau.min, tau.max] = range.map(String);
    tauAuto.checked = options.tau === null;
    if (options.tau !== null) tau.value = String(Math.log10(options.tau));
    if (options.tau === null) byId("tau-field", HTMLElement).hidden = true;
  }

  /** @type {Options} */
  let shown = defaults;
  /** @type {PageState["configured"]} */
  let configured = null;
  const restore = () => fill(shown);
  restore();
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.options === shown && state.configured === configured) return;
      shown = state.options;
      configured = state.configured;
      h = configured?.meanEdgeLength ?? 0;
      unit = configured ? configured.dt / configured.tau : 0;
      fill(shown);
      describe(shown, configured?.tau);
    },
  };
}
