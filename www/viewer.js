// @ts-check
// The surface on its canvas: opens the wasm viewer, draws only when something changed,
// follows the size of the canvas, and builds itself anew from the data it holds when the
// graphics device is lost.

import { listenForGestures } from "./gestures.js";
import { giveUpWebgpu, openViewer } from "./renderer.js";
import { contextBack, releaseContext, watchContext } from "./webgl-context.js";
import { say } from "./words.js";

/**
 * @typedef {Pick<import("./generated/types.js").Loaded, "positions" | "triangles" | "wireEdges" | "boundaryEdges">} Drawable
 * @typedef {import("./store.js").Field} Field
 * @typedef {import("./words.js").Fault} Fault
 * @typedef {import("./pkg/viewer/viewer.js").Viewer} WasmViewer
 */

/**
 * @typedef {object} Style
 * @property {"smooth" | "flat"} [shading]
 * @property {boolean} [wireframe]  the mesh's own edges
 * @property {boolean} [boundary]   the boundary loops
 * @property {boolean} [inside]     back and front are told apart of a closed surface too, as one
 *   that passes through itself shows both
 * @property {number} [cut]         share of its depth that is cut away in front
 * @property {"light" | "dark"} [theme]
 * @property {boolean} [contrast]   colour maps of high contrast
 * @property {number} [lineWidth]   of an edge, in CSS pixels
 * @property {"auto" | "always" | "never"} [effects]  darkened corners and a shadow; by itself
 *   what the device has time for, and nothing where it draws in software
 */

/**
 * @typedef {object} ViewerOptions
 * @property {1 | 4} [samples]                     a pixel; tests take 1, which is faster in software
 * @property {(fault: Fault) => void} [onFault]    what goes wrong after `createViewer` has answered
 * @property {(camera: Float32Array) => void} [onCamera]  after the user moved the camera
 * @property {(renderer: import("./renderer.js").Renderer) => void} [onRenderer]  what draws, and why that
 */

/**
 * What of a frame is on screen.
 * @typedef {object} Shown
 * @property {Float32Array} positions
 * @property {Field | null} field
 * @property {Uint32Array} marked
 */

/**
 * A step that follows another, so that the surface can be drawn between them.
 * @typedef {object} NextStep
 * @property {Float32Array} positions
 * @property {Field | null} field
 * @property {number} time            when it is shown, in any unit: after the step before; the
 *   step set by `setFrame` has time 0
 * @property {boolean} [isStraight]   whether vertices move to it at constant velocity, instead
 *   of along smooth curves
 */

/**
 * Segments of space over the surface.
 * @typedef {object} Overlay
 * @property {Float32Array} ends    two of three coordinates each
 * @property {Uint8Array} colours   r, g, b, a in sRGB each
 * @property {number} hidden        opacity where the surface hides them
 */

/** @type {Overlay} */
const none = { ends: new Float32Array(), colours: new Uint8Array(), hidden: 0 };

/** Steps that the viewer holds at a time. */
const HELD_STEPS = 4;

/** How near to an edge a click counts, in CSS pixels. */
const CLICK_REACH = 12;

/** Attempts to replace a lost graphics device before it is given up, … */
const ATTEMPTS = 3;
/** … each waiting longer than the last: right after a crash there may be no adapter yet … */
const RETRY_MILLISECONDS = 500;
/** … and counted anew once the device has held for so long. */
const CALM_MILLISECONDS = 60_000;

/**
 * Opens a viewer on a canvas. Rejects with a `Fault` where there is neither WebGPU nor WebGL2.
 * @param {HTMLCanvasElement} canvas
 * @param {ViewerOptions} [options]
 */
export async function createViewer(canvas, options = {}) {
  const view = new SurfaceView(canvas, options);
  await view.open();
  return view;
}

class SurfaceView {
  /** Where the surface is seen, and where gestures are made. */
  #canvas;
  /** What is drawn on: another one behind that, after WebGPU was lost for good. */
  #drawnOn;
  #options;
  #listening = new AbortController();
  #observer = new ResizeObserver((entries) => this.#measure(entries[0]));

  /** @type {WasmViewer | null} none while the device is being replaced */
  #viewer = null;
  /** @type {import("./renderer.js").Renderer | null} */
  #renderer = null;
  /** @type {number | null} the animation frame asked for */
  #frame = null;
  #cameraMoved = false;
  #isResting = false;
  #attempts = 0;
  #lastLoss = Number.NEGATIVE_INFINITY;

