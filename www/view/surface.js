// The tab of the surface: what it is, what was found in it, what can be changed.

import { html, nothing } from "lit-html";
import { samples } from "../generated/library.js";
import { sampleName } from "../library.js";
import { formatNumber } from "../number.js";
import { sceneTitle } from "../status.js";
import { tools } from "../store.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, idOf, select, shortNumber } from "./parts.js";

/** @import { Loaded, RepairItem } from "../generated/types.js" */

/** Below this angle triangles are called uneven, in degrees. */
const EVEN = 15;

/** @param {string} text @param {unknown} hint @param {unknown} [act] */
const finding = (text, hint, act = nothing) =>
  html`<div class="finding"><div>${text}<div class="hint">${hint}</div></div>${act}</div>`;

/** @param {Loaded} mesh */
function findings({ info, repaired }) {
  const { boundaryLoops, selfIntersections, oriented } = info;
  const angle = page.shown()?.minAngleDegrees ?? info.minAngleDegrees;
  const isEven = angle >= EVEN;
  const fill = button(say("fill-start"), () => page.edit.mode("fill"), "small primary");
  const count = { count: boundaryLoops };
  const rim =
    boundaryLoops > 0
      ? finding(say("found-holes", count), say("found-holes.hint", count), fill)
      : finding(say("found-closed"), say(oriented ? "found-two-sided" : "found-one-sided"));
  const even = isEven ? nothing : button(say("even-out"), page.edit.regularise, "small");
  const inside = say("found-angle", { angle: formatNumber(angle, 3) });
  const show = button(say("why-show"), () => showCrossings().catch(page.report), "small");
  const crossings = say("crossings", { count: selfIntersections ?? 0 });
  return html`<h3>${say("found")}</h3>${defects({ info, repaired })}${rim}
    ${finding(say(isEven ? "found-even" : "found-uneven"), inside, even)}
    ${selfIntersections ? finding(crossings, say("crossings-hint"), show) : nothing}
    ${info.warnings.map((warning) => html`<p class="hint">${say(warning)}</p>`)}`;
}

/** What a repair would change, or has changed. @param {Pick<Loaded, "info" | "repaired">} mesh */
function defects({ info, repaired }) {
  /** @param {readonly RepairItem[]} items */
  const list = (items) =>
    html`<ul class="changes">${items.map(({ message }) => html`<li>${say(message)}</li>`)}</ul>`;
  const wanting = info.repairs.filter(({ done }) => !done);
  const start = button(say("repair"), () => page.edit.repair(), "small primary");
  const name = say("weld-length");
  const field = () => /** @type {HTMLInputElement} */ (document.getElementById(idOf(name)));
  const weld = () => page.edit.repair({ weld: field().valueAsNumber });
  const gap = shortNumber(name, info.gap?.toPrecision(3) ?? "", () => {}, { min: 0 });
  return html`
    ${wanting.length > 0 ? finding(say("found-broken"), html`${say("found-broken.hint")}${list(wanting)}`, start) : nothing}
    ${info.gap === undefined ? nothing : finding(say("found-gap"), html`${say("found-gap.hint")} ${gap}`, button(say("weld"), weld, "small"))}
    ${repaired.length > 0 ? finding(say("found-repaired"), list(repaired)) : nothing}`;
}

async function showCrossings() {
  const found = await page.solver.ask("selfIntersections");
  if (found) page.patch({ marks: { edges: new Uint32Array(), triangles: found.triangles } });
}

/** @param {Loaded} mesh */
function changes({ info }) {
  const { mode, earlier } = page.state.value;
  const undone = earlier.at(-1);
  /** @type {Record<string, boolean>} */
  const isMeant = { fill: info.boundaryLoops > 0, remesh: info.oriented };
  const meant = tools.filter((tool) => isMeant[tool] ?? true);
  const chips = meant.map((tool) => {
    const turn = () => page.edit.mode(mode === tool ? null : tool);
    return button(say(`tool-${tool}`), turn, "chip", { icon: tool, pressed: mode === tool });
  });
  const isUnderWay = (page.shown()?.step ?? 0) > 0;
  return html`<hr /><h3>${say("change-it")}</h3><div class="row">${chips}</div>
    <div class="row">${button(say("even-out"), page.edit.regularise, "small")}
      ${isUnderWay ? button(say("start-from-here"), page.edit.adopt, "small") : nothing}
      ${undone ? button(say("undo", { what: undone.what }), page.edit.undo, "small", { icon: "undo" }) : nothing}</div>`;
}

export function surface() {
  const { mesh, source, comparison } = page.state.value;
  const title = sceneTitle(source);
  const isSample = source?.kind === "sample";
  const own = isSample || !source ? [] : [{ id: "", label: title, group: say("yours") }];
  const choices = samples.map(({ id, group }) => ({
    ...{ id, label: sampleName(id) },
    group: say(`group-${group}`),
  }));
  const { vertices = 0, faces = 0, boundaryLoops: loops = 0 } = mesh?.info ?? {};
  const size = say("mesh-size", { vertices, faces, loops });
  return html`${mesh ? html`<div><b class="name">${title}</b><p class="hint">${size}</p></div>` : nothing}
    ${select(say("sample"), [...own, ...choices], isSample ? source.id : "", (id) => id && page.open.sample(id))}
    <div class="row">${button(say("library"), () => page.patch({ dialog: "library" }), "", { icon: "library" })}
      ${button(say("open-mesh"), page.chooseFile, "", { icon: "open" })}</div>
    <hr />${mesh ? findings(mesh) : nothing}${mesh && comparison.rivals.length === 0 ? changes(mesh) : nothing}`;
}
