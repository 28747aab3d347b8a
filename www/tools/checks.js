// Every check of the source that needs no test run, cheapest first.

import { existsSync } from "node:fs";
import path from "node:path";
import { buildDocumentation } from "./documentation.js";
import { root, run, runNode } from "./process.js";
import { buildWasm } from "./wasm.js";

const wasm = ["--target", "wasm32-unknown-unknown", "--lib", "--no-default-features"];
const deny = ["--", "-D", "warnings"];

/** @typedef {{ title: string, run: () => void }} Check */

/** @type {Check[]} */
export const formatChecks = [
  { title: "Format of the Rust source", run: () => run("cargo", ["fmt", "--check"]) },
  {
    title: "Format and lint of the JavaScript source",
    run: () => runNode(["node_modules/@biomejs/biome/bin/biome", "ci", "--error-on-warnings"]),
  },
];

/** @type {Check[]} */
export const rustChecks = [
  {
    title: "Clippy, native",
    run: () => run("cargo", ["clippy", "--locked", "--all-targets", ...deny]),
  },
  {
    title: "Clippy, the solver in wasm",
    run: () => run("cargo", ["clippy", "--locked", ...wasm, "--features", "solver", ...deny]),
  },
  {
    title: "Clippy, the viewer in wasm",
    run: () => run("cargo", ["clippy", "--locked", ...wasm, "--features", "viewer", ...deny]),
  },
  {
    title: "Clippy, the viewer for WebGL2 in wasm",
    run: () => run("cargo", ["clippy", "--locked", ...wasm, "--features", "viewer-webgl", ...deny]),
  },
  {
    title: "Links in the Rust documentation",
    run: buildDocumentation,
  },
];

/** @type {Check} */
export const typeCheck = {
  title: "Types of the JavaScript source",
  run: () => {
    // The types of the wasm files are written by the build.
    if (!existsSync(path.join(root, "www", "pkg", "viewer-webgl"))) buildWasm();
    runNode(["node_modules/typescript/bin/tsc", "--project", "tsconfig.json"]);
  },
};
