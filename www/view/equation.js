// The energy and the equation of the flow in force, symbol by symbol, with their values.

import { html, nothing } from "lit-html";
import temml from "temml";
import { functionals, steps, symbols } from "../generated/equation.js";
import { formatNumber } from "../number.js";
import { flowOf, isRead } from "../options.js";
import { say } from "../words.js";
import { page } from "./page.js";

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

export function equation() {
  const { options, configured, mesh } = page.state.value;
  const shown = page.shown();
  const flow = flowOf(options.flow);
  const { family } = flow;
  const way = options.integrator === "semi-implicit" ? options.scheme : options.integrator;
  const step = steps[`${family} ${way}`] ?? steps[`${family} ${options.scheme}`] ?? steps[family];
  /** @type {Record<string, number | null | undefined>} */
  const values = {
    ...{ epsilon: options.epsilon, p: options.p, spontaneous: options.spontaneousCurvature },
    ...{ tension: shown?.multipliers?.tension, pressure: shown?.multipliers?.pressure },
    ...{ dt: shown?.dt ?? configured?.dt, tau: shown?.tau ?? configured?.tau },
    edge: configured?.meanEdgeLength,
    size: mesh && Math.sqrt(mesh.info.area / (4 * Math.PI)),
  };
  const rows = symbols
    .filter(
      ({ tex: symbol, id, families, reads, keeps, inFormula, isSet }) =>
        (families.length === 0 || families.includes(family)) &&
        (reads === null || isRead(reads, options)) &&
        (keeps === null || options.keep.some((one) => one === keeps)) &&
        (!inFormula || flow.formula.includes(symbol)) &&
        (!isSet || values[id] !== 0),
    )
    .map(({ tex: symbol, id }) => {
      const value = values[id] == null ? "" : formatNumber(values[id], 4);
      return html`<tr><th scope="row">${tex(symbol)}</th><td>${say(`symbols-${id}`)}</td><td>${value}</td></tr>`;
    });
  const part = (/** @type {string} */ heading, /** @type {readonly string[]} */ formulas) =>
    html`<div class="formulas" tabindex="0" role="group" aria-label=${heading}><b>${heading}</b>${formulas.map((one) => tex(one, true))}</div>`;
  const functional = functionals[shown?.monitored ?? flow.monitored[0]];
  return html`${part(say("equation-energy"), functional)}${part(say("equation-flow"), [flow.formula, step])}
    <table class="rows symbols" aria-label=${say("symbols")}><tbody>${rows}</tbody></table>
    ${family === "circle" ? html`<p class="hint">${say("what-w-says")}</p>` : nothing}
    <p class="hint">${flow.paper}${flow.tau ? `; τ = ${flow.tau}` : ""}</p>`;
}
