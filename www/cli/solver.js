// The wasm solver in Node: the same file that the page loads.

import { existsSync, readFileSync } from "node:fs";
import { refused } from "./failure.js";

/** @typedef {import("../pkg/solver/solver.js").Session} Session */

const wasm = new URL("../pkg/solver/solver_bg.wasm", import.meta.url);
const second = new URL("../pkg/solver/split_deferred.wasm", import.meta.url);

/** Help can be read before anything is built. */
const built = existsSync(wasm) ? await import("../pkg/solver/solver.js") : null;
if (built) {
  const { provide } = await import("../deferred.js");
  provide(() => new WebAssembly.Module(readFileSync(second)));
  built.initSync({ module: readFileSync(wasm) });
}

/** What the solver can do without a session. @throws where it has not been built */
export function loadSolver() {
  if (built) return built;
  throw refused("usage-not-built", {}, "NotBuilt");
}

/** @returns {Session} */
export const openSession = () => new (loadSolver().Session)();

/**
 * There is nothing of a name: perhaps another was meant.
 * @param {string} id  of the words @param {string} name @param {readonly string[]} names  that there are
 */
export const unknown = (id, name, names) =>
  refused(id, { name, names, near: loadSolver().nearest(name, [...names]) ?? "none" });