  // What is on screen, kept so that it can be put there again.
  /** @type {Drawable | null} */
  #mesh = null;
  /** @type {Shown | null} */
  #shown = null;
  /** @type {NextStep[]} */
  #steps = [];
  #time = 0;
  /** @type {Uint8Array} */
  #fixed = new Uint8Array();
  /** @type {Uint32Array} */
  #highlight = new Uint32Array();
  /** @type {Overlay | null} */
  #overlay = null;
  /** @type {Style} */
  #style = { lineWidth: 1 };
  #size = { width: 1, height: 1 };

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {ViewerOptions} options
   */
  constructor(canvas, options) {
    this.#canvas = canvas;
    this.#drawnOn = canvas;
    this.#options = options;
    if (!canvas.hasAttribute("role")) canvas.setAttribute("role", "img");
  }

  /** Loads the wasm module and opens a device; called once, by `createViewer`. */
  async open() {
    const { clientWidth, clientHeight } = this.#canvas;
    // A canvas that is not laid out yet has no size; the observer tells it later.
    this.#size = this.#estimateSize({ width: clientWidth || 1, height: clientHeight || 1 });
    await this.#openDevice();
    this.#watchSize();
    this.#watchContext();
    listenForGestures(this.#canvas, this.#moves(), this.#listening.signal);
  }

  /** Of a lost WebGPU device the viewer is told; of a lost WebGL context, the canvas is. */
  #watchContext() {
    watchContext(this.#drawnOn, this.#listening.signal, () => {
      if (this.#viewer) this.#recover(say("viewer-context-taken"));
    });
  }

  /**
   * Shows another mesh from the standard direction, without field and marks.
   * @param {Drawable} loaded
   */
  setMesh(loaded) {
    // First the viewer, which throws where it refuses, then the memory of it.
    this.#putMesh(loaded);
    this.#remember(loaded);
  }

  /** Shows the first sample, before there is a solver to make it. */
  setFirst() {
    const edges = new Uint32Array();
    const first = this.#renderer?.module.firstSurface();
    if (first) this.setMesh({ ...first, wireEdges: edges, boundaryEdges: edges });
  }

  /**
   * The same from where the camera stands: another mesh of the same surface.
   * @param {Drawable} loaded
   */
  replaceMesh(loaded) {
    if (!this.#mesh) return this.setMesh(loaded);
    const { positions, triangles, wireEdges, boundaryEdges } = loaded;
    this.#viewer?.replaceMesh(positions, triangles, wireEdges, boundaryEdges);
    this.#remember(loaded);
  }

  /** @param {Drawable} loaded */
  #remember(loaded) {
    this.#mesh = loaded;
    this.#shown = null;
    this.#steps = [];
    this.#fixed = new Uint8Array();
    this.#highlight = new Uint32Array();
    this.#redraw();
  }

  /**
   * Shows the surface after a step, and no motion. The arrays are kept, not copied.
   * @param {Float32Array} positions
   * @param {Field | null} field
   * @param {Uint32Array} [marked]  triangles to highlight
   */
  setFrame(positions, field, marked = new Uint32Array()) {
    const shown = { positions, field, marked };
    this.#putFrame(shown);
    this.#shown = shown;
    this.#steps = [];
    this.#time = 0;
    this.#redraw();
  }

  /**
   * Adds the step that follows the last; `setTime` then moves the surface between them. A
   * cubic needs the steps before and after the two it joins, so this runs a step ahead. The
   * viewer holds four steps and forgets the oldest: no array is sent twice. The arrays are
   * kept, not copied.
   * @param {NextStep} step
   */
  addStep(step) {
    this.#putStep(step);
    this.#steps = [...this.#steps, step].slice(-HELD_STEPS);
    this.#redraw();
  }

  /**
   * Shows the surface as of a time between the steps held; at that of a step, exactly as
   * `setFrame` would show it.
   * @param {number} time
   */
  setTime(time) {
    this.#viewer?.setTime(time);
    this.#time = time;
    this.#redraw();
  }

