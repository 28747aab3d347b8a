// @ts-check
// Comparisons worth teaching: what the first pane does, and what the others do otherwise.

/** @import { Loaded } from "../generated/types.js" */
/** @import { Options } from "../options.js" */

import { t } from "../language.js";

/**
 * @typedef {object} Preset
 * @property {string} id
 * @property {string} label
 * @property {"any" | "closed" | "patch"} surface  that it makes sense on
 * @property {Partial<Options>} main
 * @property {Partial<Options>[]} panes
 */

/** @returns {Preset[]} */
export const presets = () => [
  {
    id: "epsilon",
    label: t("ε = 0.1 against 0.01"),
    surface: "any",
    main: { flow: "circle", scheme: "auto", epsilon: 0.1 },
    panes: [{ epsilon: 0.01 }],
  },
  {
    id: "scheme",
    label: t("Recommended scheme against the paper’s"),
    surface: "any",
    main: { scheme: "auto" },
    panes: [{ scheme: "paper" }],
  },
  {
    id: "exponents",
    label: t("p-Willmore: p = 1, 2, 3, 4"),
    surface: "closed",
    main: { flow: "p-willmore", p: 1 },
    panes: [{ p: 2 }, { p: 3 }, { p: 4 }],
  },
  {
    id: "regularised",
    label: t("p-Willmore: regularised, and not"),
    surface: "closed",
    main: { flow: "p-willmore", p: 2, regularise: "nonlinear" },
    panes: [{ regularise: "off" }],
  },
  {
    id: "curvature",
    label: t("Four flows by mean curvature"),
    surface: "patch",
    main: { flow: "mean-curvature", prefill: true },
    panes: [{ flow: "surface-diffusion" }, { flow: "willmore" }, { flow: "mmcv" }],
  },
  {
    id: "willmore",
    label: t("Willmore flow: circle angles, p-Willmore"),
    surface: "closed",
    main: { flow: "circle" },
    panes: [{ flow: "p-willmore", p: 2 }],
  },
];

/**
 * Why a comparison makes no sense on a mesh; empty where it does.
 * @param {Preset} preset
 * @param {Loaded | null} mesh
 * @param {Options} options
 */
export function objection({ surface }, mesh, options) {
  if (!mesh || surface === "any") return "";
  if (surface === "closed") return mesh.info.closed ? "" : t("closed surfaces only");
  const isPatch = !mesh.info.closed || mesh.free || mesh.fixed || options.free || options.fixed;
  return isPatch ? "" : t("only where a part is held, or open");
}
