// The wasm solver in Node: the same file that the page loads.

import { existsSync, readFileSync } from "node:fs";
import { Failure, usage } from "./failure.js";

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

/** What the solver can do without a session. @throws {Failure} where it has not been built */
export function loadSolver() {
  if (built) return built;
  const hint = "Run `npm run build` once in the project's folder.";
  throw new Failure(2, "NotBuilt", "The solver has not been built yet.", hint);
}

/** @returns {Session} */
export const openSession = () => new (loadSolver().Session)();

/**
 * There is nothing of a name: perhaps another was meant.
 * @param {"command" | "shape"} what @param {string} name @param {string[]} names  that there are
 * @param {string} list  how all are listed
 */
export function unknown(what, name, names, list) {
  const near = loadSolver().nearest(name, names);
  const hint = near ? `Did you mean \`${near}\`?` : list;
  return usage(`There is no ${what} \`${name}\`.`, hint);
}
