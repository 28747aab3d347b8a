// @ts-check
// Edits of any mesh: the surface kept as a new start, finer faces, and the way back.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";

/** @param {HTMLButtonElement} button @param {boolean} isAble */
function enable(button, isAble) {
  if (button.ariaDisabled !== String(!isAble)) button.ariaDisabled = String(!isAble);
}

/** @param {Controller} controller */
export function createEditsForm(controller) {
  const adopt = byId("adopt", HTMLButtonElement);
  const refine = byId("refine", HTMLButtonElement);
  const scheme = byId("refine-scheme", HTMLSelectElement);
  const undo = byId("undo", HTMLButtonElement);
  const note = byId("undo-note", HTMLElement);
  adopt.addEventListener("click", () => controller.adopt());
  undo.addEventListener("click", () => controller.undo());
  refine.addEventListener("click", () =>
    controller.subdivide(/** @type {"linear" | "loop"} */ (scheme.value)),
  );

  return {
    /** @param {Readonly<PageState>} state */
    update({ earlier, reading }) {
      const last = earlier.at(-1);
      undo.parentElement?.toggleAttribute("hidden", !last);
      setText(note, last ? t("takes back {what}", { what: last.what }) : "");
      enable(adopt, reading !== null && reading.step > 0);
      enable(refine, reading !== null);
    },
  };
}
