// `npm run build`, `start`, `lint`, `doc` and `bench`: `node www/tools/task.js NAME`.

import { buildDocumentation, formatChecks, rustChecks, typeCheck } from "./checks.js";
import { buildLater } from "./half.js";
import { prerequisites } from "./prerequisites.js";
import { run, runNode, say, script } from "./process.js";
import { buildHalf } from "./wasm.js";

const [name, ...others] = process.argv.slice(2);
// Through node and not npx: ending this process then ends vite as well.
const vite = ["node_modules/vite/bin/vite.js", "--config", "www/vite.config.js"];

/** Writes the static site: every address in it is relative, so any folder of any host will do. */
function buildSite() {
  say("Writing the static site to dist");
  runNode([...vite, "build", "--logLevel", "warn"]);
}

/**
 * The solver's wasm file, and others meanwhile: the end of each is one compiler's, of the program as a
 * whole.
 * @param {import("./wasm.js").Profile} profile @param {import("./wasm.js").Half[]} viewers
 */
async function buildWasm(profile, ...viewers) {
  const others = viewers.map((name) => buildLater(name, profile));
  buildHalf("solver", profile);
  await Promise.all(others);
}

const buildRelease = () => buildWasm("release", "viewer", "viewer-webgl");

/** @type {Record<string, () => unknown>} */
const tasks = {
  /** All wasm files and the static site in `dist`. */
  async build() {
    await buildRelease();
    buildSite();
  },
  /**
   * From a fresh clone to the page in the browser. The viewer for browsers without WebGPU, which
   * takes as long to compile as all else, follows when one asks for it (`webgl.js`).
   */
  async start() {
    await buildWasm("quick", "viewer");
    say("Serving the page; Ctrl-C ends it");
    runNode([...vite, ...others]);
  },
  /** Format, lints and types, nothing run. */
  async lint() {
    for (const check of [...formatChecks, ...rustChecks]) {
      say(check.title);
      check.run();
    }
    // The types of the wasm files are written by the build.
    await buildRelease();
    say(typeCheck.title);
    typeCheck.run();
  },
  /** The documentation of the Rust source, in `target/doc/umbilic`. */
  doc: buildDocumentation,
  /** The Rust benchmarks, the command line's tables, and tasks of the page. */
  async bench() {
    say("Rust benchmarks");
    run("cargo", ["bench", "--locked", "--bench", "*"]);
    await buildRelease();
    say("A step of the circle-angle flow in wasm");
    runNode(["www/cli.js", "bench", "--table", "circle", ...others]);
    say("How long the page does not answer");
    buildSite();
    runNode(["tests/web/responsiveness.js"]);
  },
};

await script(() => {
  prerequisites();
  return tasks[name]();
});
