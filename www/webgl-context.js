// The WebGL context of a canvas. Other than a WebGPU device it belongs to the canvas for
// good: the browser takes it away and gives it back, to the same canvas, when it can.

/** How long a browser may take to give a context back. */
const RESTORE_MILLISECONDS = 4000;

/**
 * Waits for a lost context for a while.
 * @param {HTMLCanvasElement} canvas
 * @returns {Promise<boolean>} whether the canvas can be drawn on again
 */
export async function contextBack(canvas) {
  const context = canvas.getContext("webgl2");
  if (!context?.isContextLost()) return true;
  await new Promise((resolve) => {
    canvas.addEventListener("webglcontextrestored", resolve, { once: true });
    setTimeout(resolve, RESTORE_MILLISECONDS);
  });
  return !context.isContextLost();
}

/**
 * Lets a context go now, and not when garbage is collected: browsers allow few at a time.
 * @param {HTMLCanvasElement} canvas
 */
export function releaseContext(canvas) {
  canvas.getContext("webgl2")?.getExtension("WEBGL_lose_context")?.loseContext();
}

/** @returns {boolean} whether this browser has WebGL2 */
export function hasContext() {
  const canvas = document.createElement("canvas");
  const found = canvas.getContext("webgl2") !== null;
  releaseContext(canvas);
  return found;
}
