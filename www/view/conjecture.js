// The conjecture that area and localised energy fall together: on the mesh at hand, a dot an
// edge, and on random quadrilaterals.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { formatNumber } from "../number.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, grid, select, table } from "./parts.js";

/** @import { ConjectureReport, LabReport, QuadReport } from "../generated/types.js" */

/** Counterexamples that the list names, and edges that are drawn as dots, at most. */
const [LISTED, DOTS] = [50, 1500];
/** Tetrahedra, and as many flattened ones, between two pictures. */
const BATCH = 10_000;

const survey = signal(/** @type {{ report: ConjectureReport, of: unknown } | null} */ (null));
const chosen = signal(/** @type {{ n: number, quad: QuadReport } | null} */ (null));
const drawn = signal(/** @type {LabReport | null} */ (null));
const isDrawing = signal(false);
let isAsking = false;

/** With its sign, and a true minus. @param {number} value */
const signed = (value) => `${value < 0 ? "−" : "+"}${formatNumber(Math.abs(value), 6)}`;

/** @param {ConjectureReport} report @param {number} n */
const cornersOf = ({ corners }, n) => [...corners.subarray(4 * n, 4 * n + 4)];

/** Asks what holds on the mesh as it is. */
async function ask() {
  const of = page.get().reading;
  if (isAsking || survey.peek()?.of === of) return;
  isAsking = true;
  try {
    const report = await page.solver.ask("conjecture");
    survey.value = { report, of };
    chosen.value = null;
    const against = Math.min(report.counterexamples, 20_000);
    const ends = Array.from({ length: against }, (_, n) => cornersOf(report, n).slice(0, 2));
    const edges = Uint32Array.from(ends.flat());
    page.patch({ marks: { edges, triangles: new Uint32Array() } });
  } finally {
    isAsking = false;
  }
}

/** @param {ConjectureReport} report @param {number} n */
async function choose(report, n) {
  const corners = cornersOf(report, n);
  const [i, j, k, l] = corners;
  const pane = page.lead.clip.surface(page.lead.u)?.panes[0];
  const all = pane?.triangles ?? page.get().mesh?.triangles ?? new Uint32Array();
  const isBeside = (/** @type {number} */ t) => {
    const own = all.subarray(3 * t, 3 * t + 3);
    return own.includes(i) && own.includes(j) && (own.includes(k) || own.includes(l));
  };
  const triangles = Uint32Array.from({ length: all.length / 3 }, (_, t) => t).filter(isBeside);
  page.patch({ marks: { edges: Uint32Array.of(i, j), triangles } });
  chosen.value = { n, quad: await page.solver.ask("quadrilateral", { corners }) };
}

/** f_a against f_l; both axes are stretched by the cube root, as most edges lie near zero. @param {ConjectureReport} report */
function scatter({ area, localised, counterexamples }) {
  const largest = (/** @type {Float32Array} */ values) =>
    Math.cbrt(values.reduce((most, v) => Math.max(most, Math.abs(v)), 1e-30));
  const [right, high] = [largest(area), largest(localised)];
  const every = Math.max(1, Math.ceil(area.length / DOTS));
  const shown = [...area.keys()].filter((n) => n < counterexamples || n % every === 0);
  const dots = shown.map((n) => {
    const [x, y] = [(94 * Math.cbrt(area[n])) / right, (-65 * Math.cbrt(localised[n])) / high];
    const isAgainst = n < counterexamples;
    return svg`<circle class=${isAgainst ? "against" : ""} cx=${x} cy=${y} r=${isAgainst ? 2 : 0.8} />`;
  });
  return html`<svg class="scatter" viewBox="-100 -70 200 140" role="img" aria-label=${say("conjecture-plot")}>
    <rect x="-100" y="-70" width="100" height="70" /><rect x="0" y="0" width="100" height="70" />
    <line x1="-100" x2="100" y1="0" y2="0" /><line x1="0" x2="0" y1="-70" y2="70" />${dots}
    <text x="98" y="-3" text-anchor="end">f_a</text><text x="3" y="-62">f_l</text></svg>`;
}

/** @param {QuadReport} quad */
function quadrilateral({ points, area, localised, totalArea, foldDegrees, minAngleDegrees }) {
  const both = (/** @type {number[]} */ [before, after]) =>
    `${formatNumber(before, 4)}° → ${formatNumber(after, 4)}°`;
  const place = (/** @type {number[]} */ point) =>
    `(${point.map((x) => Number(x.toPrecision(6))).join(", ")})`;
  return table(say("quad"), [
    ["f_a", say("quad-gained", { gained: signed(area), area: formatNumber(totalArea, 5) })],
    ["f_l", signed(localised)],
    [say("quad-fold"), both(foldDegrees)],
    [say("reading-angle"), both(minAngleDegrees)],
    ["i, j, k, l", points.map(place).join(" ")],
  ]);
}

export function conjecture() {
  page.state.value;
  queueMicrotask(() => ask().catch(page.report));
  if (!survey.value) return html`<p class="hint">${say("computing")}</p>`;
  const { report } = survey.value;
  const { both, neither, areaOnly, localisedOnly, counterexamples, area, localised } = report;
  const against = areaOnly + localisedOnly;
  const total = both + neither + against;
  const percent = total > 0 ? ((100 * (total - against)) / total).toFixed(2) : "100";
  const names = Array.from({ length: Math.min(counterexamples, LISTED) }, (_, n) => {
    const [i, j] = cornersOf(report, n);
    const falls = { area: signed(area[n]), localised: signed(localised[n]) };
    return { id: String(n), label: say("counterexample", { i, j, ...falls }) };
  });
  const look = (/** @type {string} */ id) => choose(report, Number(id)).catch(page.report);
  const at = String(chosen.value?.n ?? "");
  return html`<p>${say("conjecture-holds", { total, against, percent })}</p>${scatter(report)}
    ${table(say("conjecture"), [
      [say("both-fall"), both],
      [say("neither-falls"), neither],
      [say("only-area"), areaOnly],
      [say("only-localised"), localisedOnly],
    ])}
    ${names.length > 0 ? select(say("counterexamples"), names, at, look) : nothing}
    ${chosen.value ? quadrilateral(chosen.value.quad) : nothing}`;
}

async function draw() {
  isDrawing.value = !isDrawing.peek();
  try {
    while (isDrawing.peek() && page.get().section === "lab") {
      drawn.value = await page.solver.ask("lab", { pairs: BATCH });
      await new Promise(requestAnimationFrame);
    }
  } finally {
    isDrawing.value = false;
  }
}

/** @param {LabReport} report */
function found({ tetrahedra: total, counterexamples, classes, strongest }) {
  const [areaOnly, localisedOnly] = counterexamples;
  const against = areaOnly + localisedOnly;
  const heads = [say("quad-fold"), say("lab-total"), say("lab-against"), say("histogram-share")];
  const rows = classes.map(({ below, total: of, counterexamples: part }, n) => [
    `${classes[n - 1]?.below ?? 0}–${below}°`,
    of,
    part,
    of === 0 ? "–" : `${((100 * part) / of).toPrecision(3)} %`,
  ]);
  return html`<p>${say("lab-found", { total, against, areaOnly, localisedOnly })}</p>${grid(say("lab"), heads, rows)}
    ${strongest ? quadrilateral(strongest) : nothing}`;
}

export const lab =
  () => html`${button(say(isDrawing.value ? "lab-stop" : "lab-run"), () => draw().catch(page.report), "small")}
  ${drawn.value ? found(drawn.value) : nothing}`;
