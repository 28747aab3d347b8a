// @ts-check
// Panes of a comparison in words: what each does otherwise, and where it stands.

/** @import { Options } from "../options.js" */
/** @import { PageState } from "../state.js" */
/** @import { Shown } from "./extra-pane.js" */

import { letter, optionsOf } from "../comparison.js";
import { t, translated } from "../language.js";
import { asText, choiceLabel, flowLabel, usualBoundary } from "../options.js";
import { isOver, standings } from "../standing.js";
import { say } from "../words.js";
import { formatNumber } from "./number.js";

/** @param {keyof Options} key @param {Options} options @returns {string} */
function inWords(key, options) {
  const value = asText(options[key]);
  switch (key) {
    case "flow":
      return options.flow === "p-willmore"
        ? t("p-Willmore, p = {p}", { p: options.p })
        : flowLabel(value);
    case "epsilon":
      return `ε = ${value}`;
    case "p":
      return `p = ${value}`;
    case "tau":
      return value === "auto" ? t("automatic time step") : `τ = ${value}`;
    case "dt":
      return value === "auto" ? t("automatic time step") : `dt = ${value}`;
    case "scheme":
      return value === "paper" ? t("the paper’s scheme") : t("recommended scheme");
    case "boundary": {
      const id = options.boundary ?? usualBoundary(options.flow);
      return id === null ? value : choiceLabel("boundary", id);
    }
    case "keep":
      return value === "none"
        ? t("nothing kept")
        : t("{kept} kept", {
            kept: value
              .split(",")
              .map((word) => translated(word))
              .join(", "),
          });
    case "regularise":
      if (value === "off") return t("not regularised");
      return value === "linear" ? t("regularised linearly") : t("regularised");
    case "regulariseEpsilon":
      return t("regularisation ε = {value}", { value });
    case "prefill":
      return value === "true" ? t("smooth first guess") : t("no first guess");
    case "sharpen":
      return value === "true" ? t("sharpened at the end") : t("not sharpened");
    case "integrator":
      return (
        {
          "semi-implicit": t("semi-implicit"),
          "forward-euler": t("forward Euler"),
          "backward-euler": t("backward Euler"),
          "l-bfgs": "L-BFGS",
        }[value] ?? value
      );
    case "mass":
      return t("mass: {value}", { value: translated(value) });
    default:
      return `${key} = ${value}`;
  }
}

/**
 * What tells the panes apart, in words a pane.
 * @param {Options} main
 * @param {readonly Partial<Options>[]} changes  of the panes beside
 * @returns {string[]}
 */
export function differences(main, changes) {
  const all = [main, ...changes.map((change) => optionsOf(main, change))];
  const keys = /** @type {(keyof Options)[]} */ (Object.keys(main)).filter((key) =>
    changes.some((change) => key in change),
  );
  return all.map((options) => {
    // With the flow p-Willmore its exponent is said already.
    const own = keys.filter((key) => key !== "p" || !keys.includes("flow"));
    return own.map((key) => inWords(key, options)).join(", ") || flowLabel(options.flow);
  });
}

/** @param {{ reading: PageState["reading"], phase: string, reason: string }} pane */
function standing({ reading, phase, reason }) {
  if (phase === "loading") return t("loading…");
  if (phase === "lost") return reason;
  if (!reading || !isOver(reading.status)) return "";
  return reading.status === "failed" && reading.message
    ? t("failed: {reason}", { reason: say(reading.message) })
    : translated(standings[reading.status]);
}

/**
 * What stands under each pane, in parts: its letter, what it does, where it stands.
 * @param {Readonly<PageState>} state
 */
export function captionParts({ options, reading, comparison }) {
  const { rivals } = comparison;
  const what = differences(
    options,
    rivals.map(({ change }) => change),
  );
  const panes = [{ reading, phase: "ready", reason: "" }, ...rivals];
  return panes.map((pane, n) => {
    const numbers = pane.reading && {
      step: pane.reading.step,
      energy: formatNumber(pane.reading.energy, 4),
      time: formatNumber(pane.reading.time, 3),
    };
    const stands = [
      numbers ? t("step {step}, energy {energy}, t = {time}", numbers) : "",
      standing(pane),
    ];
    const last = stands.filter(Boolean).map((text) => ` · ${text}`);
    return [letter(n), `: ${what[n]}`, last.join("")];
  });
}

/** The same, whole. @param {Readonly<PageState>} state */
export const captions = (state) => captionParts(state).map((parts) => parts.join(""));

/** @param {Readonly<PageState>} state @returns {Shown[]} */
export function rivalPictures(state) {
  const { mesh, comparison } = state;
  const words = captionParts(state);
  return comparison.rivals.flatMap(({ id, frame, configured }, n) =>
    mesh
      ? {
          key: `rival-${id}`,
          order: n + 1,
          caption: words[n + 1],
          drawable: mesh,
          positions: frame?.positions ?? mesh.positions,
          field: frame?.field ?? null,
          marked: frame?.flippedTriangles,
          held: configured?.heldVertices,
        }
      : [],
  );
}
