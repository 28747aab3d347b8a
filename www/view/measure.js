// The tab of numbers: readings, what the figure of a paper says, the histogram, and what is
// looked at more closely.

import "../style/measure.css";
import { html, nothing, svg } from "lit-html";
import { figureTitle, sayFigure } from "../library.js";
import { formatBeside, formatNumber, formatShort, formatSigned, isRounding } from "../number.js";
import { histogram } from "../range.js";
import { symbol } from "../status.js";
import { say } from "../words.js";
import { conjecture, lab } from "./conjecture.js";
import { thinned } from "./curve.js";
import { page } from "./page.js";
import { grid, lazy, section, table } from "./parts.js";
import { phases } from "./phases.js";
import { study } from "./study.js";
import { vertex } from "./vertex.js";

/** @import { State as Reading } from "../generated/types.js" */

/** With what sets its formulas. */
const equation = lazy(() => import("./equation.js").then(({ equation }) => equation));

/** Rows of the table, about; of more steps every so manyth. */
const MOST_ROWS = 200;
const BINS = 22;

/** A number with its change since the start, in percent. @param {string} text @param {number | null} now @param {number | null} [first] */
function since(text, now, first) {
  const percent = now === null || !first ? 0 : (100 * (now - first)) / Math.abs(first);
  const size = Math.abs(percent);
  return size < 0.05
    ? text
    : html`${text} <small>${percent < 0 ? "−" : "+"}${size.toFixed(1)} %</small>`;
}

/** The step size in the table. @param {Reading} reading */
function stepSize({ flips, dt, tau }) {
  if (!flips) return `${formatNumber(dt, 4)} (τ = ${formatNumber(tau, 3)})`;
  // Above what a mesh can hold: all there are.
  return dt > 2 ** 31 - 1 ? say("flip-all") : say("count-flips", { count: dt });
}

/** @param {Reading} reading */
function volumeOf({ volume: now, reducedVolume: reduced }) {
  if (now === null) return say("volume-none");
  const volume = formatNumber(now, 6);
  return reduced === null ? volume : say("volume-reduced", { volume, reduced });
}

function readings() {
  const { mesh, options, film, extras } = page.state.value;
  if (!mesh) return nothing;
  const shown = page.shown();
  const { clip, u } = page.lead;
  const first = clip.points[0]?.state;
  const made = clip.points[clip.at(u).index]?.drawable;
  const { genus, vertices, faces } = mesh.info;
  const isCircle = options.flow === "circle";
  /** @param {string} id @param {unknown} value @param {string} [name] @returns {readonly [string, unknown, string]} */
  const row = (id, value, name = say(`reading-${id}`)) => [name, value, id];
  const { tension, pressure } = shown?.multipliers ?? {};
  const volume = shown ? volumeOf(shown) : "";
  /** What is lost in rounding beside the start is none, and stands behind it. @param {number} value */
  const energy = (value) => {
    const exact = formatNumber(value, 6);
    return isRounding(value, first?.energy ?? 0) ? html`<span title=${exact}>0</span>` : exact;
  };
  const rows = [
    shown && row("energy", energy(shown.energy)),
    shown && isCircle && row("half", energy(shown.energyNormalised), "W/2"),
    shown && row("step", String(shown.step)),
    shown && row("time", formatNumber(shown.time)),
    shown && row("dt", stepSize(shown)),
    shown && row("area", since(formatNumber(shown.area, 6), shown.area, first?.area)),
    shown && row("volume", film ? volume : since(volume, shown.volume, first?.volume)),
    row("genus", genus === null ? say("genus-none") : String(genus)),
    row("vertices", String(made ? made.positions.length / 3 : vertices)),
    row("faces", String(made ? made.triangles.length / 3 : faces)),
    shown && row("angle", `${formatNumber(shown.minAngleDegrees, 4)}°`),
    shown && row("milliseconds", formatNumber(shown.milliseconds || null, 3)),
    shown?.crossings !== undefined && row("crossings", String(shown.crossings)),
    tension != null && row("tension", formatNumber(tension, 4)),
    pressure != null && row("pressure", formatNumber(pressure, 4)),
    extras?.jump && row("jump", formatNumber(extras.jump.relative, 3)),
  ];
  return table(say("readings"), rows);
}

/** Of what is shown: it stays while the display moves from one true step to the next. */
let binned = { of: new Float32Array(), range: /** @type {readonly number[]} */ ([]), shares: [0] };

