// The dock: the status line, Play and steps, the number, the curve, the clock.

import { html, nothing } from "lit-html";
import { letter } from "../comparison.js";
import { formatBeside } from "../number.js";
import { speeds } from "../player.js";
import { clause, isTrouble, statusText, symbol } from "../status.js";
import { say } from "../words.js";
import { comparedCurve, curve } from "./curve.js";
import { page } from "./page.js";
import { button, icon, iconButton, into } from "./parts.js";

/** @import { Note } from "../store.js" */

/** @param {Note} note */
const dismissal = ({ id }) => iconButton("close", say("dismiss"), () => page.notes.dismiss(id));

/** What stands in the line after the status: the newest that is to be read, or a clause. */
function line() {
  const s = page.state.value;
  const error = s.notes.findLast(({ kind }) => kind === "error");
  const said = error ?? (s.isNoteFresh && s.notes.find(({ id }) => id === s.noteShown));
  const isPlaying = page.player.motion.value === "playing";
  if (s.isSilent || (s.phase === "failed" && s.mesh)) {
    const what = s.isSilent ? say("solver-silent") : `${error?.text ?? ""} ${say("solver-gone")}`;
    return html`<span class="text warn" role="alert"><span class="what">${what}</span></span>${button(say("restart-solver"), page.run.halt, "small")}`;
  }
  if (said) {
    return html`<span class="text ${error ? "danger" : ""}" role=${error ? "alert" : "note"}
        title="${said.text} ${said.hint}"><span class="what">${said.text}</span> <span class="hint">${said.hint}</span></span>
      ${said.offers.map(({ label, act }) => button(label, act, "small"))}${error ? dismissal(error) : nothing}`;
  }
  if (s.progress) {
    const stop = async () =>
      (await page.open.giveUp()) || (await page.run.giveUp()) || page.run.halt();
    return html`<span class="text">${say(`stage-${s.progress.stage}`)}</span>
      <progress max="1" .value=${s.progress.fraction} aria-label=${say("progress")}></progress>
      ${button(say("stop-now"), stop, "small")}`;
  }
  const shown = page.shown();
  if (s.isNew && s.mode === null && shown?.step === 0 && !s.running) return purpose();
  if (page.player.isWaiting.value) return html`<span class="text">${say("computing")}</span>`;
  const last = page.lead.clip.last?.state.step ?? 0;
  const rests = shown && shown.step > 0 && !s.running && !isPlaying && s.mode === null;
  const text = s.mode ? say(`mode-${s.mode}`) : clause(s, shown, isPlaying, last);
  const why = html`<button type="button" class="link" @click=${page.why.ask}>${say("why")}</button>`;
  return html`<span class="text">${text}</span>${rests ? why : nothing}`;
}

/** What a mesh was opened for. */
function purpose() {
  const hasHoles = (page.state.value.mesh?.info.boundaryLoops ?? 0) > 0;
  return html`<span class="text">${say("purpose")}</span>
    ${button(say("purpose-smooth"), () => page.run.aim("smooth"), "small")}
    ${button(say("purpose-relax"), () => page.run.aim("relax"), "small")}
    ${hasHoles ? button(say("purpose-fill"), () => page.edit.mode("fill"), "small") : nothing}
    ${iconButton("close", say("dismiss"), () => page.patch({ isNew: false }))}`;
}

function status() {
  const s = page.state.value;
  const isPlaying = page.player.motion.value === "playing";
  const shown = page.shown();
  const ended = isTrouble(shown) ? "warn" : (shown?.status ?? "ready") === "ready" ? "" : "good";
  const count = s.notes.length;
  const isOpen = s.section === "notes";
  const turn = () => page.patch({ section: isOpen ? null : "notes" });
  const notes = s.notes.map((note) => html`<li>${note.text} ${note.hint} ${dismissal(note)}</li>`);
  return html`<div class="status ${s.running || isPlaying ? "run" : ended}"><i class="dot"></i>
    <strong role="status">${statusText(s, shown, isPlaying)}</strong>${line()}<span class="space"></span>
    ${count > 0 ? html`<button type="button" class="link quiet" aria-expanded=${String(isOpen)} @click=${turn}>${say("notes", { count })}</button>` : nothing}
  </div>
  ${isOpen && count > 0 ? html`<ul class="notes" aria-label=${say("messages")}>${notes}</ul>` : nothing}`;
}

function transport() {
  const s = page.state.value;
  const isMoving = s.running || page.player.motion.value === "playing";
  const { clip, u } = page.lead;
  const usable = s.reading !== null && s.phase === "ready";
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
      const [now, start] = [clip.points[clip.nearest(u)], clip.points[0]];
      const text = formatBeside(now?.state.energy, start?.state.energy ?? 0);
      return html`<span class="pane-${n}"><b>${text}</b> ${letter(n)}</span>`;
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

export function dock() {
  page.player.tick.value;
  const { welcome, mesh, comparison } = page.state.value;
  const isSlim = welcome || !mesh;
  const lines = () => (comparison.rivals.length > 0 ? comparedCurve() : curve());
  return html`<div class="dock-rows ${isSlim ? "slim" : ""}">${status()}
    ${isSlim ? nothing : html`${transport()}${energy()}${lines()}${clock()}`}</div>`;
}
