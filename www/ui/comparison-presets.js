// @ts-check
// Comparisons worth teaching: what the first pane does, and what the others do otherwise.

/** @import { Options } from "../options.js" */

import { t } from "../language.js";

/**
 * @typedef {object} Preset
 * @property {string} id
 * @property {string} label
 * @property {Partial<Options>} main
 * @property {Partial<Options>[]} panes
 */

/** @returns {Preset[]} */
export const presets = () => [
  {
    id: "epsilon",
    label: t("ε = 0.1 against 0.01"),
    main: { flow: "circle", scheme: "auto", epsilon: 0.1 },
    panes: [{ epsilon: 0.01 }],
  },
  {
    id: "scheme",
    label: t("Recommended scheme against the paper’s"),
    main: { scheme: "auto" },
    panes: [{ scheme: "paper" }],
  },
  {
    id: "exponents",
    label: t("p-Willmore: p = 1, 2, 3, 4"),
    main: { flow: "p-willmore", p: 1 },
    panes: [{ p: 2 }, { p: 3 }, { p: 4 }],
  },
  {
    id: "regularised",
    label: t("p-Willmore: regularised, and not"),
    main: { flow: "p-willmore", p: 2, regularise: "nonlinear" },
    panes: [{ regularise: "off" }],
  },
  {
    id: "curvature",
    label: t("Four flows by mean curvature"),
    main: { flow: "mean-curvature", prefill: true },
    panes: [{ flow: "surface-diffusion" }, { flow: "willmore" }, { flow: "mmcv" }],
  },
  {
    id: "willmore",
    label: t("Willmore flow: circle angles, p-Willmore"),
    main: { flow: "circle" },
    panes: [{ flow: "p-willmore", p: 2 }],
  },
];
