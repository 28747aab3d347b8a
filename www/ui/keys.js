// @ts-check
// Single keys. They rest while something is typed or a dialog is open, and can be
// switched off, for whoever dictates.

/** @import { Controller } from "../controller.js" */

import { byId } from "./element.js";

const KEY = "umbilic-keys";

/** @param {EventTarget | null} target whether the key belongs to a control that takes text or choices */
export function takesKeys(target) {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target.matches("select, textarea")) return true;
  return target instanceof HTMLInputElement && !["checkbox", "radio"].includes(target.type);
}

/** @param {EventTarget | null} target whether Space presses it already */
const takesSpace = (target) =>
  target instanceof Element && target.matches("button, summary, a[href], input, .scroll");

/**
 * @param {Controller} controller
 * @param {() => Readonly<import("../state.js").PageState>} state
 * @param {() => void} help
 */
export function createKeys(controller, state, help) {
  const on = byId("keys-on", HTMLInputElement);
  try {
    on.checked = localStorage.getItem(KEY) !== "off";
  } catch {
    // Storage may be forbidden; then the choice lasts as long as the page.
  }
  on.addEventListener("change", () => {
    try {
      localStorage.setItem(KEY, on.checked ? "on" : "off");
    } catch {
      // As above.
    }
  });

  /** @type {Record<string, () => void>} */
  const actions = {
    " ": controller.toggle,
    ".": controller.step,
    ",": controller.back,
    r: controller.reset,
    f: () => controller.present(),
    b: controller.flip,
    "?": help,
  };
  const repeating = [".", ","];

  window.addEventListener("keydown", (event) => {
    // Escape closes what lies on top first.
    const dialog = document.querySelector("dialog[open]");
    if (event.key === "Escape" && !dialog) {
      if (state().comparison.shown === "side") controller.present(false);
      else controller.sideBySide();
    }
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = Object.hasOwn(actions, key) ? actions[key] : null;
    if (!action || !on.checked || event.defaultPrevented) return;
    if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
    if (dialog || takesKeys(event.target)) return;
    if (key === " " && takesSpace(event.target)) return;
    event.preventDefault();
    if (!event.repeat || repeating.includes(key)) action();
  });
}
