// The dock below its status line: Play and steps, the number, the curve, the clock.

import "../style/transport.css";
import { html, nothing } from "lit-html";
import { letter, optionsOf } from "../comparison.js";
import { formatBeside } from "../number.js";
import { speeds } from "../player.js";
import { symbol } from "../status.js";
import { isEditing } from "../store.js";
import { say } from "../words.js";
import { comparedCurve, curve } from "./curve.js";
import { page } from "./page.js";
import { icon, iconButton, into } from "./parts.js";

function buttons() {
  const s = page.state.value;
  const isMoving = s.running || page.player.motion.value === "playing";
  const { clip, u } = page.lead;
  const usable = s.reading !== null && s.phase === "ready" && !isEditing(s);
  const isAtStart = u <= 0 && !s.reading?.canStepBack;
  const isAtEnd = page.isOver() && u >= clip.total && clip.last?.state.status !== "stepLimit";
  const name = isMoving ? "pause" : isAtEnd && clip.points.length > 1 ? "again" : "play";
  /** @param {string} icon @param {"reset" | "back" | "step"} move @param {string} key @param {boolean} [isThere] */
  const to = (icon, move, key, isThere = false) => {
    const disabled = !usable || (isThere && !isMoving);
    return iconButton(icon, say(move), page.run[move], { key, disabled });
  };
  return html`<div class="transport" role="group" aria-label=${say("transport")}>
    ${to("start", "reset", "R", page.shown()?.step === 0)}${to("back", "back", ",", isAtStart)}
    <button type="button" class="play" aria-label=${say(isMoving ? "pause" : "play")} title="${say(name)} (␣)"
      aria-keyshortcuts="Space" aria-disabled=${String(!usable)} @click=${() => usable && page.run.toggle()}>${icon(name)}</button>
    ${to("next", "step", ".")}</div>`;
}

/** The number that falls. */
function energy() {
  const s = page.state.value;
  const first = page.lead.clip.points[0]?.state.energy ?? 0;
  if (s.comparison.rivals.length > 0) {
    const numbers = page.tracks().map(({ clip, u }, n) => {
      const [now, start] = [clip.points[clip.at(u).index], clip.points[0]];
      const text = formatBeside(now?.state.energy, start?.state.energy ?? 0);
      const own = n === 0 ? s.options : optionsOf(s.options, s.comparison.rivals[n - 1].change);
      return html`<span class="pane-${n}"><b>${text}</b> ${letter(n)}, ${symbol({ options: own })}</span>`;
    });
    return html`<div class="energy pair">${numbers}</div>`;
  }
  const shown = page.shown();
  const was = { symbol: symbol(s), energy: formatBeside(first, first) };
  const label = (shown?.step ?? 0) === 0 ? symbol(s) : say("energy-was", was);
  return html`<div class="energy"><b>${formatBeside(shown?.energy, first)}</b><span>${label}</span></div>`;
}

function clock() {
  const { lead, player } = page;
  const seconds = player.seconds();
  const spent = lead.clip.total > 0 ? (seconds * lead.u) / lead.clip.total : 0;
  const next = speeds[(speeds.indexOf(player.speed.value) + 1) % speeds.length];
  return html`<div class="settings">
    <span class="clock" aria-hidden="true"><b>${spent.toFixed(1)}</b> / ${seconds.toFixed(1)} s</span>
    <button type="button" class="speed" aria-label=${say("speed", { times: player.speed.value })} title=${say("speed-keys")}
      @click=${() => into(player.speed)(next)}>${player.speed.value}×</button>
    ${iconButton("loop", say("loop"), page.run.loop, { key: "L", pressed: player.loops.value })}
    ${iconButton("expand", say("larger-plot"), () => page.patch({ dialog: "plot" }), { key: "E" })}${branches()}
    <button type="button" class="button quiet more-commands" aria-label=${say("command-commands")}
      @click=${() => page.patch({ dialog: "commands" })}>⋯</button>
  </div>`;
}

function branches() {
  const all = page.state.value.timeline?.branches ?? [];
  if (all.length === 0) return nothing;
  const choose = (/** @type {any} */ { target }) => {
    if (target.value) page.run.branch(Number(target.value));
    target.value = "";
  };
  const options = all.map(({ id, from, last, energy: least }) => {
    const text = say("branch", { from, count: last - from, energy: least });
    return html`<option value=${id}>${text}</option>`;
  });
  return html`<select class="branches" aria-label=${say("branches")} @change=${choose}>
    <option value="">${say("count-branches", { count: all.length })}</option>${options}</select>`;
}

export function transport() {
  const isAlone = page.state.value.comparison.rivals.length === 0;
  return html`${buttons()}${energy()}${isAlone ? curve() : comparedCurve()}${clock()}`;
}
