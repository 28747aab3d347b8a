// @ts-check
// Goal and method: every option of the flow but those with a select of their own.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { defaults, smoothingTau } from "../options.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** @param {Controller} controller */
export function createMethodForm(controller) {
  const form = byId("method-form", HTMLFormElement);
  const detail = byId("detail", HTMLInputElement);
  const count = byId("smooth-count", HTMLInputElement);
  const tau = byId("tau", HTMLInputElement);
  const tauAuto = byId("tau-auto", HTMLInputElement);
  const detailValue = byId("detail-value", HTMLOutputElement);
  const tauValue = byId("tau-value", HTMLOutputElement);
  const note = byId("step-note", HTMLElement);

  /** Mean edge length at the start; 0 until a mesh is there. */
  let h = 0;

  /** What the sliders say, while they move and after. @param {Options} options @param {number} [used] τ in force */
  function describe({ goal }, used) {
    const wanted =
      goal === "smooth"
        ? smoothingTau(detail.valueAsNumber, count.valueAsNumber || 1)
        : 10 ** tau.valueAsNumber;
    const length = formatNumber(detail.valueAsNumber * h, 3);
    setText(detailValue, `L = ${detail.valueAsNumber.toFixed(1)} mean edge lengths = ${length}`);
    setText(tauValue, `τ = ${formatNumber(wanted, 3)}`);
    const value = used ?? wanted;
    const numbers = `τ = dt/h² = ${formatNumber(value, 3)}, dt = ${formatNumber(value * h * h, 3)}`;
    const first = goal === "relax" && tauAuto.checked;
    setText(note, first ? `First time step: ${numbers}` : numbers);
  }

  /** @param {string} name @returns {any} the value of a control that was changed */
  function chosen(name) {
    const control = form.elements.namedItem(name);
    if (control instanceof HTMLInputElement && control.type === "checkbox") return control.checked;
    if (control instanceof HTMLInputElement) return control.valueAsNumber;
    return /** @type {RadioNodeList | HTMLSelectElement} */ (control)?.value;
  }

  form.addEventListener("input", () => describe(shown));
  form.addEventListener("change", ({ target }) => {
    const control = /** @type {HTMLInputElement | HTMLSelectElement} */ (target);
    if (!control.reportValidity()) return;
    if (control === tau || control === tauAuto) {
      controller.configure({ tau: tauAuto.checked ? null : 10 ** tau.valueAsNumber, dt: null });
    } else controller.configure({ [control.name]: chosen(control.name) });
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  byId("recommended", HTMLButtonElement).addEventListener("click", () => {
    const { flow, boundary, free, fixed } = shown;
    controller.configure({ ...defaults, flow, boundary, free, fixed });
  });

  /** @param {Options} options */
  function fill(options) {
    /** @type {Record<string, unknown>} */
    const values = { ...options };
    for (const control of form.elements) {
      if (control instanceof HTMLInputElement && control.name in values) {
        const value = values[control.name];
        if (control.type === "radio") control.checked = control.value === value;
        else if (control.type === "checkbox") control.checked = value === true;
        else control.value = String(value);
      } else if (control instanceof HTMLSelectElement) control.value = String(values[control.name]);
    }
    tauAuto.checked = options.tau === null;
    if (options.tau !== null) tau.value = String(Math.log10(options.tau));
    form.dataset.goal = options.goal;
    form.dataset.manual = String(options.tau !== null);
    for (const part of form.querySelectorAll("[data-goal]")) {
      const belongs = /** @type {HTMLElement} */ (part).dataset.goal === options.goal;
      const manual = part.hasAttribute("data-manual") && options.tau === null;
      /** @type {HTMLElement} */ (part).hidden = !belongs || manual;
    }
  }

  /** @type {Options} */
  let shown = defaults;
  /** @type {PageState["configured"]} */
  let configured = null;
  fill(shown);
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.options === shown && state.configured === configured) return;
      shown = state.options;
      configured = state.configured;
      h = configured?.meanEdgeLength ?? 0;
      fill(shown);
      describe(shown, configured?.tau);
    },
  };
}
