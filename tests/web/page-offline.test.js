// @ts-check
// After the first visit the site needs no connection; a new version takes the place of the old
// one as a whole, or not at all.

import assert from "node:assert/strict";
import {
  cpSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { writeServiceWorker } from "../../www/tools/service-worker.js";
import { button, until, untilDrawn, useSite } from "./support/app.js";
import { decodePng } from "./support/png.js";
import { site as built, serve } from "./support/server.js";

const browser = useSite();
const source = fileURLToPath(new URL("../../www/service-worker.js", import.meta.url));

/** @typedef {import("playwright-core").Page} Page */

const folder = path.join(mkdtempSync(path.join(tmpdir(), "umbilic-site-")), "site");
/** @type {Awaited<ReturnType<typeof serve>>} */
let server;
before(async () => {
  cpSync(built, folder, { recursive: true });
  server = await serve(folder);
});
after(async () => {
  await server?.close();
  rmSync(path.dirname(folder), { recursive: true, force: true });
});

/** The server comes back where it was. */
async function restart() {
  server = await serve(folder, undefined, Number(new URL(server.url).port));
}

/** Another version: its script has another name, and leaves a mark. @param {string} mark */
function deploy(mark) {
  const assets = path.join(folder, "assets");
  const old = readdirSync(assets).find((file) => /^index-.*\.js$/.test(file)) ?? "";
  const next = `index-${mark}.js`;
  renameSync(path.join(assets, old), path.join(assets, next));
  writeFileSync(
    path.join(assets, next),
    `globalThis.mark = ${JSON.stringify(mark)};\n${readFileSync(path.join(assets, next), "utf8")}`,
  );
  for (const file of readdirSync(assets).filter((name) => name.endsWith(".js"))) {
    const whole = path.join(assets, file);
    writeFileSync(whole, readFileSync(whole, "utf8").replaceAll(old, next));
  }
  const index = path.join(folder, "index.html");
  const html = readFileSync(index, "utf8").replaceAll(old, next);
  writeFileSync(
    index,
    html.replace('name="description" content="', `name="description" content="${mark}: `),
  );
  writeServiceWorker(folder, source);
}

/** What is kept: names of caches, and how many files are in each. @param {Page} page */
const kept = (page) =>
  page.evaluate(async () => {
    const sizes = [];
    for (const name of await caches.keys()) {
      sizes.push((await (await caches.open(name)).keys()).length);
    }
    return sizes;
  });

/** Leaving in the middle of a fetch would be a failed request. @param {Page} page */
const quiet = (page) => page.waitForLoadState("networkidle");

/** @param {Page} page */
const mark = (page) => page.evaluate(() => /** @type {any} */ (globalThis).mark ?? "first");

test("without a connection the page opens, draws and steps; versions do not mix", async () => {
  const { page, faults, close } = await browser.blank({ serviceWorkers: "allow" });
  await page.goto(`${server.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await page.evaluate(() => navigator.serviceWorker.ready);
  assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null, "not yet");

  await server.close();
  await quiet(page);
  await page.goto(`${server.url}?msaa=1&again#sample=pipe&colour=mean-curvature`);
  await until(page, "Ready");
  await untilDrawn(page);
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  // A dialog's pages, by their own script; and the index by its name.
  await quiet(page);
  await page.goto(`${server.url}index.html?msaa=1&embed#sample=coarse-torus`);
  await until(page, "Ready");
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");

  // A deployment under way: the list is new and the files are not. Nothing changes.
  await restart();
  const script = path.join(folder, "service-worker.js");
  const first = readFileSync(script, "utf8");
  writeFileSync(
    script,
    first.replace(/(built = \{"version":")\w+/, "$1half").replace(/sha256-..../, "sha256-AAAA"),
  );
  await quiet(page);
  await page.goto(`${server.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  const failed = await page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    await registration.update().catch(() => {});
    const next = registration.installing;
    if (next) {
      await new Promise((resolve) => {
        next.addEventListener("statechange", () => next.state === "redundant" && resolve(null));
        if (next.state === "redundant") resolve(null);
      });
    }
    return { installing: registration.installing, waiting: registration.waiting };
  });
  assert.deepEqual(failed, { installing: null, waiting: null });
  assert.equal(await mark(page), "first");

  // The whole of it: this page stays what it is and says so, the next one is new.
  deploy("second");
  await page.evaluate(async () => (await navigator.serviceWorker.ready).update());
  await page
    .locator(".status")
    .getByText(/new version is ready\. Reload/)
    .waitFor();
  assert.equal(await mark(page), "first");
  await server.close();
  await quiet(page);
  await page.reload();
  await until(page, "Ready");
  await untilDrawn(page);
  assert.equal(await mark(page), "second");
  assert.match(
    (await page.locator("meta[name=description]").getAttribute("content")) ?? "",
    /^second/,
  );
  await button(page, "Step").click();
  await until(page, "Paused at step 1");

  // Once nobody needs it, the old version is gone, and everything of the new one is there.
  await restart();
  await quiet(page);
  await page.reload();
  const all = readdirSync(folder, { recursive: true, withFileTypes: true });
  const files = all.filter((entry) => entry.isFile()).length - 1;
  for (const end = Date.now() + 60_000; ; await page.waitForTimeout(250)) {
    const sizes = await kept(page);
    if (sizes.length === 1 && sizes[0] === files) break;
    assert.ok(Date.now() < end, `kept are ${sizes}, of ${files}`);
  }
  // Views that come after a step may not have come when the page was left.
  assert.deepEqual(
    faults.filter((fault) => !fault.startsWith("request failed")),
    [],
  );
  await close();
});

test("it can be installed: a manifest with icons of the sizes it names", async () => {
  const manifest = JSON.parse(readFileSync(path.join(built, "manifest.webmanifest"), "utf8"));
  assert.equal(manifest.name, "Umbilic");
  for (const key of ["start_url", "scope", "id"]) assert.equal(manifest[key], "./", key);
  assert.ok(manifest.icons.some((/** @type {any} */ { purpose }) => purpose === "maskable"));
  for (const { src, sizes } of manifest.icons) {
    const { width, height } = decodePng(readFileSync(path.join(built, src)));
    assert.equal(`${width}x${height}`, sizes, src);
  }
  const { page, faults, close } = await browser.open();
  const href = await page.locator("link[rel=manifest]").getAttribute("href");
  assert.equal(href, "./manifest.webmanifest");
  const session = await page.context().newCDPSession(page);
  const { errors, data } = await session.send("Page.getAppManifest");
  assert.deepEqual(errors, []);
  assert.ok(data);
  assert.deepEqual(faults, []);
  await close();
});

test("where no service worker is allowed the page says nothing of it", async () => {
  const { page, faults, close } = await browser.blank();
  await page.addInitScript(() => {
    Object.defineProperty(Navigator.prototype, "serviceWorker", { get: () => undefined });
  });
  await page.goto(`${browser.url}?msaa=1`);
  await until(page, "Ready");
  await untilDrawn(page);
  assert.equal(await page.getByRole("alert").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});
