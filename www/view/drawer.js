// @ts-check
// The rail of tabs and the drawer of the one that is open.

import { html, nothing } from "lit-html";
import { tabs } from "../store.js";
import { say } from "../words.js";
import { close, icon, lazy } from "./parts.js";
import { handle, isTall } from "./sheet.js";

/** @import { Page } from "../actions.js" */
/** @import { Tab } from "../store.js" */

/** @type {Record<Tab, (page: Page) => unknown>} */
const contents = {
  surface: lazy(() => import("./surface.js").then(({ surface }) => surface)),
  flow: lazy(() => import("./flow.js").then(({ flow }) => flow)),
  measure: lazy(() => import("./measure.js").then(({ measure }) => measure)),
  compare: lazy(() => import("./compare.js").then(({ compare }) => compare)),
  share: lazy(() => import("./share.js").then(({ share }) => share)),
};

/** Opens a tab, or shuts it. @param {Page} page @param {Tab} tab */
export function turn(page, tab) {
  const isOpen = page.get().tab === tab;
  page.patch({ tab: isOpen ? null : tab, section: null, welcome: false });
  if (page.get().mode && (isOpen || tab !== "surface")) page.edit.mode(null);
}

/** @param {Page} page */
export function rail(page) {
  const { tab } = page.state.value;
  /** @param {KeyboardEvent} event */
  function move(event) {
    const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
    const all = [.../** @type {HTMLElement} */ (event.currentTarget).querySelectorAll("button")];
    const at = all.indexOf(/** @type {HTMLButtonElement} */ (event.target));
    if (by === undefined || at < 0) return;
    event.preventDefault();
    all[(at + by + all.length) % all.length].focus();
  }
  return html`<div class="tabs" role="tablist" aria-label=${say("panels")} @keydown=${move}>${tabs.map(
    (name, n) =>
      html`<button type="button" role="tab" id="tab-${name}" aria-selected=${String(name === tab)}
        aria-controls="drawer" title="${say(`tab-${name}`)} (${n + 1})" tabindex=${name === (tab ?? "surface") ? 0 : -1}
        @click=${(/** @type {MouseEvent} */ event) => {
          // Of a click the space bar knows nothing any more: it plays.
          if (event.detail > 0) /** @type {HTMLElement} */ (event.currentTarget).blur();
          turn(page, name);
        }}>${icon(name)}<span>${say(`tab-${name}`)}</span></button>`,
  )}</div>`;
}

/** @param {Page} page */
export function drawer(page) {
  const { tab } = page.state.value;
  if (!tab) return nothing;
  const shut = () => turn(page, tab);
  return html`<div class="panel ${isTall.value ? "tall" : ""}" role="tabpanel" aria-labelledby="tab-${tab}">
    <header><h2>${say(`tab-${tab}`)}</h2>${handle(shut)}${close(shut)}</header>
    <div class="body" tabindex="-1">${contents[tab](page)}</div>
  </div>`;
}
