// Tools are modes: while one is chosen, clicks and drags on the surface are its own, and a bar
// says what is done. The surface changes only when that is asked for.

import "../style/tools.css";
import { computed, signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { formatNumber } from "../number.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, into, keycap, shortNumber, slider, toggle } from "./parts.js";

/** @import { LoopInfo, Loops, InversionReport } from "../generated/types.js" */
/** @import { Mode } from "../store.js" */

/** A click that moved farther than this, in CSS pixels, was a drag. */
const STILL = 5;
/** How far the centre of an inversion is at first, in diagonals of the box: 1.2 radii and more. */
const FIRST = 0.75;
/** A press of an arrow key, in CSS pixels; with Shift four of them. */
const STEP = 6;
/** What the centre keeps from the edge of the picture to be in reach, in CSS pixels. */
const MARGIN = 28;

const { canvas } = page.stage;
const viewer = () => page.stage.first.viewer;

// Paint.
/** 1 where held. @type {Uint8Array} */
let held = new Uint8Array();
const frees = signal(true);
/** Whether there is something to apply. */
const isPainted = signal(false);
const radius = signal(24);
const free = signal(0);

/** @param {Uint8Array} vertices */
function hold(vertices) {
  held = vertices;
  isPainted.value = true;
  free.value = held.reduce((sum, one) => sum + (one === 0 ? 1 : 0), 0);
  page.stage.brush(held);
}
function takeHeld() {
  const { configured, mesh } = page.get();
  const count = (mesh?.positions.length ?? 0) / 3;
  const known = configured?.heldVertices ?? new Uint8Array(count);
  hold(Uint8Array.from(known));
  isPainted.value = false;
}
/** Paints with the button down that was pressed here: gestures hold the pointer then. @param {PointerEvent} event */
function stroke(event) {
  const isDown = event.buttons & 1 && canvas.hasPointerCapture(event.pointerId);
  const { mode, options } = page.get();
  if (mode !== "paint" || !event.isPrimary || !isDown) return;
  // The first stroke begins a region: until then all may move.
  const isFirst = !isPainted.peek() && !options.free && !options.fixed;
  const set = isFirst && frees.peek() ? new Uint8Array(held.length).fill(1) : held;
  const next = viewer()?.painted(event, set, radius.peek(), frees.peek() ? 0 : 1);
  if (next) hold(next);
}
/** @param {0 | 1} value  what spreads by a ring */
const spread = (value) => hold(viewer()?.grown(held, value) ?? held);
function holdBoundary() {
  const next = held.slice();
  for (const v of page.get().mesh?.boundaryEdges ?? []) next[v] = 1;
  hold(next);
}
/** @param {boolean} clears */
async function applyPaint(clears) {
  const list = [...held.keys()].filter((v) => held[v] === 0);
  await page.edit.select(clears || list.length === held.length ? null : list);
  page.edit.mode(null);
}

// Fill.
const loops = signal(/** @type {readonly LoopInfo[]} */ ([]));
const chosen = signal(/** @type {readonly number[]} */ ([]));
const most = signal(/** @type {number | null} */ (null));

/** Two ends an edge. @param {LoopInfo} loop @returns {number[]} */
const edgesOf = ({ vertices: all }) => all.flatMap((v, n) => [v, all[(n + 1) % all.length]]);

/** @param {number} n */
function turnLoop(n) {
  const others = chosen.peek().filter((one) => one !== n);
  const isOn = others.length < chosen.peek().length;
  chosen.value = isOn ? others : [...others, n].sort((a, b) => a - b);
  const edges = Uint32Array.from(chosen.peek().flatMap((one) => edgesOf(loops.peek()[one])));
  page.patch({ marks: { edges, triangles: new Uint32Array() } });
}
/** @param {MouseEvent} event */
function clickLoop(event) {
  const all = loops.peek();
  const found = viewer()?.nearestEdge(event, Uint32Array.from(all.flatMap(edgesOf)));
  // A loop has as many edges as vertices.
  const owners = all.flatMap(({ vertices }, n) => vertices.map(() => n));
  if (found != null) turnLoop(owners[found]);
}
/** @param {Loops} which @param {boolean} [connect] */
const fill = (which, connect = false) =>
  page.edit.fill({ loops: which, connect, maxVertices: most.peek() });

// Invert.
const centre = signal([0, 0, FIRST]);
const refusal = signal("");
let box = { middle: [0, 0, 0], size: 1 };
let isAsked = false;
const point = () => centre.peek().map((value, axis) => box.middle[axis] + box.size * value);
/** A point of space, from the middle of the box in diagonals of it. @param {number[]} to */
const inBox = (to) => to.map((value, axis) => (value - box.middle[axis]) / box.size);
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
  const pixel = Math.hypot(...inBox(right));
  const at = within({ x: middle.x + FIRST / pixel, y: middle.y + (0.3 * FIRST) / pixel });
  const across = pixel * Math.hypot(at.x - middle.x, at.y - middle.y);
  const nearer = box.size * Math.sqrt(Math.max(FIRST ** 2 - across ** 2, 0));
  const found = viewer()?.unproject({ ...at, depth: Math.max(middle.depth - nearer, nearer) });
  return found ? inBox(found) : [0, 0, FIRST];
}
async function preview() {
  if (isAsked) return;
  isAsked = true;
  let shown;
  while (shown !== centre.peek() && page.get().mode === "invert") {
    shown = centre.peek();
    try {
      await page.edit.preview(shown);
      refusal.value = "";
    } catch (error) {
      const { message, hint } = /** @type {any} */ (error ?? {});
      refusal.value = [message, hint].filter(Boolean).join(" ");
    }
  }
  isAsked = false;
}
/** @param {number[] | null | undefined} to  a point of space */
function move(to) {
  if (!to) return;
  centre.value = inBox(to);
  preview();
}

