// @ts-check
// The bar at the top: what is shown, presenting, help.

import { html, nothing } from "lit-html";
import { flowLabel } from "../options.js";
import { sceneTitle } from "../status.js";
import { say } from "../words.js";
import { icon, mark } from "./parts.js";
import { addressOf } from "./pictures.js";

/** @param {import("../actions.js").Page} page */
export function top(page) {
  const { source, options, phase } = page.state.value;
  const title = sceneTitle(source);
  // Once there is a surface to see, which nothing is to hold up.
  const picture = phase === "ready" && source?.kind === "sample" && addressOf(source.id);
  return html`
    <h1 class="brand">${mark}<span>Umbilic</span></h1>
    <button type="button" class="pick" aria-haspopup="dialog" title="${say("library")} (/)"
      @click=${() => page.patch({ dialog: "library" })}>
      ${picture ? html`<img src=${picture} alt="" />` : nothing}<span id="title">${title || say("library")}</span>
      <span class="flow">${title ? flowLabel(options.flow) : ""}</span>${icon("down")}
    </button>
    <span class="space"></span>
    <button type="button" class="button quiet" title="${say("present")} (F)" aria-label=${say("present")}
      @click=${() => page.present()}>${icon("present")}<span>${say("present")}</span></button>
    <button type="button" class="button quiet" aria-haspopup="dialog" title="${say("help")} (?)" aria-label=${say("help")}
      @click=${() => page.patch({ dialog: "help" })}>${icon("help")}<span>${say("help")}</span></button>`;
}
