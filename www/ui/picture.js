// @ts-check
// The canvas: hands the viewer what changed, and says in words what it shows. Where
// there is neither WebGPU nor WebGL2 it says so in place of the picture.

/** @import { Pane } from "../generated/types.js" */
/** @import { Fault } from "../words.js" */
/** @import { PageState, View } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { sampleName } from "../library.js";
import { hasContrast, isDark } from "../state.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";
import { overlayOf } from "./overlay.js";
import { rim } from "./selection.js";

/** @typedef {Awaited<ReturnType<typeof import("../viewer.js").createViewer>>} Viewer */

/** @param {Readonly<PageState>} state */
export function surfaceLabel({ mesh, reading }) {
  if (!mesh) return t("Surface: none yet");
  const { name } = mesh;
  if (!reading) return t("Surface: {name}", { name });
  const energy = formatNumber(reading.energy, 4);
  const area = formatNumber(reading.area, 4);
  const { step } = reading;
  return t("Surface: {name}, step {step}, energy {energy}, area {area}", {
    name,
    step,
    energy,
    area,
  });
}

/** The pane that stands in the place of the surface. @param {Readonly<PageState>} state */
export function ownPane({ frame, reading, options }) {
  const chosen = reading?.flips?.[0].criterion ?? options.flow;
  return frame?.panes.find(({ name }) => name === chosen) ?? null;
}

/** Width of an edge in CSS pixels, on a desk and from the last row. */
const LINE = { near: 1, far: 2 };

/** How the surface is drawn. @param {Readonly<PageState>} state @returns {import("../viewer.js").Style} */
export function styleOf(state) {
  const { shading, wireframe, boundary } = state.view;
  return {
    shading,
    wireframe,
    boundary,
    theme: isDark(state) ? "dark" : "light",
    contrast: hasContrast(state),
    lineWidth: state.presenting ? LINE.far : LINE.near,
  };
}

/** @param {PageState["source"]} source */
export function sceneTitle(source) {
  return source?.kind === "sample" ? sampleName(source.id) : (source?.name ?? "");
}

/**
 * @param {Controller} controller
 * @param {() => Readonly<PageState>} state
 * @param {1 | 4} samples  of the picture's smoothing
 */
