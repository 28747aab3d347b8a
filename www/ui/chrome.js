// @ts-check
// What stands around the surface: help, the panel, and presenting without either.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { byId, setText } from "./element.js";

export function createHelp() {
  const dialog = byId("help", HTMLDialogElement);
  // Not in the markup: a browser would try it at once, and complain inside another page.
  const close = dialog.querySelector("button");
  if (close) close.autofocus = true;
  const open = () => dialog.showModal();
  byId("help-open", HTMLButtonElement).addEventListener("click", open);
  // A click on the backdrop is a click on the dialog itself.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  const version = byId("version", HTMLElement);
  return {
    open,
    /** @param {Readonly<PageState>} state */
    update(state) {
      setText(version, state.version ? `Solver version ${state.version}` : "");
    },
  };
}

/** Open beside the surface where there is room; a sheet that starts closed on a phone. */
export function createPanel() {
  const button = byId("panel-toggle", HTMLButtonElement);
  const narrow = matchMedia("(max-width: 700px)");
  /** @param {boolean} open */
  function show(open) {
    document.body.dataset.panel = open ? "open" : "closed";
    button.ariaExpanded = String(open);
  }
  button.addEventListener("click", () => show(button.ariaExpanded !== "true"));
  narrow.addEventListener("change", () => show(!narrow.matches));
  show(!narrow.matches);
}

/** @param {Controller} controller */
export function createPresenter(controller) {
  const button = byId("present", HTMLButtonElement);
  button.addEventListener("click", () => controller.present());
  // Leaving full screen with the browser's own key ends the presentation too.
  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) controller.present(false);
  });

  let shown = false;
  return {
    /** @param {Readonly<PageState>} state */
    update({ presenting }) {
      if (presenting === shown) return;
      shown = presenting;
      document.documentElement.classList.toggle("presenting", presenting);
      button.ariaPressed = String(presenting);
      // Refused where the page is embedded; presenting works without.
      if (presenting) document.documentElement.requestFullscreen?.().catch(() => {});
      else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    },
  };
}
