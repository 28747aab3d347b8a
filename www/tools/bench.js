// `npm run bench`: the Rust benchmarks, the command line's tables, and tasks of the page.

import { prerequisites } from "./prerequisites.js";
import { run, runNode, say, script } from "./process.js";
import { buildSite } from "./site.js";
import { buildWasm } from "./wasm.js";

await script(() => {
  prerequisites();
  say("Rust benchmarks");
  run("cargo", ["bench", "--locked", "--bench", "*"]);
  buildWasm();
  say("A step of the circle-angle flow in wasm");
  runNode(["www/cli.js", "bench", "--table", "circle", ...process.argv.slice(2)]);
  say("How long the page does not answer");
  buildSite();
  runNode(["tests/web/responsiveness.js"]);
});
