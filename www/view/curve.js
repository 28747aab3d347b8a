// The energy over the clip: what is played is filled, true steps are ticks; of flows side by side
// all their energies. It is the scrubber.

import { html, nothing, svg } from "lit-html";
import { letter } from "../comparison.js";
import { formatNumber, formatShort } from "../number.js";
import { say } from "../words.js";
import { page } from "./page.js";

/** @import { Point } from "../clip.js" */
/** @import { Pass } from "../generated/types.js" */

/** Most points of a line: as many as there are pixels to tell them apart. */
const MOST = 600;
/** Ticks with a number keep this much of the width between them, with little, some and much room. */
const APART = [0.22, 0.13, 0.06];
/** The first and the last have a word, which takes more. */
const WORD = 1.6;
const [WIDTH, TOP, BOTTOM] = [1000, 6, 82];
/** The foot of a logarithmic axis, as a share of the start, at least. */
const FOOT = 1e-3;

/** Some of the points of a long run. @param {readonly Point[]} points @param {number} [most] */
export function thinned(points, most = MOST) {
  const every = Math.ceil(points.length / most);
  return points.filter((_, n) => n % every === 0 || n === points.length - 1);
}

/**
 * The steps that have a number below the curve, and how much room that takes: 0, 1, 2.
 * @param {readonly Point[]} points @param {number} total
 * @returns {[Point, number][]}
 */
export function labelled(points, total) {
  const last = points.at(-1);
  if (!last || points.length < 2) return [];
  /** @type {[Point, number][]} */
  const chosen = [points[0], last].map((point) => [point, 0]);
  for (const [room, apart] of APART.entries()) {
    for (const point of points) {
      const isFree = chosen.every(([other], n) => {
        const far = Math.abs(point.sum - other.sum) / total;
        return far >= apart * [WORD * 0.75, WORD, 1][Math.min(n, 2)];
      });
      if (isFree) chosen.push([point, room]);
    }
  }
  return chosen.sort(([a], [b]) => a.sum - b.sum);
}

/** The end of the energy axis. @param {readonly Point[]} points */
export const topOf = (points) =>
  points.reduce((most, { state }) => Math.max(most, state.energy), 0) || 1;

