// @ts-check
// The energy over the clip: what is played is filled, true steps are ticks. It is the scrubber.

import { html, nothing, svg } from "lit-html";
import { formatShort } from "../number.js";
import { say } from "../words.js";

/** @import { Page } from "../actions.js" */
/** @import { Point } from "../clip.js" */
/** @import { Pass } from "../generated/types.js" */

/** Most points of a line: as many as there are pixels to tell them apart. */
const MOST = 600;
/** Ticks with a number keep this much of the width between them, with little, some and much room. */
const APART = [0.22, 0.13, 0.06];
/** The first and the last have a word, which takes more. */
const WORD = 1.6;
const [WIDTH, TOP, BOTTOM] = [1000, 6, 82];

/** What a curve shows of a step. @param {Point} point */
export const energyOf = ({ state }) => state.energy;

/** Some of the points of a long run. @param {readonly Point[]} points */
export function thinned(points) {
  const every = Math.ceil(points.length / MOST);
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
  const chosen = [
    [points[0], 0],
    [last, 0],
  ];
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
export function topOf(points) {
  let most = 0;
  for (const point of points) most = Math.max(most, energyOf(point));
  return most || 1;
}

/** Where an energy lies. @param {number} energy @param {number} most  at the top */
const heightOf = (energy, most) =>
  BOTTOM - ((BOTTOM - TOP) * Math.min(Math.max(energy, 0), most)) / most;

/** Joined by straight lines. @param {readonly (readonly number[])[]} list */
export const pathOf = (list) =>
  `M${list.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

/** How a place on the curve is chosen by a pointer. @param {Page} page */
export function scrubbing(page) {
  /** @param {PointerEvent} event @param {boolean} isOn */
  function to({ clientX, currentTarget }, isOn) {
    const { left, width } = /** @type {Element} */ (currentTarget).getBoundingClientRect();
    const share = Math.min(Math.max((clientX - left) / width, 0), 1);
    if (isOn) page.run.scrub(share * page.lead.clip.total);
  }
  return {
    /** @param {PointerEvent} event */
    press(event) {
      if (page.lead.clip.points.length < 2) return;
      /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
      to(event, true);
    },
    /** @param {PointerEvent} event */
    move: (event) =>
      to(event, /** @type {Element} */ (event.currentTarget).hasPointerCapture(event.pointerId)),
    release: () => page.run.scrubbed(),
  };
}

/** @param {Page} page */
export function curve(page) {
  page.player.tick.value;
  const s = page.state.value;
  const { lead } = page;
  const { points } = lead.clip;
  const total = lead.clip.total || 1;
  const most = topOf(points);
  const some = thinned(points);
  /** @param {Point} point */
  const at = (point) => [(point.sum / total) * WIDTH, heightOf(energyOf(point), most)];
  if (points.length === 0 || (points.length < 2 && !s.running)) {
    return html`<div class="curve"><p class="empty">${say("curve-empty")}</p></div>`;
  }
  const whole = some.map(at);
  const x = (lead.u / total) * WIDTH;
  const { index, share } = lead.clip.at(lead.u);
  const [a, b] = [points[index], points[index + 1]];
  const y = b ? at(a)[1] + share * (at(b)[1] - at(a)[1]) : a ? at(a)[1] : BOTTOM;
  const played = [...whole.filter(([left]) => left < x), [x, y]];
  const under = (/** @type {number[][]} */ list) =>
    `${pathOf(list)}L${list[list.length - 1][0].toFixed(1)} ${BOTTOM}L0 ${BOTTOM}Z`;
  const { step, pass } = page.shown() ?? { step: 0, pass: undefined };
  const ticks = points.length > 200 ? [] : points;

  const scrub = scrubbing(page);
  /** @param {KeyboardEvent} event */
  function key(event) {
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
  return html`<div class="curve">
    <span class="most" aria-hidden="true">${formatShort(most)}</span><span class="least" aria-hidden="true">0</span>
    <div class="plot" role="slider" tabindex="0" aria-label=${say("history")} aria-valuemin=${points[0]?.state.step ?? 0}
      aria-valuemax=${points.at(-1)?.state.step ?? 0} aria-valuenow=${step}
      aria-valuetext=${pass ? remeshed(step, pass) : say("clause-step", { step })}
      @keydown=${key} @pointerdown=${scrub.press} @pointermove=${scrub.move} @lostpointercapture=${scrub.release}>
      <svg viewBox="0 0 ${WIDTH} 100" preserveAspectRatio="none" aria-hidden="true">
        <line class="base" x1="0" x2=${WIDTH} y1=${BOTTOM} y2=${BOTTOM} />
        <path class="computed area" d=${under(whole)} /><path class="played area" d=${under(played)} />
        <path class="computed" d=${pathOf(whole)} /><path class="played" d=${pathOf(played)} />
        ${branches(page)}${passes(points, total, most)}
        ${ticks.map((point) => svg`<line class="tick" x1=${at(point)[0]} x2=${at(point)[0]} y1=${BOTTOM + 1} y2=${BOTTOM + 5} />`)}
      </svg>
      <i class="head" .style=${`--x:${(x / WIDTH) * 100}%;--y:${y}%`}></i>
      ${labelled(points, total).map(([point, room], n, all) =>
        label(point, total, n === 0 ? "first" : n === all.length - 1 ? "last" : `room-${room}`),
      )}
    </div>
  </div>`;
}

/** @param {Point} point @param {number} total @param {string} place */
function label({ state, sum }, total, place) {
  const text =
    place === "first" && state.step === 0 ? say("start") : String(state.step).replace("-", "−");
  return html`<span class="step ${place}" aria-hidden="true" .style=${`--x:${(100 * sum) / total}%`}
    >${place === "last" ? say("clause-step", { step: state.step }) : text}</span>`;
}

/** A step that began with other triangles, in words. @param {number} step @param {Pass} pass */
const remeshed = (step, { objective: [before, after] }) =>
  say("step-remeshed", { step, before, after });

/**
 * Passes of remeshing: a tick at the step before, as high as the energy jumped and some more.
 * @param {readonly Point[]} points @param {number} total @param {number} most
 */
function passes(points, total, most) {
  return points.map(({ state: { step, pass } }, n) => {
    const before = points[step < 0 ? n + 1 : n - 1];
    if (!pass || !before) return nothing;
    const [from, to] = pass.objective.map((energy) => heightOf(energy, most));
    const x = (WIDTH * before.sum) / total;
    return svg`<line class="pass" x1=${x} x2=${x} y1=${Math.min(from, to) - 4} y2=${Math.max(from, to) + 4}
      ><title>${remeshed(step, pass)}</title></line>`;
  });
}

/** Where branches left the path. @param {Page} page */
function branches(page) {
  const { timeline } = page.state.value;
  const { clip } = page.lead;
  if (!timeline || timeline.branches.length === 0) return nothing;
  const total = clip.total || 1;
  const most = topOf(clip.points);
  return timeline.branches.map(({ from, energy }) => {
    const point = clip.points[Math.max(clip.indexOf(from), 0)];
    const [left, right] = [energyOf(point), energy].map((value) => heightOf(value, most));
    const x = (WIDTH * point.sum) / total;
    return svg`<path class="branch" d="M${x} ${left}L${Math.min(x + 60, WIDTH)} ${right}" />`;
  });
}
