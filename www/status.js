// What the flow is doing, in words.

import { sampleName } from "./library.js";
import { formatNumber } from "./number.js";
import { flowOf, settled } from "./options.js";
import { isOver } from "./session.js";
import { say } from "./words.js";

/** @import { State as Reading } from "./generated/types.js" */
/** @import { S } from "./store.js" */

/**
 * @param {S} s @param {Reading | null} shown  the step that is shown
 * @param {boolean} isPlaying  whether the display moves
 */
export function statusText(s, shown, isPlaying) {
  const { phase, loadingName, mesh, version, goal, running } = s;
  if (phase === "failed") return say("status-failed");
  if (phase === "loading" && version !== "") {
    return loadingName ? say("status-loading", { name: loadingName }) : say("status-restoring");
  }
  if (version === "") return say("status-starting");
  // A mesh may be fine and its options not: with both boundaries clamped, nothing is free.
  if (!shown) return say(mesh ? "status-stuck" : "status-empty");
  if (goal !== null && running) return say("status-running-to", { goal });
  if (running || isPlaying) return say("status-running");
  const { status, step } = shown;
  if (isOver(status)) return say("ended", { status, steps: Math.abs(step) });
  return step === 0 ? say("status-ready") : say("status-paused", { step });
}

/** Whether a run is over in a way that one should look at. @param {Reading | null} shown */
export const isTrouble = (shown) =>
  shown !== null && ["stalled", "singular", "collapsed", "failed"].includes(shown.status);

/** A clause after the status. @param {S} s @param {Reading | null} shown @param {boolean} isPlaying @param {number} last */
export function clause(s, shown, isPlaying, last) {
  if (s.welcome) return say("clause-private");
  if (s.phase !== "ready" || !shown) return "";
  if (s.running || isPlaying) {
    const { step } = shown;
    if (s.film === "back" && s.running) return say("clause-film", { step: -step });
    return s.running ? say("clause-step", { step }) : say("clause-step-of", { step, last });
  }
  if (shown.status === "ready") return shown.step === 0 ? say("clause-ready") : "";
  if (!shown.message) return "";
  const reason = say(shown.message);
  const isSound = shown.soundness?.isSound ?? true;
  const end = isSound ? reason : say("end-untrusted", { reason });
  return shown.status === "stepLimit" ? say("play-goes-on", { reason: end }) : end;
}

/** How what is monitored is called: a symbol, and a name beside it. @param {Pick<S, "options">} s @returns {string} */
export function symbol({ options }) {
  const { flow, p, spontaneousCurvature, tension, pressure } = settled(options);
  const { family, monitored } = flowOf(flow);
  if (family !== "p-willmore") return say(`symbol-${monitored[0]}`);
  if (spontaneousCurvature || tension || pressure) return say("symbol-helfrich");
  return p === 0 ? say("symbol-area") : p === 2 ? "∫H²" : `∫|H|^${p}`;
}

export const sceneTitle = (/** @type {S["source"]} */ source) =>
  source?.kind === "sample" ? sampleName(source.id) : (source?.name ?? "");

/** The surface in words. @param {S} s @param {Reading | null} shown */
export function surfaceLabel({ mesh, source }, shown) {
  if (!mesh) return say("surface-none");
  const name = sceneTitle(source);
  if (!shown) return say("surface-named", { name });
  const { step } = shown;
  const energy = formatNumber(shown.energy, 4);
  return say("surface-at", { name, step, energy, area: formatNumber(shown.area, 4) });
}
