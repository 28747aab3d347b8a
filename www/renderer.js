// Which of the two viewers draws: WebGPU where it works; else WebGL2, which brings its own
// shader compiler, is several times as large, and is fetched only then. `?renderer=webgl`
// or `?renderer=webgpu` in the page's address forces the choice.

import { hasContext } from "./webgl-context.js";
import { say, sayFault } from "./words.js";

/** @import { Fault as Refusal } from "./generated/types.js" */
/** @import { Fault } from "./words.js" */
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

/** @returns {Promise<Renderer>} */
function chooseRenderer() {
  chosen ??= choose().catch((error) => {
    chosen = null;
    throw error;
  });
  return chosen;
}

/**
 * WebGL2 from now on: WebGPU has been lost for good.
 * @param {Renderer} lost @param {string} reason
 * @returns {Promise<boolean>} whether there is one; the address may ask for WebGPU alone
 */
export async function giveUpWebgpu(lost, reason) {
  if (lost.isForced || lost.name === "WebGL2") return false;
  if ((await chooseRenderer()).name === "WebGPU") chosen = loadWebgl(reason, false);
  return chooseRenderer().then(
    () => true,
    () => {
      // What is shown of another canvas stays.
      chosen = Promise.resolve(lost);
      return false;
    },
  );
}

/**
 * Opens a viewer on a canvas. Rejects with a `Fault` where neither renderer works.
 * @param {HTMLCanvasElement} canvas @param {{ samples: number }} options
 */
export async function openViewer(canvas, options) {
  const renderer = await chooseRenderer();
  try {
    const viewer = await renderer.module.Viewer.create(canvas, options);
    hasOpened = true;
    return { viewer, renderer };
  } catch (error) {
    // An adapter that gives no device: the canvas has not been asked for anything yet.
    const refusal = /** @type {Refusal} */ (error);
    if (typeof refusal?.kind !== "string") throw error;
    const fault = sayFault(refusal);
    const isEarly = fault.kind === "NoAdapter" || fault.kind === "NoDevice";
    if (hasOpened || renderer.isForced || renderer.name === "WebGL2" || !isEarly) throw fault;
    chosen = loadWebgl(fault.message, false);
    const fallback = await chosen;
    const viewer = await fallback.module.Viewer.create(canvas, options).catch((error) => {
      throw typeof error?.kind === "string" ? sayFault(error) : error;
    });
    return { viewer, renderer: fallback };
  }
}

/** @returns {Promise<Renderer>} */
async function choose() {
  const forced = new URLSearchParams(location.search).get("renderer");
  if (forced === "webgpu") return loadWebgpu(say("renderer-asked"), true);
  if (forced === "webgl") return loadWebgl(say("renderer-asked"), true);
  const gpu = /** @type {any} */ (navigator).gpu;
  const none = say("renderer-no-webgpu");
  if (!gpu) return loadWebgl(none, false);
  // Fetched meanwhile: browsers that have WebGPU mostly have an adapter too.
  const webgpu = loadWebgpu(say("renderer-offered"), false);
  webgpu.catch(() => {});
  const adapter = await gpu.requestAdapter({ powerPreference: "high-performance" });
  return adapter ? webgpu : loadWebgl(say("renderer-no-adapter"), false);
}

/** @param {string} reason @param {boolean} isForced @returns {Promise<Renderer>} */
async function loadWebgpu(reason, isForced) {
  const wasm = new URL("./pkg/viewer/viewer_bg.wasm", import.meta.url);
  const module = await load(() => import("./pkg/viewer/viewer.js"), wasm);
  return { name: "WebGPU", reason, isForced, module };
}

/** @param {string} reason @param {boolean} isForced @returns {Promise<Renderer>} */
async function loadWebgl(reason, isForced) {
  // Looked for first: nothing large is fetched in vain.
  if (!hasContext()) {
    throw fault(
      "NoRenderer",
      isForced ? say("renderer-no-webgl") : say("renderer-neither", { reason }),
      say("renderer-neither.hint"),
    );
  }
  const wasm = new URL("./pkg/viewer-webgl/viewer-webgl_bg.wasm", import.meta.url);
  const module = await load(() => import("./pkg/viewer-webgl/viewer-webgl.js"), wasm);
  return { name: "WebGL2", reason, isForced, module };
}

/**
 * @template {{ default: (options: { module_or_path: URL }) => Promise<unknown> }} Module
 * @param {() => Promise<Module>} fetchModule @param {URL} wasm @returns {Promise<Module>}
 */
async function load(fetchModule, wasm) {
  try {
    const module = await fetchModule();
    await module.default({ module_or_path: wasm });
    return module;
  } catch (error) {
    throw fault(
      "ViewerNotLoaded",
      say("viewer-not-loaded", { reason: error instanceof Error ? error.message : String(error) }),
      say("viewer-not-loaded.hint"),
    );
  }
}

/** @param {string} kind @param {string} message @param {string} hint @returns {Fault} */
function fault(kind, message, hint) {
  return { kind, message, hint, detail: {} };
}
