// @ts-check
// Forms whose controls are named like options of the flow: what they say, showing what is
// in force, and hiding what has no meaning under it.

/** @import { Options } from "../options.js" */

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
 * `data-flow` and `data-goal` name the flows and the goal a part belongs to.
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
export function showParts(root, { flow, goal }) {
  /** @type {NodeListOf<HTMLElement>} */
  const parts = root.querySelectorAll("[data-flow], [data-goal]");
  for (const part of parts) {
    const { flow: ofFlow = flow, goal: ofGoal = goal } = part.dataset;
    part.hidden = !ofFlow.split(" ").includes(flow) || ofGoal !== goal;
  }
}
