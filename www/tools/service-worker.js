// A plugin of vite: the service worker of the site that was just built, with the list of its
// files and a version made of all their contents.

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { filesIn } from "../vite-plugin.js";

/** Needed by few, or by nothing but a dialog: kept when there is time. */
const isLater = (/** @type {string} */ file) => /\.png$|viewer-webgl/.test(file);

/**
 * Writes the service worker of a site that is complete but for it.
 * @param {string} folder @param {string} source  file of the worker's own code
 */
export function writeServiceWorker(folder, source) {
  const code = readFileSync(source, "utf8");
  /** @type {Record<"core" | "later", Record<string, string>>} */
  const built = { core: {}, later: {} };
  const whole = createHash("sha256").update(code);
  for (const file of filesIn(folder)) {
    if (file === "service-worker.js") continue;
    const digest = createHash("sha256").update(readFileSync(path.join(folder, file)));
    const integrity = `sha256-${digest.digest("base64")}`;
    built[isLater(file) ? "later" : "core"][file] = integrity;
    whole.update(`${file} ${integrity}\n`);
  }
  const version = whole.digest("hex").slice(0, 16);
  const list = `self.built = ${JSON.stringify({ version, ...built })};\n`;
  writeFileSync(path.join(folder, "service-worker.js"), list + code);
}

/** @param {string} source @returns {import("vite").Plugin} */
export const serviceWorker = (source) => ({
  name: "service-worker",
  apply: "build",
  writeBundle: ({ dir = "" }) => writeServiceWorker(dir, source),
});
