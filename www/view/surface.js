// @ts-check
// The tab of the surface: what it is, what was found in it, what can be changed.

import { html, nothing } from "lit-html";
import { samples } from "../generated/library.js";
import { sampleName } from "../library.js";
import { formatNumber } from "../number.js";
import { sceneTitle } from "../status.js";
import { say } from "../words.js";
import { button, idOf, select } from "./parts.js";

/** @import { Page } from "../actions.js" */
/** @import { RepairItem } from "../generated/types.js" */

/** Below this angle triangles are called uneven, in degrees. */
const EVEN = 15;

/** @param {string} text @param {unknown} hint @param {unknown} [act] */
const finding = (text, hint, act = nothing) =>
  html`<div class="finding"><div>${text}<div class="hint">${hint}</div></div>${act}</div>`;

/** @param {Page} page */
function findings(page) {
  const { mesh } = page.state.value;
  if (!mesh) return nothing;
  const { boundaryLoops, minAngleDegrees, selfIntersections, oriented } = mesh.info;
  const small = { kind: "small" };
  const angle = page.shown()?.minAngleDegrees ?? minAngleDegrees;
  const isEven = angle >= EVEN;
  return html`<h3>${say("found")}</h3>
    ${defects(page)}
    ${
      boundaryLoops > 0
        ? finding(
            say("found-holes", { count: boundaryLoops }),
            say("found-holes.hint"),
            button(say("fill-start"), () => page.edit.mode("fill"), { kind: "small primary" }),
          )
        : finding(say("found-closed"), say(oriented ? "found-two-sided" : "found-one-sided"))
    }
    ${finding(
      say(isEven ? "found-even" : "found-uneven"),
      say("found-angle", { angle: formatNumber(angle, 3) }),
      isEven ? nothing : button(say("even-out"), page.edit.regularise, small),
    )}
    ${
      selfIntersections
        ? finding(
            say("crossings", { count: selfIntersections }),
            say("crossings-hint"),
            button(say("why-show"), () => showCrossings(page), small),
          )
        : nothing
    }
    ${mesh.info.warnings.map((warning) => html`<p class="hint">${say(warning)}</p>`)}`;
}

/** What a repair would change, or has changed. @param {Page} page */
function defects(page) {
  const { mesh } = page.state.value;
  if (!mesh) return nothing;
  const { repaired, info } = mesh;
  /** @param {readonly RepairItem[]} items */
  const list = (items) =>
    html`<ul class="changes">${items.map((item) => html`<li>${say(item.message)}</li>`)}</ul>`;
  const wanting = info.repairs.filter(({ done }) => !done);
  const start = button(say("repair"), () => page.edit.repair(), { kind: "small primary" });
  const id = idOf("weld");
  const length = () => /** @type {HTMLInputElement} */ (document.getElementById(id)).valueAsNumber;
  const weld = button(say("weld"), () => page.edit.repair({ weld: length() }), { kind: "small" });
  return html`${
    wanting.length > 0
      ? finding(say("found-broken"), html`${say("found-broken.hint")}${list(wanting)}`, start)
      : nothing
  }${
    info.gap === undefined
      ? nothing
      : finding(
          say("found-gap"),
          html`${say("found-gap.hint")} <label class="inline" for=${id}>${say("weld-length")}
          <input id=${id} class="short" type="number" min="0" step="any" .value=${info.gap.toPrecision(3)} /></label>`,
          weld,
        )
  }${repaired.length > 0 ? finding(say("found-repaired"), list(repaired)) : nothing}`;
}

/** @param {Page} page */
async function showCrossings(page) {
  const found = await page.edit.selfIntersections().catch(page.report);
  if (found) page.edit.mark({ edges: new Uint32Array(), triangles: found.triangles });
}

/** @param {Page} page */
export function surface(page) {
  const s = page.state.value;
  const { mesh, source, mode, earlier, comparison } = s;
  const isAlone = comparison.rivals.length === 0;
  const choices = samples.map(({ id, group }) => ({
    id,
    label: sampleName(id),
    group: say(`group-${group}`),
  }));
  const isSample = source?.kind === "sample";
  const own =
    isSample || !source ? [] : [{ id: "", label: sceneTitle(source), group: say("yours") }];
  const undone = earlier.at(-1);
  /** @param {"paint" | "fill" | "subdivide" | "remesh" | "invert"} tool */
  const tool = (tool) =>
    button(say(`tool-${tool}`), () => page.edit.mode(mode === tool ? null : tool), {
      kind: "chip",
      icon: tool,
      pressed: mode === tool,
    });
  return html`
    ${
      mesh
        ? html`<div><b class="name">${sceneTitle(source)}</b><p class="hint">${say("mesh-size", {
            vertices: mesh.info.vertices,
            faces: mesh.info.faces,
            loops: mesh.info.boundaryLoops,
          })}</p></div>`
        : nothing
    }
    ${select(say("sample"), [...own, ...choices], isSample ? source.id : "", (id) => id && page.open.sample(id))}
    <div class="row">${button(say("library"), () => page.patch({ dialog: "library" }), { icon: "library" })}
      ${button(say("open-mesh"), () => page.chooseFile(), { icon: "open" })}</div>
    <hr />${findings(page)}
    ${
      mesh && isAlone
        ? html`<hr /><h3>${say("change-it")}</h3>
        <div class="row">${tool("paint")}${mesh.info.boundaryLoops > 0 ? tool("fill") : nothing}${tool("subdivide")}${mesh.info.oriented ? tool("remesh") : nothing}${tool("invert")}</div>
        <div class="row">${button(say("even-out"), page.edit.regularise, { kind: "small" })}
          ${(page.shown()?.step ?? 0) > 0 ? button(say("start-from-here"), page.edit.adopt, { kind: "small" }) : nothing}
          ${undone ? button(say("undo", { what: undone.what }), page.edit.undo, { kind: "small", icon: "undo" }) : nothing}</div>`
        : nothing
    }`;
}
