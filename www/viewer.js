// The surface on its canvas: opens the wasm viewer, draws only when something changed, follows the
// size of the canvas, and replaces the graphics device when it is lost. What is to be seen it does
// not keep: of a new device it tells, and is told again.

import { listenForGestures } from "./gestures.js";
import { contextBack, giveUpWebgpu, openViewer, releaseContext } from "./renderer.js";
import { fault, say } from "./words.js";

/**
 * @typedef {Pick<import("./generated/types.js").Loaded, "positions" | "triangles" | "wireEdges" | "boundaryEdges">} Drawable
 * @typedef {import("./generated/types.js").Up} Up
 * @typedef {import("./store.js").Field} Field
 * @typedef {import("./words.js").Fault} Fault
 * @typedef {import("./pkg/viewer/viewer.js").Viewer} WasmViewer
 */

/**
 * `cut` is a share; with `inside`, back and front are told apart of a closed surface too, as one
 * that passes through itself shows both; `lineWidth` is of an edge, in CSS pixels. `effects` are
 * darkened corners and a shadow: by itself what the device has time for, at rest more than in motion.
 * @typedef {Partial<Pick<import("./store.js").View, "shading" | "wireframe" | "boundary" | "cut" | "contrast">
 *   & { inside: boolean, theme: "light" | "dark", lineWidth: number, effects: "auto" | "always" | "never" }>} Style
 */

/**
 * @typedef {object} ViewerOptions
 * @property {1 | 4} samples                       a pixel; tests take 1, which is faster in software
 * @property {() => void} onRenewed                the device is a new one, which shows nothing yet
 * @property {(fault: Fault) => void} onFault      what goes wrong once it is open
 * @property {(camera: Float32Array) => void} onCamera    after the user moved the camera
 * @property {(renderer: import("./renderer.js").Renderer) => void} onRenderer    what draws, and why that
 */

/**
 * A step of a flow; the surface can be drawn between one and the next.
 * @typedef {object} Step
 * @property {Float32Array} positions
 * @property {Field | null} field
 * @property {number} time           when it is shown, in any unit: after the step before; a step
 *   that is put alone has time 0
 * @property {boolean} isStraight    whether vertices move to it at constant velocity, instead
 *   of along smooth curves
 */

/** Milliseconds without another picture after which one is taken to stay. */
const STILL = 200;

/** How near to an edge a click counts, in CSS pixels. */
const CLICK_REACH = 12;

const gpuLost = (/** @type {string} */ reason) => fault("GpuLost", "viewer-gpu-lost", { reason });

/** Attempts to replace a lost graphics device before it is given up, … */
const ATTEMPTS = 3;
/** … each waiting longer than the last: right after a crash there may be no adapter yet … */
const RETRY_MILLISECONDS = 500;
/** … and counted anew once the device has held for so long. */
const CALM_MILLISECONDS = 60_000;

export class SurfaceView {
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
  /** @type {ReturnType<typeof setTimeout> | undefined} the wait for rest */
  #rest;
  /** Whether the next picture is one at rest. */
  #isSettled = false;
  /** @type {Up} */
  #up = "y";
  #cameraMoved = false;
  #isResting = false;
  #attempts = 0;
  #lastLoss = Number.NEGATIVE_INFINITY;

  /** @type {Style} */
  #style = {};
  #size = { width: 1, height: 1 };

  /** @param {HTMLCanvasElement} canvas @param {ViewerOptions} options */
  constructor(canvas, options) {
    this.#canvas = canvas;
    this.#drawnOn = canvas;
    this.#options = options;
  }