  /** Highlights these triangles and no others. @param {Uint32Array} marked */
  setMarked(marked) {
    this.#viewer?.setMarkedTriangles(marked);
    if (this.#shown) this.#shown = { ...this.#shown, marked };
    this.#redraw();
  }

  /**
   * Tints the vertices that are held: a byte each, 1 where held; empty for none.
   * @param {Uint8Array} fixed
   */
  setFixed(fixed) {
    this.#viewer?.setMarkedVertices(fixed);
    this.#fixed = fixed;
    this.#redraw();
  }

  /**
   * Draws these edges over all others: two ends each; empty for none.
   * @param {Uint32Array} ends
   */
  setHighlight(ends) {
    this.#viewer?.setHighlight(ends);
    this.#highlight = ends;
    this.#redraw();
  }

  /**
   * Draws these segments over the surface and no others; they stay where they are when the
   * surface moves or its mesh is replaced.
   * @param {Overlay | null} overlay
   */
  setOverlay(overlay) {
    this.#overlay = overlay;
    this.#putOverlay();
    this.#redraw();
  }

  #putOverlay() {
    const { ends, colours, hidden } = this.#overlay ?? none;
    this.#viewer?.setOverlay(ends, colours, hidden);
  }

  /**
   * @param {ArrayLike<number>} point
   * @returns {{ x: number, y: number, depth: number } | null} where it is seen, in CSS pixels
   *   of the canvas, and how far from the eye; null from behind
   */
  project(point) {
    const scale = this.#scale;
    const seen = this.#viewer?.project(point[0], point[1], point[2]);
    return seen ? { x: seen[0] / scale, y: seen[1] / scale, depth: seen[2] } : null;
  }

  /**
   * The point seen there.
   * @param {{ x: number, y: number, depth: number }} seen
   * @returns {number[] | null}
   */
  unproject({ x, y, depth }) {
    const scale = this.#scale;
    const point = this.#viewer?.unproject(x * scale, y * scale, depth);
    return point ? [...point] : null;
  }

