// @ts-check
// A scan that is no surface: opened, repaired, filled, downloaded, read back.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  download,
  openMesh,
  openTab,
  reading,
  surface,
  until,
  upload,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** Faces by edge. @param {number[][]} faces */
function edgesOf(faces) {
  /** @type {Map<string, number>} */
  const count = new Map();
  for (const face of faces) {
    for (const [n, v] of face.entries()) {
      const key = [v, face[(n + 1) % face.length]].sort((a, b) => a - b).join();
      count.set(key, (count.get(key) ?? 0) + 1);
    }
  }
  return [...count.values()];
}

/** A torus with two triangles too many at an edge, and two holes. */
function scan() {
  const { positions, triangles } = wavyTorus(24, 12);
  const kept = triangles.filter((_, n) => n !== 100 && n !== 101 && n !== 300);
  positions.push([4, 1, 1], [4, -1, 1]);
  const last = positions.length - 1;
  return { positions, triangles: [...kept, [0, 12, last], [12, 24, last - 1]] };
}

test("a broken scan is opened by a repair, filled, and is whole in the download", async () => {
  const { page, faults, close } = await site.open();
  const mesh = scan();
  const before = await surface(page);
  assert.ok(edgesOf(mesh.triangles).some((count) => count > 2));
  await upload(page, "scan.obj", obj(mesh));
  const offer = button(page, "Repair and open");
  await offer.waitFor();
  await page.getByText(/has 3 faces/).waitFor();
  await page.getByText(/A repair would do this: Dropped 2 faces/).waitFor();
  await offer.click();
  await until(page, "Ready");
  // What was changed stands where the mesh is described.
  await page
    .locator(".changes")
    .getByText(/Dropped 2 faces of small sheets/)
    .waitFor();
  assert.equal(await reading(page, "Vertices"), "288");

  await openTab(page, "Surface");
  await button(page, "Fill…").click();
  const bar = page.getByRole("toolbar", { name: "Fill holes" });
  await bar.getByRole("button", { name: "Fill all 2" }).click();
  await page
    .getByText(/Filled 2 loops/)
    .first()
    .waitFor();
  await until(page, "Ready");
  const { bytes } = await download(page, "OBJ");
  const faces = String(bytes)
    .split("\n")
    .filter((line) => line.startsWith("f "))
    .map((line) => line.slice(2).trim().split(" ").map(Number));
  assert.ok(
    edgesOf(faces).every((count) => count === 2),
    "closed, two faces an edge",
  );
  // The file as it is cannot be shown: what was there before it is back.
  await openTab(page, "Surface");
  await page.getByRole("button", { name: /^Undo the fill/ }).click();
  await page.getByRole("button", { name: /^Undo the repair/ }).click();
  await page.getByRole("img", { name: before, exact: true }).waitFor();
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  assert.deepEqual(faults, []);
  await close();
});

test("a file with a slit is repaired by its button, and Undo brings the slit back", async () => {
  const { page, faults, close } = await site.open();
  // Each triangle has vertices of its own on one side.
  const { positions, triangles } = wavyTorus(24, 12);
  const n = positions.length;
  const mesh = {
    positions: [...positions, ...positions],
    triangles: triangles.map((t, f) => (f < triangles.length / 2 ? t : t.map((v) => v + n))),
  };
  await openMesh(page, "slit.obj", obj(mesh));
  await openTab(page, "Surface");
  await page
    .locator(".changes")
    .getByText(/Welded 24 boundary vertices/)
    .waitFor();
  const before = await reading(page, "Vertices");
  await openTab(page, "Surface");
  await button(page, "Repair").click();
  await page.getByRole("button", { name: /^Undo the repair/ }).waitFor();
  assert.equal(await reading(page, "Vertices"), "288");
  await openTab(page, "Surface");
  assert.equal(await button(page, "Repair").count(), 0, "nothing is left to repair");
  await page.getByRole("button", { name: /^Undo the repair/ }).click();
  await button(page, "Repair").waitFor();
  assert.equal(await reading(page, "Vertices"), before);
  assert.deepEqual(faults, []);
  await close();
});

test("an opened scan is asked what it is for, once, and is smoothed a little", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "bust.obj", obj(wavyTorus(48, 24)));
  await page.getByText("What is this mesh for?").waitFor();
  await button(page, "Smooth a little").click();
  await until(page, /^Stopped after 10 steps/);
  assert.equal(await page.getByText("What is this mesh for?").count(), 0);
  // Nothing is remembered for another file, and a small mesh is no scan.
  await openMesh(page, "small.obj", obj(wavyTorus(12, 8)));
  assert.equal(await page.getByText("What is this mesh for?").count(), 0);
  await openMesh(page, "again.obj", obj(wavyTorus(48, 24)));
  await page.getByText("What is this mesh for?").waitFor();
  await openTab(page, "Flow");
  assert.equal(await page.getByRole("radio", { name: "Come to rest" }).isChecked(), true);
  assert.deepEqual(faults, []);
  await close();
});
