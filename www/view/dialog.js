// Whichever dialog is open, and a question.

import { html, nothing } from "lit-html";
import { fetchRest, say } from "../words.js";
import { page } from "./page.js";
import { button, lazy } from "./parts.js";

const contents = {
  library: lazy(() =>
    Promise.all([import("./library.js"), fetchRest()]).then(([{ library }]) => library),
  ),
  help: lazy(() => import("./dialogs.js").then(({ help }) => help)),
  commands: lazy(() => import("./dialogs.js").then(({ palette }) => palette)),
  plot: lazy(() => import("./dialogs.js").then(({ largePlot }) => largePlot)),
};

/**
 * Whether a dialog is open and its contents are fetched: shown before, it would leave the
 * focus on nothing, and what is typed into it would be lost.
 * @param {import("../store.js").S} s
 */
export const isDialogOpen = (s) => s.dialog !== null && contents[s.dialog].isThere();

/** Fetches what dialogs hold, so that they open at once. */
export const fetchDialogs = () => Promise.all(Object.values(contents).map(({ fetch }) => fetch()));

export function dialog() {
  const { dialog: open } = page.state.value;
  return open ? contents[open]() : nothing;
}

export function question() {
  const asked = page.state.value.question;
  return asked
    ? html`<p id="question">${asked.text}</p><div class="row">
        ${button(say("run-them"), () => asked.answer(true), "primary")}${button(say("leave-it"), () => asked.answer(false))}</div>`
    : nothing;
}