  /** Device pixels a CSS pixel. */
  get #scale() {
    return this.#size.width / Math.max(this.#canvas.clientWidth, 1);
  }

  /** Whether drags are somebody else's, as those of a brush. @param {boolean} isResting */
  rest(isResting) {
    this.#isResting = isResting;
  }

  /** The vertex there. @param {{ clientX: number, clientY: number }} event @returns {number | null} */
  pick(event) {
    return this.#viewer?.pick(...this.#pixelOf(event))?.[3] ?? null;
  }

  /**
   * A set of vertices, a byte each, with a value within some CSS pixels of the surface there.
   * @param {{ clientX: number, clientY: number }} event
   * @param {Uint8Array} set @param {number} reach @param {0 | 1} value
   */
  painted(event, set, reach, value) {
    const [x, y] = this.#pixelOf(event);
    return this.#viewer?.painted(set, x, y, reach * this.#scale, value) ?? null;
  }

  /** The same set with a value spread by one ring. @param {Uint8Array} set @param {0 | 1} value */
  grown = (set, value) => this.#viewer?.grown(set, value) ?? null;

  /** Middle and diagonal of the box about the surface. */
  box() {
    const [x, y, z, size] = this.#viewer?.boundingBox() ?? [0, 0, 0, 1];
    return { middle: [x, y, z], size };
  }

  /**
   * @param {{ clientX: number, clientY: number }} event
   * @param {Uint32Array} ends  two vertices an edge
   * @returns {number | null} which of the edges is seen next to the pointer
   */
  nearestEdge(event, ends) {
    const reach = CLICK_REACH * this.#scale;
    return this.#viewer?.nearestEdge(ends, ...this.#pixelOf(event), reach) ?? null;
  }

  /** @param {{ clientX: number, clientY: number }} event @returns {[number, number]} */
  #pixelOf({ clientX, clientY }) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return [(clientX - left) * this.#scale, (clientY - top) * this.#scale];
  }

  /**
   * Changes what is given, keeps the rest.
   * @param {Style} style
   */
  setStyle(style) {
    this.#style = { ...this.#style, ...style };
    this.#putStyle();
    this.#redraw();
  }

  /** Centres the surface and fills the picture with it, from the present direction. */
  fit() {
    this.#move((viewer) => viewer.fit());
  }

  /** Turns to some triangles, so that they are seen from in front. @param {Uint32Array} triangles */
  face(triangles) {
    this.#move((viewer) => viewer.face(triangles));
  }

  /** Fits from the standard direction. */
  home() {
    this.#move((viewer) => viewer.home());
  }

  /** The camera as a few numbers, for links and for `setCamera`. */
  camera() {
    return this.#viewer?.camera() ?? new Float32Array();
  }

  /**
   * @param {ArrayLike<number>} numbers  of `camera`
   * @returns {boolean} false, and no change, when they make no sense
   */
  setCamera(numbers) {
    const taken = this.#viewer?.setCamera(Float32Array.from(numbers)) ?? false;
    this.#redraw();
    return taken;
  }

  /**
   * The picture as a PNG, as large as it is on screen.
   * @returns {Promise<Blob>}
   */
  snapshot() {
    this.#redrawn();
    return new Promise((resolve, reject) => {
      this.#drawnOn.toBlob((blob) =>
        blob ? resolve(blob) : reject(lostFault(say("viewer-no-picture"))),
      );
    });
  }

  /**
   * Draws the picture, and copies it.
   * @param {CanvasRenderingContext2D} context
   * @param {number} x @param {number} y @param {number} width @param {number} height
   */
  paint(context, x, y, width, height) {
    this.#redrawn();
    context.drawImage(this.#drawnOn, x, y, width, height);
  }

  /** A picture that can be read in this task: what is on the screen may be gone from the canvas. */
  #redrawn() {
    this.#viewer?.invalidate();
    this.#draw();
  }

  /**
   * The picture read back from the graphics device, r, g, b, a from the top left: what
   * golden pictures compare.
   * @returns {Promise<{ width: number, height: number, data: Uint8Array }>}
   */
  pixels() {
    return this.#viewer
      ? this.#viewer.readPixels()
      : Promise.reject(lostFault(say("viewer-rebuilding")));
  }

  /**
   * Colours of a colour map from low to high, r, g, b bytes each.
   * @param {boolean} signed
   * @param {number} count
   */
  colourBar(signed, count) {
    return this.#viewer?.colourBar(signed, count) ?? new Uint8Array(3 * count);
  }

  /** Whether the canvas is another one than it was opened on. */
  get isMoved() {
    return this.#drawnOn !== this.#canvas;
  }

  /** Lets go of canvas, listeners and graphics memory. */
  destroy() {
    this.#listening.abort();
    this.#observer.disconnect();
    if (this.#frame !== null) cancelAnimationFrame(this.#frame);
    this.#viewer?.free();
    this.#viewer = null;
    if (this.#isWebgl) releaseContext(this.#drawnOn);
    if (this.isMoved) this.#drawnOn.remove();
  }

  /** Resolves when what has been asked for is on the canvas. */
  drawn() {
    return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  }

  get #isWebgl() {
    return this.#renderer?.name === "WebGL2";
  }

  async #openDevice() {
    this.#drawnOn.width = this.#size.width;
    this.#drawnOn.height = this.#size.height;
    const options = { samples: this.#options.samples ?? 4 };
    const { viewer, renderer } = await openViewer(this.#drawnOn, options);
    this.#renderer = renderer;
    this.#options.onRenderer?.(renderer);
    if (this.#listening.signal.aborted) {
      viewer.free();
      if (this.#isWebgl) releaseContext(this.#drawnOn);
      return;
    }
    viewer.onLost((/** @type {string} */ reason) => {
      if (viewer === this.#viewer) this.#recover(reason);
    });
    this.#viewer = viewer;
    this.#putStyle();
    if (this.#mesh) this.#putMesh(this.#mesh);
    if (this.#shown) this.#putFrame(this.#shown);
    for (const step of this.#steps) this.#putStep(step);
    viewer.setTime(this.#time);
    viewer.setMarkedVertices(this.#fixed);
    viewer.setHighlight(this.#highlight);
    this.#putOverlay();
    this.#redraw();
  }

  /**
   * Replaces a lost device. A browser that loses it again and again has given up on it.
   * @param {string} reason
   */
  async #recover(reason) {
    const camera = this.camera();
    this.#viewer?.free();
    this.#viewer = null;
    const now = performance.now();
    if (now - this.#lastLoss > CALM_MILLISECONDS) this.#attempts = 0;
    this.#lastLoss = now;
    while (this.#attempts < ATTEMPTS && !this.#listening.signal.aborted) {
      await new Promise((resolve) => setTimeout(resolve, RETRY_MILLISECONDS * this.#attempts));
      this.#attempts += 1;
      try {
        // There is nothing to open on the canvas before.
        if (this.#isWebgl && !(await contextBack(this.#drawnOn))) continue;
        await this.#openDevice();
        this.setCamera(camera);
        return;
      } catch {
        // Tried again, and told after the last attempt.
      }
    }
    if (this.#listening.signal.aborted) return;
    if (!(await this.#standIn(reason, camera))) this.#options.onFault?.(lostFault(reason));
  }

  /**
   * Goes on with WebGL2, after WebGPU was lost for good: on another canvas, as one that was
   * WebGPU's stays so.
   * @param {string} reason @param {Float32Array} camera
   * @returns {Promise<boolean>} whether there is a picture again
   */
  async #standIn(reason, camera) {
    const lost = this.#renderer;
    if (!lost || !(await giveUpWebgpu(lost, say("viewer-gpu-lost", { reason })))) return false;
    const behind = document.createElement("canvas");
    behind.ariaHidden = "true";
    this.#canvas.before(behind);
    this.#drawnOn = behind;
    try {
      await this.#openDevice();
    } catch {
      return false;
    }
    // Else the last picture would hide it.
    /** @type {any} */ (this.#canvas.getContext("webgpu"))?.unconfigure();
    this.#watchContext();
    this.setCamera(camera);
    return true;
  }

  #putStyle() {
    const { lineWidth = 1 } = this.#style;
    this.#viewer?.setStyle({ ...this.#style, lineWidth: lineWidth * this.#scale });
  }

  /** @param {Drawable} mesh */
  #putMesh({ positions, triangles, wireEdges, boundaryEdges }) {
    this.#viewer?.setMesh(positions, triangles, wireEdges, boundaryEdges);
  }

  /** @param {Shown} shown */
  #putFrame({ positions, field, marked }) {
    this.#viewer?.setPositions(positions);
    this.#putField(field);
    this.#viewer?.setMarkedTriangles(marked);
  }

  /** @param {NextStep} step */
  #putStep({ positions, field, time, isStraight }) {
    this.#viewer?.addStep(positions, time, isStraight ?? false);
    this.#putField(field);
  }

  /** Of the step put last. @param {Field | null} field */
  #putField(field) {
    if (field) {
      this.#viewer?.setField(field.values, field.low, field.high, field.signed);
    } else {
      this.#viewer?.clearField();
    }
  }

  #watchSize() {
    try {
      this.#observer.observe(this.#canvas, { box: "device-pixel-content-box" });
    } catch {
      this.#observer.observe(this.#canvas);
    }
  }

  /** @param {ResizeObserverEntry} entry */
  #measure(entry) {
    const exact = entry.devicePixelContentBoxSize?.[0];
    const estimate = this.#estimateSize(entry.contentRect);
    // The exact size knows how the browser rounds, but not of an emulated pixel ratio.
    const agrees = exact && Math.abs(exact.inlineSize - estimate.width) <= 1;
    const { width, height } = agrees
      ? { width: exact.inlineSize, height: exact.blockSize }
      : estimate;
    if (width === 0 || height === 0) return;
    this.#size = { width, height };
    this.#putStyle();
    this.#redraw();
  }

  /** @param {{ width: number, height: number }} box  in CSS pixels */
  #estimateSize({ width, height }) {
    const ratio = window.devicePixelRatio;
    return { width: Math.round(width * ratio), height: Math.round(height * ratio) };
  }

  #redraw() {
    this.#frame ??= requestAnimationFrame((now) => {
      this.#frame = null;
      if (this.#draw()) this.#timeFrame(now);
      if (this.#cameraMoved) {
        this.#cameraMoved = false;
        this.#options.onCamera?.(this.camera());
      }
    });
  }

  /** Draws what has changed. @returns {boolean} whether anything had */
  #draw() {
    // A new size clears the canvas, so it waits for the picture that fills it again.
    this.#viewer?.resize(this.#size.width, this.#size.height);
    return this.#viewer?.draw() ?? false;
  }

  /**
   * Waits for the next frame of the display: a device that cannot follow holds it up.
   * @param {number} start  of the frame in which a picture was drawn
   */
  #timeFrame(start) {
    requestAnimationFrame((now) => {
      if (this.#viewer?.recordFrame(now - start)) this.#redraw();
    });
  }

  /** @param {(viewer: WasmViewer) => void} change */
  #move(change) {
    if (!this.#viewer) return;
    change(this.#viewer);
    this.#cameraMoved = true;
    this.#redraw();
  }

  /** @returns {import("./gestures.js").Moves} */
  #moves() {
    return {
      orbit: (dx, dy) => this.#isResting || this.#move((viewer) => viewer.orbit(dx, dy)),
      pan: (dx, dy) => this.#move((viewer) => viewer.pan(dx, dy)),
      zoom: (factor, x, y) => this.#move((viewer) => viewer.zoom(factor, x, y)),
      roll: (angle) => this.#move((viewer) => viewer.roll(angle)),
      fit: () => this.fit(),
      home: () => this.home(),
    };
  }
}

/**
 * @param {string} reason
 * @returns {Fault}
 */
function lostFault(reason) {
  return {
    kind: "GpuLost",
    message: say("viewer-gpu-lost", { reason }),
    hint: say("viewer-gpu-lost.hint"),
    detail: {},
  };
}
