// @ts-check
// The surfaces on the stage: one picture a pane, all under one camera. Between two true steps
// the picture is blended.

import { effect, signal } from "@preact/signals-core";
import { distances, letter, sayChange } from "../comparison.js";
import { formatNumber } from "../number.js";
import { choiceLabel, flowLabel, rowOf } from "../options.js";
import { overlayOf } from "../overlay.js";
import { rangeOf, roundedUp } from "../range.js";
import { rim } from "../selection.js";
import { surfaceLabel, symbol } from "../status.js";
import { isDark } from "../store.js";
import { say } from "../words.js";

/** @import { Page } from "../actions.js" */
/** @import { Field, S } from "../store.js" */
/** @import { Drawable } from "../viewer.js" */
/** @import { Fault } from "../words.js" */

/** @typedef {Awaited<ReturnType<typeof import("../viewer.js").createViewer>>} Viewer */

/**
 * What a pane shows.
 * @typedef {object} Shown
 * @property {string} key
 * @property {Drawable} drawable    connectivity
 * @property {Float32Array} positions
 * @property {unknown} place        changes with what is in the positions
 * @property {Field | null} field
 * @property {Uint32Array} marked
 * @property {Uint32Array} highlight
 * @property {Uint8Array | null} held
 * @property {string} title
 * @property {string} note
 */

const none = new Uint32Array();
/** Width of an edge in CSS pixels, on a desk and from the last row. */
const LINE = { near: 1.25, far: 2.5 };

class PaneView {
  /** @type {Viewer | null} */
  viewer = null;
  #isGone = false;
  /** @type {Partial<Shown> & { mesh?: unknown, camera?: unknown, style?: unknown, overlay?: unknown }} what the viewer has */
  #has = {};

  /** @param {HTMLElement} figure @param {HTMLCanvasElement} canvas */
  constructor(figure, canvas) {
    this.figure = figure;
    this.canvas = canvas;
    this.caption = figure.querySelector("figcaption") ?? document.createElement("figcaption");
    figure.append(this.caption);
  }