/** A mode begins. @param {Mode | null} mode */
async function begin(mode) {
  viewer()?.rest(mode === "paint");
  canvas.dataset.mode = mode ?? "";
  if (mode === "paint") takeHeld();
  else page.stage.brush(null);
  if (mode === "fill") {
    chosen.value = [];
    loops.value = (await page.solver.ask("loops").catch(page.report)) ?? [];
  }
  if (mode === "invert") {
    box = viewer()?.box() ?? box;
    centre.value = firstCentre();
    preview();
  }
}

// What a pointer does on the surface while a mode lasts.
computed(() => page.state.value.mode).subscribe(begin);
let pressed = { x: 0, y: 0 };
canvas.addEventListener("pointerdown", (event) => {
  pressed = { x: event.clientX, y: event.clientY };
  stroke(event);
});
canvas.addEventListener("pointermove", stroke);
canvas.addEventListener("click", (event) => {
  const { mode } = page.get();
  if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > STILL) return;
  if (mode === "fill") clickLoop(event);
  const probe = mode === "pick" ? viewer()?.pick(event) : null;
  if (probe != null) page.edit.inspect({ probe });
});

/** Where the handle was taken. @type {{ x: number, y: number, depth: number } | null} */
let grip = null;

/** Steps of keys: to the right, down, and by how much deeper. @type {Record<string, [number, number, number]>} */
const moves = {
  ...{ ArrowLeft: [-STEP, 0, 1], ArrowRight: [STEP, 0, 1], ArrowUp: [0, -STEP, 1] },
  ...{ ArrowDown: [0, STEP, 1], PageUp: [0, 0, 1.02], PageDown: [0, 0, 1 / 1.02] },
};
/** @param {KeyboardEvent} event */
function key(event) {
  const by = moves[event.key];
  const at = viewer()?.project(point());
  if (!by || !at) return;
  event.preventDefault();
  const times = event.shiftKey ? 4 : 1;
  const [x, y] = [at.x + times * by[0], at.y + times * by[1]];
  move(viewer()?.unproject({ x, y, depth: at.depth * by[2] }));
}

/** The centre of the inversion on the picture. */
function inversionHandle() {
  page.stage.pictures.value;
  centre.value;
  const projected = viewer()?.project(point());
  if (!projected) return nothing;
  const seen = { ...projected, ...within(projected) };
  const take = (/** @type {PointerEvent} */ event) => {
    grip = { x: event.clientX - seen.x, y: event.clientY - seen.y, depth: seen.depth };
    /** @type {Element} */ (event.currentTarget).setPointerCapture(event.pointerId);
  };
  const drag = (/** @type {PointerEvent} */ { clientX, clientY }) =>
    grip && move(viewer()?.unproject({ ...grip, x: clientX - grip.x, y: clientY - grip.y }));
  const drop = () => {
    grip = null;
  };
  return html`<button type="button" class="handle" aria-label=${say("inversion-centre")} .style=${`translate:${seen.x}px ${seen.y}px`}
    @keydown=${key} @pointerdown=${take} @pointermove=${drag} @lostpointercapture=${drop}></button>`;
}

/** Vertices that remeshing aims at; null: as many as there are. */
const budget = signal(/** @type {number | null} */ (null));
/** Whether edges of the shape stay. */
const keepsEdges = signal(true);

/** @param {() => unknown} act @param {boolean} isReady  whether there is something to apply */
const apply = (act, isReady) =>
  button(say("apply"), act, isReady ? "small primary" : "small", { disabled: !isReady });