export function createPicture(controller, state, samples) {
  const canvas = byId("surface", HTMLCanvasElement);
  const absence = byId("absence", HTMLElement);
  const title = byId("title", HTMLElement);

  /** @type {Viewer | null} */
  let viewer = null;
  /** @type {PageState["mesh"]} */
  let mesh = null;
  /** @type {PageState["frame"]} */
  let frame = null;
  /** @type {PageState["preview"]} */
  let preview = null;
  /** @type {import("../generated/types.js").Look | null} */
  let look = null;
  let dark = false;
  /** @type {Uint8Array | null} */
  let held = null;
  /** @type {Readonly<View> | null} */
  let view = null;
  /** @type {PageState["marks"]} */
  let marks = null;
  // The rim of the region, as last asked for.
  /** @type {{ set: Uint8Array | null, edges: Uint32Array, found: Uint32Array }} */
  let ring = { set: null, edges: new Uint32Array(), found: new Uint32Array() };
  /** @type {Pane | null} what the viewer draws in place of the mesh */
  let pane = null;
  /** @type {PageState["camera"]} what the viewer has; it tells us of every change */
  let camera = null;

  /** @param {Fault} fault */
  function showAbsence(fault) {
    viewer?.destroy();
    viewer = null;
    canvas.hidden = true;
    absence.hidden = false;
    setText(byId("absence-reason", HTMLElement), fault.message);
    setText(byId("absence-hint", HTMLElement), fault.hint);
  }

  /** @param {Float32Array} now */
  function onCamera(now) {
    camera = now;
    controller.look(now);
  }

  /** @param {import("../renderer.js").Renderer} renderer */
  function onRenderer({ name, reason }) {
    for (const id of ["renderer", "help-renderer"]) {
      setText(byId(id, HTMLElement), t("Drawn with {name}: {reason}.", { name, reason }));
    }
  }

  /** @param {Readonly<PageState>} s */
  function draw(s) {
    if (!viewer) return;
    if (s.view !== view) {
      view = s.view;
      viewer.setStyle(styleOf(s));
    }
    if (s.mesh !== mesh && s.mesh) {
      mesh = s.mesh;
      frame = null;
      viewer.setMesh(mesh);
      pane = null;
      held = null;
      camera = null;
    }
    if (s.frame && (s.frame !== frame || s.preview !== preview)) {
      frame = s.frame;
      preview = s.preview;
      drawFrame(viewer, s.frame, s);
    } else if (s.marks !== marks) drawMarks(viewer, s);
    drawLook(viewer, s);
    if (!pane && s.configured && s.configured.heldVertices !== held) {
      held = s.configured.heldVertices;
      viewer.setFixed(held);
      drawMarks(viewer, s);
    }
    if (s.camera !== camera && s.camera) {
      camera = s.camera;
      viewer.setCamera(camera);
    }
  }

  /** @param {Viewer} opened @param {NonNullable<PageState["frame"]>} now @param {Readonly<PageState>} s */
  function drawFrame(opened, now, s) {
    const next = ownPane(s);
    if (next) opened.replaceMesh(next);
    else if (pane && mesh) opened.replaceMesh(mesh);
    if (next || pane) held = null;
    pane = next;
    const { positions, field } = s.preview ?? pane ?? now;
    opened.setFrame(positions, field, now.flippedTriangles);
    drawMarks(opened, s);
  }

  /** @param {Viewer} opened @param {Readonly<PageState>} s */
  function drawLook(opened, s) {
    const next = (s.preview ?? s.frame)?.look ?? null;
    if (next === look && isDark(s) === dark) return;
    look = next;
    dark = isDark(s);
    opened.setOverlay(look && overlayOf(look, dark));
  }

  /** @param {Viewer} opened @param {Readonly<PageState>} s */
  function drawMarks(opened, s) {
    if (s.marks || marks) opened.setMarked(s.marks?.triangles ?? new Uint32Array());
    marks = s.marks;
    opened.setHighlight(marks?.edges ?? pane?.highlight ?? regionRim(s, held));
  }

  /**
   * Where a chosen region ends, while colours hide the tint of what is held.
   * @param {Readonly<PageState>} s
   * @param {Uint8Array | null} set
   */
  function regionRim(s, set) {
    const isChosen = s.options.free !== null || s.options.fixed !== null;
    if (!set || !mesh || !isChosen || !s.frame?.field) return new Uint32Array();
    // The same for all frames of a run.
    if (ring.set !== set || ring.edges !== mesh.wireEdges) {
      ring = { set, edges: mesh.wireEdges, found: rim(set, mesh.wireEdges) };
    }
    return ring.found;
  }

  return {
    /**
     * Opens the viewer. Never rejects.
     * @param {number | null} level  of the subdivided icosahedron to show until the solver has
     *   a mesh; null for nothing
     */
    async start(level) {
      try {
        const { createViewer, icosahedron } = await import("../viewer.js");
        const [opened, shape] = await Promise.all([
          createViewer(canvas, { samples, onFault: showAbsence, onCamera, onRenderer }),
          level === null ? null : icosahedron(level),
        ]);
        viewer = opened;
        if (shape) viewer.setMesh(shape);
        draw(state());
        await viewer.drawn();
      } catch (error) {
        const fault = /** @type {Partial<Fault>} */ (error);
        const message = fault?.message ?? String(error);
        showAbsence({
          kind: fault?.kind ?? "NoPicture",
          message,
          hint: fault?.hint ?? "",
          detail: {},
        });
      }
    },
    /** @param {Readonly<PageState>} s */
    update(s) {
      draw(s);
      const label = surfaceLabel(s);
      if (canvas.ariaLabel !== label) canvas.ariaLabel = label;
      setText(title, sceneTitle(s.source));
    },
    fit: () => viewer?.fit(),
    /** @returns {Float32Array | null} where it is seen from */
    camera: () => viewer?.camera() ?? null,
    /** @param {MouseEvent} event */
    pick: (event) => viewer?.pick(event) ?? null,
    /** What a brush is about to hold. @param {Uint8Array} now */
    showHeld(now) {
      viewer?.setFixed(now);
      if (!pane) viewer?.setHighlight(regionRim(state(), now));
    },
    /** @param {boolean} on  whether a drag paints and does not turn */
    brush: (on) => viewer?.rest(on),
    /** @param {ArrayLike<number>} point */
    project: (point) => viewer?.project(point) ?? null,
    /** @param {{ x: number, y: number, depth: number }} seen */
    unproject: (seen) => viewer?.unproject(seen) ?? null,
    /** @param {MouseEvent} event @param {Uint32Array} ends */
    nearestEdge: (event, ends) => viewer?.nearestEdge(event, ends) ?? null,
    /** @returns {Promise<Blob | null>} */
    snapshot: async () => viewer?.snapshot() ?? null,
    /** Whether it is drawn on another canvas than at first. */
    isMoved: () => viewer?.isMoved ?? false,
    /** @type {import("./montage.js").Tile["paint"]} */
    paint: (...place) => viewer?.paint(...place),
    /** @param {boolean} signed @param {number} count @returns {Uint8Array | null} rgb */
    colours: (signed, count) => viewer?.colourBar(signed, count) ?? null,
  };
}