  /** @param {import("../viewer.js").ViewerOptions} options */
  async open(options) {
    const { createViewer } = await import("../viewer.js");
    // Laid out first, so that the picture has a size.
    await new Promise(requestAnimationFrame);
    const onCamera = (/** @type {Float32Array} */ camera) => {
      this.#has.camera = camera;
      options.onCamera?.(camera);
    };
    const viewer = await createViewer(this.canvas, { ...options, onCamera });
    if (this.#isGone) viewer.destroy();
    else this.viewer = viewer;
    this.#has = {};
  }

  /** @param {S} s @param {Shown} shown @param {import("../viewer.js").Style} style @returns {void} */
  draw(s, shown, style) {
    const { viewer } = this;
    const has = this.#has;
    if (!viewer || shown.positions.length !== shown.drawable.positions.length) return;
    if (JSON.stringify(style) !== has.style) {
      has.style = JSON.stringify(style);
      viewer.setStyle(style);
    }
    if (s.mesh !== has.mesh || shown.drawable !== has.drawable) {
      if (s.mesh !== has.mesh && !(has.mesh && s.camera)) viewer.setMesh(shown.drawable);
      else viewer.replaceMesh(shown.drawable);
      this.#has = { style: has.style, mesh: s.mesh, drawable: shown.drawable };
      return this.draw(s, shown, style);
    }
    if (
      shown.positions !== has.positions ||
      shown.place !== has.place ||
      shown.field !== has.field
    ) {
      viewer.setFrame(shown.positions, shown.field, shown.marked);
      has.marked = shown.marked;
    }
    if (shown.marked !== has.marked) viewer.setMarked(shown.marked);
    if (shown.highlight !== has.highlight) viewer.setHighlight(shown.highlight);
    if (shown.held !== has.held) viewer.setFixed(shown.held ?? new Uint8Array());
    if (s.camera !== has.camera && s.camera) viewer.setCamera(s.camera);
    Object.assign(has, shown, { camera: s.camera ?? has.camera });
  }

  /** @param {import("../viewer.js").Overlay | null} overlay @param {unknown} of */
  overlay(overlay, of) {
    if (!this.viewer || this.#has.overlay === of) return;
    this.#has.overlay = of;
    this.viewer.setOverlay(overlay);
  }

  close() {
    this.#isGone = true;
    this.viewer?.destroy();
    this.figure.remove();
  }
}

/** Colours over the range that is held. @param {Field | null} field @param {readonly [number, number] | null} range @returns {Field | null} */
export function held(field, range) {
  if (!field || !range) return field;
  const [low, high] = range;
  return field.low === low && field.high === high ? field : { ...field, low, high };
}

/**
 * @param {Page} page
 * @param {HTMLElement} root
 * @param {1 | 4} samples  of the pictures' smoothing
 */
export function createStage(page, root, samples) {
  const own = /** @type {HTMLElement} */ (root.querySelector("figure"));
  const canvas = /** @type {HTMLCanvasElement} */ (root.querySelector("canvas"));
  const first = new PaneView(own, canvas);
  /** @type {Map<string, PaneView>} */
  const others = new Map();
  const renderer = signal("");
  /** @type {import("@preact/signals-core").Signal<Fault | null>} */
  const absence = signal(null);
  /** Of distances between panes, which are no field of the solver's. @type {import("@preact/signals-core").Signal<readonly [number, number] | null>} */
  const range = signal(null);
  /** What blended surfaces are written into, a pane each. @type {Float32Array[]} */
  const scratches = [];
  /** What a brush is about to hold. @type {Uint8Array | null} */
  let brushed = null;
  /** @type {{ set: unknown, found: Uint32Array }} */
  let ring = { set: null, found: none };

  /** @param {S} s @param {Uint8Array | null} set */
  function ringOf(s, set) {
    const isChosen = s.options.free !== null || s.options.fixed !== null || brushed;
    if (!set || !s.mesh || !isChosen) return none;
    if (ring.set !== set) ring = { set, found: rim(set, s.mesh.wireEdges) };
    return ring.found;
  }

  /** @param {import("../player.js").Track} track @param {number} n */
  function pictureOf(track, n) {
    const picture = track.clip.picture(track.u, scratches[n]);
    if (picture?.positions && !("state" in picture)) scratches[n] = picture.positions;
    return picture;
  }

  /** @param {S} s @returns {Shown[]} */
  function panesOf(s) {
    const { mesh, comparison, marks, preview, reading } = s;
    if (!mesh) return [];
    const { lead } = page;
    const picture = pictureOf(lead, 0);
    const set = brushed ?? s.configured?.heldVertices ?? null;
    const chosen = reading?.flips?.[0]?.criterion ?? s.options.flow;
    const panes = picture?.panes ?? [];
    const ownPane = panes.find(({ name }) => name === chosen);
    const state = page.shown();
    const isSide =
      comparison.rivals.length > 0 || comparison.withStart || panes.length > (ownPane ? 1 : 0);
    const note = state
      ? say("pane-note", {
          step: state.step,
          symbol: symbol(s),
          energy: formatNumber(state.energy, 4),
        })
      : "";
    /** @type {Shown[]} */
    const shown = [
      {
        key: "lead",
        drawable: ownPane ?? mesh,
        positions: (preview ?? ownPane ?? picture)?.positions ?? mesh.positions,
        place: preview ?? lead.u,
        field: held((preview ?? ownPane ?? picture)?.field ?? null, s.range),
        marked: marks?.triangles ?? picture?.marked ?? none,
        highlight: marks?.edges ?? ownPane?.highlight ?? ringOf(s, set),
        held: ownPane ? null : set,
        title: isSide
          ? comparison.rivals.length > 0 || comparison.withStart
            ? flowLabel(s.options.flow)
            : paneName(chosen)
          : "",
        note,
      },
    ];
    let n = 0;
    for (const rival of comparison.rivals) {
      n += 1;
      const track = page.rivals.get(rival.id);
      const other = track && pictureOf(track, n);
      const at = track?.clip.points[track.clip.nearest(track.u)]?.state;
      shown.push({
        key: `rival-${rival.id}`,
        drawable: mesh,
        positions: other?.positions ?? mesh.positions,
        place: track?.u,
        field: held(other?.field ?? null, s.range),
        marked: other?.marked ?? none,
        highlight: none,
        held: rival.held,
        title: sayChange(s.options, rival.change),
        note:
          rival.phase === "lost"
            ? rival.reason
            : at
              ? say("pane-note", {
                  step: at.step,
                  symbol: symbol({ options: { ...s.options, ...rival.change } }),
                  energy: formatNumber(at.energy, 4),
                })
              : "",
      });
    }
    if (comparison.withStart) {
      const start = lead.clip.points[0];
      shown.push({
        ...{ key: "then", drawable: mesh, positions: start?.positions ?? mesh.positions, place: 0 },
        ...{
          field: held(start?.field ?? null, s.range),
          marked: none,
          highlight: none,
          held: null,
        },
        ...{ title: say("start"), note: "" },
      });
    }
    for (const pane of panes) {
      if (pane === ownPane) continue;
      shown.push({
        ...{ key: `pane-${pane.name}`, drawable: pane, positions: pane.positions, place: pane },
        ...{
          field: held(pane.field, s.range),
          marked: none,
          highlight: pane.highlight,
          held: null,
        },
        ...{ title: paneName(pane.name), note: paneNote(s, pane) },
      });
    }
    return comparison.difference === null ? shown : byDistance(shown, comparison.difference);
  }

  /** Colours by the distance to one of them. @param {Shown[]} shown @param {number} to */
  function byDistance(shown, to) {
    const base = shown[to]?.positions;
    const values = shown.map(({ positions }) =>
      base && positions.length === base.length ? distances(positions, base) : null,
    );
    let most = 0;
    for (const list of values) if (list) for (const value of list) if (value > most) most = value;
    const high = most > 0 ? roundedUp(most) : 1;
    if (range.peek()?.[1] !== high) range.value = [0, high];
    return shown.map((one, n) => {
      const own = values[n];
      /** @type {any} */
      const field = own && { name: "distance", low: 0, high, signed: false, values: own };
      return { ...one, field };
    });
  }

  /** @type {import("../viewer.js").ViewerOptions} */
  const options = {
    samples,
    onFault: fail,
    onCamera: page.run.look,
    onRenderer: ({ name, reason }) => {
      renderer.value = say("drawn-with", { name, reason });
      root.dataset.renderer = renderer.value;
    },
  };

  /** @param {unknown} error */
  function fail(error) {
    const fault = /** @type {Partial<Fault>} */ (error);
    const { kind = "NoPicture", message = String(error), hint = "" } = fault;
    absence.value = { kind, message, hint, detail: {} };
    first.viewer?.destroy();
    first.viewer = null;
    canvas.hidden = true;
  }

  /** @param {Shown} shown */
  function paneOf({ key }) {
    if (key === "lead") return first;
    const known = others.get(key);
    if (known) return known;
    const figure = document.createElement("figure");
    figure.className = "pane";
    const made = document.createElement("canvas");
    made.role = "img";
    made.tabIndex = 0;
    figure.append(made);
    root.append(figure);
    const pane = new PaneView(figure, made);
    others.set(key, pane);
    pane.open({ ...options, onFault: page.report }).then(draw, page.report);
    return pane;
  }

  let isDue = false;
  /** Draws once before the next picture. */
  function draw() {
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      drawNow();
    });
  }

