// Cards over the stage, that somebody asked for: the welcome, why it stands so, a question.

import { html, nothing } from "lit-html";
import { figures } from "../generated/library.js";
import { remember } from "../language.js";
import { isOver } from "../session.js";
import { statusText } from "../status.js";
import torus from "../thumbnails/coarse-torus-after.webp?url";
import vesicle from "../thumbnails/vesicle-after.webp?url";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, close, icon } from "./parts.js";

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
  /** @param {string} id @param {unknown} picture @param {() => unknown} act */
  const starter = (id, picture, act) =>
    html`<button type="button" class="starter" @click=${leave(act)}>
      <span class="thumb">${picture}</span>${say(`starter-${id}`)}<small>${say(`starter-${id}.small`)}</small></button>`;
  const samples = Object.entries(ends).map(([id, address]) =>
    starter(id, html`<img src=${address} alt="" />`, () => page.open.sample(id)),
  );
  return html`<section class="card welcome" aria-labelledby="welcome-heading">
    <h2 id="welcome-heading">${say("welcome")}</h2><p>${say("welcome-text")}</p>
    <button type="button" class="button primary go" @click=${leave(page.run.play)}>${icon("play")}${say("watch")}</button>
    <div class="starters">${samples}${starter("own", icon("open"), page.chooseFile)}</div></section>`;
}

/** What comes next where nothing is wrong. */
function onwards() {
  const { figure } = page.state.value;
  const next = figure && figures[figures.indexOf(figure) + 1];
  const label = next ? say("next-figure") : say("next-sample", { name: say("starter-vesicle") });
  const open = () => (next ? page.open.figure(next) : page.open.sample("vesicle"));
  const explain = () => page.patch({ tab: "measure", section: "equation", why: null });
  return html`${button(label, open, "small primary")}${button(say("what-measures"), explain, "small")}`;
}

function why() {
  const s = page.state.value;
  const { why: shown, reading } = s;
  if (!shown) return nothing;
  const { diagnosis, isShown } = shown;
  const ended =
    reading?.message && isOver(reading.status)
      ? say("why-ended", { ended: statusText(s, reading, false), reason: reading.message })
      : say("nothing-wrong");
  const show = () => {
    if (isShown || !diagnosis) page.patch({ marks: null });
    else page.why.point(diagnosis);
    page.patch({ why: { diagnosis, isShown: !isShown } });
  };
  const remedies = diagnosis?.remedies.map((remedy, n) => {
    const kind = n === 0 ? "small primary" : "small";
    return button(say(remedy.label), () => page.why.remedy(remedy), kind);
  });
  const { vertices = [], faces = [], edges = [] } = diagnosis ?? {};
  const hasPlace = vertices.length + faces.length + edges.length > 0;
  return html`<section class="card why" aria-labelledby="why-heading">
    ${close(page.why.close)}
    <h2 id="why-heading">${say("why-heading")}</h2><p id="why-sentence">${diagnosis ? say(diagnosis.message) : ended}</p>
    <div class="row">${remedies ?? onwards()}
      ${hasPlace ? button(say("why-show"), show, "small", { pressed: isShown }) : nothing}</div>
  </section>`;
}

export function cards() {
  const { welcome: isNew, presenting } = page.state.value;
  const fault = page.stage.absence.value;
  const absence = fault
    ? html`<section class="absence" role="alert"><h2>${say("no-picture-here")}</h2><p>${fault.message}</p><p>${fault.hint}</p><p>${say("no-picture-hint")}</p></section>`
    : nothing;
  return html`${absence}${isNew && !presenting ? welcome() : nothing}${presenting ? nothing : why()}`;
}
