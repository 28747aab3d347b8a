// The viewer for browsers without WebGPU, for the development server: compiled when such a browser
// asks for it.

import { spawn } from "node:child_process";
import { once } from "node:events";
import path from "node:path";
import { script } from "./process.js";
import { buildHalf } from "./wasm.js";

const self = import.meta.filename;
const isViewer = (/** @type {string} */ id) => id.endsWith("/viewer-webgl.js");

/** @type {Promise<void> | null} */
let built = null;

/** Compiles it in a process of its own: the server goes on serving. */
async function build() {
  const [code] = await once(spawn(process.execPath, [self], { stdio: "inherit" }), "exit");
  if (code !== 0) throw new Error("the viewer for WebGL2 could not be compiled");
}

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
    built ??= build();
    await built;
    return null;
  },
});

if (process.argv[1] === self) await script(() => buildHalf("viewer-webgl", "quick"));
