// @ts-check
// Forms whose controls are named like options of the flow: what they say, showing what is
// in force, and hiding what has no meaning under it.

/** @import { Options } from "../options.js" */

import { choiceLabel, choicesOf, flowOf, isOption, isRead, rowOf } from "../options.js";
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

/** @param {string} text @param {HTMLElement} control */
function labelled(text, control) {
  const label = document.createElement("label");
  label.textContent = text;
  label.htmlFor = control.id;
  return label;
}

/** @param {string} text @param {HTMLInputElement} box */
function choice(text, box) {
  const label = document.createElement("label");
  label.className = "choice";
  label.append(box, ` ${text}`);
  return label;
}

/** @param {string} name @param {string} type  of an input */
function input(name, type) {
  const control = document.createElement("input");
  Object.assign(control, { name, type });
  return control;
}

/**
 * The controls of an option.
 * @param {string} name
 * @param {HTMLElement} place  for them; a fieldset shows all choices
 * @returns {Node[]}
 */
function controlsOf(name, place) {
  const { kind, ids, absent } = rowOf(name);
  const words = say(`option-${name}`);
  if (kind === "switch") return [choice(words, input(name, "checkbox"))];
  if (place instanceof HTMLFieldSetElement) {
    const legend = document.createElement("legend");
    legend.textContent = words;
    const radios = ids.map((value) => Object.assign(input(name, "radio"), { value }));
    return [legend, ...radios.map((radio) => choice(choiceLabel(name, radio.value), radio))];
  }
  const control = kind === "number" ? input(name, "number") : document.createElement("select");
  Object.assign(control, { name, id: `option-${name}` });
  limit(control, name);
  if (control instanceof HTMLInputElement && absent)
    control.placeholder = say(`option-${name}.absent`);
  if (place.dataset.note) control.setAttribute("aria-describedby", place.dataset.note);
  return [labelled(words, control), control];
}

/**
 * Makes the controls of a form: of each option that a part names by `data-option` and has no
 * controls for; those that the page has get their labels.
 * @param {HTMLFormElement} form
 */
export function dress(form) {
  /** @type {NodeListOf<HTMLElement>} */
  const places = form.querySelectorAll("[data-option]:empty");
  for (const place of places) {
    const name = String(place.dataset.option);
    place.append(...controlsOf(name, place));
  }
  for (const control of form.elements) {
    if (!(control instanceof HTMLInputElement) || !isOption(control.name)) continue;
    if (control.labels?.length === 0)
      control.before(labelled(say(`option-${control.name}`), control));
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
 * `data-option` names an option of which a part is, `data-family`, `data-monitored` and `data-goal`
 * the families of flows, what they lower, and the goal.
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
  const { goal } = options;
  const { family, monitored } = flowOf(options.flow);
  /** @type {NodeListOf<HTMLElement>} */
  const parts = root.querySelectorAll("[data-option], [data-family], [data-goal]");
  for (const part of parts) {
    const { option, family: families = family, goal: ofGoal = goal } = part.dataset;
    const lowers = part.dataset.monitored ?? monitored[0];
    const isOfFlow = option
      ? isRead(option, options)
      : families.split(" ").includes(family) && lowers === monitored[0];
    part.hidden = !isOfFlow || ofGoal !== goal;
  }
}