/** Joined by straight lines. @param {readonly (readonly number[])[]} list */
export const pathOf = (list) =>
  `M${list.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

/** The clip as a line, what of it is played, and the end of that. @param {(point: Point) => number[]} at */
export function courseOf(at) {
  const { clip, u } = page.lead;
  const whole = thinned(clip.points).map(at);
  const { index, share } = clip.at(u);
  const [from, to] = [clip.points[index], clip.points[index + 1] ?? clip.points[index]].map(at);
  const here = from.map((value, axis) => value + share * (to[axis] - value));
  return { whole, here, played: [...whole.filter(([x]) => x < here[0]), here] };
}

/** @param {PointerEvent} event */
function scrub({ clientX, currentTarget, pointerId }) {
  const plot = /** @type {Element} */ (currentTarget);
  if (!plot.hasPointerCapture(pointerId)) return;
  const { left, width } = plot.getBoundingClientRect();
  page.run.scrub(Math.min(Math.max((clientX - left) / width, 0), 1) * page.lead.clip.total);
}
/** @param {PointerEvent} event */
function press(event) {
  if (page.lead.clip.points.length < 2) return;
  /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
  scrub(event);
}
/** @param {KeyboardEvent} event */
function key(event) {
  const { points } = page.lead.clip;
  /** @type {Record<string, () => unknown>} */
  const moves = {
    ArrowLeft: page.run.back,
    ArrowRight: page.run.step,
    Home: () => page.run.seek(points[0].state.step),
    End: () => page.run.seek(points[points.length - 1].state.step),
  };
  if (!Object.hasOwn(moves, event.key)) return;
  event.preventDefault();
  event.stopPropagation();
  moves[event.key]();
}

/**
 * @param {{ kind?: string, top: string, foot: string, range: number[], now: number, text?: string }} axes
 * @param {unknown} lines @param {unknown} marks  over them
 */
const scrubber = ({ kind = "", top, foot, range: [low, high], now, text }, lines, marks) =>
  html`<div class="curve ${kind}">
    <span class="most" aria-hidden="true">${top}</span><span class="least" aria-hidden="true">${foot}</span>
    <div class="plot" role="slider" tabindex="0" aria-label=${say("history")}
      aria-valuemin=${low} aria-valuemax=${high} aria-valuenow=${now} aria-valuetext=${text ?? nothing}
      @keydown=${key} @pointerdown=${press} @pointermove=${scrub} @lostpointercapture=${page.run.scrubbed}>
      <svg viewBox="0 0 ${WIDTH} 100" preserveAspectRatio="none" aria-hidden="true">
        <line class="base" x1="0" x2=${WIDTH} y1=${BOTTOM} y2=${BOTTOM} />${lines}</svg>${marks}</div></div>`;

/** @param {string} place @param {number} percent @param {string} text */
const label = (place, percent, text) =>
  html`<span class="step ${place}" aria-hidden="true" .style=${`--x:${percent}%`}>${text}</span>`;

/** The energy of the flow of the page. */
export function curve() {
  const { running, timeline } = page.state.value;
  const { clip } = page.lead;
  const { points } = clip;
  if (points.length === 0 || (points.length < 2 && !running)) {
    return html`<div class="curve"><p class="empty">${say("curve-empty")}</p></div>`;
  }
  const total = clip.total || 1;
  const most = topOf(points);
  const x = (/** @type {Point} */ { sum }) => (sum / total) * WIDTH;
  const y = (/** @type {number} */ energy) =>
    BOTTOM - ((BOTTOM - TOP) * Math.min(Math.max(energy, 0), most)) / most;
  const { whole, played, here } = courseOf((point) => [x(point), y(point.state.energy)]);
  const under = (/** @type {number[][]} */ list) =>
    `${pathOf(list)}L${list[list.length - 1][0].toFixed(1)} ${BOTTOM}L0 ${BOTTOM}Z`;
  const ticks = points.length > 200 ? [] : points.map(x);
  // Where branches left the path.
  const branches = (timeline?.branches ?? []).map(({ from, energy }) => {
    const point = points[Math.max(clip.indexOf(from), 0)];
    const end = Math.min(x(point) + 60, WIDTH);
    return svg`<path class="branch" d="M${x(point)} ${y(point.state.energy)}L${end} ${y(energy)}" />`;
  });
  // Passes of remeshing: a tick at the step before, as high as the energy jumped and some more.
  const passes = points.map(({ state: { step, pass } }, n) => {
    const before = points[step < 0 ? n + 1 : n - 1];
    if (!pass || !before) return nothing;
    const [from, to] = pass.objective.map(y);
    return svg`<line class="pass" x1=${x(before)} x2=${x(before)} y1=${Math.min(from, to) - 4} y2=${Math.max(from, to) + 4}
      ><title>${remeshed(step, pass)}</title></line>`;
  });
  const numbers = labelled(points, total).map(([{ state, sum }, room], n, all) => {
    const { step } = state;
    const percent = (100 * sum) / total;
    if (n === all.length - 1) return label("last", percent, say("clause-step", { step }));
    const text = n === 0 && step === 0 ? say("start") : String(step).replace("-", "−");
    return label(n === 0 ? "first" : `room-${room}`, percent, text);
  });
  const { step, pass } = page.shown() ?? { step: 0, pass: undefined };
  const range = [points[0], points[points.length - 1]].map(({ state }) => state.step);
  const text = pass ? remeshed(step, pass) : say("clause-step", { step });
  return scrubber(
    { top: formatShort(most), foot: "0", range, now: step, text },
    svg`<path class="computed area" d=${under(whole)} /><path class="played area" d=${under(played)} />
      <path class="computed" d=${pathOf(whole)} /><path class="played" d=${pathOf(played)} />${branches}${passes}
      ${ticks.map((at) => svg`<line class="tick" x1=${at} x2=${at} y1=${BOTTOM + 1} y2=${BOTTOM + 5} />`)}`,
    html`<i class="head" .style=${`--x:${(here[0] / WIDTH) * 100}%;--y:${here[1]}%`}></i>${numbers}`,
  );
}

/** A step that began with other triangles, in words. @param {number} step @param {Pass} pass */
const remeshed = (step, { objective: [before, after] }) =>
  say("step-remeshed", { step, before, after });

/** The curves of all flows, as shares of their starts, on a logarithmic axis. */
export function comparedCurve() {
  const { lockstep } = page.state.value.comparison;
  const tracks = page.tracks();
  const ends = tracks.map(({ clip }) => clip.last?.state[lockstep === "time" ? "time" : "step"]);
  const furthest = Math.max(...ends.map((end) => end ?? 0), 1e-12);
  const lines = tracks.map(({ clip }) => {
    const first = clip.points[0]?.state.energy || 1;
    return clip.points.map(({ sum, state }) => [
      lockstep === "progress" ? sum / (clip.total || 1) : state[lockstep] / furthest,
      Math.max(state.energy / first, FOOT),
    ]);
  });
  const shares = lines.flat().map(([, share]) => share);
  const [foot, most] = [Math.min(...shares, 1), Math.max(...shares, 1)];
  const at = (/** @type {number[]} */ [x, share]) => [
    x * WIDTH,
    BOTTOM - ((BOTTOM - TOP) * Math.log(share / foot)) / (Math.log(most / foot) || 1),
  ];
  const { clip, u } = page.lead;
  const { index, share } = clip.at(u);
  const [from, to] = [lines[0][index], lines[0][index + 1] ?? lines[0][index]];
  const head = 100 * (from ? from[0] + share * (to[0] - from[0]) : 0);
  const percent = (/** @type {number} */ value, /** @type {number} */ digits) =>
    `${formatNumber(100 * value, digits)} %`;
  const axes = { kind: "compared", top: percent(most, 3), foot: percent(foot, 2) };
  // A letter a curve, each elsewhere so that none hides another.
  const letters = lines.map((line, n) => {
    const [left, above] = at(
      line[Math.floor((line.length * (n + 1)) / (lines.length + 1))] ?? [0, 1],
    );
    return html`<b class="letter pane-${n}" aria-hidden="true" .style=${`--x:${(100 * left) / WIDTH}%;--y:${above}%`}>${letter(n)}</b>`;
  });
  return scrubber(
    { ...axes, range: [0, 100], now: Math.round(head) },
    lines.map((line, n) =>
      line.length < 2 ? nothing : svg`<path class="pane-${n}" d=${pathOf(line.map(at))} />`,
    ),
    html`${letters}<i class="head line" .style=${`--x:${head}%;--y:0%`}></i>
      ${label("first", 0, say("start"))}${label("last", 100, say(`axis-${lockstep}`))}`,
  );
}
