// @ts-check
// Which vertices move: painted on the surface, grown and shrunk ring by ring.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { isRead } from "../options.js";
import { byId, setText } from "./element.js";
import { grown, painted } from "./selection.js";

/**
 * What the brush needs of the picture.
 * @typedef {object} Canvas
 * @property {(event: MouseEvent) => number[] | null} pick  point, and size of a pixel there
 * @property {(held: Uint8Array) => void} showHeld
 * @property {(on: boolean) => void} brush  whether a drag paints and does not turn
 */

/** @param {Controller} controller @param {Canvas} canvas */
export function createRegion(controller, canvas) {
  const section = byId("region", HTMLDetailsElement);
  const surface = byId("surface", HTMLCanvasElement);
  const brush = byId("brush", HTMLButtonElement);
  const mode = byId("brush-mode", HTMLSelectElement);
  const radius = byId("brush-radius", HTMLInputElement);
  const holdBoundary = byId("hold-boundary", HTMLButtonElement);
  const count = byId("region-count", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {Uint8Array} 1 where held */
  let held = new Uint8Array();
  /** @type {PageState["configured"]} */
  let configured = null;
  let painting = false;
  /** Whether the first stroke begins a region: until then all may move. */
  let untouched = true;

  const isOn = () => brush.ariaPressed === "true";

  /** @param {boolean} on */
  function take(on) {
    brush.ariaPressed = String(on);
    canvas.brush(on);
    surface.classList.toggle("brush", on);
  }

  function show() {
    const free = held.reduce((sum, one) => sum + (one === 0 ? 1 : 0), 0);
    setText(count, t("{free} of {all} vertices move.", { free, all: held.length }));
    canvas.showHeld(held);
  }

  /** Tells the flow. */
  function commit() {
    const free = [];
    for (const [v, one] of held.entries()) if (one === 0) free.push(v);
    controller.select(free.length === held.length ? null : free);
  }

  /** @param {PointerEvent} event */
  function stroke(event) {
    const hit = canvas.pick(event);
    const positions = state?.frame?.positions;
    if (!hit || !positions) return;
    const [x, y, z, pixel] = hit;
    const frees = mode.value === "free";
    if (untouched && frees) held = new Uint8Array(held.length).fill(1);
    untouched = false;
    painted(held, positions, [x, y, z], radius.valueAsNumber * pixel, frees ? 0 : 1);
    show();
  }

  surface.addEventListener("pointerdown", (event) => {
    if (!isOn() || !event.isPrimary || event.button !== 0) return;
    painting = true;
    stroke(event);
  });
  surface.addEventListener("pointermove", (event) => {
    if (painting && event.isPrimary) stroke(event);
  });
  const lift = () => {
    if (!painting) return;
    painting = false;
    commit();
  };
  surface.addEventListener("pointerup", lift);
  surface.addEventListener("pointercancel", lift);

  brush.addEventListener("click", () => take(!isOn()));
  section.addEventListener("toggle", () => section.open || take(false));
  /** @param {0 | 1} value  what spreads */
  function spread(value) {
    if (!state?.mesh) return;
    held = grown(held, state.mesh.triangles, value);
    untouched = false;
    show();
    commit();
  }
  byId("grow", HTMLButtonElement).addEventListener("click", () => spread(0));
  byId("shrink", HTMLButtonElement).addEventListener("click", () => spread(1));
  holdBoundary.addEventListener("click", () => {
    if (!state?.mesh) return;
    for (const v of state.mesh.boundaryEdges) held[v] = 1;
    untouched = false;
    show();
    commit();
  });
  byId("free-all", HTMLButtonElement).addEventListener("click", () => {
    held = new Uint8Array(held.length);
    untouched = true;
    show();
    controller.select(null);
  });

  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      state = now;
      section.hidden = !isRead("free", now.options) || !now.mesh;
      if (section.hidden && isOn()) take(false);
      holdBoundary.hidden = !now.mesh || now.mesh.boundaryEdges.length === 0;
      if (painting || now.configured === configured) return;
      configured = now.configured;
      held = Uint8Array.from(configured?.heldVertices ?? []);
      untouched = !now.options.free && !now.options.fixed;
      const free = held.reduce((sum, one) => sum + (one === 0 ? 1 : 0), 0);
      setText(count, t("{free} of {all} vertices move.", { free, all: held.length }));
    },
  };
}
