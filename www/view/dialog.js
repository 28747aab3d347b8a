// @ts-check
// Whichever dialog is open, and a question.

import { html, nothing } from "lit-html";
import { fetchRest, say } from "../words.js";
import { button, lazy } from "./parts.js";

/** @import { Page } from "../actions.js" */

/** What each dialog holds. */
const contents = {
  library: lazy(() =>
    Promise.all([import("./library.js"), fetchRest()]).then(([{ library }]) => library),
  ),
  help: lazy(() => import("./dialogs.js").then(({ help }) => help)),
  commands: lazy(() => import("./dialogs.js").then(({ palette }) => palette)),
  plot: lazy(() => import("./dialogs.js").then(({ largePlot }) => largePlot)),
};

/** Fetches what dialogs hold, so that the first key typed in one is not lost. */
export const fetchDialogs = () => Promise.all(Object.values(contents).map(({ fetch }) => fetch()));

/** @param {Page} page */
export const dialog = (page) => {
  const { dialog: open } = page.state.value;
  return open ? contents[open](page) : nothing;
};

/** @param {Page} page */
export function question(page) {
  const asked = page.state.value.question;
  return asked
    ? html`<p id="question">${asked.text}</p><div class="row">
        ${button(say("run-them"), () => asked.answer(true), { kind: "primary" })}${button(say("leave-it"), () => asked.answer(false))}</div>`
    : nothing;
}
