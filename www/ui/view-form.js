// @ts-check
// How the surface is drawn, and the theme of the whole page.

/** @import { PageState, View } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { byId } from "./element.js";

const KEY = "umbilic-theme";
const CONTRAST = "umbilic-contrast";

/** Storage may be forbidden; a choice then lasts as long as the page. @param {string} key @returns {string | null} */
function remembered(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null;
  }
}

/** @param {string} key @param {string} value */
function remember(key, value) {
  try {
    localStorage.setItem(key, value);
  } catch {
    // As above.
  }
}

/** @param {Controller} controller @param {() => void} fit */
export function createViewForm(controller, fit) {
  const form = byId("view-form", HTMLFormElement);
  const shading = byId("shading", HTMLSelectElement);
  const theme = byId("theme", HTMLSelectElement);

  form.addEventListener("submit", (event) => event.preventDefault());
  form.addEventListener("change", ({ target }) => {
    const control = /** @type {HTMLInputElement | HTMLSelectElement} */ (target);
    const value = control instanceof HTMLInputElement ? control.checked : control.value;
    // The select of languages is none of the view's.
    if (!control.name) return;
    controller.view({ [control.name]: value });
    if (control === theme) remember(KEY, theme.value);
    if (control.name === "contrast") remember(CONTRAST, value ? "high" : "normal");
  });
  byId("fit", HTMLButtonElement).addEventListener("click", fit);

  const system = matchMedia("(prefers-color-scheme: dark)");
  const known = remembered(KEY);
  controller.view({
    systemDark: system.matches,
    contrast: remembered(CONTRAST) === "high",
    ...(known === "light" || known === "dark" ? { theme: known } : {}),
  });
  system.addEventListener("change", () => controller.view({ systemDark: system.matches }));

  /** @type {Readonly<View> | null} */
  let shown = null;
  return {
    /** @param {Readonly<PageState>} state */
    update({ view }) {
      if (view === shown) return;
      shown = view;
      document.documentElement.dataset.theme = view.theme;
      shading.value = view.shading;
      theme.value = view.theme;
      for (const name of /** @type {const} */ (["wireframe", "boundary", "contrast"])) {
        const box = /** @type {HTMLInputElement} */ (form.elements.namedItem(name));
        box.checked = view[name];
      }
    },
  };
}
