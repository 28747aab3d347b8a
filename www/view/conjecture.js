// @ts-check
// The conjecture that area and localised energy fall together: on the mesh at hand, a dot an
// edge, and on random quadrilaterals.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { formatNumber } from "../number.js";
import { say } from "../words.js";
import { button, grid, select, table } from "./parts.js";

/** @import { ConjectureReport, LabReport, QuadReport } from "../generated/types.js" */
/** @import { Page } from "../actions.js" */

/** Counterexamples that the list names, and edges that are drawn as dots, at most. */
const [LISTED, DOTS] = [50, 1500];
/** Tetrahedra, and as many flattened ones, between two pictures. */
const BATCH = 10_000;

/** @type {import("@preact/signals-core").Signal<{ report: ConjectureReport, of: unknown } | null>} */
const survey = signal(null);
/** @type {import("@preact/signals-core").Signal<{ n: number, quad: QuadReport } | null>} */
const chosen = signal(null);
/** @type {import("@preact/signals-core").Signal<LabReport | null>} */
const drawn = signal(null);
const isDrawing = signal(false);
let isAsking = false;

/** With its sign, and a true minus. @param {number} value */
export const signed = (value) => `${value < 0 ? "−" : "+"}${formatNumber(Math.abs(value), 6)}`;

/** @param {ConjectureReport} report @param {number} n */
const cornersOf = ({ corners }, n) => [...corners.subarray(4 * n, 4 * n + 4)];

/** Asks what holds on the mesh as it is. @param {Page} page */
async function ask(page) {
  const of = page.get().reading;
  if (isAsking || survey.peek()?.of === of) return;
  isAsking = true;
  try {
    const report = await page.edit.conjecture();
    survey.value = { report, of };
    chosen.value = null;
    const edges = Array.from({ length: Math.min(report.counterexamples, 20_000) }, (_, n) =>
      cornersOf(report, n).slice(0, 2),
    ).flat();
    page.edit.mark({ edges: Uint32Array.from(edges), triangles: new Uint32Array() });
  } catch (error) {
    page.report(error);
  } finally {
    isAsking = false;
  }
}

/** @param {Page} page @param {ConjectureReport} report @param {number} n */
async function choose(page, report, n) {
  const corners = cornersOf(report, n);
  const [i, j, k, l] = corners;
  const pane = page.lead.clip.surface(page.lead.u)?.panes[0];
  const all = pane?.triangles ?? page.get().mesh?.triangles ?? new Uint32Array();
  const triangles = [];
  for (let t = 0; 3 * t < all.length; t += 1) {
    const own = [all[3 * t], all[3 * t + 1], all[3 * t + 2]];
    if (own.includes(i) && own.includes(j) && (own.includes(k) || own.includes(l)))
      triangles.push(t);
  }
  page.edit.mark({ edges: Uint32Array.of(i, j), triangles: Uint32Array.from(triangles) });
  chosen.value = { n, quad: await page.edit.quadrilateral(corners) };
}

/** f_a against f_l; both axes are stretched by the cube root, as most edges lie near zero. @param {ConjectureReport} report */
function scatter({ area, localised, counterexamples }) {
  const largest = (/** @type {Float32Array} */ values) =>
    Math.cbrt(values.reduce((most, v) => Math.max(most, Math.abs(v)), 1e-30));
  const [right, high] = [largest(area), largest(localised)];
  const every = Math.max(1, Math.ceil(area.length / DOTS));
  const dots = [...area.keys()].filter((n) => n < counterexamples || n % every === 0);
  return html`<svg class="scatter" viewBox="-100 -70 200 140" role="img" aria-label=${say("conjecture-plot")}>
    <rect x="-100" y="-70" width="100" height="70" /><rect x="0" y="0" width="100" height="70" />
    <line x1="-100" x2="100" y1="0" y2="0" /><line x1="0" x2="0" y1="-70" y2="70" />
    ${dots.map((n) => svg`<circle class=${n < counterexamples ? "against" : ""} cx=${(94 * Math.cbrt(area[n])) / right} cy=${(-65 * Math.cbrt(localised[n])) / high} r=${n < counterexamples ? 2 : 0.8} />`)}
    <text x="98" y="-3" text-anchor="end">f_a</text><text x="3" y="-62">f_l</text></svg>`;
}

