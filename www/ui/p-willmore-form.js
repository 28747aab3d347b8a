// @ts-check
// What is special to the p-Willmore flow and its cases: exponent, constraints, regularisation.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { t } from "../language.js";
import { defaults, flowLabel, flowOf } from "../options.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { chosen, dress, show } from "./option-form.js";

/** Where the deflation of a vesicle leads to, unless told otherwise: a biconcave disc. */
const DISCOCYTE = 0.6;

/** @param {Controller} controller */
export function createPWillmoreForm(controller) {
  const form = byId("p-willmore", HTMLFormElement);
  const area = byId("keep-area", HTMLInputElement);
  const volume = byId("keep-volume", HTMLInputElement);
  const lead = byId("lead", HTMLInputElement);
  const target = byId("reduced-volume", HTMLInputElement);
  const forces = byId("forces", HTMLElement);
  dress(form);

  const kept = () => [
    ...(area.checked ? /** @type {const} */ (["area"]) : []),
    ...(volume.checked ? /** @type {const} */ (["volume"]) : []),
  ];

  form.addEventListener("change", (event) => {
    const control = /** @type {HTMLInputElement | HTMLSelectElement} */ (event.target);
    if (!control.reportValidity()) return;
    if (control === area || control === volume) {
      // Without both constraints there is nothing to lead.
      const keep = kept();
      controller.configure({ keep, ...(keep.length < 2 && { reducedVolume: null }) });
    } else if (control === lead || control === target) {
      const reducedVolume = lead.checked ? target.valueAsNumber : null;
      controller.configure({ reducedVolume, ...(lead.checked && { keep: ["area", "volume"] }) });
    } else controller.configure({ [control.name]: chosen(form, control.name) });
  });
  form.addEventListener("submit", (event) => event.preventDefault());
  // A value that was refused must not stay beside the one in force.
  form.addEventListener("focusout", ({ target }) => {
    if (target instanceof HTMLInputElement && !target.checkValidity()) restore();
  });
  byId("regularise-now", HTMLButtonElement).addEventListener("click", () =>
    controller.regularise(),
  );

  /** @param {PageState["reading"]} reading */
  function describe(reading) {
    const { tension = null, pressure = null } = reading?.multipliers ?? {};
    const said = [
      tension !== null && t("tension {value}", { value: formatNumber(tension, 4) }),
      pressure !== null && t("pressure {value}", { value: formatNumber(pressure, 4) }),
    ].filter(Boolean);
    setText(
      forces,
      said.length > 0 ? t("Lagrange multipliers: {values}", { values: said.join(", ") }) : "",
    );
    forces.hidden = said.length === 0;
  }

  /** @type {Options} */
  let shown = defaults;
  /** Shows what is in force. */
  function restore() {
    show(form, shown);
    area.checked = shown.keep.includes("area");
    volume.checked = shown.keep.includes("volume");
    lead.checked = shown.reducedVolume !== null;
    target.value = String(shown.reducedVolume ?? DISCOCYTE);
  }
  restore();
  return {
    /** @param {Readonly<PageState>} state */
    update({ options, reading }) {
      describe(reading);
      if (options === shown) return;
      shown = options;
      restore();
      form.ariaLabel = flowLabel(options.flow);
      form.hidden = flowOf(options.flow).family !== "p-willmore";
    },
  };
}
