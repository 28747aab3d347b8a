// @ts-check
// What must be fetched before there is anything to see but the surface, which the solver makes;
// compressed as a web server would.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { button, openTab, until, untilDrawn, useSite } from "./support/app.js";
import { serve } from "./support/server.js";

/** In kB of 1000 bytes, with the fonts. */
const BOUND = 199.5;
/** The same of everything that a first run fetches. */
const RUN_BOUND = 600;

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

test("a first run takes little to fetch; the rest comes when it is asked for", async (context) => {
  const { page, faults, close } = await site.blank({ serviceWorkers: "block" });
  /** @type {Map<string, Promise<number>>} */
  const fetched = new Map();
  page.on("response", (response) => {
    const size = response.body().then(
      (body) => gzipSync(body, { level: 9 }).length,
      () => 0,
    );
    fetched.set(nameOf(response.url()), size);
  });
  let server = await serve();
  // A server that is left open keeps the whole run waiting.
  context.after(() => server.close());
  await page.goto(server.url);
  await until(page, "Ready");
  const sizes = await Promise.all([...fetched].map(async ([name, size]) => [name, await size]));
  sizes.sort(([, a], [, b]) => Number(b) - Number(a));
  for (const [name, size] of sizes) context.diagnostic(`${Number(size) / 1000} kB  ${name}`);
  const total = sizes.reduce((sum, [, size]) => sum + Number(size), 0) / 1000;
  context.diagnostic(`${total.toFixed(1)} kB; at most ${RUN_BOUND} kB`);
  assert.ok(total <= RUN_BOUND, `${total} kB`);

  // The tab is fetched when it is opened; then there is no connection any more.
  await openTab(page, "Flow");
  await server.close();
  await button(page, "Play").click();
  await until(page, /^Converged/);
  const other = page.getByRole("option", { name: /^p-Willmore/ });
  await other.click();
  await page.getByText("part of the program that this needs could not be fetched").waitFor();
  await until(page, /^Converged/);
  server = await serve(undefined, undefined, Number(new URL(server.url).port));
  await other.click();
  await until(page, "Ready");
  await button(page, "Play").click();
  await until(page, /^Converged/);
  await openTab(page, "Surface");
  const own = faults.filter((fault) => !/request failed|NetworkError|ERR_/.test(fault));
  assert.deepEqual(own, []);
  await close();
});
