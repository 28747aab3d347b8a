// What stands around the stage and over it: the bar at the top, the rail of tabs with the drawer of
// the one that is open, cards, dialogs and a question. On a phone the drawer is a sheet with a handle: dragged up it takes
// the place of the surface, dragged down it is as before, and then closed. A tap does the same.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { flowLabel } from "../options.js";
import { sceneTitle } from "../status.js";
import { tabs } from "../store.js";
import { say } from "../words.js";
import { cards } from "./cards.js";
import { page } from "./page.js";
import { button, close, icon, lazy, rove } from "./parts.js";

/** @import { S, Tab } from "../store.js" */

/** Once there is a surface to see, which nothing is to hold up. */
const picture = lazy(() =>
  import("./library.js").then(({ pictureOf }) => () => {
    const { source } = page.state.value;
    return source?.kind === "sample" ? pictureOf(source.id) : nothing;
  }),
);

export function top() {
  const { source, options, phase } = page.state.value;
  const title = sceneTitle(source);
  return html`
    <button type="button" class="pick" aria-haspopup="dialog" title="${say("library")} (/)"
      @click=${() => page.patch({ dialog: "library" })}>
      ${phase === "ready" ? picture() : nothing}<span id="title">${title || say("library")}</span>
      <span class="flow">${title ? flowLabel(options.flow) : ""}</span>${icon("down")}
    </button>
    <span class="space"></span>
    <button type="button" class="button quiet" title="${say("present")} (F)" aria-label=${say("present")}
      @click=${() => page.present()}>${icon("present")}<span>${say("present")}</span></button>
    <button type="button" class="button quiet" aria-haspopup="dialog" title="${say("help")} (?)" aria-label=${say("help")}
      @click=${() => page.patch({ dialog: "help" })}>${icon("help")}<span>${say("help")}</span></button>`;
}

const over = {
  tools: lazy(() => import("./tools.js").then(({ tools }) => tools)),
  why: lazy(() => import("./why.js").then(({ why }) => why)),
  legend: lazy(() => import("./legend.js").then(({ legend }) => legend)),
  present: lazy(() => import("./present.js").then(({ present }) => present)),
};

/** What lies over the surface. */
export function overStage() {
  const { mode, mesh, welcome, why, presenting, legend } = page.state.value;
  return html`${mode ? over.tools() : nothing}${cards()}${why && !presenting ? over.why() : nothing}
    ${mesh && !welcome && (legend || !presenting) ? over.legend() : nothing}${presenting ? over.present() : nothing}`;
}

const panels = {
  surface: lazy(() => import("./surface.js").then(({ surface }) => surface)),
  flow: lazy(() => import("./flow.js").then(({ flow }) => flow)),
  measure: lazy(() => import("./measure.js").then(({ measure }) => measure)),
  compare: lazy(() => import("./compare.js").then(({ compare }) => compare)),
  share: lazy(() => import("./share.js").then(({ share }) => share)),
};

/** Whether a sheet has its full height. */
const isTall = signal(false);
/** So far, in CSS pixels, a finger may slip on a tap. */
const SLIP = 6;
/** Whether the click that is about to come ends a drag. */
let wasDragged = false;

/** Opens a tab, or shuts it. @param {Tab} tab */
export function turn(tab) {
  const isOpen = page.get().tab === tab;
  document.querySelector(".panel > .body")?.scrollTo(0, 0);
  page.patch({ tab: isOpen ? null : tab, section: null, welcome: false });
  if (page.get().mode && (isOpen || tab !== "surface")) page.edit.mode(null);
}

export function rail() {
  const { tab } = page.state.value;
  const press = (/** @type {Tab} */ name) => (/** @type {MouseEvent} */ event) => {
    // Of a click the space bar knows nothing any more: it plays.
    if (event.detail > 0) /** @type {HTMLElement} */ (event.currentTarget).blur();
    turn(name);
  };
  const buttons = tabs.map((name, n) => {
    const label = say(`tab-${name}`);
    return html`<button type="button" role="tab" id="tab-${name}" aria-selected=${String(name === tab)}
      aria-controls="drawer" title="${label} (${n + 1})" tabindex=${name === (tab ?? "surface") ? 0 : -1}
      @click=${press(name)}>${icon(name)}<span>${label}</span></button>`;
  });
  return html`<div class="tabs" role="tablist" aria-label=${say("panels")} @keydown=${(/** @type {KeyboardEvent} */ event) => rove(event, "button")}>${buttons}</div>`;
}

export function drawer() {
  const { tab } = page.state.value;
  if (!tab) return nothing;
  const shut = () => turn(tab);
  const press = () => {
    if (!wasDragged) isTall.value = !isTall.value;
  };
  return html`<div class="panel ${isTall.value ? "tall" : ""}" role="tabpanel" aria-labelledby="tab-${tab}">
    <header><h2>${say(`tab-${tab}`)}</h2>
      <button type="button" class="grip" aria-label=${say("full-height")} aria-pressed=${String(isTall.value)}
        @pointerdown=${(/** @type {PointerEvent} */ event) => drag(event, shut)} @click=${press}></button>
      ${close(shut)}</header>
    <div class="body" tabindex="-1">${panels[tab]()}</div>
  </div>`;
}

/** @param {PointerEvent} down @param {() => void} shut */
function drag(down, shut) {
  const grip = /** @type {HTMLElement} */ (down.currentTarget);
  const panel = /** @type {HTMLElement} */ (grip.closest(".panel"));
  const start = panel.getBoundingClientRect().height;
  const most = start + (document.getElementById("stage")?.clientHeight ?? 0);
  let by = 0;
  wasDragged = false;
  grip.setPointerCapture(down.pointerId);
  grip.onpointermove = (event) => {
    by = down.clientY - event.clientY;
    if (Math.abs(by) <= SLIP) return;
    panel.classList.add("dragged");
    panel.style.height = `${Math.max(0, Math.min(most, start + by))}px`;
  };
  const end = () => {
    grip.onpointermove = grip.onpointerup = grip.onpointercancel = null;
    panel.style.height = "";
    panel.classList.remove("dragged");
  };
  grip.onpointercancel = end;
  grip.onpointerup = () => {
    end();
    wasDragged = Math.abs(by) > SLIP;
    // A tap is a click: were the sheet higher before that comes, what lies below would take it.
    if (!wasDragged) return;
    if (by > 0) isTall.value = true;
    else if (isTall.value && start + by > start / 3) isTall.value = false;
    else shut();
  };
}

const dialogs = {
  library: lazy(() => import("./library.js").then(({ library }) => library)),
  help: lazy(() => import("./dialogs.js").then(({ help }) => help)),
  commands: lazy(() => import("./dialogs.js").then(({ palette }) => palette)),
  plot: lazy(() => import("./dialogs.js").then(({ largePlot }) => largePlot)),
};

/**
 * Whether a dialog is open and its contents are fetched: shown before, it would leave the
 * focus on nothing, and what is typed into it would be lost.
 * @param {S} s
 */
export const isDialogOpen = (s) => s.dialog !== null && dialogs[s.dialog].isThere();

export function dialog() {
  const { dialog: open } = page.state.value;
  return open ? dialogs[open]() : nothing;
}

export function question() {
  const asked = page.state.value.question;
  if (!asked) return nothing;
  return html`<p id="question">${asked.text}</p><div class="row">
    ${button(say("run-them"), () => asked.answer(true), "primary")}${button(say("leave-it"), () => asked.answer(false))}</div>`;
}
