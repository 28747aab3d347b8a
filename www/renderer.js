// Which of the two viewers draws: WebGPU where it works; else WebGL2, which brings its own
// shader compiler, is several times as large, and is fetched only then. `?renderer=webgl`
// or `?renderer=webgpu` in the page's address forces the choice.

import { fault, say, sayFault } from "./words.js";

/** @typedef {Pick<typeof import("./pkg/viewer/viewer.js"), "Viewer" | "firstSurface">} ViewerModule */

/**
 * @typedef {object} Renderer
 * @property {"WebGPU" | "WebGL2"} name
 * @property {string} reason          why this one, a clause for people
 * @property {boolean} isForced       by the address
 * @property {ViewerModule} module    its wasm, ready
 */

/** @type {Promise<Renderer> | null} one for the whole page */
let chosen = null;
/** Whether a canvas has been taken: such a canvas cannot change its renderer any more. */
let hasOpened = false;

function chooseRenderer() {
  chosen ??= choose().catch((error) => {
    chosen = null;
    throw error;
  });
  return chosen;
}

/**
 * WebGL2 from now on: WebGPU has been lost for good. Rejects where there is none; the address may
 * ask for WebGPU alone.
 * @param {Renderer | null} lost @param {string} reason
 */
export async function giveUpWebgpu(lost, reason) {
  if (!lost || lost.isForced || lost.name === "WebGL2")
    throw new Error("there is no other renderer");
  if ((await chooseRenderer()).name === "WebGPU") chosen = load("WebGL2", reason);
  await chosen?.catch((error) => {
    // What is shown of another canvas stays.
    chosen = Promise.resolve(lost);
    throw error;
  });
}

/**
 * Opens a viewer on a canvas. Rejects with a `Fault` where neither renderer works.
 * @param {HTMLCanvasElement} canvas @param {{ samples: number }} options
 * @returns {Promise<{ viewer: import("./pkg/viewer/viewer.js").Viewer, renderer: Renderer }>}
 */
export async function openViewer(canvas, options) {
  const renderer = await chooseRenderer();
  try {
    const viewer = await renderer.module.Viewer.create(canvas, options);
    hasOpened = true;
    return { viewer, renderer };
  } catch (error) {
    // An adapter that gives no device: the canvas has not been asked for anything yet.
    const refused = inWords(error);
    const isEarly = refused.kind === "NoAdapter" || refused.kind === "NoDevice";
    if (hasOpened || renderer.isForced || renderer.name === "WebGL2" || !isEarly) throw refused;
    chosen = load("WebGL2", refused.message);
    return openViewer(canvas, options);
  }
}

/** A refusal of the viewer's in words; another error as it is. @param {any} error */
const inWords = (error) => (typeof error?.kind === "string" ? sayFault(error) : error);

/** @returns {Promise<Renderer>} */
async function choose() {
  const forced = new URLSearchParams(location.search).get("renderer");
  if (forced === "webgpu") return load("WebGPU", say("renderer-asked"), true);
  if (forced === "webgl") return load("WebGL2", say("renderer-asked"), true);
  const gpu = /** @type {any} */ (navigator).gpu;
  if (!gpu) return load("WebGL2", say("renderer-no-webgpu"));
  // Fetched meanwhile: browsers that have WebGPU mostly have an adapter too.
  const webgpu = load("WebGPU", say("renderer-offered"));
  webgpu.catch(() => {});
  const adapter = await gpu.requestAdapter({ powerPreference: "high-performance" });
  return adapter ? webgpu : load("WebGL2", say("renderer-no-adapter"));
}

/** @param {Renderer["name"]} name @param {string} reason @param {boolean} [isForced] */
async function load(name, reason, isForced = false) {
  const isWebgl = name === "WebGL2";
  // Looked for first: nothing large is fetched in vain.
  if (isWebgl && !hasContext()) {
    const id = isForced ? "renderer-no-webgl" : "renderer-neither";
    throw fault("NoRenderer", id, { reason }, "renderer-neither.hint");
  }
  const wasm = isWebgl
    ? new URL("./pkg/viewer-webgl/viewer-webgl_bg.wasm", import.meta.url)
    : new URL("./pkg/viewer/viewer_bg.wasm", import.meta.url);
  try {
    // The larger file first, and not after what is around it.
    const bytes = fetch(wasm);
    bytes.catch(() => {});
    const module = await (isWebgl
      ? import("./pkg/viewer-webgl/viewer-webgl.js")
      : import("./pkg/viewer/viewer.js"));
    await module.default({ module_or_path: bytes });
    return { name, reason, isForced, module };
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    throw fault("ViewerNotLoaded", "viewer-not-loaded", { reason: why });
  }
}

// Other than a WebGPU device the WebGL context of a canvas belongs to the canvas for good: the
// browser takes it away and gives it back, to the same canvas, when it can.

/** How long a browser may take to give a context back. */
const RESTORE_MILLISECONDS = 4000;

/** Waits a while for a lost context: whether it is back. @param {HTMLCanvasElement} canvas */
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
function hasContext() {
  const canvas = document.createElement("canvas");
  const found = canvas.getContext("webgl2") !== null;
  releaseContext(canvas);
  return found;
}
