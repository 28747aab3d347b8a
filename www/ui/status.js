// @ts-check
// The status line: what the flow is doing, why it stopped, and how far a long step is.

/** @import { PageState } from "../state.js" */

import { t, translated } from "../language.js";
import { flowOf, settled } from "../options.js";
import { isOver } from "../standing.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** What the solver calls the parts of a long step. @type {Readonly<Record<string, string>>} */
const stages = {
  assemble: "Assembling",
  factor: "Factorising",
  newton: "Newton iterations",
  project: "Keeping area and volume",
  regularise: "Regularising the mesh",
  fill: "Filling",
  triangulate: "Triangulating the holes",
  remesh: "Remeshing the patches",
  flips: "Flipping edges",
  finish: "Measuring the surface",
  replay: "Following the recipe",
  sequence: "Writing the stored steps",
};

/** @param {Readonly<PageState>} state */
export function statusText({ phase, loadingName, mesh, reading, pausing, version, goal }) {
  if (phase === "failed") return t("The solver is not running");
  if (phase === "loading") {
    if (version === "") return t("Starting the solver…");
    return loadingName ? t("Loading {name}…", { name: loadingName }) : t("Restoring the surface…");
  }
  if (!reading && version === "") return t("Starting the solver…");
  // A mesh may be fine and its options not: with both borders clamped, nothing is free.
  if (!reading) return mesh ? t("The flow cannot start") : t("Open a mesh to begin");
  if (phase === "running") {
    if (pausing) return t("Pausing after this step…");
    return goal ? t("Running to step {goal}", { goal }) : t("Running");
  }
  const { status, step } = reading;
  if (isOver(status)) return say("ended", { status, steps: step });
  return phase === "ready" ? t("Ready") : t("Paused at step {step}", { step });
}

/** Why a run is over, beyond what the status line says. @param {Readonly<PageState>} state */
export function reasonText(state) {
  if (state.phase !== "paused" || !state.reading) return "";
  const { status, message } = state.reading;
  if (!message) return "";
  return status === "stepLimit" ? say("play-goes-on", { reason: message }) : say(message);
}

/** @param {Readonly<PageState>} state how much of the way is done, or null where nothing is to be waited for */
function progressOf({ progress, goal, reading, phase }) {
  if (phase === "running" && goal && reading) {
    const { step } = reading;
    return { stage: t("Step {step} of {goal}", { step, goal }), fraction: step / goal };
  }
  const stage = progress && translated(stages[progress.stage] ?? progress.stage);
  if (!progress?.pane) return progress && { ...progress, stage: stage ?? "" };
  return {
    ...progress,
    stage: t("Pane {pane}: {stage}", { pane: progress.pane, stage: stage ?? "" }),
  };
}

/**
 * What is the matter with the solver, where starting another one helps.
 * @param {Readonly<PageState>} state
 */
function troubleOf({ isSilent, phase, mesh }) {
  if (isSilent) return say("solver-silent");
  return phase === "failed" && mesh ? say("solver-gone") : null;
}

/** Of what a flow lowers. @type {Readonly<Record<string, string>>} */
const symbols = {
  smoothedCircle: "W",
  area: "Area",
  willmore: "∫H²",
  curvatureVariation: "∫|∇H|²",
};

/** The energy's symbol. @param {Pick<PageState, "options">} state */
export const symbol = ({ options }) => {
  const { family, monitored } = flowOf(options.flow);
  if (family !== "p-willmore") return translated(symbols[monitored[0]]);
  const { p, spontaneousCurvature, tension, pressure } = settled(options);
  if (spontaneousCurvature || tension || pressure) return t("Energy");
  return p === 0 ? t("Area") : p === 2 ? "∫H²" : `∫|H|^${p}`;
};

export function createStatus() {
  const status = byId("status", HTMLElement);
  const reason = byId("reason", HTMLElement);
  const brief = byId("brief", HTMLElement);
  const box = byId("progress", HTMLElement);
  const bar = byId("progress-bar", HTMLProgressElement);
  const stage = byId("progress-stage", HTMLElement);
  const halt = byId("halt", HTMLButtonElement);

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const { reading } = state;
      setText(status, statusText(state));
      setText(brief, reading ? `${symbol(state)} = ${formatNumber(reading.energy, 4)}` : "");

      const why = reasonText(state);
      setText(reason, why);
      reason.hidden = why === "";

      const trouble = troubleOf(state);
      const waiting = trouble ? null : progressOf(state);
      box.hidden = !waiting && !state.pausing && !trouble;
      bar.hidden = trouble !== null;
      setText(stage, trouble ?? waiting?.stage ?? "");
      setText(halt, trouble ? say("restart-solver") : t("Stop now"));
      if (waiting) bar.value = waiting.fraction;
      else bar.removeAttribute("value");
    },
  };
}
