// @ts-check
// The page under its own security policy: nothing it does is forbidden by it, and nothing
// leaves the host it came from, whatever is asked of it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { colourBy, download, openMesh, playAndPause, untilDrawn, useSite } from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

test("the policy forbids inline script, eval and other hosts", async () => {
  const { page, faults, close } = await site.open();
  const policy = await page
    .locator("meta[http-equiv=Content-Security-Policy]")
    .getAttribute("content");
  const rules = Object.fromEntries(
    (policy ?? "").split(";").map((rule) => {
      const [name, ...sources] = rule.trim().split(/\s+/);
      return [name, sources];
    }),
  );
  assert.deepEqual(rules["default-src"], ["'self'"]);
  assert.deepEqual(rules["script-src"], ["'self'", "'wasm-unsafe-eval'"]);
  for (const [name, sources] of Object.entries(rules)) {
    for (const source of sources) {
      assert.match(source, /^('self'|'none'|'wasm-unsafe-eval'|blob:|data:)$/, name);
    }
  }
  assert.deepEqual(faults, []);
  await close();
});

test("a whole session breaks no rule and asks no other host", async () => {
  const { page, faults, close } = await site.blank();
  /** @type {string[]} */
  const violations = [];
  await page.exposeFunction("tellViolation", (/** @type {string} */ text) => violations.push(text));
  await page.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", (event) => {
      const { violatedDirective, blockedURI } = event;
      /** @type {any} */ (globalThis).tellViolation(`${violatedDirective}: ${blockedURI}`);
    });
  });
  /** @type {string[]} */
  const asked = [];
  page.context().on("request", (request) => asked.push(request.url()));

  await page.goto(`${site.url}?msaa=1`);
  await untilDrawn(page);
  await page.keyboard.press("Escape");
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  await colourBy(page, "Willmore energy Wᵢ");
  await playAndPause(page, 2);
  for (const format of ["PLY", "History, CSV", "Picture, PNG"]) await download(page, format);

  assert.ok(
    asked.some((url) => url.endsWith(".wasm")),
    "requests of the worker are seen as well",
  );
  assert.deepEqual(
    asked.filter((url) => !url.startsWith(site.url) && !/^(blob|data):/.test(url)),
    [],
  );
  assert.deepEqual(violations, []);
  assert.deepEqual(faults, []);
  await close();
});

test("the policy is in force", async () => {
  const { page, close } = await site.open();
  const broken = await page.evaluate(
    () =>
      new Promise((resolve) => {
        document.addEventListener("securitypolicyviolation", (event) =>
          resolve(event.violatedDirective),
        );
        fetch("https://example.org/").catch(() => {});
      }),
  );
  assert.equal(broken, "connect-src");
  await close();
});
