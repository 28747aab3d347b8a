// @ts-check
// The table of readings, and both forms of the energy.

/** @import { PageState } from "../state.js" */

import { t } from "../language.js";
import { settled } from "../options.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { showParts } from "./option-form.js";

/** @param {Readonly<PageState>} state @returns {Record<string, string>} */
function readingsOf({ reading, mesh }) {
  if (!mesh) return {};
  const { info } = mesh;
  const counts = {
    genus: info.genus === null ? t("not orientable") : String(info.genus),
    vertices: String(info.vertices),
    faces: String(info.faces),
  };
  if (!reading) return counts;
  return {
    ...counts,
    energy: formatNumber(reading.energy, 6),
    step: String(reading.step),
    time: formatNumber(reading.time),
    dt: reading.flips
      ? flipsText(reading.dt)
      : `${formatNumber(reading.dt, 4)} (τ = ${formatNumber(reading.tau, 3)})`,
    area: formatNumber(reading.area, 6),
    volume: volumeText(reading),
    angle: `${formatNumber(reading.minAngleDegrees, 4)}°`,
    milliseconds: reading.milliseconds > 0 ? formatNumber(reading.milliseconds, 3) : "–",
  };
}

/** @param {number} perStep  above what a mesh can hold: all there are */
const flipsText = (perStep) =>
  perStep > 2 ** 31 - 1 ? t("All flips") : say("count-flips", { count: perStep });

/** @param {NonNullable<PageState["reading"]>} reading */
function volumeText({ volume, reducedVolume }) {
  if (volume === null) return t("none enclosed");
  const text = formatNumber(volume, 6);
  if (reducedVolume === null) return text;
  return t("{volume} (reduced {reduced})", {
    volume: text,
    reduced: formatNumber(reducedVolume, 4),
  });
}

/** What the p-Willmore flow decreases. @param {PageState["options"]} options */
function energyLabel({ p, spontaneousCurvature, tension, pressure }) {
  if (spontaneousCurvature || tension || pressure) return "∫(H − H₀)² dA + ¼(σA − PV)";
  const powers = new Map([
    [0, t("Area")],
    [1, "∫|H| dA"],
    [2, "∫H² dA"],
    [3, "∫|H|³ dA"],
    [4, "∫H⁴ dA"],
  ]);
  return powers.get(p) ?? `∫|H|^${p} dA`;
}

export function createReadings() {
  const energy = byId("energy", HTMLElement);
  const half = byId("energy-half", HTMLElement);
  const panel = byId("panel", HTMLElement);
  const label = byId("energy-label", HTMLElement);
  /** @type {NodeListOf<HTMLElement>} */
  const cells = byId("readings", HTMLTableElement).querySelectorAll("[data-reading]");

  /** @type {PageState["reading"]} */
  let shown = null;
  /** @type {PageState["mesh"]} */
  let mesh = null;
  /** @type {PageState["options"] | null} */
  let options = null;
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.options !== options) {
        options = state.options;
        showParts(panel, options);
        setText(label, energyLabel(settled(options)));
      }
      if (state.reading === shown && state.mesh === mesh) return;
      shown = state.reading;
      mesh = state.mesh;
      const texts = readingsOf(state);
      for (const cell of cells) setText(cell, texts[cell.dataset.reading ?? ""] ?? "–");
      setText(energy, formatNumber(shown?.energy, 5));
      setText(half, formatNumber(shown?.energyNormalised, 5));
    },
  };
}
