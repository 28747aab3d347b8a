// @ts-check
// Elements of the page by id, with their types.

import { translated } from "../language.js";

/**
 * @template {Element} T
 * @param {string} id
 * @param {new () => T} type
 * @returns {T}
 */
export function byId(id, type) {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`index.html has no ${type.name} #${id}`);
  return found;
}

/**
 * Sets text only when it differs, so that a frame touches only what changed.
 * @param {Element} element @param {string} text
 */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/**
 * @param {HTMLSelectElement} select
 * @param {readonly { id: string, label: string }[]} choices
 */
export function fillSelect(select, choices) {
  select.replaceChildren(...choices.map(({ id, label }) => new Option(translated(label), id)));
}
