// @ts-check
// Two panes of 40,962 vertices each step together, and the page answers all the while: no task
// of the main thread longer than 50 ms.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { button, choice, reading, until, untilDrawn, useSite } from "./support/app.js";
import { lastingLongTasks, watchLongTasks } from "./support/long-tasks.js";

const site = useSite();

test("the main thread is free while two large panes step, coloured by their distance", async (context) => {
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  const file = path.join(folder, "large.obj");
  const cli = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
  const shape = ["shape", "icosahedron", "--level", "6", "--out", file];
  assert.equal(spawnSync(process.execPath, [cli, ...shape]).status, 0);

  const { page, faults, close } = await site.blank({ viewport: { width: 1000, height: 500 } });
  await watchLongTasks(page);
  await page.goto(`${site.url}?msaa=1`);
  await untilDrawn(page);
  await page.getByLabel("Open mesh", { exact: true }).setInputFiles(file);
  await page.locator("#title").filter({ hasText: "large" }).waitFor();
  await until(page, "Ready");
  assert.equal(Number(await reading(page, "Vertices")), 40_962);
  await page.locator("#comparison > summary").click();
  await choice(page, "Ready-made comparison").selectOption({ label: "ε = 0.1 against 0.01" });
  const steps = () =>
    page
      .locator("#panes figcaption")
      .evaluateAll((all) =>
        all.map(({ textContent }) => Number(/step (\d+)/.exec(textContent ?? "")?.[1])),
      );
  await page.locator("#panes figcaption").nth(1).filter({ hasText: "step 0" }).waitFor();
  await choice(page, "Colours").selectOption("Distance to A");
  await page.getByRole("img", { name: /^Colours: Distance to A/ }).waitFor();
  await page.locator("#comparison-plot canvas").waitFor();
  // Both pictures are on the screen, and what it took is over.
  await page.waitForTimeout(3000);

  const long = await lastingLongTasks(
    page,
    async (round) => {
      // From the start each time: the flow comes to rest soon.
      if (round > 1) await button(page, "Reset").click();
      await page.waitForFunction(() =>
        /step 0,/.test(document.querySelector("#own-caption")?.textContent ?? ""),
      );
      await button(page, "Play").click();
      await page.waitForFunction(
        () =>
          Number(
            /step (\d+)/.exec(document.querySelector("#own-caption")?.textContent ?? "")?.[1],
          ) >= 2,
      );
      await button(page, "Pause").click();
      await button(page, "Play").waitFor();
      const [a, b] = await steps();
      assert.equal(a, b);
      assert.ok(a >= 2);
    },
    (text) => context.diagnostic(text),
  );
  assert.deepEqual(long, [], "tasks longer than 50 ms");
  assert.deepEqual(faults, []);
  await close();
  rmSync(folder, { recursive: true });
});
