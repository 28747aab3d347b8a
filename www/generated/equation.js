// The functional, the step and the symbols of each flow. Written from src/flow/equation.rs by
// `UPDATE_SCHEMA=1 cargo test --test schema`.

/** @import { Monitored } from './types.js' */

/**
 * A symbol, and where it matters: where all that is said of it holds.
 * @typedef {{ tex: string, id: string, families: readonly string[], reads: string | null, keeps: string | null, inFormula: boolean, isSet: boolean }} Symbol
 */

/** @type {Readonly<Record<Monitored, readonly string[]>>} */
export const functionals = {
  "area": ["A = \\int dA"],
  "curvatureVariation": ["F = \\int \\|\\nabla H\\|^2 \\, dA"],
  "helfrich": ["E = \\int (H - H_0)^2 \\, dA + \\tfrac14 (\\sigma A - P V)"],
  "pWillmore": ["E = \\int |H|^p \\, dA"],
  "smoothedCircle": ["E = \\sum_i \\Bigl( \\sum_j \\varphi(\\beta_{ij}) - 2\\pi \\Bigr)","\\varphi(\\beta) = \\sqrt{\\beta^2 + \\epsilon^2} - \\epsilon"],
  "willmore": ["E = \\int H^2 \\, dA"],
};

/** @type {Readonly<Record<string, string>>} */
export const steps = {
  "circle auto": "\\Bigl( \\frac{M}{dt} + K_+ \\Bigr) \\Delta x = -\\nabla E(x)",
  "circle backward-euler": "\\frac{M}{dt} \\Delta x = -\\nabla E(x + \\Delta x)",
  "circle forward-euler": "\\frac{M}{dt} \\Delta x = -\\nabla E(x)",
  "circle l-bfgs": "\\Delta x = -\\alpha B_k \\nabla E(x)",
  "circle paper": "\\Bigl( \\frac{I}{dt} + K \\Bigr) \\Delta x = -\\nabla E(x)",
  "curvature": "\\frac{\\varphi_i}{dt} = V_i^{k+1}(\\varphi), \\quad x^{k+1} = x^k + s \\varphi n",
  "flips": "f(e) = W_m - W_n > 0",
  "p-willmore auto": "\\Bigl( \\frac{M}{dt} + L C L \\Bigr) \\Delta x = -\\Pi \\, 2^p (\\nabla E + \\lambda \\nabla A - \\mu \\nabla V)",
  "p-willmore paper": "M \\frac{x^{k+1} - x^k}{dt} = -2^p (\\nabla E + \\lambda \\nabla A - \\mu \\nabla V)(\\tfrac12 (x^k + x^{k+1}))",
};

/** @type {readonly Symbol[]} */
export const symbols = [
  {"families":["circle","flips"],"id":"beta","inFormula":false,"isSet":false,"keeps":null,"reads":null,"tex":"\\beta_{ij}"},
  {"families":[],"id":"epsilon","inFormula":false,"isSet":false,"keeps":null,"reads":"epsilon","tex":"\\epsilon"},
  {"families":[],"id":"p","inFormula":false,"isSet":false,"keeps":null,"reads":"p","tex":"p"},
  {"families":["circle","p-willmore","curvature"],"id":"mean","inFormula":false,"isSet":false,"keeps":null,"reads":null,"tex":"H"},
  {"families":[],"id":"gauss","inFormula":true,"isSet":false,"keeps":null,"reads":null,"tex":"K"},
  {"families":["curvature"],"id":"normal","inFormula":false,"isSet":false,"keeps":null,"reads":null,"tex":"n"},
  {"families":[],"id":"spontaneous","inFormula":false,"isSet":true,"keeps":null,"reads":"p","tex":"H_0 \\ell"},
  {"families":[],"id":"tension","inFormula":false,"isSet":false,"keeps":"area","reads":"keep","tex":"\\lambda"},
  {"families":[],"id":"pressure","inFormula":false,"isSet":false,"keeps":"volume","reads":"keep","tex":"\\mu"},
  {"families":["circle","p-willmore"],"id":"mass","inFormula":false,"isSet":false,"keeps":null,"reads":null,"tex":"M"},
  {"families":["circle"],"id":"matrix","inFormula":false,"isSet":false,"keeps":null,"reads":null,"tex":"K_+"},
  {"families":[],"id":"dt","inFormula":false,"isSet":false,"keeps":null,"reads":"dt","tex":"dt"},
  {"families":[],"id":"tau","inFormula":false,"isSet":false,"keeps":null,"reads":"tau","tex":"\\tau"},
  {"families":[],"id":"edge","inFormula":false,"isSet":false,"keeps":null,"reads":"epsilon","tex":"h"},
  {"families":[],"id":"size","inFormula":false,"isSet":false,"keeps":null,"reads":"p","tex":"\\ell"},
  {"families":[],"id":"localised","inFormula":false,"isSet":false,"keeps":null,"reads":"criterion","tex":"W_m, W_n"},
];
