// @ts-check
// The legend: what colours mean, and behind it how the surface is drawn.

import { html, nothing } from "lit-html";
import { currentLanguage, languages, remember, speak } from "../language.js";
import { formatShort, formatSigned } from "../number.js";
import { colours, named } from "../options.js";
import { rangeOf } from "../range.js";
import { say } from "../words.js";
import { button, icon, segmented, select, toggle } from "./parts.js";

/** @import { Page } from "../actions.js" */

const STOPS = 17;

/** The colours of data from low to high, as the viewer has them. @param {Page} page @param {boolean} signed */
function ramp(page, signed) {
  const colours = page.stage.colours(signed, STOPS);
  const stops = Array.from(
    { length: colours.length / 3 },
    (_, n) => `rgb(${[...colours.subarray(3 * n, 3 * n + 3)].join(" ")})`,
  );
  return stops.length > 0 ? `background: linear-gradient(90deg, ${stops.join(", ")})` : "";
}

/** The value that a ball of the surface's area has. @param {Page} page @returns {number | null} */
function round(page) {
  const { colour } = page.state.value;
  const area = page.shown()?.area;
  if (!area) return null;
  const radius = Math.sqrt(area / (4 * Math.PI));
  return (
    { "mean-curvature": 1 / radius, "gauss-curvature": 1 / radius ** 2 }[
      /** @type {string} */ (colour)
    ] ?? null
  );
}

/** @param {Page} page */
function scale(page) {
  const s = page.state.value;
  const field = page.lead.clip.points[0]?.field;
  const range = s.comparison.difference === null ? s.range : page.stage.range.value;
  if (!range) return nothing;
  const [low, high] = range;
  const signed = s.comparison.difference === null && (field?.signed ?? low < 0);
  const place = (/** @type {number} */ value) => (100 * (value - low)) / (high - low);
  const ball = round(page);
  const hasBall = ball !== null && place(ball) < 88 && place(ball) > (signed ? 58 : 12);
  /** @type {[number, string, string][]} */
  const ticks = [
    [low, signed ? `≤ ${formatSigned(low)}` : formatShort(low), "first"],
    ...(signed ? [/** @type {[number, string, string]} */ ([0, "0", ""])] : []),
    ...(hasBall && ball !== null
      ? [/** @type {[number, string, string]} */ ([ball, say("round"), ""])]
      : []),
    [high, `≥ ${formatShort(high)}`, "last"],
  ];
  return html`<div class="ramp" .style=${ramp(page, signed)}></div>
    ${hasBall && ball !== null ? html`<i class="ball" .style=${`--x:${place(ball)}%`}></i>` : nothing}
    <div class="ticks" aria-hidden="true">${ticks.map(
      ([value, text, kind]) =>
        html`<span class=${kind} .style=${`--x:${place(value)}%`}>${text}</span>`,
    )}</div>
    <p class="held">${icon("lock")}${say("range-held")}</p>`;
}

/** Colours of this step alone. @param {Page} page */
function fit(page) {
  const field = page.lead.clip.surface(page.lead.u)?.field;
  if (field) page.run.range(rangeOf(field));
}

/** @param {Page} page */
function optionsOf(page) {
  const { view, colour, presenting, lookOptions, mesh, reading } = page.state.value;
  const themes = ["auto", "light", "dark"].map((id) => ({ id, label: say(`theme-${id}`) }));
  const tongues = Object.entries(languages).map(([id, label]) => ({ id, label }));
  return html`<div class="options">
    ${select(say("colour-by"), named(colours, "colour"), colour, (id) => page.run.colour(/** @type {any} */ (id)))}
    ${colour === "none" ? nothing : html`<div class="row">${button(say("fit-range"), () => fit(page), { kind: "small" })}</div>`}
    ${toggle(say("wireframe"), view.wireframe, (wireframe) => page.run.view({ wireframe }))}
    ${toggle(say("boundary-lines"), view.boundary, (boundary) => page.run.view({ boundary }))}
    <label class="inline">${say("cut")} <input type="range" min="0" max="95" .value=${String(view.cut)}
      @input=${(/** @type {any} */ { target }) => page.run.view({ cut: target.valueAsNumber })} /></label>
    ${(reading?.crossings ?? mesh?.info.selfIntersections ?? 0) > 0 ? toggle(say("double-curves"), lookOptions.crossings, (crossings) => page.edit.inspect({ crossings })) : nothing}
    ${segmented(
      say("shading"),
      [
        { id: "smooth", label: say("shading-smooth") },
        { id: "flat", label: say("shading-flat") },
      ],
      view.shading,
      (id) => page.run.view({ shading: id === "flat" ? "flat" : "smooth" }),
    )}
    ${toggle(say("high-contrast"), view.contrast || presenting, (contrast) => page.run.view({ contrast }))}
    ${segmented(say("theme"), themes, view.theme, (id) => {
      page.run.view({ theme: /** @type {any} */ (id) });
      remember("theme", id);
    })}
    ${select(say("language"), tongues, currentLanguage(), async (id) => {
      await speak(/** @type {any} */ (id));
      remember("language", id);
      document.documentElement.lang = id;
      page.patch({});
    })}
    <div class="row">${button(say("fit-view"), () => page.stage.fit(), { kind: "small" })}
      <small class="hint">${page.stage.renderer.value}</small></div>
  </div>`;
}

/** @param {Page} page */
export function legend(page) {
  const s = page.state.value;
  if (!s.mesh || s.welcome) return nothing;
  const what =
    s.comparison.difference === null ? say(`colour-${s.colour}`) : say("colour-distance");
  const isPlain = s.colour === "none" && s.comparison.difference === null;
  return html`<figure class="legend ${isPlain ? "plain" : ""} ${s.legend ? "open" : ""}" role="group" aria-label=${say("legend")}>
    ${s.legend ? optionsOf(page) : nothing}
    <button type="button" class="title" aria-expanded=${String(s.legend)} title="${say("colour-by")} (C)"
      @click=${() => page.patch({ legend: !s.legend })}><b>${isPlain ? say("look") : what}</b>${icon("down")}</button>
    ${isPlain ? nothing : html`<div role="img" aria-label=${say("colours-from-to", { what, low: s.range?.[0] ?? 0, high: s.range?.[1] ?? 1 })}>${scale(page)}</div>`}
  </figure>`;
}
