// The viewer for browsers without WebGPU, for the development server: compiled when such a browser
// asks for it.

import path from "node:path";
import { buildLater } from "./half.js";

const isViewer = (/** @type {string} */ id) => id.endsWith("/viewer-webgl.js");

/** @type {Promise<void> | null} */
let built = null;

/** @returns {import("vite").Plugin} */
export const webglOnDemand = () => ({
  name: "webgl-on-demand",
  apply: "serve",
  enforce: "pre",
  // It need not be there yet; vite looks at all sources before any is asked for.
  resolveId(source, importer, options) {
    if (!isViewer(source) || !importer) return null;
    const { scan } = /** @type {{ scan?: boolean }} */ (options);
    return scan ? { id: source, external: true } : path.resolve(path.dirname(importer), source);
  },
  async load(id) {
    if (!isViewer(id)) return null;
    built ??= buildLater("viewer-webgl", "quick");
    await built;
    return null;
  },
});
