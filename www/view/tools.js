// @ts-check
// Tools are modes: while one is chosen, clicks and drags on the surface are its own, and a bar
// says what is done. The surface changes only when that is asked for.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { formatNumber } from "../number.js";
import { grown, painted } from "../selection.js";
import { say } from "../words.js";
import { button, idOf, into, keycap } from "./parts.js";

/** @import { LoopInfo, InversionReport } from "../generated/types.js" */
/** @import { Page } from "../actions.js" */

/** A click that moved farther than this, in CSS pixels, was a drag. */
const STILL = 5;
/** How far the centre of an inversion is at first, in diagonals of the box: 1.2 radii and more. */
const FIRST = 0.75;
/** A press of an arrow key, in CSS pixels; with Shift four of them. */
const STEP = 6;
/** What the centre keeps from the edge of the picture to be in reach, in CSS pixels. */
const MARGIN = 28;

/** Middle and diagonal of the box about the surface. @param {Float32Array} positions */
export function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 1) {
    low[i % 3] = Math.min(low[i % 3], positions[i]);
    high[i % 3] = Math.max(high[i % 3], positions[i]);
  }
  const size = Math.hypot(...high.map((value, axis) => value - low[axis]));
  return { middle: high.map((value, axis) => (value + low[axis]) / 2), size };
}

/** The vertex nearest to a point. @param {Float32Array} positions @param {number[]} point */
export function nearestVertex(positions, [x, y, z]) {
  let [best, nearest] = [Infinity, 0];
  for (let v = 0; v < positions.length / 3; v += 1) {
    const square =
      (positions[3 * v] - x) ** 2 +
      (positions[3 * v + 1] - y) ** 2 +
      (positions[3 * v + 2] - z) ** 2;
    if (square < best) [best, nearest] = [square, v];
  }
  return nearest;
}

/** @param {readonly number[]} vertices  of a loop, in order @returns {number[]} two ends an edge */
const edgesOf = (vertices) => vertices.flatMap((v, n) => [v, vertices[(n + 1) % vertices.length]]);

/**
 * A number of vertices, or what is usual.
 * @param {string} label @param {{ value: number | null }} to @param {number} least @param {string} usual
 */
const atMost = (label, to, least, usual) =>
  html`<label class="inline">${label} <input class="short" type="number" min=${least} step="1" placeholder=${usual}
    @change=${(/** @type {any} */ { target }) => into(to)(target.value === "" ? null : target.valueAsNumber)} /></label>`;

