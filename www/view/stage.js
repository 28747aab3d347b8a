// @ts-check
// The surfaces on the stage: one picture a pane, all under one camera.

import { effect, signal } from "@preact/signals-core";
import { distances, letter, sayChange } from "../comparison.js";
import { formatNumber } from "../number.js";
import { choiceLabel, flowLabel, rowOf } from "../options.js";
import { overlayOf } from "../overlay.js";
import { roundedUp } from "../range.js";
import { rim } from "../selection.js";
import { surfaceLabel, symbol } from "../status.js";
import { isDark } from "../store.js";
import { say } from "../words.js";
import { PaneView } from "./pane.js";

/** @import { Page } from "../actions.js" */
/** @import { Field, S } from "../store.js" */
/** @import { Shown, Step } from "./pane.js" */
/** @import { Fault } from "../words.js" */

const none = new Uint32Array();
/** Width of an edge in CSS pixels, on a desk and from the last row. */
const LINE = { near: 1.25, far: 2.5 };

/**
 * @param {Page} page
 * @param {HTMLElement} root
 * @param {{ samples: 1 | 4, effects: "auto" | "always" }} quality  of the pictures
 */
export function createStage(page, root, { samples, effects }) {
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

  /**
   * The surface of a track, in motion from step to step.
   * @param {S} s @param {import("../player.js").Track} track
   * @returns {{ steps: readonly Step[], time: number } | null}
   */
  function motionOf({ range, comparison }, { clip, u }) {
    // Distances are of true steps.
    const point = comparison.difference === null ? null : clip.surface(u);
    const points = point ? [point] : clip.around(u);
    if (points.length === 0) return null;
    const isColoured = points.every(({ field }) => field);
    const steps = points.map(({ positions, field, sum, isSharp }) => ({
      positions: /** @type {Float32Array} */ (positions),
      field: isColoured ? field : null,
      range,
      time: sum,
      isStraight: isSharp,
    }));
    return { steps, time: points.length > 1 ? u : points[0].sum };
  }

  /** @param {S} s @returns {Shown[]} */
  function panesOf(s) {
    const { mesh, comparison, marks, preview, reading } = s;
    if (!mesh) return [];
    const { lead } = page;
    const point = lead.clip.surface(lead.u);
    /** A surface that does not move. @param {Float32Array} positions @param {Field | null} field */
    const still = (positions, field) => ({
      steps: [{ positions, field, range: s.range, time: 0, isStraight: false }],
      time: 0,
    });
    const set = brushed ?? s.configured?.heldVertices ?? null;
    const chosen = reading?.flips?.[0]?.criterion ?? s.options.flow;
    const panes = point?.panes ?? [];
    const ownPane = panes.find(({ name }) => name === chosen);
    const apart = preview ?? ownPane;
    // Of other triangles it is not known which vertices are held.
    const isOfStart = !ownPane && !point?.drawable && set?.length === mesh.positions.length / 3;
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
        drawable: ownPane ?? point?.drawable ?? mesh,
        ...(apart
          ? still(apart.positions, apart.field)
          : (motionOf(s, lead) ?? still(mesh.positions, null))),
        marked: marks?.triangles ?? point?.marked ?? none,
        highlight: marks?.edges ?? ownPane?.highlight ?? (isOfStart ? ringOf(s, set) : none),
        held: isOfStart ? set : null,
        title: isSide
          ? comparison.rivals.length > 0 || comparison.withStart
            ? flowLabel(s.options.flow)
            : paneName(chosen)
          : "",
        note,
      },
    ];
    for (const rival of comparison.rivals) {
      const track = page.rivals.get(rival.id);
      const other = track?.clip.surface(track.u);
      const at = track?.clip.points[track.clip.nearest(track.u)]?.state;
      shown.push({
        key: `rival-${rival.id}`,
        drawable: other?.drawable ?? mesh,
        ...((track && motionOf(s, track)) ?? still(mesh.positions, null)),
        marked: other?.marked ?? none,
        highlight: none,
        held: other?.drawable ? null : rival.held,
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
        ...still(start?.positions ?? mesh.positions, start?.field ?? null),
        ...{ key: "then", drawable: mesh, marked: none, highlight: none, held: null },
        ...{ title: say("start"), note: "" },
      });
    }
    for (const pane of panes) {
      if (pane === ownPane) continue;
      shown.push({
        ...still(pane.positions, pane.field),
        ...{ key: `pane-${pane.name}`, drawable: pane, marked: none },
        ...{ highlight: pane.highlight, held: null },
        ...{ title: paneName(pane.name), note: paneNote(s, pane) },
      });
    }
    return comparison.difference === null ? shown : byDistance(shown, comparison.difference);
  }

  /** Colours by the distance to one of them. @param {Shown[]} shown @param {number} to */
  function byDistance(shown, to) {
    const surfaces = shown.map(({ steps }) => steps[0].positions);
    const base = surfaces[to];
    const values = surfaces.map((positions) =>
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
      return { ...one, steps: [{ ...one.steps[0], field, range: null }] };
    });
  }

  /** @type {import("../viewer.js").ViewerOptions} */
  const options = {
    samples,
    onFault: fail,
    onCamera: page.run.look,
    onRenewed: draw,
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
      cut: s.view.cut / 100,
      inside: (s.mesh?.info.selfIntersections ?? 0) > 0,
      theme: /** @type {"light" | "dark"} */ (isDark(s) ? "dark" : "light"),
      contrast: s.view.contrast || s.presenting,
      lineWidth: s.presenting ? LINE.far : LINE.near,
      effects,
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
      if (pane.lacks) draw();
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
    /**
     * Opens the picture. Never rejects.
     * @param {boolean} isPlain  whether it begins with the first sample, of which the viewer
     *   has a copy: the solver may take its time
     */
    async start(isPlain) {
      try {
        await first.open(options);
        if (isPlain && !page.get().mesh) first.viewer?.setFirst();
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
