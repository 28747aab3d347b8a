// @ts-check
// The options of a flow: their defaults, their choices, and how they are read from text.

/** @import { FlowOptions } from "./protocol.js" */

/** @typedef {Readonly<Required<FlowOptions>>} Options */

/** @type {Options} */
export const defaults = Object.freeze({
  flow: "circle",
  scheme: "auto",
  integrator: "semi-implicit",
  boundary: null,
  goal: "relax",
  detail: 4,
  smoothSteps: 10,
  dt: null,
  tau: null,
  mass: "auto",
  epsilon: 0.1,
  sharpen: true,
  prefill: false,
  free: null,
  fixed: null,
  maxSteps: null,
  maxSeconds: 120,
  perturbation: 0,
  p: 2,
  keep: [],
  regularise: "nonlinear",
  regulariseEpsilon: 0.01,
  tauGrowth: 1.2,
  tauMax: null,
  reducedVolume: null,
  spontaneousCurvature: 0,
  tension: 0,
  pressure: 0,
  criterion: "localised",
  guardFolds: false,
  rungs: null,
});

/** Flows by mean curvature and its derivatives, by their order. */
export const byCurvature = ["mean-curvature", "surface-diffusion", "willmore", "mmcv"];

/** What a flow does at a boundary unless told otherwise. @param {string} flow */
export const usualBoundary = (flow) => (byCurvature.includes(flow) ? "fixed" : "clamped");

/** @type {Readonly<import("./protocol.js").Arrangement>} */
export const plainArrangement = Object.freeze({ compare: "none", subdivide: 0, flipsPerStep: 1 });

/** @type {Readonly<Record<string, readonly { id: string, label: string }[]>>} */
export const choices = {
  flow: [
    { id: "circle", label: "Willmore, circle angles" },
    { id: "p-willmore", label: "p-Willmore" },
    { id: "mean-curvature", label: "Mean curvature" },
    { id: "surface-diffusion", label: "Surface diffusion" },
    { id: "willmore", label: "Willmore, fitted operators" },
    { id: "mmcv", label: "Mean-curvature variation" },
    { id: "flips", label: "Edge flips" },
  ],
  boundary: [
    { id: "clamped", label: "Clamped (with tangent)" },
    { id: "fixed", label: "Fixed (position only)" },
    { id: "free", label: "Free" },
  ],
  criterion: [
    { id: "area", label: "Area" },
    { id: "willmore", label: "Willmore energy" },
    { id: "localised", label: "Localised Willmore energy" },
  ],
  colour: [
    { id: "none", label: "Nothing" },
    { id: "mean-curvature", label: "Mean curvature H" },
    { id: "gauss-curvature", label: "Gaussian curvature K" },
    { id: "willmore", label: "Willmore energy Wᵢ" },
    { id: "gradient", label: "Gradient size" },
    { id: "displacement", label: "Displacement" },
  ],
  format: [
    { id: "ply", label: "PLY" },
    { id: "ply-ascii", label: "PLY, text" },
    { id: "obj", label: "OBJ" },
    { id: "off", label: "OFF" },
    { id: "stl", label: "STL" },
    { id: "stl-ascii", label: "STL, text" },
    { id: "glb", label: "glTF (GLB)" },
    { id: "csv", label: "History, CSV" },
    { id: "recipe", label: "Recipe, JSON" },
    { id: "png", label: "Picture, PNG" },
  ],
};

/** @param {string | number} low @param {string | number} high */
const between = (low, high) => (/** @type {string} */ text) => {
  const value = Number(text);
  return text !== "" && value >= Number(low) && value <= Number(high) ? value : undefined;
};
/** @param {string[]} names */
const oneOf =
  (...names) =>
  (/** @type {string} */ text) =>
    names.includes(text) ? text : undefined;
/** @param {string[]} known  some of them, or `none` */
const names =
  (...known) =>
  (/** @type {string} */ text) => {
    if (text === "none") return [];
    const list = text.split(",");
    return list.every((name) => known.includes(name)) ? list : undefined;
  };
/**
 * @template T
 * @param {(text: string) => T | undefined} read  `auto` is null: left to the solver, or no limit
 */
const orAuto = (read) => (/** @type {string} */ text) => (text === "auto" ? null : read(text));
/** @param {string} text @returns {boolean | undefined} */
const flag = (text) => (text === "true" ? true : text === "false" ? false : undefined);
/** @param {string} text */
const count = (text) => (/^[1-9]\d{0,6}$/.test(text) ? Number(text) : undefined);

/**
 * Reads one option from text; `undefined` when the text is not a value of it.
 * @type {Readonly<Record<string, (text: string) => string | number | boolean | string[] | null | undefined>>}
 */
export const readers = {
  flow: oneOf(
    ...["circle", "p-willmore", "mean-curvature", "surface-diffusion", "willmore", "mmcv", "flips"],
  ),
  scheme: oneOf("auto", "paper"),
  integrator: oneOf("semi-implicit", "forward-euler", "backward-euler", "l-bfgs"),
  boundary: orAuto(oneOf("clamped", "fixed", "free")),
  goal: oneOf("relax", "smooth"),
  detail: between(0.1, 1000),
  smoothSteps: count,
  dt: orAuto(between(1e-300, 1e300)),
  tau: orAuto(between(1e-12, 1e12)),
  mass: oneOf("auto", "uniform", "area"),
  epsilon: between(0, 10),
  sharpen: flag,
  prefill: flag,
  maxSteps: orAuto(count),
  maxSeconds: orAuto(between(1e-3, 1e9)),
  perturbation: between(0, 0.3),
  p: between(0, 16),
  keep: names("area", "volume"),
  regularise: oneOf("off", "linear", "nonlinear"),
  regulariseEpsilon: between(1e-9, 1e9),
  tauGrowth: between(1, 100),
  tauMax: orAuto(between(1e-12, 1e12)),
  reducedVolume: orAuto(between(0.01, 1)),
  spontaneousCurvature: between(-1e3, 1e3),
  tension: between(-1e6, 1e6),
  pressure: between(-1e6, 1e6),
  criterion: oneOf("area", "willmore", "localised"),
  guardFolds: flag,
  rungs: orAuto((text) => (text === "0" ? 0 : count(text))),
};

/**
 * The same for an arrangement.
 * @type {Readonly<Record<string, (text: string) => string | number | null | undefined>>}
 */
export const arrangementReaders = {
  compare: oneOf("none", "start", "criteria", "flows"),
  subdivide: (text) => (/^[0-3]$/.test(text) ? Number(text) : undefined),
  flipsPerStep: (text) => (text === "all" ? null : count(text)),
};

/**
 * An option as text, which its reader reads.
 * @param {unknown} value
 */
export const asText = (value) =>
  Array.isArray(value) && value.length === 0 ? "none" : String(value ?? "auto");

/**
 * How far `smooth` goes: halves every wavelength of L½ ≈ 6.7 (N τ)^¼ h, so N steps
 * that remove what is below `detail` edge lengths have this τ = dt/h² each.
 * @param {number} detail  in mean edge lengths
 * @param {number} steps
 */
export const smoothingTau = (detail, steps) => (detail / 6.7) ** 4 / steps;
