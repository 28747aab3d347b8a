// @ts-check
// Presenting: the surface alone, its words large enough for the last row, controls that show up
// when they are reached for, and the keys that a presenter's clicker sends.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { figures } from "../generated/library.js";
import { t } from "../language.js";
import { figureTitle } from "../library.js";
import { isOver } from "../standing.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";
import { isThere } from "./gallery.js";
import { takesKeys } from "./keys.js";
import { formatNumber } from "./number.js";
import { sceneTitle } from "./picture.js";
import { symbol } from "./status.js";

/** Milliseconds without a movement after which the controls go. */
const QUIET = 2000;

/**
 * What is shown, and where it stands, in one line.
 * @param {Readonly<PageState>} state
 */
export function presentedText(state) {
  const { reading, figure, source } = state;
  // Of a paper, its authors.
  const shown = figure
    ? `${say(`paper-${figure.paper}.authors`)}, ${figureTitle(figure)}`
    : sceneTitle(source);
  if (!reading) return shown;
  return t("{energy} · step {step} · {title}", {
    energy: `${symbol(state)} = ${formatNumber(reading.energy, 4)}`,
    step: reading.step,
    title: shown,
  });
}

/** Whether a flow has come as far as it goes, or as its figure wants. @param {Readonly<PageState>} state */
function isAtEnd(state) {
  const { figure, reading } = state;
  if (figure) return isThere(figure, state);
  // From its limit Play goes on.
  return reading !== null && isOver(reading.status) && reading.status !== "stepLimit";
}

/** @param {Controller} controller @param {() => Readonly<PageState>} state @param {() => void} gallery */
export function createPresenter(controller, state, gallery) {
  const button = byId("present", HTMLButtonElement);
  const line = byId("presented", HTMLElement);
  const root = document.documentElement;
  button.addEventListener("click", () => controller.present());
  // Leaving full screen with the browser's own key ends the presentation too.
  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) controller.present(false);
  });

  /** The figure so many places further in the gallery, if there is one. @param {1 | -1} way */
  function turnTo(way) {
    const place = figures.findIndex(({ id }) => id === state().figure?.id);
    const next = figures[place + way];
    if (place >= 0 && next) controller.figure(next);
  }

  function forward() {
    const now = state();
    if (now.phase === "loading") return;
    if (now.phase !== "running" && now.figure && isAtEnd(now)) turnTo(1);
    else controller.toggle();
  }

  function backward() {
    const { phase, reading, figure } = state();
    if (phase === "loading") return;
    if (phase === "running" || (reading && reading.step > 0)) controller.reset();
    else if (figure) turnTo(-1);
  }

  let isLineHidden = false;
  /** @type {Record<string, () => void>} */
  const actions = {
    PageDown: forward,
    ArrowRight: forward,
    PageUp: backward,
    ArrowLeft: backward,
    h: () => {
      isLineHidden = !isLineHidden;
      line.hidden = isLineHidden;
    },
    g: gallery,
  };

  window.addEventListener("keydown", (event) => {
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = Object.hasOwn(actions, key) ? actions[key] : null;
    if (!action || !shown || event.defaultPrevented || event.repeat) return;
    if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey) return;
    if (document.querySelector("dialog[open]") || takesKeys(event.target)) return;
    // Arrow keys belong to what has the focus: they turn the surface.
    if (key.startsWith("Arrow") && document.activeElement !== document.body) return;
    event.preventDefault();
    action();
  });

  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let quiet;
  function stir() {
    if (!shown) return;
    root.classList.remove("idle");
    clearTimeout(quiet);
    quiet = setTimeout(() => root.classList.add("idle"), QUIET);
  }
  for (const kind of ["pointermove", "pointerdown", "focusin"]) {
    window.addEventListener(kind, stir, { passive: true });
  }
  // A button that was clicked keeps the focus, and would keep the controls in sight for good.
  window.addEventListener("click", ({ detail, target }) => {
    const pressed = target instanceof Element ? target.closest("button") : null;
    if (shown && detail > 0 && pressed && !pressed.closest("dialog")) pressed.blur();
  });

  let shown = false;
  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      if (now.presenting) setText(line, presentedText(now));
      if (now.presenting === shown) return;
      shown = now.presenting;
      root.classList.toggle("presenting", shown);
      root.classList.remove("idle");
      clearTimeout(quiet);
      button.ariaPressed = String(shown);
      line.hidden = !shown || isLineHidden;
      // What had the focus before would stay in sight.
      if (shown && document.activeElement instanceof HTMLElement) document.activeElement.blur();
      stir();
      // Refused where the page is embedded; presenting works without.
      if (shown) document.documentElement.requestFullscreen?.().catch(() => {});
      else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    },
  };
}