  /**
   * Loads the wasm module and opens a device; called once, before all else. Rejects with a `Fault`
   * where there is neither WebGPU nor WebGL2.
   */
  async open() {
    const { clientWidth, clientHeight } = this.#canvas;
    // A canvas that is not laid out yet has no size; the observer tells it later.
    this.#size = this.#estimateSize({ width: clientWidth || 1, height: clientHeight || 1 });
    await this.#openDevice();
    try {
      this.#observer.observe(this.#canvas, { box: "device-pixel-content-box" });
    } catch {
      this.#observer.observe(this.#canvas);
    }
    listenForGestures(this.#canvas, this.#move, this.#listening.signal);
  }

  /** Of a lost WebGPU device the viewer is told; of a lost WebGL context, the canvas is. @param {Event} event */
  #loseContext = (event) => {
    // Else the browser does not give it back.
    event.preventDefault();
    if (this.#viewer) this.#recover(say("viewer-context-taken"));
  };

  /** Changes what is to be seen, and draws it. @param {(viewer: WasmViewer) => void} change */
  change(change) {
    if (!this.#viewer) return;
    change(this.#viewer);
    this.#redraw();
  }

  /**
   * Shows another mesh, without field and marks.
   * @param {Drawable} mesh
   * @param {Up | null} up  the axis that points up, seen from the standard direction; null: a mesh of
   *   the same surface, seen from where the camera stands
   */
  setMesh({ positions, triangles, wireEdges, boundaryEdges }, up) {
    this.change((viewer) => {
      viewer.setMesh(positions, triangles, wireEdges, boundaryEdges);
      if (up) this.#up = up;
      if (up) viewer.home(up === "z");
    });
  }

  /** Shows the first sample, before there is a solver to make it. */
  setFirst() {
    const none = new Uint32Array();
    const first = this.#renderer?.module.firstSurface();
    if (first) this.setMesh({ ...first, wireEdges: none, boundaryEdges: none }, "y");
  }

  /**
   * Shows a step alone, or adds it as the one that follows the last; `setTime` then moves the
   * surface between them. A cubic needs the steps before and after the two it joins, so this runs
   * a step ahead. The viewer holds four steps and forgets the oldest: no array is sent twice.
   * @param {Step} step @param {boolean} isAlone
   */
  putStep({ positions, field, time, isStraight }, isAlone) {
    this.change((viewer) => {
      if (isAlone) viewer.setPositions(positions);
      else viewer.addStep(positions, time, isStraight);
      if (field) viewer.setField(field.values, field.low, field.high, field.signed);
      else viewer.clearField();
    });
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

  /** The point seen there. @param {{ x: number, y: number, depth: number }} seen */
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

  /** Changes what is given, keeps the rest. @param {Style} style */
  setStyle(style) {
    this.#style = { ...this.#style, ...style };
    this.#putStyle();
  }

  /** Centres the surface and fills the picture with it, from the present direction. */
  fit = () => this.#move("fit");

  /** Turns to some triangles, so that they are seen from in front. @param {Uint32Array} triangles */
  face = (triangles) => this.#move("face", triangles);

  /** The picture as a PNG, as large as it is on screen. */
  async snapshot() {
    this.#redrawn(true);
    /** @type {Blob | null} */
    const blob = await new Promise((resolve) => this.#drawnOn.toBlob(resolve));
    if (!blob) throw gpuLost(say("viewer-no-picture"));
    return blob;
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

  /** The picture as it is at rest. */
  #settle = () => {
    this.#isSettled = this.#viewer?.settle() ?? false;
    if (this.#isSettled) this.#redraw();
  };

  /**
   * A picture that can be read in this task: what is on the screen may be gone from the canvas.
   * @param {boolean} [isStill]  and not one of many
   */
  #redrawn(isStill = false) {
    this.#viewer?.invalidate();
    if (isStill) this.#viewer?.settle();
    this.#draw();
  }

  /** A colour map from low to high, r, g, b bytes. @param {boolean} signed @param {number} count */
  colourBar(signed, count) {
    return this.#viewer?.colourBar(signed, count) ?? new Uint8Array(3 * count);
  }

  /** Lets go of canvas, listeners and graphics memory. */
  destroy() {
    clearTimeout(this.#rest);
    this.#listening.abort();
    this.#observer.disconnect();
    this.#release(this.#viewer);
    this.#viewer = null;
    if (this.#drawnOn !== this.#canvas) this.#drawnOn.remove();
  }

  /** @param {WasmViewer | null} viewer */
  #release(viewer) {
    viewer?.free();
    if (this.#isWebgl) releaseContext(this.#drawnOn);
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
    const { samples } = this.#options;
    const { signal } = this.#listening;
    const { viewer, renderer } = await openViewer(this.#drawnOn, { samples });
    this.#renderer = renderer;
    this.#options.onRenderer(renderer);
    if (signal.aborted) return this.#release(viewer);
    this.#drawnOn.addEventListener("webglcontextlost", this.#loseContext, { signal });
    viewer.onLost((/** @type {string} */ reason) => {
      if (viewer === this.#viewer) this.#recover(reason);
    });
    this.#viewer = viewer;
    this.#putStyle();
    this.#options.onRenewed();
  }

  /** Replaces a lost device; one lost again and again is given up. @param {string} reason */
  async #recover(reason) {
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
        return await this.#openDevice();
      } catch {
        // Tried again, and told after the last attempt.
      }
    }
    if (this.#listening.signal.aborted) return;
    await this.#standIn(reason).catch(() => this.#options.onFault(gpuLost(reason)));
  }

  /**
   * Goes on with WebGL2, after WebGPU was lost for good: on another canvas, as one that was
   * WebGPU's stays so. Rejects where that cannot be.
   * @param {string} reason
   */
  async #standIn(reason) {
    await giveUpWebgpu(this.#renderer, say("viewer-gpu-lost", { reason }));
    const behind = document.createElement("canvas");
    behind.ariaHidden = "true";
    this.#canvas.before(behind);
    this.#drawnOn = behind;
    await this.#openDevice();
    // Else the last picture would hide it.
    /** @type {any} */ (this.#canvas.getContext("webgpu"))?.unconfigure();
  }

  #putStyle() {
    const lineWidth = (this.#style.lineWidth ?? 1) * this.#scale;
    this.change((viewer) => viewer.setStyle({ ...this.#style, lineWidth }));
  }

  /** @param {ResizeObserverEntry} entry */
  #measure(entry) {
    const exact = entry.devicePixelContentBoxSize?.[0];
    const estimate = this.#estimateSize(entry.contentRect);
    // The exact size knows how the browser rounds, but not of an emulated pixel ratio.
    const agrees = exact && Math.abs(exact.inlineSize - estimate.width) <= 1;
    const size = agrees ? { width: exact.inlineSize, height: exact.blockSize } : estimate;
    if (size.width === 0 || size.height === 0) return;
    this.#size = size;
    this.#putStyle();
  }

  /** @param {{ width: number, height: number }} box  in CSS pixels */
  #estimateSize({ width, height }) {
    const ratio = window.devicePixelRatio;
    return { width: Math.round(width * ratio), height: Math.round(height * ratio) };
  }

  #redraw() {
    this.#frame ??= requestAnimationFrame((now) => {
      this.#frame = null;
      if (this.#draw()) {
        clearTimeout(this.#rest);
        if (!this.#isSettled) this.#rest = setTimeout(this.#settle, STILL);
        this.#isSettled = false;
        // A device that cannot follow holds up the next frame of the display.
        requestAnimationFrame((next) => {
          if (this.#viewer?.recordFrame(next - now)) this.#redraw();
        });
      }
      if (this.#cameraMoved && this.#viewer) this.#options.onCamera(this.#viewer.camera());
      this.#cameraMoved = false;
    });
  }

  /** Draws what has changed. @returns {boolean} whether anything had */
  #draw() {
    // A new size clears the canvas, so it waits for the picture that fills it again.
    this.#viewer?.resize(this.#size.width, this.#size.height);
    return this.#viewer?.draw() ?? false;
  }

  /** Moves the camera, and tells of it. @param {string} name  of the viewer's move @param {...unknown} values */
  #move = (name, ...values) => {
    if (name === "orbit" && this.#isResting) return;
    const given = name === "home" ? [this.#up === "z"] : values;
    this.change((viewer) => {
      /** @type {any} */ (viewer)[name](...given);
      this.#cameraMoved = true;
    });
  };
}
