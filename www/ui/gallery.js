// @ts-check
// Every figure of the papers, a click away: a dialog of cards, and beside the surface what the
// paper reports, what is expected, and what was just measured here.

/** @import { Figure, Run } from "../figures.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t, translated } from "../language.js";
import { isOver } from "../standing.js";
import { byId, setText } from "./element.js";

/** @type {Readonly<Record<Figure["paper"], string>>} */
export const papers = {
  circle: "Bobenko and Schröder: discrete Willmore flow",
  "p-willmore": "Gruber and Aulisa: p-Willmore flow",
  flips: "Brink and Alboul: edge flips",
  curvature: "Xu and Zhang: mean-curvature variation",
};

/** @param {Figure} figure */
export const figureTitle = ({ figure, title }) => `${translated(figure)}: ${translated(title)}`;

/** What a figure's measure is given. @param {Readonly<PageState>} state @param {PageState["reading"]} first @returns {Run | null} */
function runOf({ reading, mesh, frame }, first) {
  if (!reading || !mesh || !frame || !first) return null;
  /** @type {Record<string, number>} */
  const jumps = {};
  for (const { name, standing } of frame.panes) {
    if (standing?.jump) jumps[name] = standing.jump.relative;
  }
  return {
    first,
    last: reading,
    steps: reading.step,
    info: mesh.info,
    jump: frame.jump,
    jumps,
    start: mesh.positions,
    positions: frame.positions,
    panes: [...frame.panes],
    regularised: null,
    refined: [],
    reference: null,
  };
}

/** Whether it takes more than one run to measure. @param {Figure} figure */
const isCompound = ({ refine, reference, regularise }) =>
  Boolean(refine || reference || regularise);

/** Whether a run has come as far as the figure wants. @param {Figure} figure @param {Readonly<PageState>} state */
export function isThere({ steps }, { reading, phase }) {
  if (!reading || phase === "running" || phase === "loading") return false;
  if (isOver(reading.status)) return true;
  return steps !== "rest" && reading.step >= steps;
}

/** @param {Figure} figure */
function waitingText(figure) {
  if (isCompound(figure)) {
    return t("It takes more than one run to measure: {command}", {
      command: `umbilic bench --table figures --figures ${figure.id}`,
    });
  }
  if (figure.steps === "rest") return t("Play, until it comes to rest.");
  return figure.steps === 0
    ? t("As it stands.")
    : t("Play, at least to step {steps}.", { steps: figure.steps });
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
    text.textContent = translated(figure.reports);
    button.append(picture, title, text);
    button.addEventListener("click", () => {
      dialog.close();
      controller.figure(figure);
    });
    return button;
  }

  let filled = false;
  async function open() {
    dialog.showModal();
    if (filled) return;
    try {
      const { figures } = await import("../figures.js");
      filled = true;
      for (const [paper, name] of Object.entries(papers)) {
        const title = document.createElement("h3");
        title.textContent = translated(name);
        const group = document.createElement("div");
        group.className = "cards";
        group.append(...figures.filter((figure) => figure.paper === paper).map(card));
        cards.append(title, group);
      }
    } catch (error) {
      dialog.close();
      controller.report(error);
    }
  }
  byId("gallery-open", HTMLButtonElement).addEventListener("click", open);
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());

  /** @type {PageState["figure"]} */
  let figure = null;
  /** @type {PageState["reading"]} */
  let first = null;
  return {
    open,
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.figure !== figure) {
        figure = state.figure;
        first = null;
        section.hidden = !figure;
        if (!figure) return;
        setText(heading, figureTitle(figure));
        setText(said, translated(figure.reports));
        setText(expected, translated(figure.expected));
      }
      if (!figure) return;
      if (state.reading?.step === 0 && state.reading.status === "ready") first = state.reading;
      const run = isCompound(figure) || !isThere(figure, state) ? null : runOf(state, first);
      const result = run && figure.measure(run);
      setText(
        measured,
        result ? `${result.ok ? "✓" : "✗"} ${translated(result.value)}` : waitingText(figure),
      );
      setText(why, result && !result.ok && figure.shortfall ? translated(figure.shortfall) : "");
      measured.dataset.verdict = result ? (result.ok ? "yes" : "no") : "open";
    },
  };
}
