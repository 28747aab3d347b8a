// One picture on the stage: hands the viewer what has changed and nothing else. Steps are
// uploaded once; the graphics card makes the surfaces between them.

/** @import { Field, S } from "../store.js" */
/** @import { Drawable, Step as Put, SurfaceView as Viewer, ViewerOptions } from "../viewer.js" */

/** A surface that is shown at a time; colours over a range that is held. @typedef {Put & { range: readonly [number, number] | null }} Step */

/**
 * What a pane shows: connectivity, and of the surface one step, or the two around a time and their neighbours.
 * @typedef {{ key: string, drawable: Drawable, steps: readonly Step[], time: number, marked: Uint32Array,
 *   highlight: Uint32Array, held: Uint8Array | null, title: string, note: string }} Shown
 */

/** What the viewer has. @typedef {Partial<Shown> & { mesh?: unknown, camera?: unknown, style?: unknown, overlay?: unknown }} Has */

/** Steps that the viewer holds at a time. */
const HELD_STEPS = 4;
/** Nothing over the surface. */
const nothing = { ends: new Float32Array(), colours: new Uint8Array(), hidden: 0 };

/** Colours over the range that is held. @param {Step} step @returns {Field | null} */
function coloured({ field, range }) {
  if (!field || !range) return field;
  const [low, high] = range;
  return field.low === low && field.high === high ? field : { ...field, low, high };
}

const parts = /** @type {const} */ (["positions", "field", "range", "time", "isStraight"]);
/** @param {Step} a @param {Step | undefined} b */
const isSame = (a, b) => parts.every((part) => a[part] === b?.[part]);

export class PaneView {
  /** @type {Viewer | null} */
  viewer = null;
  /** Whether another step is to be sent, with the next picture. */
  lacks = false;
  /** @type {Has} */
  #has = {};
  /** Steps that the viewer has, the newest last. @type {readonly Step[]} */
  #steps = [];
  /** The time of the step that was set: the viewer counts from there. */
  #zero = 0;

  /** @param {HTMLElement} figure  with a canvas and a caption in it */
  constructor(figure) {
    this.figure = figure;
    this.canvas = /** @type {HTMLCanvasElement} */ (figure.querySelector("canvas"));
    this.caption = /** @type {HTMLElement} */ (figure.querySelector("figcaption"));
  }

  /** @param {ViewerOptions} options */
  async open(options) {
    const { SurfaceView } = await import("../viewer.js");
    // Laid out first, so that the picture has a size.
    await new Promise(requestAnimationFrame);
    const onCamera = (/** @type {Float32Array} */ camera) => {
      this.#has.camera = camera;
      options.onCamera(camera);
    };
    const onRenewed = () => {
      this.#forget({});
      options.onRenewed();
    };
    const viewer = new SurfaceView(this.canvas, { ...options, onCamera, onRenewed });
    await viewer.open();
    // Closed meanwhile, it is shown nowhere.
    if (this.figure.isConnected) this.viewer = viewer;
    else viewer.destroy();
  }

  /** @param {Has} rest  what it still has */
  #forget(rest) {
    this.#has = rest;
    this.#steps = [];
  }

  /** @param {S} s @param {Shown} shown @param {import("../viewer.js").Style} style @returns {void} */
  draw(s, shown, style) {
    const { viewer } = this;
    const has = this.#has;
    this.lacks = false;
    if (!viewer || shown.steps[0]?.positions.length !== shown.drawable.positions.length) return;
    if (JSON.stringify(style) !== has.style) {
      has.style = JSON.stringify(style);
      viewer.setStyle(style);
    }
    if (s.mesh !== has.mesh || shown.drawable !== has.drawable) {
      const isSame = s.mesh === has.mesh || (has.mesh && s.camera);
      viewer.setMesh(shown.drawable, isSame ? null : (s.mesh?.up ?? "y"));
      this.#forget({ style: has.style, mesh: s.mesh, drawable: shown.drawable });
      return this.draw(s, shown, style);
    }
    this.#move(viewer, shown);
    if (shown.marked !== has.marked) viewer.change((it) => it.setMarkedTriangles(shown.marked));
    if (shown.highlight !== has.highlight) viewer.change((it) => it.setHighlight(shown.highlight));
    if (shown.held !== has.held)
      viewer.change((it) => it.setMarkedVertices(shown.held ?? new Uint8Array()));
    const { camera } = s;
    if (camera && camera !== has.camera) viewer.change((it) => it.setCamera(camera));
    Object.assign(has, shown, { camera: camera ?? has.camera });
  }

  /** Shows the surface of a time, with the steps that the viewer lacks. @param {Viewer} viewer @param {Shown} shown */
  #move(viewer, { steps, time }) {
    const from = this.#steps.findIndex((step) => isSame(step, steps[0]));
    const known = from < 0 ? [] : this.#steps.slice(from, from + steps.length);
    // What follows the steps that are there follows the last of them.
    const isAtEnd = from + known.length === this.#steps.length;
    const goesOn = known.every((step, n) => isSame(step, steps[n]));
    if (!goesOn || (known.length < steps.length && !isAtEnd)) known.length = 0;
    if (known.length === 0) [this.#steps, this.#zero] = [[], steps[0].time];
    let sent = known.length;
    // What is after the next step bends the way to it little: a large surface at a time.
    while (sent < steps.length && !(sent > known.length && steps[sent - 1].time > time)) {
      const step = steps[sent];
      const put = { ...step, field: coloured(step), time: step.time - this.#zero };
      viewer.putStep(put, sent === 0);
      this.#steps = [...this.#steps, step].slice(-HELD_STEPS);
      sent += 1;
    }
    this.lacks = sent < steps.length;
    viewer.change((it) => it.setTime(time - this.#zero));
  }

  /** @param {import("../overlay.js").Overlay | null} overlay @param {unknown} of */
  overlay(overlay, of) {
    if (!this.viewer || this.#has.overlay === of) return;
    this.#has.overlay = of;
    const { ends, colours, hidden } = overlay ?? nothing;
    this.viewer.change((it) => it.setOverlay(ends, colours, hidden));
  }

  close() {
    this.viewer?.destroy();
    this.figure.remove();
  }
}
