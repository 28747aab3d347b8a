// @ts-check
// How long the page does not answer while a large mesh is loaded, flows and is coloured: tasks of
// its main thread over 50 ms, on the built site. `node tests/web/responsiveness.js [vertices …]`.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { button, colourBy, openTab, until } from "./support/app.js";
import { launch, openPage } from "./support/browser.js";
import { binaryPly, wavyTorus } from "./support/meshes.js";
import { serve } from "./support/server.js";

/** Milliseconds that each part is watched for. */
const WATCHED = 15_000;
const sizes = process.argv.slice(2).map(Number);
const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
const server = await serve();
const browser = await launch();

/**
 * Tasks of the main thread while something is done: how long each took, and how long it computed,
 * rather than waited for the graphics device or for a turn of the processor.
 * @param {import("playwright-core").Page} page
 * @param {() => Promise<unknown>} act
 * @returns {Promise<{ lasted: number[], computed: number[] }>}  in milliseconds
 */
async function watched(page, act) {
  await browser.startTracing(page, { categories: ["toplevel", "__metadata"] });
  await act();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  /** @type {any[]} */
  const events = traceEvents;
  const threads = events.filter(
    ({ name, args }) => name === "thread_name" && args.name === "CrRendererMain",
  );
  const main = new Set(threads.map(({ pid, tid }) => `${pid} ${tid}`));
  const tasks = events.filter(
    ({ name, pid, tid, tdur }) =>
      name === "ThreadControllerImpl::RunTask" && main.has(`${pid} ${tid}`) && tdur > 0,
  );
  return {
    lasted: tasks.map(({ dur }) => dur / 1000),
    computed: tasks.map(({ tdur }) => tdur / 1000),
  };
}

console.log("vertices  part      over 50 ms  longest  of computing: over 50 ms  longest");
try {
  for (const vertices of sizes.length > 0 ? sizes : [41_000, 164_000]) {
    const around = Math.round(Math.sqrt(vertices / 2));
    const file = path.join(folder, "torus.ply");
    writeFileSync(file, binaryPly(wavyTorus(2 * around, around)));
    const { page, close } = await openPage(browser, { viewport: { width: 1280, height: 720 } });
    page.setDefaultTimeout(300_000);
    await page.goto(`${server.url}?msaa=1#sample=icosahedron`);
    await until(page, "Ready");
    /** @type {Record<string, () => Promise<unknown>>} */
    const parts = {
      async load() {
        await page.getByLabel("Open mesh", { exact: true }).setInputFiles(file);
        await page
          .locator("#title")
          .filter({ hasText: /^torus$/ })
          .waitFor();
        await until(page, "Ready");
      },
      flow: () => button(page, "Play").click(),
      measure: () => openTab(page, "Measure"),
      colour: () => colourBy(page, "Mean curvature H"),
    };
    for (const [name, act] of Object.entries(parts)) {
      const { lasted, computed } = await watched(page, async () => {
        await act();
        await page.waitForTimeout(WATCHED);
      });
      const cells = [lasted, computed].flatMap((some) => {
        const long = some.filter((one) => one > 50).length;
        return [String(long), `${Math.round(Math.max(...some))} ms`];
      });
      const [all, longest, busy, most] = cells;
      console.log(
        `${String(2 * around * around).padStart(8)}  ${name.padEnd(8)}${all.padStart(12)}${longest.padStart(9)}${busy.padStart(26)}${most.padStart(9)}`,
      );
    }
    await close();
  }
} finally {
  await browser.close();
  await server.close();
  rmSync(folder, { recursive: true });
}