/** @param {Page} page */
export function createTools(page) {
  const { stage } = page;
  const { canvas } = stage;
  const viewer = () => stage.first.viewer;
  const positions = () =>
    page.lead.clip.surface(page.lead.u)?.positions ??
    page.get().mesh?.positions ??
    new Float32Array();

  // Paint.
  /** @type {Uint8Array} 1 where held */
  let held = new Uint8Array();
  const frees = signal(true);
  const radius = signal(24);
  /** Whether the first stroke begins a region: until then all may move. */
  let isUntouched = true;
  const free = signal(0);
  let isPainting = false;

  function count() {
    free.value = held.reduce((sum, one) => sum + (one === 0 ? 1 : 0), 0);
    stage.brush(held);
  }
  function takeHeld() {
    const { configured, options, mesh } = page.get();
    held = Uint8Array.from(
      configured?.heldVertices ?? new Uint8Array((mesh?.positions.length ?? 0) / 3),
    );
    isUntouched = !options.free && !options.fixed;
    count();
  }
  /** @param {PointerEvent} event */
  function stroke(event) {
    const hit = viewer()?.pick(event);
    if (!hit) return;
    const [x, y, z, pixel] = hit;
    if (isUntouched && frees.peek()) held = new Uint8Array(held.length).fill(1);
    else held = held.slice();
    isUntouched = false;
    painted(held, positions(), [x, y, z], radius.peek() * pixel, frees.peek() ? 0 : 1);
    count();
  }
  /** @param {0 | 1} value  what spreads by a ring */
  function spread(value) {
    const { mesh } = page.get();
    if (!mesh) return;
    held = grown(held, mesh.triangles, value);
    isUntouched = false;
    count();
  }
  function holdBoundary() {
    held = held.slice();
    for (const v of page.get().mesh?.boundaryEdges ?? []) held[v] = 1;
    isUntouched = false;
    count();
  }
  /** @param {boolean} clears */
  async function applyPaint(clears) {
    const list = [...held.keys()].filter((v) => held[v] === 0);
    await page.edit.select(clears || list.length === held.length ? null : list);
    page.edit.mode(null);
  }

  // Fill.
  /** @type {import("@preact/signals-core").Signal<readonly LoopInfo[]>} */
  const loops = signal([]);
  /** @type {import("@preact/signals-core").Signal<readonly number[]>} */
  const chosen = signal([]);
  const most = signal(/** @type {number | null} */ (null));
  function showChosen() {
    const edges = chosen.peek().flatMap((n) => edgesOf(loops.peek()[n].vertices));
    page.edit.mark({ edges: Uint32Array.from(edges), triangles: new Uint32Array() });
  }
  /** @param {number} n */
  function turnLoop(n) {
    chosen.value = chosen.peek().includes(n)
      ? chosen.peek().filter((one) => one !== n)
      : [...chosen.peek(), n].sort((a, b) => a - b);
    showChosen();
  }
  /** @param {MouseEvent} event */
  function clickLoop(event) {
    const all = loops.peek().map(({ vertices }) => edgesOf(vertices));
    const found = viewer()?.nearestEdge(event, Uint32Array.from(all.flat()));
    if (found === null || found === undefined) return;
    let before = 0;
    const n = all.findIndex((edges) => {
      before += edges.length / 2;
      return found < before;
    });
    if (n >= 0) turnLoop(n);
  }
  /** @param {import("../generated/types.js").Loops} which @param {boolean} [connect] */
  const fill = (which, connect = false) =>
    page.edit.fill({ loops: which, connect, maxVertices: most.peek() });

  // Invert.
  const centre = signal([0, 0, FIRST]);
  /** @type {import("@preact/signals-core").Signal<string>} */
  const refusal = signal("");
  let box = { middle: [0, 0, 0], size: 1 };
  let isAsked = false;
  let isStale = false;
  const point = () => centre.peek().map((value, axis) => box.middle[axis] + box.size * value);
  /** @param {{ x: number, y: number }} at  the nearest place in reach */
  const within = ({ x, y }) => ({
    x: Math.min(Math.max(x, MARGIN), canvas.clientWidth - MARGIN),
    y: Math.min(Math.max(y, MARGIN), canvas.clientHeight - MARGIN),
  });
  /** Where it is at first: to the right of the surface as it is seen, or nearer to the eye where there is no room. */
  function firstCentre() {
    const middle = viewer()?.project(box.middle);
    const right = middle && viewer()?.unproject({ ...middle, x: middle.x + 1 });
    if (!middle || !right) return [0, 0, FIRST];
    const pixel = Math.hypot(...right.map((value, axis) => value - box.middle[axis])) / box.size;
    const at = within({ x: middle.x + FIRST / pixel, y: middle.y + (0.3 * FIRST) / pixel });
    const across = pixel * Math.hypot(at.x - middle.x, at.y - middle.y);
    const nearer = box.size * Math.sqrt(Math.max(FIRST ** 2 - across ** 2, 0));
    const found = viewer()?.unproject({ ...at, depth: Math.max(middle.depth - nearer, nearer) });
    return found
      ? found.map((value, axis) => (value - box.middle[axis]) / box.size)
      : [0, 0, FIRST];
  }
  async function preview() {
    isStale = true;
    if (isAsked) return;
    isAsked = true;
    while (isStale && page.get().mode === "invert") {
      isStale = false;
      try {
        await page.edit.preview(centre.peek());
        refusal.value = "";
      } catch (error) {
        const fault = /** @type {any} */ (error);
        refusal.value = [fault?.message, fault?.hint].filter(Boolean).join(" ");
      }
    }
    isAsked = false;
  }
  /** @param {number[] | null | undefined} to  a point of space */
  function move(to) {
    if (!to) return;
    centre.value = to.map((value, axis) => (value - box.middle[axis]) / box.size);
    preview();
  }

  /** A mode begins. @param {import("../store.js").Mode | null} mode */
  async function begin(mode) {
    viewer()?.rest(mode === "paint");
    canvas.dataset.mode = mode ?? "";
    if (mode === "paint") takeHeld();
    else stage.brush(null);
    if (mode === "fill") {
      chosen.value = [];
      loops.value = await page.edit.loops().catch((error) => {
        page.report(error);
        return [];
      });
    }
    if (mode === "invert") {
      box = boxOf(positions());
      centre.value = firstCentre();
      preview();
    }
  }
  /** @type {import("../store.js").Mode | null} */
  let mode = null;
  page.state.subscribe((s) => {
    if (s.mode === mode) return;
    mode = s.mode;
    begin(mode);
  });

  /** A click on the surface that was none of a tool's. @type {Set<(event: MouseEvent) => unknown>} */
  const clicks = new Set();
  let pressed = { x: 0, y: 0 };
  canvas.addEventListener("pointerdown", (event) => {
    pressed = { x: event.clientX, y: event.clientY };
    if (mode !== "paint" || !event.isPrimary || event.button !== 0) return;
    isPainting = true;
    stroke(event);
  });
  canvas.addEventListener("pointermove", (event) => isPainting && event.isPrimary && stroke(event));
  for (const kind of ["pointerup", "pointercancel"])
    canvas.addEventListener(kind, () => {
      isPainting = false;
    });
  canvas.addEventListener("click", (event) => {
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > STILL) return;
    if (mode === "fill") clickLoop(event);
    else if (mode === "pick") {
      const hit = viewer()?.pick(event);
      if (hit) page.edit.inspect({ probe: nearestVertex(positions(), hit) });
    } else for (const listener of clicks) listener(event);
  });

  /** @type {{ x: number, y: number, depth: number } | null} where the handle was taken */
  let grip = null;
  /** The centre of the inversion on the picture. */
  function handle() {
    stageTick.value;
    const { mode: now } = page.state.value;
    centre.value;
    const projected = now === "invert" ? viewer()?.project(point()) : null;
    if (!projected) return nothing;
    const seen = { ...projected, ...within(projected) };
    /** @param {KeyboardEvent} event */
    function key(event) {
      const step = event.shiftKey ? 4 * STEP : STEP;
      /** @type {Record<string, [number, number, number]>} */
      const moves = {
        ...{ ArrowLeft: [-step, 0, 1], ArrowRight: [step, 0, 1], ArrowUp: [0, -step, 1] },
        ...{ ArrowDown: [0, step, 1], PageUp: [0, 0, 1.02], PageDown: [0, 0, 1 / 1.02] },
      };
      const by = moves[event.key];
      const at = viewer()?.project(point());
      if (!by || !at) return;
      event.preventDefault();
      move(viewer()?.unproject({ x: at.x + by[0], y: at.y + by[1], depth: at.depth * by[2] }));
    }
    return html`<button type="button" class="handle" aria-label=${say("inversion-centre")} .style=${`translate:${seen.x}px ${seen.y}px`}
      @keydown=${key}
      @pointerdown=${(/** @type {PointerEvent} */ event) => {
        grip = { x: event.clientX - seen.x, y: event.clientY - seen.y, depth: seen.depth };
        /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
      }}
      @pointermove=${(/** @type {PointerEvent} */ event) => grip && move(viewer()?.unproject({ x: event.clientX - grip.x, y: event.clientY - grip.y, depth: grip.depth }))}
      @lostpointercapture=${() => {
        grip = null;
      }}></button>`;
  }
  const stageTick = signal(0);
  stage.onDrawn(() => {
    if (mode === "invert")
      queueMicrotask(() => {
        stageTick.value += 1;
      });
  });

  /** Vertices that remeshing aims at; null: as many as there are. @type {import("@preact/signals-core").Signal<number | null>} */
  const budget = signal(null);
  const small = { kind: "small" };
  const bars = {
    paint: () => html`
      ${[true, false].map((value) =>
        button(say(value ? "paint-free" : "paint-hold"), () => into(frees)(value), {
          kind: "small",
          pressed: frees.value === value,
        }),
      )}
      <label class="inline">${say("brush-size")} <input type="range" min="6" max="80" .value=${String(radius.value)}
        @input=${(/** @type {any} */ { target }) => into(radius)(target.valueAsNumber)} /></label>
      ${button(say("grow"), () => spread(0), small)}${button(say("shrink"), () => spread(1), small)}
      ${(page.state.value.mesh?.info.boundaryLoops ?? 0) > 0 ? button(say("hold-boundary"), holdBoundary, small) : nothing}
      <span class="hint">${say("region-count", { free: free.value, all: held.length })}</span>
      ${button(say("clear-paint"), () => applyPaint(true), small)}
      ${button(say("apply"), () => applyPaint(false), { kind: "small primary" })}`,
    fill: () => {
      const count = chosen.value.length;
      const all = loops.value.length;
      const holes = loops.value.filter(({ small: isHole }) => isHole).length;
      // The outer rim of a sheet is no hole.
      const some = holes > 0 && holes < all;
      return html`<span class="hint">${say("loops-chosen", { count, all })}</span>
        ${
          loops.value.length <= 12
            ? loops.value.map((loop, n) =>
                button(String(n), () => turnLoop(n), {
                  kind: "small",
                  pressed: chosen.value.includes(n),
                  title: say("boundary-loop", { edges: loop.edges, length: loop.length }),
                }),
              )
            : nothing
        }
        ${count > 0 ? button(say("fill-chosen", { count }), () => fill([...chosen.value]), { kind: "small primary" }) : nothing}
        ${count > 1 ? button(say("bridge"), () => fill([...chosen.value], true), small) : nothing}
        ${some ? button(say("fill-small", { count: holes }), () => fill("small"), { kind: count > 0 ? "small" : "small primary" }) : nothing}
        ${button(say("fill-all", { count: all }), () => fill("all"), { kind: count > 0 || some ? "small" : "small primary" })}
        ${atMost(say("most-vertices"), most, 1, say("automatic"))}`;
    },
    remesh: () => {
      const wanted = { vertices: budget.value };
      return html`
      ${atMost(say("remesh-number"), budget, 4, String(page.state.value.mesh?.info.vertices ?? ""))}
      ${button(say("remesh-adaptive"), () => page.edit.remesh({ kind: "adaptive", ...wanted }), { kind: "small primary" })}
      ${button(say("remesh-isotropic"), () => page.edit.remesh({ kind: "isotropic", ...wanted }), small)}`;
    },
    subdivide: () => html`
      ${button(say("subdivide-loop"), () => page.edit.subdivide("loop"), { kind: "small primary" })}
      ${button(say("subdivide-linear"), () => page.edit.subdivide("linear"), small)}`,
    invert: () => {
      const { preview: shown } = page.state.value;
      return html`
        ${["x", "y", "z"].map(
          (
            axis,
            n,
          ) => html`<label class="inline" for=${idOf(`centre-${axis}`)}>${axis} <input id=${idOf(`centre-${axis}`)} class="short" type="number" step="any"
            .value=${String(Number(centre.value[n].toFixed(4)))} @change=${(
              /** @type {any} */ { target },
            ) => {
              if (!target.reportValidity()) return;
              centre.value = centre.value.map((value, k) =>
                k === n ? target.valueAsNumber : value,
              );
              preview();
            }} /></label>`,
        )}
        <span class="hint ${refusal.value ? "danger" : ""}" role="note">${refusal.value || (shown ? inversion(shown.report) : "")}</span>
        ${button(say("apply"), () => page.edit.invert(centre.value), { kind: "small primary", disabled: refusal.value !== "" || !shown })}`;
    },
    pick: () => html`<span class="hint">${say("pick-hint")}</span>`,
    edge: () => nothing,
  };

  return {
    handle,
    clicks,
    /** What a tool says and offers, above the surface. */
    bar() {
      const { mode: now } = page.state.value;
      if (!now) return nothing;
      return html`<div class="modebar" role="toolbar" aria-label=${say(`tool-${now}`)}><b>${say(`tool-${now}`)}</b>${bars[now]()}
        <button type="button" class="button small quiet" @click=${() => page.edit.mode(null)}>${say("done")} ${keycap("Esc")}</button></div>`;
    },
  };
}

/** What an inversion does to the numbers. @param {InversionReport} report */
function inversion({ before, after }) {
  const change = after.circle - before.circle;
  return say("inversion-numbers", {
    before: formatNumber(before.circle, 6),
    after: formatNumber(after.circle, 6),
    change: change === 0 ? "0" : change.toExponential(1),
    bending: formatNumber(before.willmore, 5),
    bendingNow: formatNumber(after.willmore, 5),
  });
}
