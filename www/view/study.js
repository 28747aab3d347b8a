// A refinement study: energies at several resolutions, with orders and what that means.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { LOST } from "../channel.js";
import { samples } from "../generated/library.js";
import { formatNumber } from "../number.js";
import { createSolver } from "../solver.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, grid, into, select } from "./parts.js";

/** @import { StudyReport } from "../generated/types.js" */
/** @import { Solver } from "../solver.js" */

const result = signal(/** @type {StudyReport | null} */ (null));
const subject = signal("shape");

/** Work of a solver of its own, so that the flow on screen goes on. @param {(own: Solver, isWanted: () => boolean) => Promise<unknown>} job */
export function workAside(job) {
  const said = signal("");
  const solver = signal(/** @type {Solver | null} */ (null));
  function end() {
    solver.peek()?.dismiss();
    solver.value = null;
  }
  async function begin() {
    const own = createSolver({
      onCrashed(reason) {
        said.value = say("study-crashed", { reason });
        end();
      },
    });
    const isWanted = () => solver.peek() === own;
    solver.value = own;
    said.value = "";
    try {
      await job(own, isWanted);
    } catch (error) {
      const { kind, message } = /** @type {import("../words.js").Fault} */ (error);
      if (isWanted() && kind !== LOST) said.value = message;
    }
    if (isWanted()) end();
  }
  const turn = (/** @type {string} */ start) =>
    solver.value
      ? button(say("study-cancel"), end, "small")
      : button(start, begin, "small primary");
  return { said, turn };
}

const { said, turn } = workAside(async (own, isWanted) => {
  const { options, source } = page.get();
  result.value = null;
  said.value = say("study-preparing");
  const p = options.flow === "p-willmore" ? options.p : 2;
  const isShape = subject.peek() === "shape" && source?.kind === "sample";
  const sample = isShape ? samples.find(({ id }) => id === source.id) : undefined;
  const shape = sample && !sample.fill ? sample : null;
  if (!shape) {
    const { bytes } = await page.solver.export("ply");
    await own.load("surface.ply", bytes);
  }
  for (let level = 1; ; level += 1) {
    said.value = say("study-measuring", { level });
    const begun = shape ? { shape: shape.shape, parameters: shape.parameters, p } : { p };
    const study = await own.ask("study", { options: level === 1 ? begun : null });
    if (!isWanted()) return;
    result.value = study;
    if (study.finished) break;
  }
  said.value = "";
});

/** @param {StudyReport} study */
function shown(study) {
  const { trends, rows, refinedBy, mostVertices: most, findings } = study;
  const symbols = trends.map(({ quantity }) => say("trend-symbol", { quantity }));
  const heads = [say("reading-vertices"), "h", ...symbols];
  const measured = rows.map(({ vertices, h }, k) => [
    vertices,
    formatNumber(h, 3),
    ...trends.map(({ values, orders }) => {
      const order = orders[k]?.toFixed(2);
      const small = order ? html`<br /><small>${say("study-order", { order })}</small>` : nothing;
      return html`${formatNumber(values[k], 5)}${small}`;
    }),
  ]);
  const smooth = trends.map(
    (one) => `${one.isKnown || one.smooth === null ? "" : "≈ "}${formatNumber(one.smooth, 5)}`,
  );
  const isAny = trends.some((one) => one.smooth !== null);
  const all = isAny ? [...measured, [say("study-smooth"), "0", ...smooth]] : measured;
  return html`<p class="hint">${say("study-refined-by", { refinedBy, most })}</p>${grid(say("study"), heads, all)}
    ${findings.length > 0 ? html`<ul class="findings">${findings.map((one) => html`<li>${say(one)}</li>`)}</ul>` : nothing}`;
}

export function study() {
  const { source } = page.state.value;
  const choices = [
    ...(source?.kind === "sample" ? [{ id: "shape", label: say("study-sample") }] : []),
    { id: "surface", label: say("study-surface") },
  ];
  return html`<div class="row">${select(say("study-of"), choices, subject.value, into(subject))}${turn(say("study-run"))}</div>
    <p class="hint" role="note">${said.value}</p>${result.value ? shown(result.value) : nothing}`;
}
