// The card that says why the flow stands as it does, and what helps.

import { html, nothing } from "lit-html";
import { figures } from "../generated/library.js";
import { sampleName, sayFigure } from "../library.js";
import { isOver } from "../session.js";
import { statusText } from "../status.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, close } from "./parts.js";

/** What comes next where nothing is wrong. */
function onwards() {
  const { figure, source } = page.state.value;
  const sample = source?.kind === "sample" && source.id === "vesicle" ? "coarse-torus" : "vesicle";
  const next = figure && figures[figures.indexOf(figure) + 1];
  const label = say("next", { name: next ? sayFigure(next, "title") : sampleName(sample) });
  const open = () => (next ? page.open.figure(next) : page.open.sample(sample));
  const explain = () => page.patch({ tab: "measure", section: "equation", why: null });
  return html`${button(label, open, "small primary")}${button(say("what-measures"), explain, "small")}`;
}

export function why() {
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
