// @ts-check
// The tab of numbers: readings, what the figure of a paper says, the histogram, and what is
// looked at more closely.

import "../style/measure.css";
import { html, nothing, svg } from "lit-html";
import { figureTitle, sayFigure } from "../library.js";
import { formatBeside, formatNumber, formatShort, formatSigned } from "../number.js";
import { histogram } from "../range.js";
import { symbol } from "../status.js";
import { say } from "../words.js";
import { conjecture, lab } from "./conjecture.js";
import { grid, lazy, section, table } from "./parts.js";
import { phases } from "./phases.js";
import { study } from "./study.js";
import { vertex } from "./vertex.js";

/** @import { Page } from "../actions.js" */
/** @import { State as Reading } from "../generated/types.js" */

/** With what sets its formulas. */
const equation = lazy(() => import("./equation.js").then(({ equation }) => equation));

/** Rows of the table at most; of more steps every so manyth. */
const MOST_ROWS = 200;
const BINS = 22;

/** A share of the start, in percent. @param {number | null} now @param {number | null} first */
function since(now, first) {
  if (now === null || first === null || first === 0) return "";
  const percent = (100 * (now - first)) / Math.abs(first);
  if (Math.abs(percent) < 0.05) return "";
  return `${percent < 0 ? "−" : "+"}${Math.abs(percent).toFixed(1)} %`;
}

/** @param {string} text @param {string} change */
const changed = (text, change) =>
  html`${text}${change ? html` <small>${change}</small>` : nothing}`;

/** The step size in the table. @param {Reading} reading */
function stepSize({ flips, dt, tau }) {
  if (!flips) return `${formatNumber(dt, 4)} (τ = ${formatNumber(tau, 3)})`;
  // Above what a mesh can hold: all there are.
  return dt > 2 ** 31 - 1 ? say("flip-all") : say("count-flips", { count: dt });
}

/** @param {Reading} reading */
function volume({ volume: now, reducedVolume }) {
  if (now === null) return say("volume-none");
  const text = formatNumber(now, 6);
  return reducedVolume === null
    ? text
    : say("volume-reduced", { volume: text, reduced: reducedVolume });
}

/** @param {Page} page */
function readings(page) {
  page.player.tick.value;
  const s = page.state.value;
  const { mesh, options } = s;
  const shown = page.shown();
  const first = page.lead.clip.points[0]?.state;
  if (!mesh) return nothing;
  const { genus } = mesh.info;
  const { clip, u } = page.lead;
  const made = clip.points[clip.at(u).index]?.drawable;
  const { vertices, faces } = made
    ? { vertices: made.positions.length / 3, faces: made.triangles.length / 3 }
    : mesh.info;
  /** @type {(readonly [string, unknown, string?])[]} */
  const rows = [];
  if (shown) {
    rows.push(
      [say("reading-energy"), formatNumber(shown.energy, 6), "energy"],
      ...(options.flow === "circle"
        ? [/** @type {const} */ (["W/2", formatNumber(shown.energyNormalised, 6), "half"])]
        : []),
      [say("reading-step"), String(shown.step), "step"],
      [say("reading-time"), formatNumber(shown.time), "time"],
      [say("reading-dt"), stepSize(shown), "dt"],
      [
        say("reading-area"),
        changed(formatNumber(shown.area, 6), since(shown.area, first?.area ?? null)),
        "area",
      ],
      [
        say("reading-volume"),
        s.film ? volume(shown) : changed(volume(shown), since(shown.volume, first?.volume ?? null)),
        "volume",
      ],
    );
  }
  rows.push(
    [say("reading-genus"), genus === null ? say("genus-none") : String(genus), "genus"],
    [say("reading-vertices"), String(vertices), "vertices"],
    [say("reading-faces"), String(faces), "faces"],
  );
  if (shown) {
    rows.push(
      [say("reading-angle"), `${formatNumber(shown.minAngleDegrees, 4)}°`, "angle"],
      [
        say("reading-milliseconds"),
        shown.milliseconds > 0 ? formatNumber(shown.milliseconds, 3) : "–",
        "milliseconds",
      ],
    );
    if (shown.crossings !== undefined)
      rows.push([say("reading-crossings"), String(shown.crossings), "crossings"]);
    if (shown.multipliers?.tension != null)
      rows.push([say("reading-tension"), formatNumber(shown.multipliers.tension, 4)]);
    if (shown.multipliers?.pressure != null)
      rows.push([say("reading-pressure"), formatNumber(shown.multipliers.pressure, 4)]);
  }
  const jump = s.extras?.jump;
  if (jump) rows.push([say("reading-jump"), formatNumber(jump.relative, 3)]);
  return html`${table(say("readings"), rows)}${options.flow === "circle" ? html`<p class="hint">${say("what-w-says")}</p>` : nothing}`;
}

