// @ts-check
// A file that cannot be used: said once, in words that help, with the old mesh still there.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import {
  button,
  energy,
  openMesh,
  plotted,
  sharedMesh,
  surface,
  until,
  upload,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** Three triangles on one edge. */
const fan = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";

/**
 * The errors on screen, each the lines it shows.
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[][]>}
 */
const errors = (page) =>
  page
    .getByRole("alert")
    .locator(".message")
    .evaluateAll((messages) =>
      messages.map((message) =>
        [...message.querySelectorAll("p:not([hidden])")].map((line) => line.textContent ?? ""),
      ),
    );

/** A torus after one step. */
async function stepped() {
  const opened = await site.open();
  await openMesh(opened.page, "wavy.obj", obj(wavyTorus(16, 8)));
  await button(opened.page, "Step").click();
  await until(opened.page, "Paused at step 1");
  return opened;
}

test("a file that is refused leaves the mesh, its step and its numbers", async () => {
  const { page, faults, close } = await stepped();
  const before = [await surface(page), await energy(page), await plotted(page)];
  // Twice: the same error must not pile up.
  for (const name of ["fan.obj", "fan.obj"]) {
    await upload(page, name, fan);
    await page.getByRole("alert").getByText(/edge/i).first().waitFor();
    await until(page, "Paused at step 1");
  }
  const [lines, ...more] = await errors(page);
  assert.deepEqual(more, [], "said once");
  assert.equal(lines.length, 2, `what is wrong, and what to do: ${lines}`);
  assert.match(lines[0], /1\D+2/, "the message names the edge as the file counts its vertices");
  assert.deepEqual([await surface(page), await energy(page), await plotted(page)], before);

  await button(page, "Step").click();
  await until(page, "Paused at step 2");
  await button(page, "Dismiss").click();
  assert.deepEqual(await errors(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test("a good file clears what was said of a bad one", async () => {
  const { page, faults, close } = await stepped();
  await upload(page, "nothing.obj", "");
  await page.getByRole("alert").locator(".message").waitFor();
  await openMesh(page, "good.obj", obj(wavyTorus(12, 6)));
  assert.deepEqual(await errors(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test("damaged files of every kind are answered in words", async (context) => {
  const folder = sharedMesh("broken");
  const files = folder
    ? readdirSync(folder).map((name) => ({ name, bytes: readFileSync(path.join(folder, name)) }))
    : [];
  if (!folder) context.diagnostic("the developers' damaged meshes are not at hand: two of our own");
  files.push({ name: "words.obj", bytes: Buffer.from("not a mesh at all\n") });
  files.push({ name: "picture.png", bytes: Buffer.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]) });
  const { page, faults, close } = await stepped();
  for (const { name, bytes } of files) {
    const title = await page.locator("#title").textContent();
    const dismiss = button(page, "Dismiss");
    while (await dismiss.count()) await dismiss.first().click();
    await upload(page, name, bytes);
    // Taken, or refused with a reason; never neither.
    await page.waitForFunction(
      ([name, before]) => {
        const title = document.querySelector("#title")?.textContent;
        const refused = document.querySelector("#errors .message") !== null;
        return refused || (title !== before && title === name.replace(/\.\w+$/, ""));
      },
      [name, title ?? ""],
    );
    await until(page, /^(Ready|Paused at step 1|The flow cannot start)$/);
    const said = (await errors(page)).flat().join(" · ") || "taken";
    assert.doesNotMatch(said, /panicked|unreachable|undefined|RuntimeError|stopped unexpectedly/);
    context.diagnostic(`${name}: ${said}`);
  }
  assert.deepEqual(faults, []);
  await close();
});
