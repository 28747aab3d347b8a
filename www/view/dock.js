// The dock: the status line, and below it what plays.

import { html, nothing } from "lit-html";
import { clause, isTrouble, statusText } from "../status.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, iconButton, lazy } from "./parts.js";

/** @import { Note } from "../store.js" */

/** What a command line says after its name, as a sentence. @param {string} text */
const sentence = (text) =>
  text && text.charAt(0).toUpperCase() + text.slice(1) + (/[.!?…:]$/.test(text) ? "" : ".");

/** @param {Note} note */
const dismissal = ({ id }) => iconButton("close", say("dismiss"), () => page.notes.dismiss(id));

/** What stands in the line after the status: the newest that is to be read, or a clause. */
function line() {
  const s = page.state.value;
  const error = s.notes.findLast(({ kind }) => kind === "error");
  const said = error ?? (s.isNoteFresh && s.notes.find(({ id }) => id === s.noteShown));
  const isPlaying = page.player.motion.value === "playing";
  const shown = page.shown();
  const rests = shown && shown.step > 0 && !s.running && !isPlaying && s.mode === null;
  const why = html`<button type="button" class="link" @click=${page.why.ask}>${say("why")}</button>`;
  if (s.isSilent || (s.phase === "failed" && s.mesh)) {
    const what = s.isSilent ? say("solver-silent") : `${error?.text ?? ""} ${say("solver-gone")}`;
    return html`<span class="text warn" role="alert"><span class="what">${what}</span></span>${button(say("restart-solver"), page.run.halt, "small")}`;
  }
  if (said) {
    const { hint, offers } = said;
    const text = sentence(said.text);
    return html`<span class="text ${error ? "danger" : ""}" role=${error ? "alert" : "note"}
        title="${text} ${hint}"><span class="what">${text}</span> <span class="hint">${hint}</span></span>
      ${offers.map(({ label, act }) => button(label, act, "small"))}${error ? dismissal(error) : rests ? why : nothing}`;
  }
  if (s.progress) {
    const stop = async () =>
      (await page.open.giveUp()) || (await page.run.giveUp()) || page.run.halt();
    return html`<span class="text">${say(`stage-${s.progress.stage}`)}</span>
      <progress max="1" .value=${s.progress.fraction} aria-label=${say("progress")}></progress>
      ${button(say("stop-now"), stop, "small")}`;
  }
  if (s.isNew && s.mode === null && shown?.step === 0 && !s.running) return purpose();
  if (page.player.isWaiting.value) return html`<span class="text">${say("computing")}</span>`;
  const last = page.lead.clip.last?.state.step ?? 0;
  const text = s.mode ? say(`mode-${s.mode}`) : sentence(clause(s, shown, isPlaying, last));
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
  const notes = s.notes.map(
    (note) => html`<li>${sentence(note.text)} ${note.hint} ${dismissal(note)}</li>`,
  );
  return html`<div class="status ${s.running || isPlaying ? "run" : ended}"><i class="dot"></i>
    <strong role="status">${statusText(s, shown, isPlaying)}</strong>${line()}<span class="space"></span>
    ${count > 0 ? html`<button type="button" class="link quiet" aria-expanded=${String(isOpen)} @click=${turn}>${say("notes", { count })}</button>` : nothing}
  </div>
  ${isOpen && count > 0 ? html`<ul class="notes" aria-label=${say("messages")}>${notes}</ul>` : nothing}`;
}

/** There is nothing to play before there is a surface. */
const transport = lazy(() => import("./transport.js").then(({ transport }) => transport));

export function dock() {
  page.player.tick.value;
  const { welcome, mesh } = page.state.value;
  const isSlim = welcome || !mesh;
  return html`<div class="dock-rows ${isSlim ? "slim" : ""}">${status()}${isSlim ? nothing : transport()}</div>`;
}
