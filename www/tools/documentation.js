// The documentation of the Rust source. Its formulas are set by the browser that shows it, with
// nothing fetched from elsewhere.

import { copyFileSync } from "node:fs";
import path from "node:path";
import { root, run, targetDir } from "./process.js";

export function buildDocumentation() {
  const header = path.join(root, "www", "tools", "formulas.html");
  run("cargo", ["doc", "--locked", "--no-deps", "--lib", "--document-private-items"], {
    env: {
      CARGO_ENCODED_RUSTDOCFLAGS: ["-D", "warnings", "--html-in-header", header].join("\x1f"),
    },
  });
  const setter = path.join(root, "node_modules", "temml", "dist", "temml.min.js");
  copyFileSync(setter, path.join(targetDir, "doc", "temml.min.js"));
}
