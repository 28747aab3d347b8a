// @ts-check
// A browser for a test file, and pages that remember what went wrong on them.

import { chromium } from "playwright-core";
import { chromiumSwitches, ensureChromium } from "./chromium.js";
import { decodePng } from "./png.js";

/** @typedef {import("playwright-core").Browser} Browser */
/** @typedef {import("playwright-core").BrowserContextOptions} ContextOptions */

/**
 * @param {import("./chromium.js").Graphics} [options]
 * @returns {Promise<Browser>}
 */
export async function launch(options) {
  return chromium.launch({
    executablePath: await ensureChromium(),
    headless: true,
    args: chromiumSwitches(options),
  });
}

/**
 * A fresh page and the list of everything that goes wrong on it: exceptions, console
 * errors, failed requests. Whether a test tolerates an entry is for the test to say;
 * most end with `assert.deepEqual(faults, [])`.
 * @param {Browser} browser
 * @param {ContextOptions} [options]  viewport, colour scheme, …
 */
export async function openPage(browser, options = {}) {
  // Without a service worker, whose fetching would be in the way of whatever is measured.
  const context = await browser.newContext({
    viewport: { width: 1000, height: 700 },
    serviceWorkers: "block",
    ...options,
  });
  const page = await context.newPage();
  /** @type {string[]} */
  const faults = [];
  /**
   * @param {string} fault
   * @param {string} url  the browser fetches the icon of a tab by itself, and drops it; a worker
   *   fetches a blob to see whether it was revoked
   */
  const add = (fault, url) =>
    /\/icon-[^/]*\.svg$|^blob:/.test(url) || faults.push(`${fault} ${url}`.trim());
  page.on("pageerror", (error) => faults.push(`exception: ${error.message}`));
  page.on("crash", () => faults.push("the page crashed"));
  page.on("requestfailed", (request) => add("request failed:", request.url()));
  page.on("console", (message) => {
    if (message.type() === "error") add(`console: ${message.text()}`, message.location().url);
  });
  return { page, faults, close: () => context.close() };
}

/** @typedef {{ width: number, height: number, colours: number, mean: number[] }} Measured */

/**
 * The pixels that an element shows, as they reached the screen.
 * @param {import("playwright-core").Locator} locator
 */
export async function picture(locator) {
  return measure(await locator.screenshot());
}

/**
 * @param {Buffer} png
 * @returns {{ width: number, height: number, colours: number, mean: number[] }}
 *   size, number of different colours, mean of red, green and blue (0 to 255)
 */
export function measure(png) {
  const { width, height, channels, data } = decodePng(png);
  const seen = new Set();
  const sum = [0, 0, 0];
  for (let i = 0; i < data.length; i += channels) {
    seen.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    for (let channel = 0; channel < 3; channel++) sum[channel] += data[i + channel];
  }
  const mean = sum.map((value) => value / (width * height));
  return { width, height, colours: seen.size, mean };
}

/**
 * How much two pictures of one size differ: of a pixel, the channel that differs most
 * (0 to 255); of all pixels, the mean and the 95th percentile.
 * @param {Buffer} first
 * @param {Buffer} second
 */
export function difference(first, second) {
  const [a, b] = [decodePng(first), decodePng(second)];
  if (a.width !== b.width || a.height !== b.height) {
    throw new Error(`${a.width} × ${a.height} against ${b.width} × ${b.height} pixels`);
  }
  const apart = new Float64Array(a.width * a.height).map((_, pixel) => {
    const [i, j] = [pixel * a.channels, pixel * b.channels];
    return Math.max(...[0, 1, 2].map((c) => Math.abs(a.data[i + c] - b.data[j + c])));
  });
  const mean = apart.reduce((sum, value) => sum + value, 0) / apart.length;
  return { mean, percentile95: apart.sort()[Math.floor(0.95 * apart.length)] };
}
