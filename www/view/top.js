// The bar at the top: what is shown, presenting, help.

import { html, nothing } from "lit-html";
import { flowLabel } from "../options.js";
import { sceneTitle } from "../status.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { icon, lazy } from "./parts.js";

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
