// @ts-check
// The page answers while it works: no task of the main thread longer than 50 ms, with a
// mesh of 100 000 triangles, while it steps and is turned.

import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import {
  button,
  canvas,
  choice,
  reading,
  sharedMesh,
  until,
  untilDrawn,
  useSite,
} from "./support/app.js";
import {
  durations,
  lastingLongTasks,
  longTasks,
  now,
  watchLongTasks,
} from "./support/long-tasks.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** Turns the surface by dragging. @param {import("playwright-core").Page} page */
async function orbit(page) {
  const box = await canvas(page).boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 1; i <= 20; i += 1) await page.mouse.move(x + 6 * i, y + 3 * i);
  await page.mouse.up();
}

test("the main thread is free while a large mesh flows and is turned", async (context) => {
  const { page, faults, close } = await site.blank({ viewport: { width: 800, height: 500 } });
  await watchLongTasks(page);
  await page.goto(`${site.url}?msaa=1`);
  await untilDrawn(page);
  const opening = await now(page);
  const koala = sharedMesh("koala.obj");
  if (!koala) context.diagnostic("koala.obj is not at hand: a torus of as many triangles");
  // A path: bytes would be handed over on the main thread, at our expense.
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  const file = path.join(folder, "large.obj");
  if (koala) copyFileSync(koala, file);
  else writeFileSync(file, obj(wavyTorus(354, 142)));
  await page.getByLabel("Open mesh", { exact: true }).setInputFiles(file);
  await page.locator("#title").filter({ hasText: "large" }).waitFor();
  await until(page, "Ready");
  assert.ok(Number(await reading(page, "Faces")) > 99_000);
  await choice(page, "Colour by").selectOption({ label: "Mean curvature H" });
  await page.getByRole("img", { name: /^Colours:/ }).waitFor();
  await untilDrawn(page);

  const opened = await now(page);
  const all = await longTasks(page);
  context.diagnostic(`first picture: ${durations(all.filter(({ start }) => start < opening))}`);
  const load = all.filter(({ start }) => start >= opening && start < opened);
  context.diagnostic(`opening the mesh: ${durations(load)}`);
  const long = await lastingLongTasks(
    page,
    async () => {
      const before = Number(await reading(page, "Step"));
      await button(page, "Play").click();
      await orbit(page);
      await page.waitForFunction(
        (step) => Number(document.querySelector("[data-reading=step]")?.textContent) >= step,
        before + 2,
      );
      await orbit(page);
      await button(page, "Pause").click();
      await button(page, "Play").waitFor();
    },
    (text) => context.diagnostic(`stepping and turning, ${text}`),
  );
  assert.deepEqual(long, [], "tasks longer than 50 ms");
  assert.deepEqual(faults, []);
  await close();
  rmSync(folder, { recursive: true });
});