  function drawNow() {
    const s = page.get();
    const shown = panesOf(s);
    const style = {
      shading: s.view.shading,
      wireframe: s.view.wireframe,
      boundary: s.view.boundary,
      theme: /** @type {"light" | "dark"} */ (isDark(s) ? "dark" : "light"),
      contrast: s.view.contrast || s.presenting,
      lineWidth: s.presenting ? LINE.far : LINE.near,
    };
    const keys = shown.map(({ key }) => key);
    for (const [key, pane] of others) {
      if (keys.includes(key)) continue;
      pane.close();
      others.delete(key);
    }
    root.dataset.count = String(Math.max(shown.length, 1));
    const { shown: which } = s.comparison;
    root.dataset.shown = which === "side" ? "side" : "place";
    shown.forEach((one, n) => {
      const pane = paneOf(one);
      const isHidden = which !== "side" && which !== n && shown.length > 1;
      pane.figure.classList.toggle("away", isHidden);
      pane.figure.style.order = String(n);
      caption(pane.caption, shown.length > 1 ? n : -1, one);
      const what = `${one.title}, ${one.note}`;
      const title = say("surface-pane", { name: letter(n), what });
      if (n > 0 && pane.canvas.ariaLabel !== title) pane.canvas.ariaLabel = title;
      pane.draw(s, one, style);
    });
    const look = (s.preview ?? s.extras)?.look ?? null;
    const isTrue = page.player.motion.peek() === "still";
    first.overlay(
      look && isTrue ? overlayOf(look, isDark(s)) : null,
      isTrue && look
        ? `${look.ends.length} ${look.probe?.vertex} ${isDark(s)} ${page.shown()?.step}`
        : null,
    );
    for (const listener of listeners) listener();
  }
  /** @type {Set<() => unknown>} */
  const listeners = new Set();

