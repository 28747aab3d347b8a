// Every check of the source that needs no test run, cheapest first.

import { copyFileSync } from "node:fs";
import path from "node:path";
import { root, run, runNode, targetDir } from "./process.js";

/** @typedef {{ title: string, run: () => unknown }} Check */

/** @type {Check[]} */
export const formatChecks = [
  { title: "Format of the Rust source", run: () => run("cargo", ["fmt", "--check"]) },
  {
    title: "Format and lint of the JavaScript source",
    run: () => runNode(["node_modules/@biomejs/biome/bin/biome", "ci", "--error-on-warnings"]),
  },
];

/**
 * The documentation of the Rust source. Its formulas are set by the browser that shows it, with
 * nothing fetched from elsewhere.
 */
export function buildDocumentation() {
  const header = path.join(root, "www", "tools", "formulas.html");
  const flags = ["-D", "warnings", "--html-in-header", header].join("\x1f");
  run("cargo", ["doc", "--locked", "--no-deps", "--lib", "--document-private-items"], {
    CARGO_ENCODED_RUSTDOCFLAGS: flags,
  });
  const setter = path.join(root, "node_modules", "temml", "dist", "temml.min.js");
  copyFileSync(setter, path.join(targetDir, "doc", "temml.min.js"));
}

/** @param {string} what @param {string[]} targets */
const clippy = (what, ...targets) => ({
  title: `Clippy, ${what}`,
  run: () => run("cargo", ["clippy", "--locked", ...targets, "--", "-D", "warnings"]),
});
const wasm = ["--target", "wasm32-unknown-unknown", "--lib", "--no-default-features", "--features"];

/** @type {Check[]} */
export const rustChecks = [
  clippy("native", "--all-targets"),
  clippy("the solver in wasm", ...wasm, "solver,split"),
  clippy("the viewer in wasm", ...wasm, "viewer"),
  clippy("the viewer for WebGL2 in wasm", ...wasm, "viewer-webgl"),
  { title: "Links in the Rust documentation", run: buildDocumentation },
];

/** Of the wasm files too, as the build has written them. @type {Check} */
export const typeCheck = {
  title: "Types of the JavaScript source",
  run: () => runNode(["node_modules/typescript/bin/tsc", "--project", "tsconfig.json"]),
};
