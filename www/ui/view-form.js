// @ts-check
// How the surface is drawn, and the theme of the whole page.

/** @import { PageState, View } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { byId } from "./element.js";

const KEY = "umbilic-theme";

/** Storage may be forbidden; the theme then lasts as long as the page. @returns {string | null} */
function remembered() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

/** @param {string} theme */
function remember(theme) {
  try {
    localStorage.setItem(KEY, theme);
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
    controller.view({ [control.name]: value });
    if (control === theme) remember(theme.value);
  });
  byId("fit", HTMLButtonElement).addEventListener("click", fit);

  const system = matchMedia("(prefers-color-scheme: dark)");
  const known = remembered();
  controller.view({
    systemDark: system.matches,
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
      for (const name of /** @type {const} */ (["wireframe", "boundary"])) {
        const box = /** @type {HTMLInputElement} */ (form.elements.namedItem(name));
        box.checked = view[name];
      }
    },
  };
}
