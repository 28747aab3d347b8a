// @ts-check
// A vertex with its circles and its numbers; circumcircles, lines of curvature.

import { html, nothing } from "lit-html";
import { formatNumber } from "../number.js";
import { numberOf, vertexOf } from "../numbers.js";
import { colourOf } from "../overlay.js";
import { isDark } from "../store.js";
import { say } from "../words.js";
import { button, grid, idOf, table, toggle } from "./parts.js";

/** @import { Drawn, Look, Probe } from "../generated/types.js" */
/** @import { Page } from "../actions.js" */

/** @param {number} radians */
const degrees = (radians) => `${formatNumber((180 / Math.PI) * radians, 5)}°`;

/** @param {Probe} probe @returns {(readonly [string, string])[]} */
export function rowsOf(probe) {
  const { position, edges, sum, turn, energy, defect, principal, radii } = probe;
  return [
    [say("vertex-position"), position.map((value) => formatNumber(value, 5)).join(", ")],
    [say("vertex-valence"), String(edges.length)],
    ...(turn === null ? [] : [/** @type {const} */ (["β₃", degrees(turn)])]),
    ["Σβ", `${formatNumber(sum, 6)} (${degrees(sum)})`],
    ["Wᵢ = Σβ − 2π", energy === null ? say("vertex-outside") : formatNumber(energy, 6)],
    [say("vertex-defect"), `${formatNumber(defect, 6)} (${degrees(defect)})`],
    [say("vertex-mean"), formatNumber(probe.meanCurvature, 6)],
    [say("vertex-gauss"), probe.boundary ? "–" : formatNumber(probe.gaussCurvature, 6)],
    [
      say("vertex-principal"),
      principal ? principal.map((value) => formatNumber(value, 5)).join(", ") : "–",
    ],
    [say("vertex-area"), formatNumber(probe.area, 6)],
    [
      say("vertex-radii"),
      `${formatNumber(Math.min(...radii), 4)} … ${formatNumber(Math.max(...radii), 4)}`,
    ],
  ];
}

/** @param {Page} page @param {Probe} probe */
function probed(page, probe) {
  const { vertex, boundary, energy, edges } = probe;
  const count = edges.filter(({ beta }) => beta === null).length;
  const note = boundary ? say("vertex-boundary", { counts: String(energy !== null), count }) : "";
  const mark = (/** @type {number} */ neighbour) =>
    page.edit.mark({ edges: Uint32Array.of(vertex, neighbour), triangles: new Uint32Array() });
  return html`${note ? html`<p class="hint">${note}</p>` : nothing}
    ${table(say("vertex-numbers", { vertex }), rowsOf(probe))}
    ${grid(
      say("vertex-edges"),
      [say("vertex-to"), say("vertex-length"), "β"],
      edges.map(({ neighbour, length, beta }) => [
        html`<button type="button" class="link" aria-label=${say("vertex-go", { neighbour })} @focus=${() => mark(neighbour)} @pointerenter=${() => mark(neighbour)}
        @blur=${() => page.edit.mark(null)} @pointerleave=${() => page.edit.mark(null)} @click=${() => page.edit.inspect({ probe: neighbour })}>${numberOf("vertices", neighbour)}</button>`,
        formatNumber(length, 4),
        beta === null ? say("vertex-none") : degrees(beta),
      ]),
    )}`;
}

/** @param {Drawn | null | undefined} circles */
const circlesText = (circles) =>
  circles
    ? say("circles-drawn", {
        ...circles,
        some: String(circles.drawn + circles.leftOut < circles.total),
      })
    : "";

/** @param {Look | null} look */
function directionsText(look) {
  const { directions, alignment } = look ?? {};
  if (!directions || !alignment) return "";
  const { aligned, edges } = alignment;
  return say("directions-drawn", {
    ...directions,
    share: edges > 0 ? ((100 * aligned) / edges).toFixed(1) : "–",
  });
}

/** @param {Page} page */
export function vertex(page) {
  const s = page.state.value;
  const { lookOptions, mode } = s;
  const look = (s.preview ?? s.extras)?.look ?? null;
  const id = idOf("probe");
  const dark = isDark(s);
  const key = (/** @type {number} */ kind, /** @type {string} */ text) =>
    html`<span class="key" .style=${`--kind:${colourOf(kind, dark)}`}>${text}</span>`;
  return html`<div class="row">${button(say("tool-pick"), () => page.edit.mode(mode === "pick" ? null : "pick"), { kind: "small", pressed: mode === "pick" })}
      <label class="inline" for=${id}>${say("vertex-number")} <input id=${id} class="short" type="number" min="0" step="1" .value=${lookOptions.probe === null ? "" : String(numberOf("vertices", lookOptions.probe))}
        @change=${(/** @type {any} */ { target }) => page.edit.inspect({ probe: target.value === "" ? null : vertexOf(target.valueAsNumber) })} /></label>
      ${lookOptions.probe === null ? nothing : button(say("vertex-leave"), () => page.edit.inspect({ probe: null }), { kind: "small" })}</div>
    ${look?.probe ? probed(page, look.probe) : lookOptions.probe === null ? nothing : html`<p class="hint">${say("vertex-missing", { vertex: lookOptions.probe })}</p>`}
    ${toggle(say("circles"), lookOptions.circles, (circles) => page.edit.inspect({ circles }), circlesText(look?.circles))}
    ${toggle(say("directions"), lookOptions.directions, (directions) => page.edit.inspect({ directions }), directionsText(look))}
    ${lookOptions.directions ? html`<p class="hint">${key(3, "κ₁")} ${key(4, "κ₂")}</p>` : nothing}`;
}
