// @ts-check
// What must be fetched before there is anything to see but the surface, which the solver makes;
// compressed as a web server would.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { untilDrawn, useSite } from "./support/app.js";

/** In kB of 1000 bytes, with the fonts. */
const BOUND = 199.5;

const site = useSite();

/** @param {string} address */
const nameOf = (address) => new URL(address).pathname.split("/").pop() || "index.html";

test("the page and its viewer take little to fetch", async (context) => {
  const { page, faults, close } = await site.blank();
  /** @type {Promise<{ name: string, raw: number, gzipped: number }>[]} */
  const fetched = [];
  /** @type {Set<string>} a browser may ask for its icon twice */
  const seen = new Set();
  page.on("response", (response) => {
    const name = nameOf(response.url());
    if (seen.has(name)) return;
    seen.add(name);
    // What is held up has no body.
    const measured = response.body().then(
      (body) => ({ name, raw: body.length, gzipped: gzipSync(body, { level: 9 }).length }),
      () => ({ name, raw: 0, gzipped: 0 }),
    );
    fetched.push(measured);
  });
  // The solver is held up for good: the page must come without it.
  await page.route(/solver_bg[^/]*\.wasm$/, () => {});
  await page.goto(`${site.url}?msaa=1`);
  await untilDrawn(page);
  // What was asked for once the picture was there is for what may come after.
  const before = await page.evaluate(() => {
    const [mark] = performance.getEntriesByName("first-picture");
    const all = performance.getEntriesByType("resource");
    return all.filter((one) => one.startTime < mark.startTime).map((one) => one.name);
  });
  const names = ["index.html", ...before.map(nameOf)];
  const all = await Promise.all(fetched);
  const files = all
    .filter(({ name, raw }) => names.includes(name) && raw > 0)
    .sort((a, b) => b.gzipped - a.gzipped);
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