/** Of what is shown: it stays while the display moves from one true step to the next. */
let binned = {
  of: /** @type {Float32Array} */ (new Float32Array()),
  range: /** @type {readonly number[]} */ ([]),
  shares: [0],
};

/** @param {Page} page */
function spread(page) {
  page.player.tick.value;
  const { range, colour } = page.state.value;
  const field = page.lead.clip.surface(page.lead.u)?.field;
  if (!field || !range || field.name !== colour) return nothing;
  const { values: of } = field;
  if (binned.of !== of || binned.range !== range)
    binned = { of, range, shares: histogram(of, range, BINS) };
  const { shares } = binned;
  const most = Math.max(...shares, 1e-9);
  const colours = page.stage.colours(field.signed, BINS);
  const rgb = (/** @type {number} */ n) =>
    `rgb(${[...colours.subarray(3 * n, 3 * n + 3)].join(" ")})`;
  const bars = shares.map(
    (share, n) =>
      svg`<rect x=${2 + n * 13.4} y=${70 - (66 * share) / most} width="12.4" height=${(66 * share) / most} fill=${colours.length ? rgb(n) : "currentColor"} />`,
  );
  const what = say(`colour-${colour}`);
  const step = (range[1] - range[0]) / BINS;
  return html`<hr /><h3>${say("over-the-surface", { what })}</h3>
    <svg class="histogram" viewBox="0 0 300 84" role="img" aria-label=${say("over-the-surface", { what })}>
      ${bars}<line x1="0" x2="300" y1="70.5" y2="70.5" />
      <text x="2" y="83">≤ ${formatSigned(range[0])}</text>
      ${range[0] < 0 ? svg`<text x="149" y="83" text-anchor="middle">0</text>` : nothing}
      <text x="298" y="83" text-anchor="end">≥ ${formatShort(range[1])}</text>
    </svg>
    ${section(page, "bins", say("histogram-table"), () =>
      grid(
        say("histogram-table"),
        [say("histogram-from"), say("histogram-share")],
        shares.map((share, n) => [
          formatShort(range[0] + n * step),
          `${(100 * share).toFixed(2)} %`,
        ]),
      ),
    )}`;
}

/** What stands in the paper, and what came of it here. @param {Page} page */
function figure(page) {
  const { figure: shown } = page.state.value;
  if (!shown) return nothing;
  const finding = page.finding.value;
  const isHere = finding?.id === shown.id;
  return html`<section class="figure"><h3>${say(`paper-${shown.paper}.authors`)}, ${figureTitle(shown)}</h3>
    <p>${sayFigure(shown, "reports")}</p><p class="hint">${say("figure-expects")} ${sayFigure(shown, "expected")}</p>
    <p class="measured ${isHere ? (finding.ok ? "good" : "other") : ""}">${isHere ? html`${say(finding.ok ? "figure-holds" : "figure-differs")} ${say(finding.message)}` : say("figure-waiting", { steps: shown.steps })}</p>
    ${isHere && !finding.ok && shown.fallsShort ? html`<p class="hint">${sayFigure(shown, "shortfall")}</p>` : nothing}
  </section><hr />`;
}

/** @param {Page} page */
function allSteps(page) {
  page.player.tick.value;
  const s = page.state.value;
  const { points } = page.lead.clip;
  const every = Math.ceil(points.length / MOST_ROWS);
  const some = points.filter((_, n) => n % every === 0 || n === points.length - 1);
  const first = points[0]?.state.energy ?? 0;
  const heads = ["reading-step", "reading-time", "reading-dt"].map((id) => say(id));
  return html`<div id="plot-rows">${grid(
    say("all-steps"),
    [...heads, symbol(s), say("reading-area"), say("reading-volume"), say("reading-angle")],
    some.map(({ state }) => [
      state.step,
      formatNumber(state.time),
      formatNumber(state.dt, 4),
      html`<span title=${formatNumber(state.energy, 6)}>${formatBeside(state.energy, first)}</span>`,
      formatNumber(state.area, 6),
      formatNumber(state.volume, 6),
      formatNumber(state.minAngleDegrees, 4),
    ]),
  )}</div>`;
}

/** @param {Page} page */
export function measure(page) {
  const { reading } = page.state.value;
  const isFlips = reading?.flips !== null && reading !== null;
  return html`${figure(page)}${readings(page)}${spread(page)}
    ${isFlips ? section(page, "conjecture", say("conjecture"), () => conjecture(page)) : nothing}
    ${isFlips ? section(page, "lab", say("lab"), () => lab(page)) : nothing}
    ${section(page, "vertex", say("look-at-vertex"), () => vertex(page))}
    ${section(page, "equation", say("equation"), () => equation(page))}
    ${section(page, "study", say("study"), () => study(page))}
    ${section(page, "phases", say("phases"), () => phases(page))}
    ${section(page, "steps", say("all-steps"), () => allSteps(page))}`;
}
