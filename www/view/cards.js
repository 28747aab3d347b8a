// Cards over the stage that are there before the surface: the welcome, and why there is no picture.

import { html, nothing } from "lit-html";
import { remember } from "../language.js";
import torus from "../thumbnails/coarse-torus-after.webp?url";
import vesicle from "../thumbnails/vesicle-after.webp?url";
import { say } from "../words.js";
import { page } from "./page.js";
import { icon } from "./parts.js";

/** What one may begin with beside the surface that is there, and where that leads: fetched before all other pictures. */
const ends = { vesicle, "coarse-torus": torus };
export const starters = Object.keys(ends);

function welcome() {
  /** @param {() => unknown} act */
  const leave = (act) => () => {
    remember("visited", "yes");
    page.patch({ welcome: false });
    act();
  };
  /** @param {string} name  of its words @param {unknown} picture @param {() => unknown} act */
  const starter = (name, picture, act) =>
    html`<button type="button" class="starter" @click=${leave(act)}>
      <span class="thumb">${picture}</span>${say(name)}<small>${say(`${name}.small`)}</small></button>`;
  const samples = Object.entries(ends).map(([id, address]) =>
    starter(`sample-${id}`, html`<img src=${address} alt="" />`, () => page.open.sample(id)),
  );
  return html`<section class="card welcome" aria-labelledby="welcome-heading">
    <h2 id="welcome-heading">${say("welcome")}</h2><p>${say("welcome-text")}</p>
    <button type="button" class="button primary go" aria-label=${say("watch.name")} @click=${leave(page.run.play)}>${icon("play")}${say("watch")}</button>
    <div class="starters">${samples}${starter("own-mesh", icon("open"), page.chooseFile)}</div></section>`;
}

export function cards() {
  const { welcome: isNew, presenting } = page.state.value;
  const fault = page.stage.absence.value;
  const absence = fault
    ? html`<section class="absence" role="alert"><h2>${say("no-picture-here")}</h2><p>${fault.message}</p><p>${fault.hint}</p><p>${say("no-picture-hint")}</p></section>`
    : nothing;
  return html`${absence}${isNew && !presenting ? welcome() : nothing}`;
}
