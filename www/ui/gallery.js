// @ts-check
// Every figure of the papers, a click away: a dialog of cards, and in the panel what the
// paper reports, what is expected, and what was just measured here.

/** @import { Figure } from "../library.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { figures } from "../generated/library.js";
import { figureTitle, papers, sayFigure } from "../library.js";
import { isOver } from "../standing.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";

/** Whether a run has come as far as the figure wants. @param {Figure} figure @param {Readonly<PageState>} state */
export function isThere({ steps }, { reading, phase }) {
  if (!reading || phase === "running" || phase === "loading") return false;
  if (isOver(reading.status)) return true;
  return steps !== "rest" && reading.step >= steps;
}

/** @param {Controller} controller */
export function createGallery(controller) {
  const dialog = byId("gallery", HTMLDialogElement);
  const cards = byId("gallery-cards", HTMLElement);
  const section = byId("figure", HTMLElement);
  const heading = byId("figure-heading", HTMLElement);
  const said = byId("figure-reports", HTMLElement);
  const expected = byId("figure-expected", HTMLElement);
  const measured = byId("figure-measured", HTMLElement);
  const why = byId("figure-why", HTMLElement);

  /** @param {Figure} figure */
  function card(figure) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "card";
    const picture = document.createElement("img");
    picture.src = new URL(`../thumbnails/${figure.id}.png`, import.meta.url).href;
    picture.alt = "";
    picture.loading = "lazy";
    picture.width = 240;
    picture.height = 150;
    const title = document.createElement("strong");
    title.textContent = figureTitle(figure);
    const text = document.createElement("span");
    text.textContent = sayFigure(figure, "reports");
    button.append(picture, title, text);
    button.addEventListener("click", () => {
      dialog.close();
      controller.figure(figure);
    });
    return button;
  }

  function open() {
    dialog.showModal();
    if (cards.childElementCount > 0) return;
    for (const paper of papers) {
      const title = document.createElement("h3");
      title.textContent = say(`paper-${paper}`);
      const group = document.createElement("div");
      group.className = "cards";
      group.append(...figures.filter((figure) => figure.paper === paper).map(card));
      cards.append(title, group);
    }
  }
  byId("gallery-open", HTMLButtonElement).addEventListener("click", open);
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());

  /** @type {PageState["figure"]} */
  let figure = null;
  /** Where a run stands that the solver was asked to judge. */
  let asked = "";

  /** @param {Figure} judged @param {string} place */
  async function judge(judged, place) {
    setText(measured, say("figure-measuring"));
    const finding = await controller.judge(judged).catch(() => null);
    // Another step or figure came first.
    if (asked !== place || !finding) return;
    setText(measured, `${finding.ok ? "✓" : "✗"} ${say(finding.message)}`);
    setText(why, !finding.ok && judged.fallsShort ? sayFigure(judged, "shortfall") : "");
    measured.dataset.outcome = finding.ok ? "yes" : "no";
  }

  return {
    open,
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.figure !== figure) {
        figure = state.figure;
        section.hidden = !figure;
        if (!figure) return;
        setText(heading, figureTitle(figure));
        setText(said, sayFigure(figure, "reports"));
        setText(expected, sayFigure(figure, "expected"));
      }
      if (!figure) return;
      const { reading } = state;
      const place =
        reading && isThere(figure, state) ? `${figure.id} ${reading.step} ${reading.energy}` : "";
      if (place !== "" && place === asked) return;
      asked = place;
      measured.dataset.outcome = "open";
      setText(why, "");
      if (place !== "") judge(figure, place);
      else setText(measured, say("figure-waiting", { steps: figure.steps }));
    },
  };
}
