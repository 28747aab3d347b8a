// `npm test`: everything that must hold, on a machine that has only Rust and Node.
// What fails fast comes first; the browser meets the site as it is shipped, which is built while Rust
// is tested: most of that is one compiler at a time, of the program as a whole.

import { readdirSync } from "node:fs";
import path from "node:path";
import { ensureChromium } from "../../tests/web/support/chromium.js";
import { ensureFirefox } from "../../tests/web/support/firefox.js";
import { ensureWebkit } from "../../tests/web/support/webkit.js";
import { formatChecks, rustChecks, typeCheck } from "./checks.js";
import { prerequisites } from "./prerequisites.js";
import { root, run, runLater, runNode, say, script } from "./process.js";

const folder = path.join("tests", "web");
const files = readdirSync(path.join(root, folder)).filter((file) => file.endsWith(".test.js"));
const commandLine = files.filter((file) => file.startsWith("cli"));
/** What counts pictures, or how soon something is answered, has the machine to itself. */
const timed = ["page-first-visit", "page-run"].map((name) => `${name}.test.js`);
const browser = files.filter((file) => !file.startsWith("cli") && !timed.includes(file));

/** @param {string[]} names @param {number} [atOnce]  so many files */
function nodeTests(names, atOnce = 2) {
  const paths = names.map((name) => path.join(folder, name));
  // What waits for ever is to be told, and not to be waited for.
  runNode(["--test", "--test-timeout=900000", `--test-concurrency=${atOnce}`, ...paths]);
}

/** Chromium must be there; what is missing of the others is said, and their tests are skipped. */
async function browsers() {
  await ensureChromium();
  if (!ensureFirefox()) say("No Firefox here: its test is skipped");
  if (!ensureWebkit()) say("No WebKitGTK here: its test is skipped");
}

/** @type {Promise<void>} */
let built = Promise.resolve();
function beginBuild() {
  built = runLater(process.execPath, ["www/tools/task.js", "build"]);
}

/** @type {{ title: string, run: () => unknown }[]} */
const checks = [
  { title: "Node, node packages, Rust", run: prerequisites },
  ...formatChecks,
  // Looked for now: to find none after ten minutes would be unkind.
  { title: "Browsers for the browser tests", run: browsers },
  { title: "The wasm files and the site begin to be built", run: beginBuild },
  ...rustChecks,
  { title: "Rust tests", run: () => run("cargo", ["test", "--locked"]) },
  { title: "Wasm files and static site", run: () => built },
  typeCheck,
  { title: "Command line tests", run: () => nodeTests(commandLine) },
  { title: "Browser tests", run: () => nodeTests(browser) },
  { title: "Browser tests by the clock", run: () => nodeTests(timed, 1) },
];

await script(async () => {
  /** @type {string[]} */
  const times = [];
  for (const check of checks) {
    say(check.title);
    const start = performance.now();
    await check.run();
    const seconds = (performance.now() - start) / 1000;
    times.push(`${seconds.toFixed(1).padStart(8)} s  ${check.title}`);
  }
  say("All checks passed");
  console.log(times.join("\n"));
});
