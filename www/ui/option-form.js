// @ts-check
// Forms whose controls are named like options of the flow: what they say, showing what is
// in force, and hiding what has no meaning under it.

/** @import { Options } from "../options.js" */

import { choiceLabel, choicesOf, isOption, isRead, rowOf } from "../options.js";
import { say } from "../words.js";
import { fillSelect } from "./element.js";

/**
 * What can be chosen in a control, and how far its numbers go.
 * @param {HTMLInputElement | HTMLSelectElement} control
 * @param {string} name  of the option
 */
export function limit(control, name) {
  const { kind, range, absent } = rowOf(name);
  if (control instanceof HTMLSelectElement) fillSelect(control, choicesOf(name));
  // A slider ends where it is of use.
  if (control.type !== "number" || kind !== "number" || !range) return;
  const { low, high, whole, also } = range;
  Object.assign(/** @type {HTMLInputElement} */ (control), {
    min: String(Math.min(low, also ?? low)),
    max: String(high),
    step: whole ? "1" : "any",
  });
  control.required = absent === null;
}

/**
 * Gives the controls of a form that are named like options what the tables say of them: choices,
 * limits, and labels where the page has none.
 * @param {HTMLFormElement} form
 */
export function dress(form) {
  for (const control of form.elements) {
    const isControl = control instanceof HTMLInputElement || control instanceof HTMLSelectElement;
    if (!isControl || !isOption(control.name)) continue;
    limit(control, control.name);
    const isRadio = control.type === "radio";
    const words = isRadio
      ? choiceLabel(control.name, control.value)
      : say(`option-${control.name}`);
    for (const label of control.labels ?? []) {
      if (label.textContent?.trim()) continue;
      label.append(label.contains(control) ? ` ${words}` : words);
    }
  }
}

/**
 * What a control that was changed now says.
 * @param {HTMLFormElement} form
 * @param {string} name
 * @returns {any}
 */
export function chosen(form, name) {
  const control = form.elements.namedItem(name);
  if (control instanceof HTMLInputElement && control.type === "checkbox") return control.checked;
  // What may be left empty is then null.
  if (control instanceof HTMLInputElement)
    return control.value === "" ? null : control.valueAsNumber;
  return /** @type {RadioNodeList | HTMLSelectElement} */ (control)?.value;
}

/**
 * Shows the options in the controls of their names, and only the parts that have a meaning:
 * `data-option` names an option of which a part is, `data-flow` and `data-goal` the flows and the
 * goal.
 * @param {HTMLFormElement} form
 * @param {Options} options
 */
export function show(form, options) {
  /** @type {Record<string, unknown>} */
  const values = { ...options };
  for (const control of form.elements) {
    if (control instanceof HTMLInputElement && control.name in values) {
      const value = values[control.name];
      if (control.type === "radio") control.checked = control.value === value;
      else if (control.type === "checkbox") control.checked = value === true;
      else control.value = String(value ?? "");
    } else if (control instanceof HTMLSelectElement && control.name in values) {
      control.value = String(values[control.name]);
    }
  }
  showParts(form, options);
}

/**
 * @param {ParentNode} root
 * @param {Options} options
 */
export function showParts(root, options) {
  const { flow, goal } = options;
  /** @type {NodeListOf<HTMLElement>} */
  const parts = root.querySelectorAll("[data-option], [data-flow], [data-goal]");
  for (const part of parts) {
    const { option, flow: ofFlow = flow, goal: ofGoal = goal } = part.dataset;
    const isOfFlow = option ? isRead(option, options) : ofFlow.split(" ").includes(flow);
    part.hidden = !isOfFlow || ofGoal !== goal;
  }
}
