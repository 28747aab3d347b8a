// @ts-check
// Boundary loops: chosen from a list or on the surface, filled or connected.

/** @import { LoopInfo as BoundaryLoop } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { say } from "../words.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** Loops that the list names; a scan may have hundreds. */
const LISTED = 200;

/** Edges of a loop, two ends each. @param {BoundaryLoop} loop */
const edgesOf = ({ vertices }) =>
  vertices.flatMap((v, n) => [v, vertices[(n + 1) % vertices.length]]);

/**
 * @param {Controller} controller
 * @param {(event: MouseEvent, ends: Uint32Array) => number | null} nearestEdge  on the surface
 */
export function createHoles(controller, nearestEdge) {
  const section = byId("holes", HTMLDetailsElement);
  const list = byId("loops", HTMLFieldSetElement);
  const summary = byId("loops-summary", HTMLElement);
  const surface = byId("surface", HTMLCanvasElement);
  const most = byId("most-vertices", HTMLInputElement);
  const buttons = {
    all: byId("fill-all", HTMLButtonElement),
    chosen: byId("fill-chosen", HTMLButtonElement),
    connect: byId("connect", HTMLButtonElement),
  };

  /** @type {BoundaryLoop[]} */
  let loops = [];
  /** @type {Set<number>} */
  const chosen = new Set();
  /** @type {PageState["mesh"]} */
  let mesh = null;
  /** @type {number | null} the loop under the pointer or the focus */
  let near = null;

  function mark() {
    const marked = new Set(chosen);
    if (near !== null) marked.add(near);
    const edges = [...marked].flatMap((n) => (loops[n] ? edgesOf(loops[n]) : []));
    controller.mark(
      edges.length > 0 ? { edges: Uint32Array.from(edges), triangles: new Uint32Array() } : null,
    );
  }

  /** @param {HTMLButtonElement} button @param {boolean} usable */
  function allow(button, usable) {
    button.ariaDisabled = String(!usable);
  }

  function showChosen() {
    for (const box of list.querySelectorAll("input")) box.checked = chosen.has(Number(box.value));
    allow(buttons.chosen, chosen.size > 0);
    allow(buttons.connect, chosen.size > 1);
    mark();
  }

  /** @param {BoundaryLoop} loop @param {number} n */
  function entry({ edges, length }, n) {
    const label = document.createElement("label");
    label.className = "choice";
    const box = document.createElement("input");
    box.type = "checkbox";
    box.value = String(n);
    const said = t("{n}: {edges} edges, length {length}", {
      n: n + 1,
      edges,
      length: formatNumber(length, 4),
    });
    label.append(box, ` ${said}`);
    const approach = (/** @type {number | null} */ value) => () => {
      near = value;
      mark();
    };
    label.addEventListener("pointerenter", approach(n));
    label.addEventListener("pointerleave", approach(null));
    box.addEventListener("focus", approach(n));
    box.addEventListener("blur", approach(null));
    return label;
  }

  async function survey() {
    const asked = mesh;
    loops = [];
    near = null;
    chosen.clear();
    list.replaceChildren();
    if (!asked || !section.open || section.hidden) return;
    try {
      const found = await controller.loops();
      if (asked !== mesh) return;
      loops = found;
    } catch (error) {
      return controller.report(error);
    }
    setText(
      summary,
      loops.length > LISTED
        ? t("{count} boundary loops, the first {listed} of them listed.", {
            count: loops.length,
            listed: LISTED,
          })
        : say("boundary-loops", { count: loops.length }),
    );
    list.append(...loops.slice(0, LISTED).map(entry));
    showChosen();
  }

  section.addEventListener("toggle", () => {
    if (!section.open) {
      near = null;
      chosen.clear();
      mark();
    } else survey();
  });
  list.addEventListener("change", ({ target }) => {
    const box = /** @type {HTMLInputElement} */ (target);
    if (box.checked) chosen.add(Number(box.value));
    else chosen.delete(Number(box.value));
    showChosen();
  });
  surface.addEventListener("click", (event) => {
    if (!section.open || section.hidden || loops.length === 0) return;
    const ends = Uint32Array.from(loops.flatMap(edgesOf));
    const found = nearestEdge(event, ends);
    if (found === null) return;
    let [n, before] = [0, 0];
    while (found >= before + loops[n].vertices.length) {
      before += loops[n].vertices.length;
      n += 1;
    }
    if (!chosen.delete(n)) chosen.add(n);
    showChosen();
  });

  /** @param {Partial<import("../generated/types.js").FillOptions>} wanted */
  function fill(wanted) {
    if (!most.reportValidity()) return;
    controller.fill({ ...wanted, maxVertices: most.valueAsNumber });
  }
  buttons.all.addEventListener("click", () => fill({ loops: "all" }));
  buttons.chosen.addEventListener("click", () => {
    if (chosen.size > 0) fill({ loops: [...chosen].sort((a, b) => a - b) });
  });
  buttons.connect.addEventListener("click", () => {
    if (chosen.size > 1) fill({ loops: [...chosen].sort((a, b) => a - b), connect: true });
  });

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.mesh === mesh) return;
      mesh = state.mesh;
      section.hidden = !mesh || mesh.info.boundaryLoops === 0;
      survey();
    },
  };
}
