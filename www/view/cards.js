// @ts-check
// Cards over the stage, that somebody asked for: the welcome, why it stands so, a question.

import { html, nothing } from "lit-html";
import { figures } from "../generated/library.js";
import { remember } from "../language.js";
import { isOver } from "../session.js";
import { statusText } from "../status.js";
import torus from "../thumbnails/coarse-torus-after.webp?url";
import vesicle from "../thumbnails/vesicle-after.webp?url";
import { say } from "../words.js";
import { button, close, icon } from "./parts.js";

/** @import { Page } from "../actions.js" */

/** What one may begin with beside the surface that is there. */
export const starters = /** @type {const} */ (["vesicle", "coarse-torus"]);
/** Where those lead; fetched before all other pictures. */
const ends = { vesicle, "coarse-torus": torus };

/** @param {Page} page */
export function leaveWelcome(page) {
  if (!page.get().welcome) return;
  remember("visited", "yes");
  page.patch({ welcome: false });
}

/** @param {Page} page */
function welcome(page) {
  /** @param {() => unknown} act */
  const leave = (act) => () => {
    leaveWelcome(page);
    act();
  };
  return html`<section class="card welcome" aria-labelledby="welcome-heading">
    <h2 id="welcome-heading">${say("welcome")}</h2><p>${say("welcome-text")}</p>
    <button type="button" class="button primary go" @click=${leave(page.run.play)}>${icon("play")}${say("watch")}</button>
    <div class="starters">${starters.map(
      (
        id,
      ) => html`<button type="button" class="starter" @click=${leave(() => page.open.sample(id))}>
        <span class="thumb"><img src=${ends[id]} alt="" /></span>${say(`starter-${id}`)}<small>${say(`starter-${id}.small`)}</small></button>`,
    )}<button type="button" class="starter" @click=${leave(() => page.chooseFile())}>
        <span class="thumb">${icon("open")}</span>${say("starter-own")}<small>${say("starter-own.small")}</small></button>
    </div></section>`;
}

/** What comes next where nothing is wrong. @param {Page} page */
function onwards(page) {
  const { figure } = page.state.value;
  const next = figure ? figures[figures.indexOf(figure) + 1] : undefined;
  return [
    next
      ? button(say("next-figure"), () => page.open.figure(next), { kind: "small primary" })
      : button(
          say("next-sample", { name: say("starter-vesicle") }),
          () => page.open.sample("vesicle"),
          {
            kind: "small primary",
          },
        ),
    button(
      say("what-measures"),
      () => page.patch({ tab: "measure", section: "equation", why: null }),
      { kind: "small" },
    ),
  ];
}

/** @param {Page} page */
function why(page) {
  const { why: shown, reading } = page.state.value;
  if (!shown) return nothing;
  const { diagnosis } = shown;
  const arrived =
    reading && isOver(reading.status) && reading.message
      ? say("why-ended", {
          ended: statusText(page.state.value, reading, false),
          reason: reading.message,
        })
      : say("nothing-wrong");
  const elements = diagnosis
    ? diagnosis.vertices.length + diagnosis.faces.length + diagnosis.edges.length
    : 0;
  const show = () => {
    if (!diagnosis) return;
    if (shown.isShown) page.edit.mark(null);
    else page.why.point(diagnosis, page.stage.camera());
    page.patch({ why: { ...shown, isShown: !shown.isShown } });
  };
  return html`<section class="card why" aria-labelledby="why-heading">
    ${close(page.why.close)}
    <h2 id="why-heading">${say("why-heading")}</h2><p id="why-sentence">${diagnosis ? say(diagnosis.message) : arrived}</p>
    <div class="row">${
      diagnosis
        ? diagnosis.remedies.map((remedy, n) =>
            button(say(remedy.label), () => page.why.remedy(remedy), {
              kind: n === 0 ? "small primary" : "small",
            }),
          )
        : onwards(page)
    }
    ${elements > 0 ? button(say("why-show"), show, { kind: "small", pressed: shown.isShown }) : nothing}</div>
  </section>`;
}

/** @param {Page} page */
function absence(page) {
  const fault = page.stage.absence.value;
  return fault
    ? html`<section class="absence" role="alert"><h2>${say("no-picture-here")}</h2><p>${fault.message}</p><p>${fault.hint}</p><p>${say("no-picture-hint")}</p></section>`
    : nothing;
}

/** @param {Page} page */
export function cards(page) {
  const s = page.state.value;
  return html`${absence(page)}${s.welcome && !s.presenting ? welcome(page) : nothing}${s.presenting ? nothing : why(page)}`;
}
