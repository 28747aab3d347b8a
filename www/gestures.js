// Pointer, wheel, touch and keys on a canvas, turned into camera moves. Knows no viewer:
// moves go to a `Moves` object, in device pixels from the top left.
//
// | gesture                                   | move          |
// | ----------------------------------------- | ------------- |
// | drag, one finger                          | orbit         |
// | right or middle drag, Shift + drag        | pan           |
// | wheel, pinch on a trackpad                | zoom to there |
// | two fingers: move, pinch, twist           | pan, zoom, roll |
// | double click                              | fit           |
// | arrows; with Shift                        | orbit; pan    |
// | + and -                                   | zoom          |
// | [ and ]                                   | roll          |
// | 0; Home                                   | fit; fit from the standard direction |

/**
 * @typedef {object} Moves
 * @property {(dx: number, dy: number) => void} orbit
 * @property {(dx: number, dy: number) => void} pan
 * @property {(factor: number, x: number, y: number) => void} zoom
 * @property {(angle: number) => void} roll  anticlockwise, radians
 * @property {() => void} fit
 * @property {() => void} home
 */

const ARROW_PIXELS = 24;
const KEY_ZOOM = 1.15;
const KEY_ROLL = Math.PI / 36;
const WHEEL_ZOOM_PER_PIXEL = 0.0015;
// A trackpad pinch comes as a wheel with Ctrl, in much smaller steps.
const PINCH_ZOOM_PER_PIXEL = 0.01;
const LINE_PIXELS = 16;

/**
 * Listens until the signal aborts.
 * @param {HTMLCanvasElement} canvas @param {Moves} moves @param {AbortSignal} signal
 */
export function listenForGestures(canvas, moves, signal) {
  canvas.style.touchAction = "none";
  if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;

  /** Device pixels in a CSS pixel. */
  const scale = () => canvas.width / Math.max(canvas.clientWidth, 1);

  /** @type {Map<number, { x: number, y: number }>} where each pressed pointer is */
  const pointers = new Map();

  /** @param {MouseEvent} event */
  const place = (event) => {
    const box = canvas.getBoundingClientRect();
    return { x: (event.clientX - box.left) * scale(), y: (event.clientY - box.top) * scale() };
  };

  /** @param {PointerEvent} event */
  function press(event) {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, place(event));
  }

  /** @param {PointerEvent} event */
  function release(event) {
    pointers.delete(event.pointerId);
  }

  /** @param {PointerEvent} event */
  function move(event) {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    pointers.set(event.pointerId, now);
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    if (other) {
      moveOneOfTwo(other, before, now);
    } else if (event.shiftKey || event.buttons & 6) {
      moves.pan(dx, dy);
    } else {
      moves.orbit(dx, dy);
    }
  }

  /**
   * Two fingers hold the picture: what is under them stays there.
   * @param {{ x: number, y: number }} still @param {{ x: number, y: number }} before
   * @param {{ x: number, y: number }} now
   */
  function moveOneOfTwo(still, before, now) {
    const [from, to] = [before, now].map((at) => ({
      length: Math.hypot(at.x - still.x, at.y - still.y),
      angle: Math.atan2(at.y - still.y, at.x - still.x),
    }));
    moves.pan((now.x - before.x) / 2, (now.y - before.y) / 2);
    if (from.length > 0 && to.length > 0) {
      moves.zoom(to.length / from.length, (still.x + now.x) / 2, (still.y + now.y) / 2);
    }
    // The shorter way round; screen angles run clockwise.
    const turn = to.angle - from.angle;
    moves.roll(-Math.atan2(Math.sin(turn), Math.cos(turn)));
  }

  /** @param {WheelEvent} event */
  function turnWheel(event) {
    event.preventDefault();
    const unit = [1, LINE_PIXELS, canvas.clientHeight][event.deltaMode] ?? 1;
    const rate = event.ctrlKey ? PINCH_ZOOM_PER_PIXEL : WHEEL_ZOOM_PER_PIXEL;
    const { x, y } = place(event);
    moves.zoom(Math.exp(-event.deltaY * unit * rate), x, y);
  }

  /** @param {KeyboardEvent} event */
  function pressKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = ARROW_PIXELS * scale();
    const drag = event.shiftKey ? moves.pan : moves.orbit;
    const [x, y] = [canvas.width / 2, canvas.height / 2];
    /** @type {Record<string, () => void>} */
    const actions = {
      ArrowLeft: () => drag(-step, 0),
      ArrowRight: () => drag(step, 0),
      ArrowUp: () => drag(0, -step),
      ArrowDown: () => drag(0, step),
      "+": () => moves.zoom(KEY_ZOOM, x, y),
      "=": () => moves.zoom(KEY_ZOOM, x, y),
      "-": () => moves.zoom(1 / KEY_ZOOM, x, y),
      "[": () => moves.roll(KEY_ROLL),
      "]": () => moves.roll(-KEY_ROLL),
      0: () => moves.fit(),
      Home: () => moves.home(),
    };
    const action = actions[event.key];
    if (action) {
      event.preventDefault();
      action();
    }
  }

  const quiet = { signal };
  canvas.addEventListener("pointerdown", press, quiet);
  canvas.addEventListener("pointermove", move, quiet);
  canvas.addEventListener("pointerup", release, quiet);
  canvas.addEventListener("pointercancel", release, quiet);
  canvas.addEventListener("lostpointercapture", release, quiet);
  canvas.addEventListener("wheel", turnWheel, { signal, passive: false });
  canvas.addEventListener("keydown", pressKey, quiet);
  canvas.addEventListener("dblclick", () => moves.fit(), quiet);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault(), quiet);
}
