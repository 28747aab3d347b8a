// The surfaces on the stage: one picture a pane, all under one camera.

import { effect, signal } from "@preact/signals-core";
import { html, render } from "lit-html";
import { distances, letter, sayChange } from "../comparison.js";
import { formatBeside, formatNumber } from "../number.js";
import { choiceLabel, flowLabel, rowOf } from "../options.js";
import { overlayOf } from "../overlay.js";
import { roundedUp } from "../range.js";
import { surfaceLabel, symbol } from "../status.js";
import { isDark } from "../store.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { PaneView } from "./pane.js";

/** @import { Pane, State as Reading } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { Track } from "../player.js" */
/** @import { Field, S } from "../store.js" */
/** @import { Fault } from "../words.js" */
/** @import { Shown } from "./pane.js" */

const none = new Uint32Array();
/** Width of an edge in CSS pixels, on a desk and from the last row. */
const LINE = { near: 1.25, far: 2.5 };
/** What a pane shows that has nothing but a surface. */
const bare = { marked: none, highlight: none, held: null, note: "" };

/** A surface that does not move. @param {Float32Array} positions @param {Field | null} field @param {S["range"]} range */
const still = (positions, field, range) => ({
  steps: [{ positions, field, range, time: 0, isStraight: false }],
  time: 0,
});

