// @ts-check
// The tab that sets flows side by side, and their curves in the dock.

import { html, nothing, svg } from "lit-html";
import { letter, MOST_PANES, optionsOf, timeUnitsAgree } from "../comparison.js";
import { flows } from "../generated/schema.js";
import { formatNumber } from "../number.js";
import { asText, flowLabel, rowOf } from "../options.js";
import { say } from "../words.js";
import { field, fieldsOf } from "./flow.js";
import { button, iconButton, keycap, segmented, select } from "./parts.js";

/** @import { Page } from "../actions.js" */
/** @import { Options } from "../options.js" */

const contrasts = /** @type {const} */ (["flow", "p", "regularise", "scheme", "then"]);
const [WIDTH, TOP, BOTTOM] = [1000, 6, 82];
/** The foot of a logarithmic axis, as a share of the start, at least. */
const FOOT = 1e-3;

/** What a pane does otherwise, in words. @param {Options} main @param {Partial<Options>} change */
export function sayChange(main, change) {
  const { flow, ...others } = change;
  const parts = Object.entries(others).map(
    ([name, value]) => `${say(`option-${name}`)} ${asText(value, name)}`,
  );
  return [flowLabel(flow ?? main.flow), ...parts].join(", ");
}

/** @param {Page} page */
export function compare(page) {
  const s = page.state.value;
  const { comparison, options, mesh, colour } = s;
  const { rivals, lockstep, shown, difference, withStart } = comparison;
  if (!mesh) return nothing;
  const isOpen = rivals.length > 0 || withStart;
  const all = [options, ...rivals.map(({ change }) => optionsOf(options, change))];
  const agree = timeUnitsAgree(all);
  const steps = [
    { id: "progress", label: say("lockstep-progress") },
    ...(agree ? [{ id: "time", label: say("lockstep-time") }] : []),
    { id: "step", label: say("lockstep-step") },
  ];
  const flowChoices = flows
    .filter(({ id }) => id !== "flips")
    .map(({ id }) => ({ id, label: flowLabel(id) }));
  return html`
    <p class="hint">${say("compare-hint")}</p>
    <div class="row">${contrasts.map((what) => button(say(`contrast-${what}`), () => page.compare.contrast(what), { kind: "chip" }))}</div>
    ${rivals.length > 0 ? html`<p class="pane-name"><b class="pane-0">A</b> ${flowLabel(options.flow)}</p>` : nothing}
    ${rivals.map(({ id, change, phase, reason }, n) => {
      const own = optionsOf(options, change);
      const name = letter(n + 1);
      return html`<fieldset class="pane-form"><legend><b class="pane-${n + 1}">${name}</b></legend>
        ${select(say("pane-flow", { name }), flowChoices, own.flow, (flow) => page.compare.change(id, { flow: /** @type {Options["flow"]} */ (flow) }))}
        ${fieldsOf(page, own, true)
          .concat(rowOf("tau"))
          .map((row) => field(page, row, own, (edit) => page.compare.change(id, edit)))}
        ${phase === "lost" ? html`<p class="hint danger">${reason}</p>` : nothing}
        ${iconButton("close", say("remove-pane", { name }), () => page.compare.remove(id))}</fieldset>`;
    })}
    ${rivals.length > 0 && rivals.length < MOST_PANES - 1 ? button(say("add-pane", { name: letter(rivals.length + 1) }), page.compare.add, { kind: "small" }) : nothing}
    ${
      isOpen
        ? html`<hr />
        ${rivals.length > 0 ? segmented(say("lockstep"), steps, lockstep, (id) => page.compare.show({ lockstep: /** @type {any} */ (id) })) : nothing}
        ${agree ? nothing : html`<p class="hint">${say("times-differ")}</p>`}
        ${segmented(
          say("show-panes"),
          [
            { id: "side", label: say("side-by-side") },
            { id: "place", label: say("in-place") },
          ],
          shown === "side" ? "side" : "place",
          (id) => page.compare.show({ shown: id === "side" ? "side" : 0 }),
        )}
        <p class="hint">${say("in-place-hint")} ${keycap("B")}</p>
        ${select(
          say("pane-colours"),
          [
            { id: "", label: say(`colour-${colour}`) },
            ...[options, ...rivals].map((_, n) => ({
              id: String(n),
              label: say("distance-to", { name: letter(n) }),
            })),
          ],
          difference === null ? "" : String(difference),
          (id) => page.compare.show({ difference: id === "" ? null : Number(id) }),
        )}
        ${button(say("close-comparison"), page.compare.close, { kind: "small" })}`
        : nothing
    }`;
}

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
  /** @param {PointerEvent} event */
  function drag(event) {
    const box = /** @type {Element} */ (event.currentTarget).getBoundingClientRect();
    page.run.scrub(
      Math.min(Math.max((event.clientX - box.left) / box.width, 0), 1) * lead.clip.total,
    );
  }
  return html`<div class="curve compared"><span class="most" aria-hidden="true">${formatNumber(100 * most, 3)} %</span><span class="least" aria-hidden="true">${formatNumber(100 * foot, 2)} %</span>
    <div class="plot" role="slider" tabindex="0" aria-label=${say("history")} aria-valuemin="0" aria-valuemax="100" aria-valuenow=${Math.round(100 * head)}
      @pointerdown=${(/** @type {PointerEvent} */ event) => {
        /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
        drag(event);
      }}
      @pointermove=${(/** @type {PointerEvent} */ event) => /** @type {Element} */ (event.currentTarget).hasPointerCapture(event.pointerId) && drag(event)}
      @lostpointercapture=${() => page.run.scrubbed()}>
    <svg viewBox="0 0 ${WIDTH} 100" preserveAspectRatio="none" aria-hidden="true">
      <line class="base" x1="0" x2=${WIDTH} y1=${BOTTOM} y2=${BOTTOM} />
      ${shares.map((points, n) => (points.length < 2 ? nothing : svg`<path class="pane-${n}" d="M${points.map(([x, value]) => `${x.toFixed(1)} ${y(value).toFixed(1)}`).join("L")}" />`))}
    </svg><i class="head line" .style=${`--x:${100 * head}%;--y:0%`}></i>
    <span class="step first" aria-hidden="true" .style=${"--x:0%"}>${say("start")}</span>
    <span class="step last" aria-hidden="true" .style=${"--x:100%"}>${say(`axis-${lockstep}`)}</span></div></div>`;
}
