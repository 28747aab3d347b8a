// Small pictures of samples and figures, taken by tools/thumbnails.js.

import { html } from "lit-html";
import { icon } from "./parts.js";

/** What there is a picture of, by name. @type {Record<string, string>} */
const pictures = import.meta.glob("../thumbnails/*.webp", {
  query: "?url",
  import: "default",
  eager: true,
});

/** @param {string} name @returns {string | undefined} */
export const addressOf = (name) => pictures[`../thumbnails/${name}.webp`];

/** @param {string} name */
export function pictureOf(name) {
  const address = addressOf(name);
  return address ? html`<img src=${address} alt="" loading="lazy" />` : icon("surface");
}
