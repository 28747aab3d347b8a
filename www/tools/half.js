// `node www/tools/half.js NAME PROFILE` builds one of the wasm files: in a process of its own, so
// that another is compiled or served meanwhile.

import path from "node:path";
import { runLater, script } from "./process.js";
import { buildHalf } from "./wasm.js";

const self = import.meta.filename;

/**
 * Builds one of the wasm files beside what is done meanwhile.
 * @param {import("./wasm.js").Half} name @param {import("./wasm.js").Profile} profile
 */
export const buildLater = (name, profile) => runLater(process.execPath, [self, name, profile]);

if (process.argv[1] && path.resolve(process.argv[1]) === self) {
  const [name, profile] = process.argv.slice(2);
  await script(() => buildHalf(/** @type {any} */ (name), /** @type {any} */ (profile)));
}
