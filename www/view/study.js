// @ts-check
// A refinement study: energies at several resolutions, with orders and what that means. It has a
// solver of its own, so that the flow on screen goes on.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { LOST } from "../channel.js";
import { samples } from "../generated/library.js";
import { formatNumber } from "../number.js";
import { createSolver } from "../solver.js";
import { say } from "../words.js";
import { button, grid, into, select } from "./parts.js";

/** @import { StudyOptions, StudyReport, Trend } from "../generated/types.js" */
/** @import { Page } from "../actions.js" */
/** @import { Solver } from "../solver.js" */

/** @type {Readonly<Record<string, string>>} */
const symbols = {
  area: "A",
  circle: "W/2",
  cotangent: "∫H² cot",
  fitted: "∫H² fit",
  power: "∫|H|^p",
};

/** @type {import("@preact/signals-core").Signal<StudyReport | null>} */
const result = signal(null);
const said = signal("");
const subject = signal("shape");
/** @type {import("@preact/signals-core").Signal<Solver | null>} */
const solver = signal(null);

/** What a quantity does, in one sentence. @param {Trend} trend @param {number} p */
function finding({ quantity, tendency, smooth, isKnown, values, orders }, p) {
  const last = values.at(-1) ?? 0;
  const order = orders.at(-1);
  return say("trend", {
    name: say("trend-name", { quantity, p }),
    tendency:
      tendency === "converges" && !isKnown
        ? smooth === null
          ? "settles"
          : "nears"
        : tendency === "elsewhere" && !smooth
          ? "elsewhereThanZero"
          : tendency,
    smooth: formatNumber(smooth, 5),
    order: order === null || order === undefined ? "–" : order.toFixed(1),
    ratio: smooth ? formatNumber(last / smooth, 3) : "–",
  });
}

/** @param {StudyReport} study */
function findings({ refinedBy, trends, p }) {
  const circle = trends.find(({ quantity }) => quantity === "circle")?.tendency;
  return [
    ...trends.map((trend) => finding(trend, p)),
    ...(refinedBy === "polyhedron" ? [say("study-polyhedron")] : []),
    ...(circle === "elsewhere" || circle === "diverges" ? [say("study-lattice")] : []),
    say("study-minimisers"),
  ];
}

function end() {
  solver.peek()?.dismiss();
  solver.value = null;
}

/** A solver that the flow on screen knows nothing of. @param {(reason: string) => void} onCrashed */
export function solverAside(onCrashed) {
  const deaf = () => {};
  const [onReady, onFrame, onStopped, onProgress, onSilent] = Array(5).fill(deaf);
  return createSolver({ onReady, onFrame, onStopped, onProgress, onSilent, onCrashed });
}

/** @param {Page} page */
async function run(page) {
  const { options, source, mesh } = page.get();
  if (solver.peek() || !mesh) return;
  const own = solverAside((reason) => {
    said.value = say("study-crashed", { reason });
    end();
  });
  solver.value = own;
  result.value = null;
  said.value = say("study-preparing");
  const p = options.flow === "p-willmore" ? options.p : 2;
  const sample =
    subject.peek() === "shape" && source?.kind === "sample"
      ? samples.find(({ id }) => id === source.id)
      : undefined;
  try {
    /** @type {Partial<StudyOptions> | null} */
    let next = { p };
    if (sample && !sample.fill) next = { shape: sample.shape, parameters: sample.parameters, p };
    else {
      const { bytes } = await page.solver.export("ply");
      await own.load("surface.ply", bytes);
    }
    for (let level = 1; solver.peek() === own; level += 1) {
      said.value = say("study-measuring", { level });
      const study = await own.study(next);
      if (solver.peek() !== own) return;
      next = null;
      result.value = study;
      if (!study.finished) continue;
      said.value = "";
      end();
    }
  } catch (error) {
    const { kind, message } = /** @type {import("../words.js").Fault} */ (error);
    if (solver.peek() !== own || kind === LOST) return;
    said.value = message;
    end();
  }
}

/** @param {StudyReport} study */
function shown(study) {
  const heads = [
    say("reading-vertices"),
    "h",
    ...study.trends.map(({ quantity }) => symbols[quantity]),
  ];
  const rows = study.rows.map(({ vertices, h }, k) => [
    vertices,
    formatNumber(h, 3),
    ...study.trends.map(
      ({ values, orders }) =>
        html`${formatNumber(values[k], 5)}${orders[k] === null || orders[k] === undefined ? nothing : html`<br /><small>${say("study-order", { order: Number(orders[k]).toFixed(2) })}</small>`}`,
    ),
  ]);
  const smooth = study.trends.map((one) => {
    const text = one.smooth === null ? "–" : formatNumber(one.smooth, 5);
    return one.isKnown || one.smooth === null ? text : `≈ ${text}`;
  });
  return html`<p class="hint">${say("study-refined-by", { refinedBy: study.refinedBy, most: study.mostVertices })}</p>
    ${grid(say("study"), heads, [...rows, ...(study.trends.some((one) => one.smooth !== null) ? [[say("study-smooth"), "0", ...smooth]] : [])])}
    ${study.finished ? html`<ul class="findings">${findings(study).map((text) => html`<li>${text}</li>`)}</ul>` : nothing}`;
}

/** @param {Page} page */
export function study(page) {
  const { source } = page.state.value;
  const choices = [
    ...(source?.kind === "sample" ? [{ id: "shape", label: say("study-sample") }] : []),
    { id: "surface", label: say("study-surface") },
  ];
  return html`${select(say("study-of"), choices, subject.value, into(subject))}
    ${solver.value ? button(say("study-cancel"), end, { kind: "small" }) : button(say("study-run"), () => run(page), { kind: "small primary" })}
    <p class="hint" role="note">${said.value}</p>${result.value ? shown(result.value) : nothing}`;
}
