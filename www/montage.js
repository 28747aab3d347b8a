// Pictures that stand side by side, with their captions, as one: for a PNG and for films.

/**
 * @typedef {object} Tile  a picture on the stage
 * @property {HTMLElement} figure  with a canvas and a caption in it
 * @property {(context: CanvasRenderingContext2D, x: number, y: number, width: number, height: number) => void} paint
 */

/** Pixels of a side at most: what video encoders take. */
const LARGEST = 4096;

/**
 * @param {CanvasRenderingContext2D} context  in CSS pixels of the stage
 * @param {HTMLElement} caption  each part of it a line @param {DOMRect} stage
 */
function drawCaption(context, caption, stage) {
  if (caption.hidden) return;
  for (const part of caption.children) {
    const { color, backgroundColor, font, borderRadius } = getComputedStyle(part);
    const { x, y, width, height } = part.getBoundingClientRect();
    const [left, top] = [x - stage.x, y - stage.y];
    context.fillStyle = backgroundColor;
    context.beginPath();
    context.roundRect(left, top, width, height, borderRadius.endsWith("%") ? width / 2 : 0);
    context.fill();
    context.fillStyle = color;
    context.font = font;
    context.textBaseline = "middle";
    const text = part.textContent ?? "";
    // A letter stands in the middle of its disc.
    const space = borderRadius.endsWith("%") ? (width - context.measureText(text).width) / 2 : 0;
    context.fillText(text, left + space, top + height / 2);
  }
}

/** @param {HTMLElement} root  around the pictures @param {() => Tile[]} tiles  that are seen */
export function createMontage(root, tiles) {
  /** As large as the stage is on the screen. */
  function canvas() {
    const { width, height } = root.getBoundingClientRect();
    const scale = Math.min(devicePixelRatio, LARGEST / Math.max(width, height, 1));
    const made = document.createElement("canvas");
    // Codecs take even sizes.
    made.width = 2 * Math.round((width * scale) / 2);
    made.height = 2 * Math.round((height * scale) / 2);
    return made;
  }

  /** @param {HTMLCanvasElement} onto  what was on it goes */
  function paint(onto) {
    const context = onto.getContext("2d");
    if (!context) return;
    const stage = root.getBoundingClientRect();
    // The stage may have another size by now.
    const scale = Math.min(onto.width / stage.width, onto.height / stage.height);
    context.resetTransform();
    context.fillStyle = getComputedStyle(document.body).backgroundColor;
    context.fillRect(0, 0, onto.width, onto.height);
    context.scale(scale, scale);
    for (const { figure, paint: drawPicture } of tiles()) {
      const { x, y, width, height } = figure.getBoundingClientRect();
      drawPicture(context, x - stage.x, y - stage.y, width, height);
      const caption = figure.querySelector("figcaption");
      if (caption) drawCaption(context, caption, stage);
    }
  }

  return {
    canvas,
    paint,
    /** @returns {Promise<Blob | null>} */
    snapshot() {
      const picture = canvas();
      paint(picture);
      return new Promise((resolve) => picture.toBlob(resolve));
    },
  };
}
