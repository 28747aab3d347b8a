// @ts-check
// What must be fetched before the first picture, compressed as a web server would.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { until, untilDrawn, useSite } from "./support/app.js";

/** In kB of 1000 bytes. The solver is fetched after the first picture. */
const BOUND = 350;

const site = useSite();

test("the first picture takes little to fetch", async (context) => {
  const { page, faults, close } = await site.blank();
  /** @type {Promise<{ name: string, raw: number, gzipped: number }>[]} */
  const fetched = [];
  /** @type {Set<string>} a browser may ask for its icon twice */
  const seen = new Set();
  let pictured = false;
  page.on("response", (response) => {
    const name = new URL(response.url()).pathname.split("/").pop() || "index.html";
    // The plot's library comes last, and only for the plot.
    if (pictured || seen.has(name) || name.startsWith("energy-chart")) return;
    seen.add(name);
    fetched.push(
      response.body().then((body) => ({
        name,
        raw: body.length,
        gzipped: gzipSync(body, { level: 9 }).length,
      })),
    );
  });
  // The solver is held up for good: the picture must come without it.
  await page.route(/solver_bg[^/]*\.wasm$/, () => {});
  await page.goto(`${site.url}?msaa=1`);
  await untilDrawn(page);
  pictured = true;
  const files = (await Promise.all(fetched)).sort((a, b) => b.gzipped - a.gzipped);
  const total = files.reduce((sum, { gzipped }) => sum + gzipped, 0) / 1000;
  const kilobytes = (/** @type {number} */ bytes) => (bytes / 1000).toFixed(1).padStart(8);
  context.diagnostic("     raw  gzipped  kB");
  for (const { name, raw, gzipped } of files) {
    context.diagnostic(`${kilobytes(raw)} ${kilobytes(gzipped)}  ${name}`);
  }
  context.diagnostic(`         ${kilobytes(1000 * total)}  kB; at most ${BOUND} kB`);
  // The viewer, the page, its script and style.
  assert.ok(files.length >= 4, `only ${files.map(({ name }) => name)}`);
  assert.ok(total <= BOUND, `${total.toFixed(1)} kB, more than ${BOUND} kB`);
  assert.deepEqual(faults, []);
  await close();
});

test("the plot's library waits for the first picture", async () => {
  const { page, faults, close } = await site.blank();
  /** @type {string[]} */
  const order = [];
  page.on("request", (request) => order.push(request.url()));
  // The graphics are held up: the solver is ready, and there is something to plot.
  /** @type {() => void} */
  let release = () => {};
  const held = new Promise((resolve) => {
    release = () => resolve(undefined);
  });
  await page.route(/viewer_bg[^/]*\.wasm$/, (route) => held.then(() => route.continue()));
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  const asked = () => order.some((url) => url.includes("energy-chart"));
  assert.equal(asked(), false);
  release();
  await page.locator("#plot canvas").waitFor();
  assert.equal(asked(), true);
  assert.deepEqual(faults, []);
  await close();
});
