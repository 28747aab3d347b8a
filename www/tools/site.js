// The static site in `dist`, by vite.

import { runNode, say } from "./process.js";

// Through node and not npx: ending this process then ends vite as well.
export const vite = ["node_modules/vite/bin/vite.js", "--config", "www/vite.config.js"];

/** Writes the static site: every address in it is relative, so any folder of any host will do. */
export function buildSite() {
  say("Writing the static site to dist");
  runNode([...vite, "build", "--logLevel", "warn"]);
}
