// The library: samples and figures of the papers together, by what happens to them.

import "../style/library.css";
import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { figures, samples } from "../generated/library.js";
import { firsts, sampleName, sayFigure, shelves } from "../library.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, close, icon, idOf, into, keycap } from "./parts.js";

/** @import { Figure, Sample } from "../library.js" */

const filter = signal("all");
const search = signal("");

/** @typedef {ReturnType<typeof asItem>} Item */

/** Small pictures of samples and figures, taken by tools/thumbnails.js. @type {Record<string, string>} */
const pictures = import.meta.glob("../thumbnails/*.webp", {
  query: "?url",
  import: "default",
  eager: true,
});

/** @param {string} name */
export function pictureOf(name) {
  const address = pictures[`../thumbnails/${name}.webp`];
  return address ? html`<img src=${address} alt="" loading="lazy" />` : null;
}

const size = (/** @type {number} */ vertices) => say("library-size", { vertices });

/** @param {Sample} sample */
const asItem = ({ id, group, vertices }) => ({
  ...{ id, shelf: firsts.includes(id) ? "first" : String(group), note: size(vertices) },
  title: sampleName(id),
  text: say(`sample-${id}-shows`),
  open: () => page.open.sample(id),
});

/** @param {Figure} figure @returns {Item} */
const asFigure = (figure) => ({
  ...{ id: figure.id, shelf: "papers" },
  title: sayFigure(figure, "title"),
  text: sayFigure(figure, "reports"),
  note: [
    size(samples.find(({ id }) => id === figure.sample)?.vertices ?? 0),
    `${say(`paper-${figure.paper}.authors`)}, ${sayFigure(figure)}`,
  ].join(" · "),
  open: () => page.open.figure(figure),
});

/** @param {string} text */
const plain = (text) => text.toLowerCase().replaceAll(".", "");

/** @param {Item} item */
function card({ id, title, text, note, open }) {
  const { figure, source } = page.state.value;
  const isOpen = id === (figure ? figure.id : source?.kind === "sample" && source.id);
  const after = pictureOf(`${id}-after`);
  const act = () => {
    page.patch({ dialog: null, welcome: false });
    open();
  };
  return html`<button type="button" class="entry" aria-current=${isOpen ? "true" : nothing} @click=${act}>
    <span class="thumb ${after ? "two" : ""}">${pictureOf(id) ?? icon("surface")}${after}
      ${isOpen ? html`<em>${say("open-now")}</em>` : nothing}</span>
    <span class="text"><b>${title}</b><span>${text}</span>${note ? html`<small>${note}</small>` : nothing}</span></button>`;
}

export function library() {
  const wanted = plain(search.value.trim());
  const found = [...samples.map(asItem), ...figures.map(asFigure)].filter(
    ({ title, text, note, id }) => plain(`${title} ${text} ${note} ${id}`).includes(wanted),
  );
  const chip = (/** @type {string} */ id) =>
    button(say(`shelf-${id}`), () => into(filter)(id), "chip", { pressed: filter.value === id });
  const entries = (/** @type {string} */ id) => {
    const some = found.filter(({ shelf }) => shelf === id);
    if (some.length === 0 || !["all", id].includes(filter.value)) return nothing;
    return html`<section aria-label=${say(`shelf-${id}`)}><h3>${say(`shelf-${id}`)} <small>${say(`shelf-${id}.about`)}</small></h3>
      <div class="entries">${some.map(card)}</div></section>`;
  };
  const id = idOf("library-search");
  return html`<header><h2 id="library-heading">${say("library")}</h2>
      <label class="search" for=${id}>${icon("search")}<span class="visually-hidden">${say("search")}</span>
        <input id=${id} type="search" placeholder=${say("search-hint")} .value=${search.value}
          @input=${(/** @type {any} */ { target }) => into(search)(target.value)} />${keycap("/")}</label>
      <span class="space"></span>
      ${button(say("open-mesh"), page.chooseFile, "", { icon: "open" })}
      ${close(() => page.patch({ dialog: null }))}</header>
    <div class="filters" role="group" aria-label=${say("shelves")}>${["all", ...shelves].map(chip)}<span class="space"></span>
      <span class="hint" role="note">${say("library-count", { count: found.length })}</span></div>
    <div class="shelves">${found.length > 0 ? shelves.map(entries) : html`<p class="hint">${say("library-none")}</p>`}</div>`;
}
