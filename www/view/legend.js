// The legend: what colours mean, and behind it how the surface is drawn.

import "../style/legend.css";
import { html, nothing } from "lit-html";
import { currentLanguage, languages, remember, speak } from "../language.js";
import { formatShort, formatSigned } from "../number.js";
import { colours, named } from "../options.js";
import { rangeOf } from "../range.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, icon, segmented, select, slider, toggle } from "./parts.js";

const STOPS = 17;

/** The value that a ball of the surface's area has. @returns {number | null} */
function round() {
  const area = page.shown()?.area;
  if (!area) return null;
  const radius = Math.sqrt(area / (4 * Math.PI));
  /** @type {Record<string, number>} */
  const values = { "mean-curvature": 1 / radius, "gauss-curvature": 1 / radius ** 2 };
  return values[page.state.value.colour] ?? null;
}

function scale() {
  const { comparison, range: held } = page.state.value;
  const isField = comparison.difference === null;
  const range = isField ? held : page.stage.range.value;
  if (!range) return nothing;
  const [low, high] = range;
  const signed = isField && (page.lead.clip.points[0]?.field?.signed ?? low < 0);
  const place = (/** @type {number} */ value) => (100 * (value - low)) / (high - low);
  const ball = round();
  const hasBall = ball !== null && place(ball) < 88 && place(ball) > (signed ? 58 : 12);
  const tick = (/** @type {number} */ value, /** @type {string} */ text, kind = "") =>
    html`<span class=${kind} .style=${`--x:${place(value)}%`}>${text}</span>`;
  const stops = page.stage.colours(signed, STOPS).join(", ");
  return html`<div class="ramp" .style=${stops ? `background: linear-gradient(90deg, ${stops})` : ""}></div>
    ${hasBall ? html`<i class="ball" .style=${`--x:${place(ball)}%`}></i>` : nothing}
    <div class="ticks" aria-hidden="true">${tick(low, signed ? `≤ ${formatSigned(low)}` : formatShort(low), "first")}
      ${signed ? tick(0, "0") : nothing}${hasBall ? tick(ball, say("round"), "round") : nothing}
      ${tick(high, `≥ ${formatShort(high)}`, "last")}</div>
    <p class="held">${icon("lock")}${say("range-held")}</p>`;
}

/** Colours of this step alone. */
function fit() {
  const field = page.lead.clip.surface(page.lead.u)?.field;
  if (field) page.patch({ range: rangeOf(field) });
}

/** CSS pixels of an edge below which few are drawn (`fragment_wire` in surface.wgsl). */
const DENSE = 8;

/** Whether edges lie so close on the screen that they are left out. */
function isDense() {
  // The camera is the picture's.
  page.stage.pictures.value;
  const { mesh } = page.state.value;
  const { viewer } = page.stage.first;
  const area = page.shown()?.area;
  const at = mesh && viewer?.project(mesh.positions);
  const beside = at && viewer?.unproject({ ...at, x: at.x + 1 });
  if (!mesh || !area || !beside) return false;
  const pixel = Math.hypot(...beside.map((value, axis) => value - mesh.positions[axis]));
  return Math.sqrt((4 * area) / (Math.sqrt(3) * mesh.info.faces)) < DENSE * pixel;
}

function optionsOf() {
  const { view, colour, presenting, lookOptions, mesh, reading } = page.state.value;
  const { view: set } = page.run;
  const tongues = Object.entries(languages).map(([id, label]) => ({ id, label }));
  const crosses = (reading?.crossings ?? mesh?.info.selfIntersections ?? 0) > 0;
  const doubled = (/** @type {boolean} */ crossings) => page.edit.inspect({ crossings });
  return html`<div class="options">
    ${select(say("colour-by"), named(colours, "colour"), colour, page.run.colour)}
    ${colour === "none" ? nothing : html`<div class="row">${button(say("fit-range"), fit, "small")}</div>`}
    ${toggle(say("wireframe"), view.wireframe, (wireframe) => set({ wireframe }))}
    ${view.wireframe && isDense() ? html`<p class="hint">${say("wireframe-dense")}</p>` : nothing}
    ${(mesh?.info.boundaryLoops ?? 0) > 0 ? toggle(say("boundary-lines"), view.boundary, (boundary) => set({ boundary })) : nothing}
    ${slider(say("cut"), view.cut, 0, 95, (cut) => set({ cut }))}
    ${crosses ? toggle(say("double-curves"), lookOptions.crossings, doubled) : nothing}
    ${segmented(say("shading"), named(["smooth", "flat"], "shading"), view.shading, (shading) => set({ shading }))}
    ${toggle(say("high-contrast"), view.contrast || presenting, (contrast) => set({ contrast }))}
    ${segmented(say("theme"), named(["auto", "light", "dark"], "theme"), view.theme, (theme) => {
      set({ theme });
      remember("theme", theme);
    })}
    ${select(say("language"), tongues, currentLanguage(), async (id) => {
      await speak(/** @type {any} */ (id));
      remember("language", id);
      document.documentElement.lang = id;
      page.patch({});
    })}
    <div class="row">${button(say("fit-view"), page.stage.fit, "small")}
      <small class="hint">${page.stage.renderer.value}</small></div>
  </div>`;
}

export function legend() {
  const { colour, comparison, legend: isAsked, presenting, range } = page.state.value;
  const isOpen = isAsked && !presenting;
  const isField = comparison.difference === null;
  const what = say(isField ? `colour-${colour}` : "colour-distance");
  const isPlain = colour === "none" && isField;
  const [low, high] = range ?? [0, 1];
  return html`<figure class="legend ${isPlain ? "plain" : ""} ${isOpen ? "open" : ""}" role="group" aria-label=${say("legend")}>
    ${isOpen ? optionsOf() : nothing}
    <button type="button" class="title" aria-expanded=${String(isOpen)} title="${say("colour-by")} (C)"
      @click=${() => page.patch({ legend: !isOpen })}><b>${isPlain ? say("look") : what}</b>${icon("down")}</button>
    ${isPlain ? nothing : html`<div role="img" aria-label=${say("colours-from-to", { what, low, high })}>${scale()}</div>`}
  </figure>`;
}