/** The surface of a track, in motion from step to step. @param {S} s @param {Track} track */
function motionOf({ range, comparison, mesh }, { clip, u }) {
  // Distances are of true steps.
  const point = comparison.difference === null ? null : clip.surface(u);
  const points = point ? [point] : clip.around(u);
  if (points.length === 0) return still(mesh?.positions ?? new Float32Array(), null, range);
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

/** A pane that the flow itself has: a flow, a criterion, or the start. @param {string} name */
function paneName(name) {
  if (name === "start") return say("start");
  if (rowOf("criterion").ids.includes(name)) return choiceLabel("criterion", name);
  return flowLabel(name);
}

/** @param {S} s @param {Pane} pane */
function paneNote({ reading }, { name, state }) {
  if (state) return say("pane-step", { step: state.step });
  const run = reading?.flips?.find(({ criterion }) => criterion === name);
  if (!run) return "";
  const [area, circle] = [formatNumber(run.area, 6), formatNumber(run.circle, 5)];
  return say("pane-flips", { flips: run.flips, area, circle });
}

/** @param {Track} track @param {Reading | null | undefined} state @param {Options} options */
function noteOf({ clip }, state, options) {
  if (!state) return "";
  const energy = formatBeside(state.energy, clip.points[0]?.state.energy ?? 0);
  return say("pane-note", { step: state.step, symbol: symbol({ options }), energy });
}

/** @param {HTMLElement} element @param {number} n  −1 without one @param {Shown} shown */
function caption(element, n, { title, note }) {
  element.hidden = n < 0;
  element.className = `pane-${n}`;
  render(html`<i>${n < 0 ? "" : letter(n)}</i><b>${title}</b><small>${note}</small>`, element);
}

/** @param {HTMLElement} root @param {{ samples: 1 | 4, effects: "auto" | "always" | "never" }} quality  of the pictures */
export function createStage(root, { samples, effects }) {
  const first = new PaneView(/** @type {HTMLElement} */ (root.querySelector("figure")));
  const { canvas } = first;
  /** @type {Map<string, PaneView>} */
  const others = new Map();
  const renderer = signal("");
  const absence = signal(/** @type {Pick<Fault, "message" | "hint"> | null} */ (null));
  /** Of distances between panes, which are no field of the solver's. */
  const range = signal(/** @type {readonly [number, number] | null} */ (null));
  /** What a brush is about to hold. @type {Uint8Array | null} */
  let brushed = null;
  /** Triangles that were turned to. @type {Uint32Array | null} */
  let faced = null;
  /** Changes with each picture. */
  const pictures = signal(0);

  /** @param {S} s @returns {Shown[]} */
  function panesOf(s) {
    const { mesh, comparison, marks, preview, reading, options } = s;
    if (!mesh) return [];
    const { lead } = page;
    const point = lead.clip.surface(lead.u);
    const set = brushed ?? s.configured?.heldVertices ?? null;
    const chosen = reading?.flips?.[0]?.criterion ?? options.flow;
    const panes = point?.panes ?? [];
    const ownPane = panes.find(({ name }) => name === chosen);
    const apart = preview ?? ownPane;
    // Of other triangles it is not known which vertices are held.
    const isOfStart = !ownPane && !point?.drawable && set?.length === mesh.positions.length / 3;
    const isCompared = comparison.rivals.length > 0 || comparison.withStart;
    const title = panes.length > (ownPane ? 1 : 0) ? paneName(chosen) : "";
    /** @type {Shown[]} */
    const shown = [
      {
        key: "lead",
        drawable: ownPane ?? point?.drawable ?? mesh,
        ...(apart ? still(apart.positions, apart.field, s.range) : motionOf(s, lead)),
        marked: marks?.triangles ?? point?.marked ?? none,
        highlight: marks?.edges ?? ownPane?.highlight ?? none,
        held: isOfStart ? set : null,
        title: isCompared ? flowLabel(options.flow) : title,
        note: noteOf(lead, page.shown(), options),
      },
    ];
    for (const rival of comparison.rivals) {
      const { id, change, phase, reason, held, clip, u } = rival;
      const other = clip.surface(u);
      const at = clip.points[clip.nearest(u)]?.state;
      shown.push({
        ...{ ...bare, key: `rival-${id}`, drawable: other?.drawable ?? mesh },
        ...motionOf(s, rival),
        marked: other?.marked ?? none,
        held: other?.drawable ? null : held,
        title: sayChange(options, change),
        note: phase === "lost" ? reason : noteOf(rival, at, { ...options, ...change }),
      });
    }
    if (comparison.withStart) {
      const start = lead.clip.points[0];
      const surface = still(start?.positions ?? mesh.positions, start?.field ?? null, s.range);
      shown.push({ ...bare, ...surface, key: "then", drawable: mesh, title: say("start") });
    }
    for (const pane of panes) {
      const { name, positions, field, highlight } = pane;
      const [title, note] = [paneName(name), paneNote(s, pane)];
      const surface = { ...still(positions, field, s.range), drawable: pane, highlight };
      if (pane !== ownPane) shown.push({ ...bare, ...surface, key: `pane-${name}`, title, note });
    }
    return comparison.difference === null ? shown : byDistance(shown, comparison.difference);
  }

  /** Colours by the distance to one of them. @param {Shown[]} shown @param {number} to */
  function byDistance(shown, to) {
    const base = shown[to]?.steps[0].positions;
    const all = shown.map(({ steps: [{ positions }] }) =>
      base && positions.length === base.length ? distances(positions, base) : null,
    );
    const most = Math.max(...all.map((one) => one?.reduce((a, b) => Math.max(a, b), 0) ?? 0));
    const high = most > 0 ? roundedUp(most) : 1;
    if (range.peek()?.[1] !== high) range.value = [0, high];
    return shown.map((one, n) => {
      const values = all[n];
      /** @type {any} */
      const field = values && { name: "distance", low: 0, high, signed: false, values };
      return { ...one, steps: [{ ...one.steps[0], field, range: null }] };
    });
  }

  /** @type {import("../viewer.js").ViewerOptions} */
  const options = {
    samples,
    onFault: fail,
    onCamera: (camera) => page.patch({ camera }),
    onRenewed: draw,
    onRenderer: ({ name, reason }) => {
      renderer.value = say("drawn-with", { name, reason });
      root.dataset.renderer = renderer.value;
    },
  };

  /** @param {unknown} error */
  function fail(error) {
    const { message = String(error), hint = "" } = /** @type {Partial<Fault>} */ (error);
    absence.value = { message, hint };
    first.viewer?.destroy();
    first.viewer = null;
    canvas.hidden = true;
  }

  /** @param {string} key */
  function paneOf(key) {
    const known = key === "lead" ? first : others.get(key);
    if (known) return known;
    const figure = Object.assign(document.createElement("figure"), { className: "pane" });
    figure.innerHTML = '<canvas role="img" tabindex="0"></canvas><figcaption></figcaption>';
    root.append(figure);
    const pane = new PaneView(figure);
    others.set(key, pane);
    pane.open({ ...options, onFault: page.report }).then(draw, page.report);
    return pane;
  }

  /** Whether what was drawn has colours of high contrast. */
  const hasContrast = signal(false);
  /** The animation frame asked for; 0: none. */
  let frame = 0;
  /** Draws once before the next picture. */
  function draw() {
    if (frame === 0) frame = requestAnimationFrame(drawNow);
  }

  function drawNow() {
    frame = 0;
    const s = page.get();
    const shown = panesOf(s);
    const dark = isDark(s);
    const { shading, wireframe, boundary, cut, contrast } = s.view;
    const style = {
      ...{ shading, wireframe, boundary, cut: cut / 100, effects },
      inside: (s.mesh?.info.selfIntersections ?? 0) > 0,
      theme: /** @type {"light" | "dark"} */ (dark ? "dark" : "light"),
      contrast: contrast || s.presenting,
      lineWidth: s.presenting ? LINE.far : LINE.near,
    };
    for (const [key, pane] of others) {
      if (shown.some((one) => one.key === key)) continue;
      pane.close();
      others.delete(key);
    }
    root.dataset.count = String(Math.max(shown.length, 1));
    const { shown: which } = s.comparison;
    root.dataset.shown = which === "side" ? "side" : "place";
    shown.forEach((one, n) => {
      const pane = paneOf(one.key);
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
    hasContrast.value = style.contrast;
    const { near = null } = s.marks ?? {};
    if (near && near !== faced) first.viewer?.face(near);
    faced = near;
    const isTrue = page.player.motion.peek() === "still";
    const look = (isTrue && (s.preview ?? s.extras)?.look) || null;
    const of = look && `${look.ends.length} ${look.probe?.vertex} ${dark} ${page.shown()?.step}`;
    first.overlay(look && overlayOf(look, dark), of);
    pictures.value += 1;
  }

  effect(() => {
    const s = page.state.value;
    page.player.tick.value;
    // At once, whenever the picture follows.
    const label = surfaceLabel(s, s.mesh && page.shown());
    if (canvas.ariaLabel !== label) canvas.ariaLabel = label;
    draw();
  });

  return {
    ...{ renderer, absence, range, canvas, root, first, others, pictures },
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
    /** What a brush is about to hold; null: what the flow holds. @param {Uint8Array | null} set */
    brush(set) {
      brushed = set;
      draw();
    },
    /** So many colours of data from low to high, as the viewer has them. @param {boolean} signed @param {number} count */
    colours(signed, count) {
      hasContrast.value;
      const rgb = first.viewer?.colourBar(signed, count) ?? [];
      const bytes = (/** @type {number} */ n) => [...rgb.slice(3 * n, 3 * n + 3)];
      return Array.from({ length: rgb.length / 3 }, (_, n) => `rgb(${bytes(n).join(" ")})`);
    },
  };
}

/** @typedef {ReturnType<typeof createStage>} Stage */
