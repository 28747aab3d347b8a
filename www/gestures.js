// Pointer, wheel, touch and keys on a canvas, turned into camera moves. Knows no viewer:
// moves go to a function, in device pixels from the top left.
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
 * By pixels across and down; by a factor towards a place; by radians, anticlockwise; `home` from the
 * standard direction.
 * @typedef {(name: "orbit" | "pan" | "zoom" | "roll" | "fit" | "home", ...values: number[]) => void} Move
 */

const ARROW_PIXELS = 24;
const KEY_ZOOM = 1.15;
const KEY_ROLL = Math.PI / 36;
const WHEEL_ZOOM_PER_PIXEL = 0.0015;
// A trackpad pinch comes as a wheel with Ctrl, in much smaller steps.
const PINCH_ZOOM_PER_PIXEL = 0.01;
const LINE_PIXELS = 16;

/** @param {HTMLCanvasElement} canvas @param {Move} act @param {AbortSignal} signal  ends it */
export function listenForGestures(canvas, act, signal) {
  canvas.style.touchAction = "none";

  /** Device pixels in a CSS pixel. */
  const scale = () => canvas.width / Math.max(canvas.clientWidth, 1);

  /** @type {Map<number, { x: number, y: number }>} where each pressed pointer is */
  const pointers = new Map();

  const place = (/** @type {MouseEvent} */ event) => {
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
  function move(event) {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const now = place(event);
    const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    pointers.set(event.pointerId, now);
    const [dx, dy] = [now.x - before.x, now.y - before.y];
    if (other) moveOneOfTwo(other, before, now);
    else act(event.shiftKey || event.buttons & 6 ? "pan" : "orbit", dx, dy);
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
    act("pan", (now.x - before.x) / 2, (now.y - before.y) / 2);
    if (from.length > 0 && to.length > 0) {
      act("zoom", to.length / from.length, (still.x + now.x) / 2, (still.y + now.y) / 2);
    }
    // The shorter way round; screen angles run clockwise.
    const turn = to.angle - from.angle;
    act("roll", -Math.atan2(Math.sin(turn), Math.cos(turn)));
  }

  /** @param {WheelEvent} event */
  function turnWheel(event) {
    event.preventDefault();
    const unit = [1, LINE_PIXELS, canvas.clientHeight][event.deltaMode] ?? 1;
    const rate = event.ctrlKey ? PINCH_ZOOM_PER_PIXEL : WHEEL_ZOOM_PER_PIXEL;
    const { x, y } = place(event);
    act("zoom", Math.exp(-event.deltaY * unit * rate), x, y);
  }

  /** @param {KeyboardEvent} event */
  function pressKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = ARROW_PIXELS * scale();
    const drag = event.shiftKey ? "pan" : "orbit";
    const [x, y] = [canvas.width / 2, canvas.height / 2];
    /** @type {Record<string, Parameters<Move>>} */
    const moves = {
      ArrowLeft: [drag, -step, 0],
      ArrowRight: [drag, step, 0],
      ArrowUp: [drag, 0, -step],
      ArrowDown: [drag, 0, step],
      "+": ["zoom", KEY_ZOOM, x, y],
      "=": ["zoom", KEY_ZOOM, x, y],
      "-": ["zoom", 1 / KEY_ZOOM, x, y],
      "[": ["roll", KEY_ROLL],
      "]": ["roll", -KEY_ROLL],
      0: ["fit"],
      Home: ["home"],
    };
    const move = moves[event.key];
    if (!move) return;
    event.preventDefault();
    act(...move);
  }

  const quiet = { signal };
  canvas.addEventListener("pointerdown", press, quiet);
  canvas.addEventListener("pointermove", move, quiet);
  // After each release too, as every press has captured its pointer.
  canvas.addEventListener("lostpointercapture", (event) => pointers.delete(event.pointerId), quiet);
  canvas.addEventListener("wheel", turnWheel, { signal, passive: false });
  canvas.addEventListener("keydown", pressKey, quiet);
  canvas.addEventListener("dblclick", () => act("fit"), quiet);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault(), quiet);
}