function spread() {
  const { range, colour } = page.state.value;
  const field = page.lead.clip.surface(page.lead.u)?.field;
  if (!field || !range || field.name !== colour) return nothing;
  const of = /** @type {Float32Array<ArrayBuffer>} */ (field.values);
  if (binned.of !== of || binned.range !== range)
    binned = { of, range, shares: histogram(of, range, BINS) };
  const { shares } = binned;
  const most = Math.max(...shares, 1e-9);
  const colours = page.stage.colours(field.signed, BINS);
  const bars = shares.map((share, n) => {
    const height = (66 * share) / most;
    const fill = colours[n] ?? "currentColor";
    return svg`<rect x=${2 + n * 13.4} y=${70 - height} width="12.4" height=${height} fill=${fill} />`;
  });
  const what = say("over-the-surface", { what: say(`colour-${colour}`) });
  const step = (range[1] - range[0]) / BINS;
  const name = say("histogram-table");
  const heads = [say("histogram-from"), say("histogram-share")];
  const rows = shares.map((share, n) => [
    formatShort(range[0] + n * step),
    `${(100 * share).toFixed(2)} %`,
  ]);
  return html`<hr /><h3>${what}</h3>
    <svg class="histogram" viewBox="0 0 300 84" role="img" aria-label=${what}>
      ${bars}<line x1="0" x2="300" y1="70.5" y2="70.5" />
      <text x="2" y="83">≤ ${formatSigned(range[0])}</text>
      ${range[0] < 0 ? svg`<text x="149" y="83" text-anchor="middle">0</text>` : nothing}
      <text x="298" y="83" text-anchor="end">≥ ${formatShort(range[1])}</text>
    </svg>
    ${section("bins", name, () => grid(name, heads, rows))}`;
}

/** What stands in the paper, and what came of it here. */
function figure() {
  const { figure: shown } = page.state.value;
  if (!shown) return nothing;
  const found = page.finding.value?.id === shown.id ? page.finding.value : null;
  const said = found
    ? html`${say(found.ok ? "figure-holds" : "figure-differs")} ${say(found.message)}`
    : say("figure-waiting", { steps: shown.steps });
  const isShort = found && !found.ok && shown.fallsShort;
  return html`<section class="figure"><h3>${say(`paper-${shown.paper}.authors`)}, ${figureTitle(shown)}</h3>
    <p>${sayFigure(shown, "reports")}</p><p class="hint">${say("figure-expects")} ${sayFigure(shown, "expected")}</p>
    <p class="measured ${found ? (found.ok ? "good" : "other") : ""}">${said}</p>
    ${isShort ? html`<p class="hint">${sayFigure(shown, "shortfall")}</p>` : nothing}
  </section><hr />`;
}

function allSteps() {
  const points = thinned(page.lead.clip.points, MOST_ROWS);
  const first = points[0]?.state.energy ?? 0;
  const columns = ["step", "time", "dt", "energy", "area", "volume", "angle"];
  const heads = columns.map((id) =>
    id === "energy" ? symbol(page.state.value) : say(`reading-${id}`),
  );
  const rows = points.map(({ state }) => [
    state.step,
    formatNumber(state.time),
    formatNumber(state.dt, 4),
    html`<span title=${formatNumber(state.energy, 6)}>${formatBeside(state.energy, first)}</span>`,
    formatNumber(state.area, 6),
    formatNumber(state.volume, 6),
    formatNumber(state.minAngleDegrees, 4),
  ]);
  return html`<div id="plot-rows">${grid(say("all-steps"), heads, rows)}</div>`;
}

export function measure() {
  page.player.tick.value;
  const { reading, section: open } = page.state.value;
  const isFlips = !!reading?.flips;
  // What is looked at closely takes the place of what is seen at a glance.
  const isClose = open !== null && !["bins", "notes"].includes(open);
  return html`${isClose ? nothing : figure()}${readings()}${isClose ? nothing : spread()}
    ${isFlips ? section("conjecture", say("conjecture"), conjecture) : nothing}
    ${isFlips ? section("lab", say("lab"), lab) : nothing}
    ${section("vertex", say("look-at-vertex"), vertex)}
    ${section("equation", say("equation"), equation)}
    ${section("study", say("study"), study)}
    ${section("phases", say("phases"), phases)}
    ${section("steps", say("all-steps"), allSteps)}`;
}
