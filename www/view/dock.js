// @ts-check
// The dock: the status line, Play and steps, the number, the curve, the clock.

import { html, nothing } from "lit-html";
import { letter } from "../comparison.js";
import { formatBeside } from "../number.js";
import { speeds } from "../player.js";
import { clause, isTrouble, statusText, symbol } from "../status.js";
import { say } from "../words.js";
import { comparedCurve } from "./compared.js";
import { curve } from "./curve.js";
import { button, icon, iconButton } from "./parts.js";

/** @import { Page } from "../actions.js" */

/** What stands in the line after the status: the newest that is to be read, or a clause. @param {Page} page */
function line(page) {
  const s = page.state.value;
  const note = s.notes.find(({ id }) => id === s.noteShown);
  const error = s.notes.findLast(({ kind }) => kind === "error");
  const said = error ?? (s.isNoteFresh ? note : undefined);
  const isPlaying = page.player.motion.value === "playing";
  if (s.isSilent || (s.phase === "failed" && s.mesh)) {
    const what = s.isSilent ? say("solver-silent") : `${error?.text ?? ""} ${say("solver-gone")}`;
    return html`<span class="text warn" role="alert"><span class="what">${what}</span></span>${button(say("restart-solver"), page.run.halt, { kind: "small" })}`;
  }
  if (said) {
    return html`<span class="text ${said.kind === "error" ? "danger" : ""}" role=${said.kind === "error" ? "alert" : "note"}
        title="${said.text} ${said.hint}"><span class="what">${said.text}</span> <span class="hint">${said.hint}</span></span>
      ${said.offers.map(({ label, act }) => button(label, act, { kind: "small" }))}
      ${said.kind === "error" ? iconButton("close", say("dismiss"), () => page.notes.dismiss(said.id)) : nothing}`;
  }
  if (s.progress) {
    return html`<span class="text">${say(`stage-${s.progress.stage}`)}</span>
      <progress max="1" .value=${s.progress.fraction} aria-label=${say("progress")}></progress>
      ${button(say("stop-now"), async () => (await page.open.giveUp()) || page.run.halt(), { kind: "small" })}`;
  }
  const isAsked = s.isNew && s.mode === null && page.shown()?.step === 0 && !s.running;
  if (isAsked) return purpose(page);
  if (page.player.isWaiting.value) return html`<span class="text">${say("computing")}</span>`;
  const shown = page.shown();
  const last = page.lead.clip.last?.state.step ?? 0;
  const rests = shown && shown.step > 0 && !s.running && !isPlaying && s.mode === null;
  const text = s.mode ? say(`mode-${s.mode}`) : clause(s, shown, isPlaying, last);
  return html`<span class="text">${text}</span>${
    rests
      ? html`<button type="button" class="link" @click=${page.why.ask}>${say("why")}</button>`
      : nothing
  }`;
}

/** What a mesh was opened for. @param {Page} page */
function purpose(page) {
  const { mesh } = page.state.value;
  const small = { kind: "small" };
  return html`<span class="text">${say("purpose")}</span>
    ${button(say("purpose-smooth"), () => page.run.aim("smooth"), small)}
    ${button(say("purpose-relax"), () => page.run.aim("relax"), small)}
    ${
      (mesh?.info.boundaryLoops ?? 0) > 0
        ? button(say("purpose-fill"), () => page.edit.mode("fill"), small)
        : nothing
    }
    ${iconButton("close", say("dismiss"), () => page.patch({ isNew: false }))}`;
}

/** @param {Page} page */
function status(page) {
  page.player.tick.value;
  const s = page.state.value;
  const isPlaying = page.player.motion.value === "playing";
  const shown = page.shown();
  const kind =
    s.running || isPlaying
      ? "run"
      : isTrouble(shown)
        ? "warn"
        : shown && shown.status !== "ready"
          ? "good"
          : "";
  const count = s.notes.length;
  return html`<div class="status ${kind}"><i class="dot"></i>
    <strong role="status">${statusText(s, shown, isPlaying)}</strong>${line(page)}<span class="space"></span>
    ${
      count > 0
        ? html`<button type="button" class="link quiet" aria-expanded=${String(s.section === "notes")}
      @click=${() => page.patch({ section: s.section === "notes" ? null : "notes" })}>${say("notes", { count })}</button>`
        : nothing
    }
  </div>
  ${
    s.section === "notes" && count > 0
      ? html`<ul class="notes" aria-label=${say("messages")}>${s.notes.map(
          (note) =>
            html`<li>${note.text} ${note.hint} ${iconButton("close", say("dismiss"), () => page.notes.dismiss(note.id))}</li>`,
        )}</ul>`
      : nothing
  }`;
}