  effect(() => {
    const s = page.state.value;
    page.player.tick.value;
    // At once, whenever the picture follows.
    const label = surfaceLabel(s, s.mesh && page.shown());
    if (canvas.ariaLabel !== label) canvas.ariaLabel = label;
    draw();
  });

  return {
    renderer,
    absence,
    range,
    canvas,
    root,
    first,
    others,
    /** @param {() => unknown} listener  told after each picture @returns {() => void} ends that */
    onDrawn(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    redraw: draw,
    /** Opens the picture. Never rejects. */
    async start() {
      try {
        await first.open(options);
        draw();
        await first.viewer?.drawn();
      } catch (error) {
        fail(error);
      }
    },
    fit: () => first.viewer?.fit(),
    camera: () => first.viewer?.camera() ?? null,
    label: () => surfaceLabel(page.get(), page.shown()),
    /** What a brush is about to hold; null: what the flow holds. @param {Uint8Array | null} set */
    brush(set) {
      brushed = set;
      draw();
    },
    /** @param {boolean} signed @param {number} count @returns {Uint8Array} rgb */
    colours: (signed, count) => first.viewer?.colourBar(signed, count) ?? new Uint8Array(),
    /** Colours of this step alone. */
    fitRange() {
      const field = page.lead.clip.picture(page.lead.u)?.field;
      if (field) page.run.range(rangeOf(field));
    },
  };
}

/** @typedef {ReturnType<typeof createStage>} Stage */

/** A pane that the flow itself has: a flow, a criterion, or the start. @param {string} name */
function paneName(name) {
  if (name === "start") return say("start");
  if (rowOf("criterion").ids.includes(name)) return choiceLabel("criterion", name);
  return flowLabel(name);
}

/** @param {S} s @param {import("../generated/types.js").Pane} pane */
function paneNote({ reading }, { name, state }) {
  if (state) return say("pane-step", { step: state.step });
  const run = reading?.flips?.find(({ criterion }) => criterion === name);
  if (!run) return "";
  return say("pane-flips", {
    flips: run.flips,
    area: formatNumber(run.area, 6),
    circle: formatNumber(run.circle, 5),
  });
}

/** @param {HTMLElement} element @param {number} n  −1 without one @param {Shown} shown */
function caption(element, n, { title, note }) {
  element.hidden = n < 0;
  const text = [n < 0 ? "" : letter(n), title, note];
  if (element.dataset.text === text.join("|")) return;
  element.dataset.text = text.join("|");
  element.className = `pane-${n}`;
  element.replaceChildren(
    ...["i", "b", "small"].map((name, k) => {
      const part = document.createElement(name);
      part.textContent = text[k];
      return part;
    }),
  );
}
