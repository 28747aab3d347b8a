// @ts-check
// The energy and the equation of the flow in force, symbol by symbol, with their values.

import { html } from "lit-html";
import temml from "temml";
import { formatNumber } from "../number.js";
import { flowOf, isRead } from "../options.js";
import { say } from "../words.js";
import { page } from "./page.js";

/** @import { Monitored, State as Reading } from "../generated/types.js" */
/** @import { S } from "../store.js" */

/** Formulas that were set once. @type {Map<string, Element>} */
const known = new Map();

/** TeX as MathML. @param {string} source @param {boolean} [displayMode] */
function tex(source, displayMode = false) {
  const name = `${displayMode} ${source}`;
  let math = known.get(name);
  if (!math) {
    const holder = document.createElement("span");
    temml.render(source, holder, { displayMode, throwOnError: true });
    math = /** @type {Element} */ (holder.firstElementChild);
    known.set(name, math);
  }
  return math.cloneNode(true);
}

/** What does not rise. @type {Record<Monitored, readonly string[]>} */
const energies = {
  smoothedCircle: [
    "E = \\sum_i \\Bigl( \\sum_j \\varphi(\\beta_{ij}) - 2\\pi \\Bigr)",
    "\\varphi(\\beta) = \\sqrt{\\beta^2 + \\epsilon^2} - \\epsilon",
  ],
  area: ["A = \\int dA"],
  willmore: ["E = \\int H^2 \\, dA"],
  pWillmore: ["E = \\int |H|^p \\, dA"],
  helfrich: ["E = \\int (H - H_0)^2 \\, dA + \\tfrac14 (\\sigma A - P V)"],
  curvatureVariation: ["F = \\int \\|\\nabla H\\|^2 \\, dA"],
};

/** How a step is solved, by the family of the flow and its scheme. @type {Record<string, string>} */
const steps = {
  "circle auto": "\\Bigl( \\frac{M}{dt} + K_+ \\Bigr) \\Delta x = -\\nabla E(x)",
  "circle paper": "\\Bigl( \\frac{I}{dt} + K \\Bigr) \\Delta x = -\\nabla E(x)",
  "circle forward-euler": "\\frac{M}{dt} \\Delta x = -\\nabla E(x)",
  "circle backward-euler": "\\frac{M}{dt} \\Delta x = -\\nabla E(x + \\Delta x)",
  "circle l-bfgs": "\\Delta x = -\\alpha B_k \\nabla E(x)",
  "p-willmore auto":
    "\\Bigl( \\frac{M}{dt} + L C L \\Bigr) \\Delta x = -\\Pi \\, 2^p (\\nabla E + \\lambda \\nabla A - \\mu \\nabla V)",
  "p-willmore paper":
    "M \\frac{x^{k+1} - x^k}{dt} = -2^p (\\nabla E + \\lambda \\nabla A - \\mu \\nabla V)(\\tfrac12 (x^k + x^{k+1}))",
  curvature: "\\frac{\\varphi_i}{dt} = V_i^{k+1}(\\varphi), \\quad x^{k+1} = x^k + s \\varphi n",
  flips: "f(e) = W_m - W_n > 0",
};

/**
 * Symbols, what they are, and where they matter.
 * @type {readonly { tex: string, id: string, value?: (s: S, shown: Reading | null) => number | null | undefined, when: (s: S) => boolean }[]}
 */
const rows = [
  {
    tex: "\\beta_{ij}",
    id: "beta",
    when: ({ options }) => ["circle", "flips"].includes(flowOf(options.flow).family),
  },
  {
    tex: "\\epsilon",
    id: "epsilon",
    value: ({ options }) => options.epsilon,
    when: ({ options }) => isRead("epsilon", options),
  },
  {
    tex: "p",
    id: "p",
    value: ({ options }) => options.p,
    when: ({ options }) => isRead("p", options),
  },
  { tex: "H", id: "mean", when: ({ options }) => flowOf(options.flow).family !== "flips" },
  { tex: "K", id: "gauss", when: ({ options }) => flowOf(options.flow).formula.includes("K") },
  { tex: "n", id: "normal", when: ({ options }) => flowOf(options.flow).family === "curvature" },
  {
    tex: "H_0 \\ell",
    id: "spontaneous",
    value: ({ options }) => options.spontaneousCurvature,
    when: ({ options }) => isRead("p", options) && options.spontaneousCurvature !== 0,
  },
  {
    tex: "\\lambda",
    id: "tension",
    value: (_, shown) => shown?.multipliers?.tension,
    when: ({ options }) => isRead("keep", options) && options.keep.includes("area"),
  },
  {
    tex: "\\mu",
    id: "pressure",
    value: (_, shown) => shown?.multipliers?.pressure,
    when: ({ options }) => isRead("keep", options) && options.keep.includes("volume"),
  },
  {
    tex: "M",
    id: "mass",
    when: ({ options }) => ["circle", "p-willmore"].includes(flowOf(options.flow).family),
  },
  { tex: "K_+", id: "matrix", when: ({ options }) => flowOf(options.flow).family === "circle" },
  {
    tex: "dt",
    id: "dt",
    value: ({ configured }, shown) => shown?.dt ?? configured?.dt,
    when: ({ options }) => isRead("dt", options),
  },
  {
    tex: "\\tau",
    id: "tau",
    value: ({ configured }, shown) => shown?.tau ?? configured?.tau,
    when: ({ options }) => isRead("tau", options),
  },
  {
    tex: "h",
    id: "edge",
    value: ({ configured }) => configured?.meanEdgeLength,
    when: ({ options }) => isRead("epsilon", options),
  },
  {
    tex: "\\ell",
    id: "size",
    value: ({ mesh }) => mesh && Math.sqrt(mesh.info.area / (4 * Math.PI)),
    when: ({ options }) => isRead("p", options),
  },
  { tex: "W_m, W_n", id: "localised", when: ({ options }) => isRead("criterion", options) },
];

/** @param {S} s */
function stepOf({ options }) {
  const { family } = flowOf(options.flow);
  const own = `${family} ${options.integrator === "semi-implicit" ? options.scheme : options.integrator}`;
  return steps[own] ?? steps[`${family} ${options.scheme}`] ?? steps[family];
}

export function equation() {
  page.player.tick.value;
  const s = page.state.value;
  const shown = page.shown();
  const flow = flowOf(s.options.flow);
  const monitored = /** @type {Monitored} */ (shown?.monitored ?? flow.monitored[0]);
  const part = (/** @type {string} */ heading, /** @type {readonly string[]} */ formulas) =>
    html`<div class="formulas" tabindex="0" role="group" aria-label=${heading}><b>${heading}</b>${formulas.map((one) => tex(one, true))}</div>`;
  return html`${part(say("equation-energy"), energies[monitored])}${part(say("equation-flow"), [flow.formula, stepOf(s)])}
    <table class="rows symbols" aria-label=${say("symbols")}><tbody>${rows
      .filter(({ when }) => when(s))
      .map(({ tex: symbol, id, value }) => {
        const now = value?.(s, shown);
        return html`<tr><th scope="row">${tex(symbol)}</th><td>${say(`symbols-${id}`)}</td><td>${now === undefined || now === null ? "" : formatNumber(now, 4)}</td></tr>`;
      })}</tbody></table>
    <p class="hint">${flow.paper}${flow.tau ? `; τ = ${flow.tau}` : ""}</p>`;
}
