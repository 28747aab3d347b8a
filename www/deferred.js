// The solver's second wasm file (src/deferred.rs). Rust waits for no promise, so whoever runs the
// solver says how to come by the file at once.

import { initSync } from "./pkg/solver/solver.js";

/** @type {() => WebAssembly.Module} */
let compile = () => {
  throw new Error("nobody has said where the rest of the solver is");
};
let isThere = false;

/** @param {() => WebAssembly.Module} how  to come by the file; may throw */
export function provide(how) {
  compile = how;
}

/**
 * The splitter knows the name. Tells a function of the solver, by its index, whether the file is there.
 * @param {number} callback @param {number} data  to be given back
 */
export function __wasm_split_load_deferred(callback, data) {
  const solver = /** @type {any} */ (initSync)();
  try {
    if (!isThere) new WebAssembly.Instance(compile(), { __wasm_split: solver });
    isThere = true;
  } catch (error) {
    console.error(error);
  }
  solver.__indirect_function_table.get(callback)(data, isThere);
}
