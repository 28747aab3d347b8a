// `npm test`: everything that must hold, on a machine that has only Rust and Node.
// What fails fast comes first; the browser meets the site as it is shipped.

import { readdirSync } from "node:fs";
import path from "node:path";
import { ensureChromium } from "../../tests/web/support/chromium.js";
import { ensureFirefox } from "../../tests/web/support/firefox.js";
import { ensureWebkit } from "../../tests/web/support/webkit.js";
import { formatChecks, rustChecks, typeCheck } from "./checks.js";
import { prerequisites } from "./prerequisites.js";
import { root, run, runNode, say, script } from "./process.js";
import { buildSite } from "./site.js";
import { buildWasm } from "./wasm.js";

const folder = path.join("tests", "web");
const files = readdirSync(path.join(root, folder)).filter((file) => file.endsWith(".test.js"));
const commandLine = files.filter((file) => file.startsWith("cli"));
const browser = files.filter((file) => !file.startsWith("cli"));

/** One file at a time: each browser test wants the whole machine. @param {string[]} names */
function nodeTests(names) {
  if (names.length === 0) return;
  const paths = names.map((name) => path.join(folder, name));
  runNode(["--test", "--test-concurrency=1", ...paths]);
}

/** Chromium must be there; what is missing of the others is said, and their tests are skipped. */
async function browsers() {
  await ensureChromium();
  if (!ensureFirefox()) say("No Firefox here: its test is skipped");
  if (!ensureWebkit()) say("No WebKitGTK here: its test is skipped");
}

/** @type {{ title: string, run: () => unknown }[]} */
const checks = [
  { title: "Node, node packages, Rust", run: prerequisites },
  ...formatChecks,
  // Looked for now: to find none after ten minutes would be unkind.
  { title: "Browsers for the browser tests", run: browsers },
  ...rustChecks,
  { title: "Rust tests", run: () => run("cargo", ["test", "--locked"]) },
  { title: "Wasm build", run: buildWasm },
  typeCheck,
  { title: "Command line tests", run: () => nodeTests(commandLine) },
  { title: "Static site", run: buildSite },
  { title: "Browser tests", run: () => nodeTests(browser) },
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
