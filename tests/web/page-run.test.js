// @ts-check
// A mesh of the user's: opened, played, paused, stepped, taken back; readings and plot follow.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import {
  button,
  energy,
  openMesh,
  playAndPause,
  plotted,
  reading,
  sharedMesh,
  surface,
  until,
  useSite,
} from "./support/app.js";
import { obj, ply, wavyTorus } from "./support/meshes.js";

const site = useSite();

const readings = [
  "Energy",
  "Step",
  "Time",
  "Step size",
  "Area",
  "Volume",
  "Genus",
  "Vertices",
  "Faces",
  "Smallest angle",
  "Milliseconds per step",
];

test("a mesh is opened, flows, and goes back", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  assert.match(await surface(page), /^Surface: wavy, step 0, /);
  assert.deepEqual(
    [await reading(page, "Vertices"), await reading(page, "Faces"), await reading(page, "Genus")],
    ["1152", "2304", "1"],
  );
  const atStart = await energy(page);

  const step = await playAndPause(page, 3);
  assert.ok(step >= 3);
  assert.ok((await energy(page)) < atStart, "the energy falls");
  assert.equal((await plotted(page)).length, step + 1);

  const paused = await energy(page);
  await button(page, "Step").click();
  await until(page, `Paused at step ${step + 1}`);
  assert.match(await surface(page), new RegExp(`^Surface: wavy, step ${step + 1}, `));
  assert.notEqual(await energy(page), paused);
  await button(page, "Back").click();
  await until(page, `Paused at step ${step}`);
  assert.equal(await energy(page), paused, "one step back has the energy of before");

  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await energy(page), atStart);
  assert.equal((await plotted(page)).length, 1);
  // Nothing is lost: the steps are still there to be shown.
  await page.getByRole("slider", { name: "History", exact: true }).focus();
  await page.keyboard.press("End");
  await until(page, `Paused at step ${step + 1}`);
  assert.equal((await plotted(page)).length, step + 2);
  assert.deepEqual(faults, []);
  await close();
});

test("the readings are all there, and agree with the numbers of the plot", async () => {
  const { page, faults, close } = await site.open();
  const table = page.getByRole("table", { name: "Readings" });
  assert.deepEqual(await table.getByRole("rowheader").allTextContents(), readings);
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  const step = await playAndPause(page, 4);
  for (const text of await table.getByRole("cell").allTextContents()) {
    assert.match(text, /^[-\d.]+/, "every reading is a number");
  }
  const rows = await plotted(page);
  assert.deepEqual(
    rows.map(([number]) => number),
    Array.from({ length: step + 1 }, (_, i) => i),
  );
  const last = rows[step];
  assert.equal(last[1], Number(await reading(page, "Time")));
  assert.equal(last[2], Number.parseFloat(await reading(page, "Step size")));
  assert.equal(last[3], await energy(page));
  for (let i = 1; i <= step; i += 1) {
    assert.ok(rows[i][1] > rows[i - 1][1], "time goes on");
    // U_ε falls from step to step, and W lies below it.
    assert.ok(rows[i][4] <= rows[i - 1][4] && rows[i][3] < rows[i][4], `${rows[i]}`);
  }
  assert.deepEqual(faults, []);
  await close();
});

test("a run goes on until it converges, and says so", async () => {
  const { page, faults, close } = await site.open();
  await button(page, "Play").click();
  await until(page, /^Converged after \d+ steps$/);
  assert.ok((await energy(page)) < 1, `W = ${await energy(page)} is far from a round sphere's 0`);
  assert.equal(await button(page, "Play").isVisible(), true);
  const converged = (await page.locator("[role=status]").textContent()) ?? "";
  const rows = await plotted(page);
  assert.equal(rows.length, Number(await reading(page, "Step")) + 1);

  // Finer faces of the surface it came to, and the way back.
  const [low, faces] = [await energy(page), Number(await reading(page, "Faces"))];
  await button(page, "Subdivide").click();
  const count = page.locator("[data-reading=faces]");
  await count.filter({ hasText: String(4 * faces) }).waitFor();
  await until(page, "Ready");
  // The same point set, with new vertices that lie in its faces.
  assert.ok((await energy(page)) > low);
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await button(page, "Undo").click();
  await count.filter({ hasText: new RegExp(`^${faces}$`) }).waitFor();
  // The run is back too, to be scrubbed and gone on with.
  await until(page, converged);
  assert.equal(await energy(page), low);
  assert.deepEqual(await plotted(page), rows);
  await button(page, "Back").click();
  await until(page, `Paused at step ${rows.length - 2}`);
  assert.equal(await energy(page), rows[rows.length - 2][3]);
  assert.deepEqual(faults, []);
  await close();
});

test("a dropped file opens like a chosen one, in any format", async () => {
  const { page, faults, close } = await site.open();
  await page.evaluate(
    (text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], "dropped.ply"));
      for (const type of ["dragenter", "dragover", "drop"]) {
        window.dispatchEvent(
          new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }),
        );
      }
    },
    ply(wavyTorus(16, 8)),
  );
  await page.waitForFunction(() => document.querySelector("#title")?.textContent === "dropped");
  await until(page, "Ready");
  assert.equal(await reading(page, "Vertices"), "128");
  assert.equal(await page.locator("#drop").isVisible(), false);
  assert.deepEqual(faults, []);
  await close();
});

const spot = sharedMesh("spot_low_resolution.obj");
test("a model of the field's opens and flows", { skip: spot ? false : "no mesh" }, async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "spot.obj", readFileSync(spot ?? ""));
  assert.equal(await reading(page, "Vertices"), "829");
  assert.equal(await reading(page, "Faces"), "1654");
  const atStart = await energy(page);
  await playAndPause(page, 2);
  assert.ok((await energy(page)) < atStart);
  assert.deepEqual(faults, []);
  await close();
});
