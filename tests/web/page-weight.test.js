// @ts-check
// What must be fetched before there is anything to see but the surface, which the solver makes;
// compressed as a web server would.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { untilDrawn, useSite } from "./support/app.js";

/** In kB of 1000 bytes, with the fonts. */
const BOUND = 250;

const site = useSite();

test("the page and its viewer take little to fetch", async (context) => {
  const { page, faults, close } = await site.blank();
  /** @type {Promise<{ name: string, raw: number, gzipped: number }>[]} */
  const fetched = [];
  /** @type {Set<string>} a browser may ask for its icon twice */
  const seen = new Set();
  let pictured = false;
  page.on("response", (response) => {
    const name = new URL(response.url()).pathname.split("/").pop() || "index.html";
    if (pictured || seen.has(name)) return;
    seen.add(name);
    fetched.push(
      response.body().then((body) => ({
        name,
        raw: body.length,
        gzipped: gzipSync(body, { level: 9 }).length,
      })),
    );
  });
  // The solver is held up for good: the page must come without it.
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
