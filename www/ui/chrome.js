// @ts-check
// What stands around the surface: help, and the panel.

/** @import { PageState } from "../state.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";

export function createHelp() {
  const dialog = byId("help", HTMLDialogElement);
  // Not in the markup: a browser would try it at once, and complain inside another page.
  const close = dialog.querySelector("button.primary");
  if (close instanceof HTMLButtonElement) close.autofocus = true;
  function open() {
    dialog.showModal();
    // The button that has the focus is at its end.
    dialog.scrollTop = 0;
  }
  byId("help-open", HTMLButtonElement).addEventListener("click", open);
  // A click on the backdrop is a click on the dialog itself.
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  const version = byId("version", HTMLElement);
  return {
    open,
    /** @param {Readonly<PageState>} state */
    update(state) {
      setText(
        version,
        state.version ? t("Solver version {version}", { version: state.version }) : "",
      );
    },
  };
}

/** How far down a swipe has to go to close the sheet, in CSS pixels. */
const SWIPE = 60;
/** How far a tap may slip. */
const SLIP = 8;

/** Open beside the surface where there is room; a sheet that starts closed on a phone. */
export function createPanel() {
  const button = byId("panel-toggle", HTMLButtonElement);
  const panel = byId("panel", HTMLElement);
  const handle = byId("panel-handle", HTMLButtonElement);
  const narrow = matchMedia("(max-width: 700px)");
  /** @param {boolean} open */
  function show(open) {
    document.body.dataset.panel = open ? "open" : "closed";
    button.ariaExpanded = String(open);
  }
  button.addEventListener("click", () => show(button.ariaExpanded !== "true"));
  narrow.addEventListener("change", () => show(!narrow.matches));
  show(!narrow.matches);

  function close() {
    show(false);
    button.focus();
  }
  let isDrag = false;
  handle.addEventListener("click", () => isDrag || close());
  /** @param {string} by */
  function shift(by) {
    for (const part of [handle, panel]) part.style.translate = by;
  }
  // The sheet follows the finger, and is let go of where it came far enough.
  /** @type {number | null} */
  let from = null;
  handle.addEventListener("pointerdown", (event) => {
    from = event.clientY;
    isDrag = false;
    handle.setPointerCapture(event.pointerId);
  });
  handle.addEventListener("pointermove", ({ clientY }) => {
    if (from === null) return;
    isDrag ||= Math.abs(clientY - from) > SLIP;
    shift(`0 ${Math.max(0, clientY - from)}px`);
  });
  /** @param {PointerEvent} event */
  function lift({ type, clientY }) {
    const isFar = from !== null && type === "pointerup" && clientY - from > SWIPE;
    from = null;
    shift("");
    if (isFar) close();
    // After the click that a drag with a mouse ends with.
    setTimeout(() => {
      isDrag = false;
    });
  }
  handle.addEventListener("pointerup", lift);
  handle.addEventListener("pointercancel", lift);
}
