// @ts-check
// Play or Pause, Step, Back, Reset.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { canStepBack, hasMoved } from "../comparison-state.js";
import { t } from "../language.js";
import { byId, setText } from "./element.js";

/** @param {Controller} controller */
export function createTransport(controller) {
  const play = byId("play", HTMLButtonElement);
  const label = byId("play-label", HTMLElement);
  const buttons = {
    play,
    step: byId("step", HTMLButtonElement),
    back: byId("back", HTMLButtonElement),
    reset: byId("reset", HTMLButtonElement),
  };
  const press = {
    play: controller.toggle,
    step: controller.step,
    back: controller.back,
    reset: controller.reset,
  };
  for (const name of /** @type {(keyof typeof press)[]} */ (Object.keys(press))) {
    buttons[name].addEventListener("click", () => {
      if (buttons[name].ariaDisabled !== "true") press[name]();
    });
  }
  byId("halt", HTMLButtonElement).addEventListener("click", () => controller.halt());

  /**
   * Not `disabled`: that would drop the focus of whoever steps back to the start.
   * @param {HTMLButtonElement} button @param {boolean} usable
   */
  function allow(button, usable) {
    const word = String(!usable);
    if (button.ariaDisabled !== word) button.ariaDisabled = word;
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const { phase, reading, playing } = state;
      const running = phase === "running" || playing !== 0;
      const usable = reading !== null && phase !== "loading" && phase !== "failed";
      setText(label, running ? t("Pause") : t("Play"));
      play.dataset.running = String(running);
      allow(play, usable);
      allow(buttons.step, usable);
      allow(buttons.back, usable && (running || canStepBack(state)));
      allow(buttons.reset, usable && (running || hasMoved(state)));
    },
  };
}
