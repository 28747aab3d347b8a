// @ts-check
// Pictures that stand side by side, with their captions, as one: for a PNG and for films.

/**
 * @typedef {object} Tile  a picture on the stage
 * @property {HTMLElement} figure  with a canvas and a caption in it
 * @property {(context: CanvasRenderingContext2D, x: number, y: number, width: number, height: number) => void} paint
 */

/** Pixels of a side at most: what video encoders take. */
const LARGEST = 4096;

/**
 * Lines of a text that are no wider than a caption.
 * @param {CanvasRenderingContext2D} context @param {string} text @param {number} width
 */
function wrapped(context, text, width) {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(" ")) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    // A pixel for rounding, as the width is that of the text itself.
    if (lines.length > 0 && context.measureText(longer).width <= width + 1) {
      lines[lines.length - 1] = longer;
    } else lines.push(word);
  }
  return lines;
}

/**
 * @param {CanvasRenderingContext2D} context  in CSS pixels of the stage
 * @param {HTMLElement} caption
 * @param {DOMRect} stage
 */
function drawCaption(context, caption, stage) {
  // A narrow pane leaves a part of it out.
  const parts = [...caption.children].filter((part) => getComputedStyle(part).display !== "none");
  const text = parts
    .map((part) => part.textContent)
    .join("")
    .trim();
  if (caption.hidden || text === "") return;
  const { color, backgroundColor, font, lineHeight, paddingLeft, borderRadius } =
    getComputedStyle(caption);
  const { x, y, width, height } = caption.getBoundingClientRect();
  const [left, top] = [x - stage.x, y - stage.y];
  context.fillStyle = backgroundColor;
  context.beginPath();
  context.roundRect(left, top, width, height, Number.parseFloat(borderRadius) || 0);
  context.fill();
  context.fillStyle = color;
  context.font = font;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const lines = wrapped(context, text, width - 2 * Number.parseFloat(paddingLeft));
  const line = Number.parseFloat(lineHeight) || height / lines.length;
  lines.forEach((one, n) => {
    const middle = top + height / 2 + (n - (lines.length - 1) / 2) * line;
    context.fillText(one, left + width / 2, middle);
  });
}

/**
 * @param {HTMLElement} root  that the pictures stand in
 * @param {() => Tile[]} tiles  those that are seen
 */
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
