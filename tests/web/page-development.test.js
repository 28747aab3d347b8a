// @ts-check
// What `npm start` serves, file by file, looks as the site that is shipped, and breaks no rule of
// the page's policy.

import assert from "node:assert/strict";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { createServer } from "vite";
import { button, openTab, until, useSite } from "./support/app.js";

const site = useSite();

/**
 * Where things lie once a run has ended and what comes later is there.
 * @param {string} url
 */
async function layout(url) {
  const { page, faults, close } = await site.blank({ viewport: { width: 1280, height: 720 } });
  await page.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) =>
      console.error(`${violatedDirective}: ${blockedURI}`),
    );
  });
  await page.goto(`${url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await openTab(page, "Flow");
  await button(page, "Play").click();
  await until(page, /^Converged/);
  const parts = [
    "#dock",
    ".dock-rows",
    ".play",
    ".curve",
    "#surface",
    "[role=tabpanel]",
    "[role=tablist]",
  ];
  const boxes = [];
  for (const part of parts) {
    const box = await page.locator(part).first().boundingBox();
    boxes.push([part, box && Object.values(box).map(Math.round)]);
  }
  assert.deepEqual(faults, []);
  await close();
  return boxes;
}

test("the development server shows the page as it is shipped", async () => {
  const configFile = fileURLToPath(new URL("../../www/vite.config.js", import.meta.url));
  const server = await createServer({ configFile, logLevel: "error", server: { port: 0 } });
  try {
    await server.listen();
    const address = server.resolvedUrls?.local[0] ?? "";
    assert.deepEqual(await layout(address), await layout(site.url));
  } finally {
    await server.close();
  }
});
