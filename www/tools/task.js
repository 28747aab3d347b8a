// `npm run build`, `start`, `lint`, `doc` and `bench`: `node www/tools/task.js NAME`.

import { buildDocumentation, formatChecks, rustChecks, typeCheck } from "./checks.js";
import { prerequisites } from "./prerequisites.js";
import { run, runNode, say, script } from "./process.js";
import { buildHalf, buildWasm } from "./wasm.js";

const [name, ...others] = process.argv.slice(2);
// Through node and not npx: ending this process then ends vite as well.
const vite = ["node_modules/vite/bin/vite.js", "--config", "www/vite.config.js"];

/** Writes the static site: every address in it is relative, so any folder of any host will do. */
function buildSite() {
  say("Writing the static site to dist");
  runNode([...vite, "build", "--logLevel", "warn"]);
}

/** @type {Record<string, () => unknown>} */
const tasks = {
  /** Both wasm halves and the static site in `dist`. */
  build() {
    buildWasm();
    buildSite();
  },
  /**
   * From a fresh clone to the page in the browser. The viewer for browsers without WebGPU, which
   * takes as long to compile as all else, follows when one asks for it (`webgl.js`).
   */
  start() {
    buildHalf("solver", "quick");
    buildHalf("viewer", "quick");
    say("Serving the page; Ctrl-C ends it");
    runNode([...vite, ...others]);
  },
  /** Format, lints and types, nothing run. */
  lint() {
    for (const check of [...formatChecks, ...rustChecks, typeCheck]) {
      say(check.title);
      check.run();
    }
  },
  /** The documentation of the Rust source, in `target/doc/umbilic`. */
  doc: buildDocumentation,
  /** The Rust benchmarks, the command line's tables, and tasks of the page. */
  bench() {
    say("Rust benchmarks");
    run("cargo", ["bench", "--locked", "--bench", "*"]);
    buildWasm();
    say("A step of the circle-angle flow in wasm");
    runNode(["www/cli.js", "bench", "--table", "circle", ...others]);
    say("How long the page does not answer");
    buildSite();
    runNode(["tests/web/responsiveness.js"]);
  },
};

await script(() => {
  prerequisites();
  tasks[name]();
});
