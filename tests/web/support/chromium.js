// @ts-check
// Finds a Chromium for the browser tests, installs one where that is possible, and
// knows the switches under which it draws WebGPU without a graphics card.

import { findProgram, installPackages, isExecutable, succeeds } from "./programs.js";

const names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const places = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  "C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe",
];

/**
 * An installed Chromium: `CHROMIUM_PATH` first, then what is on the PATH, then the
 * usual places.
 * @returns {string | null}
 */
export function findChromium() {
  return findProgram(names, places, "CHROMIUM_PATH");
}

/**
 * As {@link findChromium}; when there is none, the system's package where this
 * process may install it, else Playwright's own download.
 * @returns {Promise<string>} path of the program
 * @throws {Error} with the ways out, when no way worked
 */
export async function ensureChromium() {
  const found = findChromium() ?? installPackage() ?? (await downloadChromium());
  if (found) return found;
  throw new Error(
    "The browser tests need Chromium and none could be found or installed. " +
      "Install the package `chromium` or Google Chrome, or set CHROMIUM_PATH.",
  );
}

function installPackage() {
  installPackages(["chromium"]);
  return findChromium();
}

async function downloadChromium() {
  const { chromium } = await import("playwright-core");
  const program = chromium.executablePath();
  if (isExecutable(program)) return program;
  console.log("  downloading Playwright's Chromium");
  succeeds(process.execPath, ["node_modules/playwright-core/cli.js", "install", "chromium"]);
  return isExecutable(program) ? program : null;
}

/**
 * Command line switches for tests.
 *
 * On Linux all four graphics switches are needed for a canvas: with fewer the
 * adapter is there, but the first frame loses the device. `--disable-gpu` and
 * `--disable-vulkan-surface` must not be added: the canvas then stays blank, without
 * an error. Elsewhere the machine's own graphics are used.
 * @typedef {object} Graphics
 * @property {boolean} [webgpu]  false: as a browser without WebGPU
 * @property {boolean} [webgl]   false: without WebGL as well
 */

/**
 * @param {Graphics} [options]
 * @returns {string[]}
 */
export function chromiumSwitches({ webgpu = true, webgl = true } = {}) {
  const quiet = [
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
  ];
  const sandbox = process.getuid?.() === 0 ? ["--no-sandbox"] : [];
  const software = [
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
  ];
  const graphics = ["--enable-unsafe-webgpu", ...(process.platform === "linux" ? software : [])];
  const webglAlone = process.platform === "linux" ? ["--use-angle=swiftshader"] : [];
  const without = webgl ? webglAlone : ["--disable-3d-apis"];
  return [...quiet, ...sandbox, ...(webgpu ? graphics : without)];
}
