// @ts-check
// Whether a change of the flow goes on from the step that is shown, and the notes that say so.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { canGoOn, goesOn } from "../state.js";
import { byId, setText } from "./element.js";

/** What a change would do now. @param {Readonly<PageState>} state */
function announcement(state) {
  if (!goesOn(state)) return t("A change takes the surface back to the start.");
  const { at = 0, last = 0 } = state.timeline ?? {};
  return at < last
    ? t("A change goes on from step {step}; the steps after it are kept as a branch.", { step: at })
    : t("A change goes on from step {step}.", { step: at });
}

/** @param {Controller} controller */
export function createGoingOn(controller) {
  const choice = byId("go-on-choice", HTMLElement);
  const box = byId("go-on", HTMLInputElement);
  const notes = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(".change-note"));

  box.addEventListener("change", () => controller.goOn(box.checked));

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      choice.hidden = !canGoOn(state);
      box.checked = goesOn(state);
      const said = announcement(state);
      for (const note of notes) setText(note, said);
    },
  };
}
