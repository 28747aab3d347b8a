// @ts-check
// The built site as plain files: complete, and free of addresses that tie it to a place.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { launch, openPage } from "./support/browser.js";
import { serve, site } from "./support/server.js";

test("the page names its files by relative addresses", () => {
  const html = readFileSync(path.join(site, "index.html"), "utf8");
  const addresses = [...html.matchAll(/\b(?:src|href)="([^"]*)"/g)].map((match) => match[1]);
  assert.ok(addresses.length > 0);
  assert.deepEqual(
    addresses.filter((address) => !/^(\.\/|#|data:)/.test(address)),
    [],
  );
});

test("every wasm file is there", () => {
  const files = readdirSync(path.join(site, "assets"));
  for (const half of ["solver", "viewer", "viewer-webgl"]) {
    assert.ok(
      files.some((file) => file.startsWith(`${half}_bg`) && file.endsWith(".wasm")),
      `${half} is missing among ${files.join(", ")}`,
    );
  }
});

test("the site opens in any folder and asks no other host for anything", async () => {
  const server = await serve(site, "/a/folder/of/any/host/");
  const browser = await launch();
  try {
    const { page, faults } = await openPage(browser);
    /** @type {string[]} */
    const foreign = [];
    page.on("request", (request) => {
      const { protocol } = new URL(request.url());
      const ours = request.url().startsWith(server.url) || /^(data|blob):$/.test(protocol);
      if (!ours) foreign.push(request.url());
    });
    await page.goto(server.url);
    await page.getByRole("button", { name: "Play: Watch it flow" }).waitFor();
    await page.waitForLoadState("networkidle");
    assert.deepEqual(foreign, []);
    assert.deepEqual(faults, []);
  } finally {
    await browser.close();
    await server.close();
  }
});
