// @ts-check
// The canvas: hands the viewer what changed, and says in words what it shows. Where
// there is neither WebGPU nor WebGL2 it says so in place of the picture.

/** @import { Fault, Pane } from "../protocol.js" */
/** @import { PageState, View } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { samples as shapes } from "../samples.js";
import { isDark } from "../state.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** @typedef {Awaited<ReturnType<typeof import("../viewer.js").createViewer>>} Viewer */

/** @param {Readonly<PageState>} state */
export function surfaceLabel({ mesh, reading }) {
  if (!mesh) return "Surface: none yet";
  if (!reading) return `Surface: ${mesh.name}`;
  const energy = formatNumber(reading.energy, 4);
  const area = formatNumber(reading.area, 4);
  return `Surface: ${mesh.name}, step ${reading.step}, energy ${energy}, area ${area}`;
}

/** The pane that stands in the place of the surface. @param {Readonly<PageState>} state */
export function ownPane({ frame, reading, options }) {
  const chosen = reading?.flips?.[0].criterion ?? options.flow;
  return frame?.panes.find(({ name }) => name === chosen) ?? null;
}

/** @param {PageState["source"]} source */
function titleOf(source) {
  if (source?.kind !== "sample") return source?.name ?? "";
  return shapes.find(({ id }) => id === source.id)?.label ?? "";
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
  /** @type {Uint8Array | null} */
  let held = null;
  /** @type {Readonly<View> | null} */
  let view = null;
  /** @type {PageState["marks"]} */
  let marks = null;
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

  /** @param {Readonly<PageState>} s */
  function draw(s) {
    if (!viewer) return;
    if (s.view !== view) {
      view = s.view;
      const { shading, wireframe, boundary } = view;
      viewer.setStyle({ shading, wireframe, boundary, theme: isDark(s) ? "dark" : "light" });
    }
    if (s.mesh !== mesh && s.mesh) {
      mesh = s.mesh;
      frame = null;
      viewer.setMesh(mesh);
      pane = null;
      held = null;
      camera = null;
    }
    if (s.frame !== frame && s.frame) {
      frame = s.frame;
      drawFrame(viewer, s.frame, s);
    } else if (s.marks !== marks) drawMarks(viewer, s);
    if (!pane && s.configured && s.configured.heldVertices !== held) {
      held = s.configured.heldVertices;
      viewer.setFixed(held);
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
    const { positions, field } = pane ?? now;
    opened.setFrame(positions, field, now.flippedTriangles);
    drawMarks(opened, s);
  }

  /** @param {Viewer} opened @param {Readonly<PageState>} s */
  function drawMarks(opened, s) {
    if (s.marks || marks) opened.setMarked(s.marks?.triangles ?? new Uint32Array());
    marks = s.marks;
    opened.setHighlight(marks?.edges ?? pane?.highlight ?? new Uint32Array());
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
          createViewer(canvas, { samples, onFault: showAbsence, onCamera }),
          level === null ? null : icosahedron(level),
        ]);
        viewer = opened;
        const { name, reason } = viewer.renderer;
        for (const id of ["renderer", "help-renderer"]) {
          setText(byId(id, HTMLElement), `Drawn with ${name}: ${reason}.`);
        }
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
      setText(title, titleOf(s.source));
    },
    fit: () => viewer?.fit(),
    /** @returns {Float32Array | null} where it is seen from */
    camera: () => viewer?.camera() ?? null,
    /** @param {MouseEvent} event */
    pick: (event) => viewer?.pick(event) ?? null,
    /** What a brush is about to hold. @param {Uint8Array} now */
    showHeld: (now) => viewer?.setFixed(now),
    /** @param {boolean} on  whether a drag paints and does not turn */
    brush: (on) => viewer?.rest(on),
    /** @param {MouseEvent} event @param {Uint32Array} ends */
    nearestEdge: (event, ends) => viewer?.nearestEdge(event, ends) ?? null,
    /** @returns {Promise<Blob | null>} */
    snapshot: async () => viewer?.snapshot() ?? null,
    /** @param {boolean} signed @param {number} count @returns {Uint8Array | null} rgb */
    colours: (signed, count) => viewer?.colourBar(signed, count) ?? null,
  };
}