/** @param {Page} page */
function transport(page) {
  page.player.tick.value;
  const s = page.state.value;
  const isMoving = s.running || page.player.motion.value === "playing";
  const { lead } = page;
  const usable = s.reading !== null && s.phase === "ready";
  const isAtStart = lead.u <= 0 && !s.reading?.canStepBack;
  const isAtEnd =
    page.isOver() && lead.u >= lead.clip.total && page.lead.clip.last?.state.status !== "stepLimit";
  const name = isMoving ? "pause" : isAtEnd && lead.clip.points.length > 1 ? "again" : "play";
  return html`<div class="transport" role="group" aria-label=${say("transport")}>
    ${iconButton("start", say("reset"), page.run.reset, { key: "R", disabled: !usable || (page.shown()?.step === 0 && !isMoving) })}
    ${iconButton("back", say("back"), page.run.back, { key: ",", disabled: !usable || (isAtStart && !isMoving) })}
    <button type="button" class="play" aria-label=${say(isMoving ? "pause" : "play")} title="${say(isMoving ? "pause" : name)} (␣)"
      aria-keyshortcuts="Space" aria-disabled=${String(!usable)} @click=${() => usable && page.run.toggle()}>${icon(name)}</button>
    ${iconButton("next", say("step"), page.run.step, { key: ".", disabled: !usable })}
  </div>`;
}

/** The number that falls. @param {Page} page */
function energy(page) {
  page.player.tick.value;
  const s = page.state.value;
  const { rivals } = s.comparison;
  const first = page.lead.clip.points[0]?.state.energy ?? 0;
  if (rivals.length > 0) {
    const tracks = [page.lead, ...page.rivals.values()];
    return html`<div class="energy pair">${tracks.map((track, n) => {
      const state = track.clip.points[track.clip.nearest(track.u)]?.state;
      return html`<span class="pane-${n}"><b>${formatBeside(state?.energy, track.clip.points[0]?.state.energy ?? 0)}</b> ${letter(n)}</span>`;
    })}</div>`;
  }
  const shown = page.shown();
  const label =
    !shown || shown.step === 0
      ? symbol(s)
      : say("energy-was", { symbol: symbol(s), energy: formatBeside(first, first) });
  return html`<div class="energy"><b>${formatBeside(shown?.energy, first)}</b><span>${label}</span></div>`;
}

/** @param {Page} page */
function clock(page) {
  page.player.tick.value;
  const { lead, player } = page;
  const seconds = player.seconds();
  const spent = lead.clip.total > 0 ? (seconds * lead.u) / lead.clip.total : 0;
  const next = speeds[(speeds.indexOf(player.speed.value) + 1) % speeds.length];
  const { timeline } = page.state.value;
  return html`<div class="settings">
    <span class="clock" aria-hidden="true"><b>${spent.toFixed(1)}</b> / ${seconds.toFixed(1)} s</span>
    <button type="button" class="speed" aria-label=${say("speed", { times: player.speed.value })} title=${say("speed-keys")}
      @click=${() => page.run.speed(next)}>${player.speed.value}×</button>
    ${iconButton("loop", say("loop"), page.run.loop, { key: "L", pressed: player.loops.value })}
    ${iconButton("expand", say("larger-plot"), () => page.patch({ dialog: "plot" }), { key: "E" })}
    ${
      timeline && timeline.branches.length > 0
        ? html`<select class="branches" aria-label=${say("branches")} @change=${(
            /** @type {any} */ event,
          ) => {
            if (event.target.value) page.run.branch(Number(event.target.value));
            event.target.value = "";
          }}><option value="">${say("count-branches", { count: timeline.branches.length })}</option>
        ${timeline.branches.map(
          ({ id, from, last, energy: least }) =>
            html`<option value=${id}>${say("branch", { from, count: last - from, energy: least })}</option>`,
        )}</select>`
        : nothing
    }
  </div>`;
}

/** @param {Page} page */
export function dock(page) {
  const s = page.state.value;
  const isSlim = s.welcome || !s.mesh;
  return html`<div class="dock-rows ${isSlim ? "slim" : ""}">${status(page)}
    ${isSlim ? nothing : html`${transport(page)}${energy(page)}${s.comparison.rivals.length > 0 ? comparedCurve(page) : curve(page)}${clock(page)}`}
  </div>`;
}
