// A vertex with its circles and its numbers; circumcircles, lines of curvature.

import { html, nothing } from "lit-html";
import { formatNumber } from "../number.js";
import { numberOf, vertexOf } from "../numbers.js";
import { colourOf } from "../overlay.js";
import { isDark } from "../store.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, grid, shortNumber, table, toggle } from "./parts.js";

/** @import { Probe } from "../generated/types.js" */

/** @param {number} radians */
const degrees = (radians) => `${formatNumber((180 / Math.PI) * radians, 5)}°`;
/** @param {number} radians */
const angle = (radians) => `${formatNumber(radians, 6)} (${degrees(radians)})`;
/** @param {readonly number[]} values */
const list = (values) => values.map((value) => formatNumber(value, 5)).join(", ");

/** @param {Probe} probe */
function numbers({ vertex, position, edges, sum, turn, energy, defect, principal, ...probe }) {
  const radii = [Math.min(...probe.radii), Math.max(...probe.radii)];
  return table(say("vertex-numbers", { vertex }), [
    [say("vertex-position"), list(position)],
    [say("vertex-valence"), String(edges.length)],
    turn !== null && ["β₃", degrees(turn)],
    ["Σβ", angle(sum)],
    ["Wᵢ = Σβ − 2π", energy === null ? say("vertex-outside") : formatNumber(energy, 6)],
    [say("vertex-defect"), angle(defect)],
    [say("vertex-mean"), formatNumber(probe.meanCurvature, 6)],
    [say("vertex-gauss"), probe.boundary ? "–" : formatNumber(probe.gaussCurvature, 6)],
    [say("vertex-principal"), principal ? list(principal) : "–"],
    [say("vertex-area"), formatNumber(probe.area, 6)],
    [say("vertex-radii"), radii.map((radius) => formatNumber(radius, 4)).join(" … ")],
  ]);
}

/** @param {Probe} probe */
function probed(probe) {
  const { vertex, boundary, energy, edges } = probe;
  const count = edges.filter(({ beta }) => beta === null).length;
  const note = say("vertex-boundary", { counts: String(energy !== null), count });
  const rows = edges.map(({ neighbour, length, beta }) => {
    const marks = { edges: Uint32Array.of(vertex, neighbour), triangles: new Uint32Array() };
    const [mark, unmark] = [() => page.patch({ marks }), () => page.patch({ marks: null })];
    const go = () => page.edit.inspect({ probe: neighbour });
    return [
      html`<button type="button" class="link" aria-label=${say("vertex-go", { neighbour })} @focus=${mark} @pointerenter=${mark}
        @blur=${unmark} @pointerleave=${unmark} @click=${go}>${numberOf("vertices", neighbour)}</button>`,
      formatNumber(length, 4),
      beta === null ? say("vertex-none") : degrees(beta),
    ];
  });
  return html`${boundary ? html`<p class="hint">${note}</p>` : nothing}
    ${numbers(probe)}
    ${grid(say("vertex-edges"), [say("vertex-to"), say("vertex-length"), "β"], rows)}`;
}

export function vertex() {
  const s = page.state.value;
  const { mode, lookOptions } = s;
  const { probe, circles, directions } = lookOptions;
  const look = (s.preview ?? s.extras)?.look ?? null;
  const { inspect } = page.edit;
  const { circles: drawn, directions: found, alignment } = look ?? {};
  const some = drawn && String(drawn.drawn + drawn.leftOut < drawn.total);
  const { aligned = 0, edges = 0 } = alignment ?? {};
  const share = edges > 0 ? ((100 * aligned) / edges).toFixed(1) : "–";
  const hint = (/** @type {string} */ text) => html`<p class="hint">${text}</p>`;
  const pick = () => page.edit.mode(mode === "pick" ? null : "pick");
  const shown = probe === null ? null : numberOf("vertices", probe);
  const go = (/** @type {number | null} */ to) =>
    inspect({ probe: to === null ? null : vertexOf(to) });
  const leave = probe === null ? nothing : button(say("vertex-leave"), () => go(null), "small");
  const missing = hint(say("vertex-missing", { vertex: probe }));
  const key = (/** @type {number} */ kind, /** @type {string} */ text) =>
    html`<span class="key" .style=${`--kind:${colourOf(kind, isDark(s))}`}>${text}</span>`;
  return html`<div class="row">${button(say("tool-pick"), pick, "small", { pressed: mode === "pick" })}
      ${shortNumber(say("vertex-number"), shown, go, { min: 0, step: 1 })}${leave}</div>
    ${look?.probe ? probed(look.probe) : probe === null ? nothing : missing}
    ${toggle(say("circles"), circles, (on) => inspect({ circles: on }))}${drawn ? hint(say("circles-drawn", { ...drawn, some })) : nothing}
    ${toggle(say("directions"), directions, (on) => inspect({ directions: on }))}${found ? hint(say("directions-drawn", { ...found, share })) : nothing}
    ${directions ? html`<p class="hint">${key(3, "κ₁")} ${key(4, "κ₂")}</p>` : nothing}`;
}
