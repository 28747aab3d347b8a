// The wasm solver in Node: the same file that the page loads.

import { existsSync, readFileSync } from "node:fs";
import { Failure } from "./failure.js";

/** @typedef {import("../pkg/solver/solver.js").Session} Session */

const glue = new URL("../pkg/solver/solver.js", import.meta.url);
const wasm = new URL("../pkg/solver/solver_bg.wasm", import.meta.url);
const second = new URL("../pkg/solver/split_deferred.wasm", import.meta.url);

let isLoaded = false;

/** What the solver can do without a session. @throws {Failure} where it has not been built */
export async function loadSolver() {
  if (!existsSync(wasm)) {
    const hint = "Run `npm run build` once in the project's folder.";
    throw new Failure(2, "NotBuilt", "The solver has not been built yet.", hint);
  }
  const solver = await import(glue.href);
  if (!isLoaded) {
    const { provide } = await import("../deferred.js");
    provide(() => new WebAssembly.Module(readFileSync(second)));
    solver.initSync({ module: readFileSync(wasm) });
  }
  isLoaded = true;
  return solver;
}

/** @returns {Promise<Session>} */
export async function openSession() {
  const { Session } = await loadSolver();
  return new Session();
}

/** @returns {string} */
export function packageVersion() {
  const file = new URL("../../package.json", import.meta.url);
  return JSON.parse(readFileSync(file, "utf8")).version;
}
