// @ts-check
// The library: samples and figures of the papers together, by what happens to them.

import "../style/library.css";
import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { figures, samples } from "../generated/library.js";
import { firsts, sampleName, sayFigure, shelves } from "../library.js";
import { say } from "../words.js";
import { button, close, icon, idOf, into, keycap } from "./parts.js";
import { addressOf, pictureOf } from "./pictures.js";

/** @import { Page } from "../actions.js" */
/** @import { Figure, Sample } from "../library.js" */

const filter = signal("all");
const search = signal("");

/**
 * @typedef {{ id: string, shelf: string, title: string, text: string, note: string, open: (page: Page) => unknown, isOpen: (s: import("../store.js").S) => boolean }} Item
 */

/** @param {Sample} sample @returns {Item} */
const asItem = ({ id, group }) => ({
  id,
  shelf: firsts.includes(id) ? "first" : group,
  title: sampleName(id),
  text: say(`sample-${id}-shows`),
  note: "",
  open: (page) => page.open.sample(id),
  isOpen: ({ source, figure }) => source?.kind === "sample" && source.id === id && !figure,
});

/** @param {Figure} figure @returns {Item} */
const asFigure = (figure) => ({
  id: figure.id,
  shelf: "papers",
  title: sayFigure(figure, "title"),
  text: sayFigure(figure, "reports"),
  note: `${say(`paper-${figure.paper}.authors`)}, ${sayFigure(figure)}`,
  open: (page) => page.open.figure(figure),
  isOpen: (s) => s.figure?.id === figure.id,
});

/** @param {Item} item @param {string} wanted  in lower case */
const matches = ({ title, text, note, id }, wanted) =>
  `${title} ${text} ${note} ${id}`
    .toLowerCase()
    .replaceAll(".", "")
    .includes(wanted.replaceAll(".", ""));

/** @param {Page} page @param {Item} item */
function card(page, item) {
  const isOpen = item.isOpen(page.state.value);
  const after = addressOf(`${item.id}-after`);
  const act = () => {
    page.patch({ dialog: null, welcome: false });
    item.open(page);
  };
  return html`<button type="button" class="entry" aria-current=${isOpen ? "true" : nothing} @click=${act}>
    <span class="thumb ${after ? "two" : ""}">${pictureOf(item.id)}${after ? html`<img src=${after} alt="" loading="lazy" />` : nothing}
      ${isOpen ? html`<em>${say("open-now")}</em>` : nothing}</span>
    <span class="text"><b>${item.title}</b><span>${item.text}</span>${item.note ? html`<small>${item.note}</small>` : nothing}</span></button>`;
}

/** @param {Page} page */
export function library(page) {
  const all = [...samples.map(asItem), ...figures.map(asFigure)];
  const wanted = search.value.trim().toLowerCase();
  const found = all.filter((item) => matches(item, wanted));
  const shown = shelves.filter((id) => filter.value === "all" || filter.value === id);
  const chip = (/** @type {string} */ id) =>
    html`<button type="button" class="button chip" aria-pressed=${String(filter.value === id)} @click=${() => into(filter)(id)}>${say(`shelf-${id}`)}</button>`;
  return html`<header><h2 id="library-heading">${say("library")}</h2>
      <label class="search" for=${idOf("library-search")}>${icon("search")}<span class="visually-hidden">${say("search")}</span>
        <input id=${idOf("library-search")} type="search" placeholder=${say("search-hint")} .value=${search.value}
          @input=${(/** @type {any} */ { target }) => into(search)(target.value)} />${keycap("/")}</label>
      <span class="space"></span>
      ${button(say("open-mesh"), () => page.chooseFile(), { icon: "open" })}
      ${close(() => page.patch({ dialog: null }))}</header>
    <div class="filters" role="group" aria-label=${say("shelves")}>${chip("all")}${shelves.map(chip)}<span class="space"></span>
      <span class="hint" role="note">${say("library-count", { count: found.length })}</span></div>
    <div class="shelves">${shown.map((id) => {
      const some = found.filter(({ shelf }) => shelf === id);
      return some.length === 0
        ? nothing
        : html`<section aria-label=${say(`shelf-${id}`)}><h3>${say(`shelf-${id}`)} <small>${say(`shelf-${id}.about`)}</small></h3>
            <div class="entries">${some.map((item) => card(page, item))}</div></section>`;
    })}</div>`;
}
