// @ts-check
// Where the surface passes through itself: counted when asked, and marked on it.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";

/** @param {Awaited<ReturnType<Controller["selfIntersections"]>>} found */
function countText(found) {
  if (!found) return t("Too many triangles are near each other to compare them all.");
  if (found.pairs.length === 0) return t("The surface does not pass through itself.");
  return say("crossings", { count: found.pairs.length / 2 });
}

/** @param {Controller} controller */
export function createCrossings(controller) {
  const show = byId("crossings-show", HTMLButtonElement);
  const note = byId("crossings-note", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {Float32Array | undefined} of the surface that was asked about */
  let asked;
  /** @type {PageState["marks"]} made here, to be taken away here */
  let marked = null;

  function forget() {
    asked = undefined;
    show.ariaPressed = "false";
    setText(note, "");
    if (marked && state?.marks === marked) controller.mark(null);
    marked = null;
  }

  async function tell() {
    asked = state?.frame?.positions;
    const of = asked;
    if (!of) return;
    const found = await controller.selfIntersections();
    // A step meanwhile has moved the surface.
    if (of !== asked) return;
    setText(note, countText(found));
    if (!found || found.triangles.length === 0) return;
    show.ariaPressed = "true";
    marked = { edges: new Uint32Array(), triangles: found.triangles };
    controller.mark(marked);
  }

  show.addEventListener("click", () => {
    if (show.ariaPressed === "true") forget();
    // Whoever ended the solver has said so.
    else tell().catch(forget);
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      state = now;
      if (asked && now.frame?.positions !== asked) forget();
    },
  };
}