/** @type {Record<Mode, () => unknown>} */
const bars = {
  paint: () => html`
    ${button(say("paint-free"), () => into(frees)(true), "small", { pressed: frees.value })}
    ${button(say("paint-hold"), () => into(frees)(false), "small", { pressed: !frees.value })}
    ${slider(say("brush-size"), radius.value, 6, 80, into(radius))}
    ${button(say("grow"), () => spread(0), "small")}${button(say("shrink"), () => spread(1), "small")}
    ${(page.state.value.mesh?.info.boundaryLoops ?? 0) > 0 ? button(say("hold-boundary"), holdBoundary, "small") : nothing}
    <span class="hint">${say("paint-count", { free: free.value, all: held.length })}</span>
    ${button(say("clear-paint"), () => applyPaint(true), "small")}
    ${apply(() => applyPaint(false), isPainted.value)}`,
  fill() {
    const count = chosen.value.length;
    const all = loops.value.length;
    const holes = loops.value.filter(({ small }) => small).length;
    // The outer rim of a sheet is no hole.
    const some = holes > 0 && holes < all;
    const each = loops.value.map(({ edges, length }, n) => {
      const title = say("boundary-loop", { edges, length });
      const pressed = chosen.value.includes(n);
      return button(String(n + 1), () => turnLoop(n), "small", { pressed, title });
    });
    return html`<span class="hint">${say("loops-chosen", { count, all })}</span>
      ${all <= 12 ? each : nothing}
      ${count > 0 ? button(say("fill-chosen", { count }), () => fill([...chosen.value]), "small primary") : nothing}
      ${count > 1 ? button(say("bridge"), () => fill([...chosen.value], true), "small") : nothing}
      ${some ? button(say("fill-small", { count: holes }), () => fill("small"), "small") : nothing}
      ${count < all ? button(say("fill-all", { count: all }), () => fill("all"), "small") : nothing}
      ${shortNumber(say("most-vertices"), most.value, into(most), { min: 1, step: 1, placeholder: say("automatic") })}`;
  },
  remesh() {
    const to = (/** @type {"adaptive" | "isotropic"} */ kind) => () =>
      page.edit.remesh({
        kind,
        vertices: budget.value,
        creases: keepsEdges.value ? "keep" : "smooth",
      });
    const placeholder = page.state.value.mesh?.info.vertices;
    return html`${shortNumber(say("remesh-number"), budget.value, into(budget), { min: 4, step: 1, placeholder })}
      ${toggle(say("remesh-edges"), keepsEdges.value, into(keepsEdges), say("remesh-edges.about"))}
      ${button(say("remesh-adaptive"), to("adaptive"), "small primary")}
      ${button(say("remesh-isotropic"), to("isotropic"), "small")}`;
  },
  subdivide: () => html`
    ${button(say("subdivide-loop"), () => page.edit.subdivide("loop"), "small primary")}
    ${button(say("subdivide-linear"), () => page.edit.subdivide("linear"), "small")}`,
  invert() {
    const { preview: shown } = page.state.value;
    /** @param {number} n @returns {(typed: number | null) => void} */
    const along = (n) => (typed) => {
      centre.value = centre.value.map((value, axis) => (axis === n ? (typed ?? value) : value));
      preview();
    };
    return html`${["x", "y", "z"].map((axis, n) => shortNumber(axis, Number(centre.value[n].toFixed(4)), along(n)))}
      <span class="hint ${refusal.value ? "danger" : ""}" role="note">${refusal.value || (shown ? inversion(shown.report) : "")}</span>
      ${apply(() => page.edit.invert(centre.value), refusal.value === "" && shown !== null)}`;
  },
  pick: () => html`<span class="hint">${say("pick-hint")}</span>`,
};

/** What an inversion does to the numbers. @param {InversionReport} report */
function inversion({ before, after }) {
  return say("inversion-numbers", {
    before: formatNumber(before.circle, 6),
    after: formatNumber(after.circle, 6),
    bending: formatNumber(before.willmore, 5),
    bendingNow: formatNumber(after.willmore, 5),
  });
}

/** What a tool says and offers, above the surface. */
export function tools() {
  const { mode } = page.state.value;
  if (!mode) return nothing;
  const name = say(`tool-${mode}`);
  return html`<div class="modebar" role="toolbar" aria-label=${name}><b>${name}</b>${bars[mode]()}
    <button type="button" class="button small quiet" @click=${() => page.edit.mode(null)}>${say("done")} ${keycap("Esc")}</button></div>
    ${mode === "invert" ? inversionHandle() : nothing}`;
}
