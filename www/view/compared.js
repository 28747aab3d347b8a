// @ts-check
// The curves of flows side by side, in the dock.

import { html, nothing, svg } from "lit-html";
import { formatNumber } from "../number.js";
import { say } from "../words.js";
import { pathOf, scrubbing } from "./curve.js";

/** @import { Page } from "../actions.js" */

const [WIDTH, TOP, BOTTOM] = [1000, 6, 82];
/** The foot of a logarithmic axis, as a share of the start, at least. */
const FOOT = 1e-3;

/** The curves of all, as shares of their starts, on a logarithmic axis. @param {Page} page */
export function comparedCurve(page) {
  page.player.tick.value;
  const { comparison } = page.state.value;
  const { lockstep } = comparison;
  const tracks = [page.lead, ...page.rivals.values()];
  const furthest = Math.max(
    ...tracks.map(({ clip }) => clip.last?.state[lockstep === "time" ? "time" : "step"] ?? 0),
    1e-12,
  );
  let foot = 1;
  const shares = tracks.map(({ clip }) => {
    const first = clip.points[0]?.state.energy || 1;
    return clip.points.map((point) => {
      const share = Math.max(point.state.energy / first, FOOT);
      foot = Math.min(foot, share);
      const x =
        lockstep === "progress" ? point.sum / (clip.total || 1) : point.state[lockstep] / furthest;
      return [x * WIDTH, share];
    });
  });
  const most = Math.max(...shares.flat().map(([, share]) => share), 1);
  const y = (/** @type {number} */ share) =>
    BOTTOM - ((BOTTOM - TOP) * Math.log(share / foot)) / (Math.log(most / foot) || 1);
  const { lead } = page;
  const { index, share } = lead.clip.at(lead.u);
  const here = lead.clip.points[index]?.state;
  const next = lead.clip.points[index + 1]?.state ?? here;
  const head =
    lockstep === "progress" || !here
      ? lead.u / (lead.clip.total || 1)
      : (here[lockstep] + share * (next[lockstep] - here[lockstep])) / furthest;
  const scrub = scrubbing(page);
  return html`<div class="curve compared"><span class="most" aria-hidden="true">${formatNumber(100 * most, 3)} %</span><span class="least" aria-hidden="true">${formatNumber(100 * foot, 2)} %</span>
    <div class="plot" role="slider" tabindex="0" aria-label=${say("history")} aria-valuemin="0" aria-valuemax="100" aria-valuenow=${Math.round(100 * head)}
      @pointerdown=${scrub.press} @pointermove=${scrub.move} @lostpointercapture=${scrub.release}>
    <svg viewBox="0 0 ${WIDTH} 100" preserveAspectRatio="none" aria-hidden="true">
      <line class="base" x1="0" x2=${WIDTH} y1=${BOTTOM} y2=${BOTTOM} />
      ${shares.map((points, n) => (points.length < 2 ? nothing : svg`<path class="pane-${n}" d=${pathOf(points.map(([x, value]) => [x, y(value)]))} />`))}
    </svg><i class="head line" .style=${`--x:${100 * head}%;--y:0%`}></i>
    <span class="step first" aria-hidden="true" .style=${"--x:0%"}>${say("start")}</span>
    <span class="step last" aria-hidden="true" .style=${"--x:100%"}>${say(`axis-${lockstep}`)}</span></div></div>`;
}