/** @param {QuadReport} quad */
function quadrilateral({ points, area, localised, totalArea, foldDegrees, minAngleDegrees }) {
  const both = (/** @type {number[]} */ [before, after]) =>
    `${formatNumber(before, 4)}° → ${formatNumber(after, 4)}°`;
  return table(say("quad"), [
    ["f_a", say("quad-gained", { gained: signed(area), area: formatNumber(totalArea, 5) })],
    ["f_l", signed(localised)],
    [say("quad-fold"), both(foldDegrees)],
    [say("reading-angle"), both(minAngleDegrees)],
    [
      "i, j, k, l",
      points.map((point) => `(${point.map((x) => Number(x.toPrecision(6))).join(", ")})`).join(" "),
    ],
  ]);
}

/** @param {Page} page */
export function conjecture(page) {
  page.state.value;
  queueMicrotask(() => ask(page));
  const found = survey.value;
  if (!found) return html`<p class="hint">${say("computing")}</p>`;
  const { report } = found;
  const { both, neither, areaOnly, localisedOnly, counterexamples } = report;
  const total = both + neither + areaOnly + localisedOnly;
  const against = areaOnly + localisedOnly;
  const names = Array.from({ length: Math.min(counterexamples, LISTED) }, (_, n) => {
    const [i, j] = cornersOf(report, n);
    return {
      id: String(n),
      label: say("counterexample", {
        i,
        j,
        area: signed(report.area[n]),
        localised: signed(report.localised[n]),
      }),
    };
  });
  return html`<p>${say("conjecture-holds", { total, against, percent: total > 0 ? ((100 * (total - against)) / total).toFixed(2) : "100" })}</p>
    ${scatter(report)}
    ${table(say("conjecture"), [
      [say("both-fall"), both],
      [say("neither-falls"), neither],
      [say("only-area"), areaOnly],
      [say("only-localised"), localisedOnly],
    ])}
    ${names.length > 0 ? select(say("counterexamples"), names, String(chosen.value?.n ?? ""), (id) => choose(page, report, Number(id)).catch(page.report)) : nothing}
    ${chosen.value ? quadrilateral(chosen.value.quad) : nothing}`;
}

/** @param {Page} page */
async function draw(page) {
  isDrawing.value = !isDrawing.peek();
  try {
    while (isDrawing.peek() && page.get().section === "lab") {
      drawn.value = await page.edit.lab(BATCH);
      await new Promise(requestAnimationFrame);
    }
  } catch (error) {
    page.report(error);
  }
  isDrawing.value = false;
}

/** @param {Page} page */
export function lab(page) {
  const report = drawn.value;
  const percent = (/** @type {number} */ part, /** @type {number} */ of) =>
    of === 0 ? "–" : `${((100 * part) / of).toPrecision(3)} %`;
  return html`${button(say(isDrawing.value ? "lab-stop" : "lab-run"), () => draw(page), { kind: "small" })}
    ${
      report
        ? html`<p>${say("lab-found", { total: report.tetrahedra, against: report.counterexamples[0] + report.counterexamples[1], areaOnly: report.counterexamples[0], localisedOnly: report.counterexamples[1] })}</p>
        ${grid(
          say("lab"),
          [say("quad-fold"), say("lab-total"), say("lab-against"), say("histogram-share")],
          report.classes.map(({ below, total, counterexamples }, n) => [
            `${n === 0 ? 0 : report.classes[n - 1].below}–${below}°`,
            total,
            counterexamples,
            percent(counterexamples, total),
          ]),
        )}
        ${report.strongest ? quadrilateral(report.strongest) : nothing}`
        : nothing
    }`;
}
