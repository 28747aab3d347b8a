// The page through vite: the development server, and the static site in `dist`.

import { runNode, say } from "./process.js";

// Through node and not npx: ending this process then ends vite as well.
const vite = "node_modules/vite/bin/vite.js";
const config = ["--config", "www/vite.config.js"];

/**
 * Serves the page until interrupted; vite prints the address.
 * @param {string[]} parameters  handed on to vite, e.g. `--port 8000`
 */
export function serve(parameters) {
  say("Serving the page; Ctrl-C ends it");
  runNode([vite, ...config, ...parameters]);
}

/** Writes the static site: every address in it is relative, so any folder of any host will do. */
export function buildSite() {
  say("Writing the static site to dist");
  runNode([vite, "build", ...config, "--logLevel", "warn"]);
}
