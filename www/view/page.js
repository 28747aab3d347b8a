// The page that all views are of: there is one. Its stage, its tools and what else is made of the
// document are put beside it where it is built (main.js).

import { createPage } from "../actions.js";
import { createStore } from "../store.js";

/** @type {import("../actions.js").Page} */
export const page = Object.assign(
  createPage(createStore(), {
    isCalm: () => matchMedia("(prefers-reduced-motion: reduce)").matches,
    nextFrame: (draw) => requestAnimationFrame(draw),
  }),
  /** @type {any} */ ({}),
);
