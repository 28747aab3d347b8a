// @ts-check
// What the page saves: every format read again by the command line, which shares nothing
// with the page but the solver.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import {
  button,
  download,
  energy,
  openMesh,
  reading,
  until,
  untilDrawn,
  useSite,
} from "./support/app.js";
import { measure } from "./support/browser.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();
const cli = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

/** The formats as the page calls them: their extension, and how such a file begins. */
const meshes = {
  PLY: { extension: "ply", begins: /^ply\r?\nformat binary_little_endian 1\.0/ },
  "PLY, text": { extension: "ply", begins: /^ply\r?\nformat ascii 1\.0/ },
  OBJ: { extension: "obj", begins: /^(#.*\n)*(o .*\n)?v [-\d.]/ },
  OFF: { extension: "off", begins: /^OFF\n(#.*\n)*1152 2304 0\n/ },
  // A binary file must not begin with this word, which is that of the text format.
  STL: { extension: "stl", begins: /^(?!solid)/ },
  "STL, text": { extension: "stl", begins: /^solid/ },
};

/** @param {string} command @param {string} file @returns {any} the command's JSON */
function ask(command, file) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [cli, command, file, "--json"], {
    encoding: "utf8",
  });
  assert.equal(status, 0, stderr);
  return JSON.parse(stdout);
}

/** @param {Buffer} bytes @returns {any} the JSON part of a binary glTF file */
function gltf(bytes) {
  assert.equal(bytes.toString("latin1", 0, 4), "glTF");
  assert.equal(bytes.readUInt32LE(8), bytes.length, "the header tells the length");
  return JSON.parse(bytes.toString("utf8", 20, 20 + bytes.readUInt32LE(12)));
}

/** A torus after two steps. */
async function stepped() {
  const opened = await site.open();
  await openMesh(opened.page, "wavy torus.obj", obj(wavyTorus()));
  for (const step of [1, 2]) {
    await button(opened.page, "Step").click();
    await until(opened.page, `Paused at step ${step}`);
  }
  return opened;
}

test("a mesh that was saved is the mesh on the screen", async () => {
  const { page, faults, close } = await stepped();
  const folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  const [area, shown] = [Number(await reading(page, "Area")), await energy(page)];
  try {
    for (const [format, { extension, begins }] of Object.entries(meshes)) {
      const { name, bytes } = await download(page, format);
      assert.match(bytes.toString("latin1", 0, 200), begins, format);
      if (format === "STL") assert.equal(bytes.length, 84 + 50 * 2304);
      assert.equal(name, `wavy-torus-circle-step0002.${extension}`);
      const file = path.join(folder, name);
      writeFileSync(file, bytes);
      const info = ask("info", file);
      const { vertices, faces, edges, genus, closed, oriented, components } = info;
      assert.deepEqual(
        { vertices, faces, edges, genus, closed, oriented, components },
        {
          vertices: 1152,
          faces: 2304,
          edges: 3456,
          genus: 1,
          closed: true,
          oriented: true,
          components: 1,
        },
        format,
      );
      // The page shows six digits; STL stores single precision.
      assert.ok(Math.abs(info.area / area - 1) < 2e-5, `${format}: area ${info.area}, not ${area}`);
      const { circle } = ask("energy", file);
      assert.ok(Math.abs(circle / shown - 1) < 2e-4, `${format}: W = ${circle}, not ${shown}`);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
  assert.deepEqual(faults, []);
  await close();
});

test("a saved glTF scene has the mesh in it", async () => {
  const { page, faults, close } = await stepped();
  const { name, bytes } = await download(page, "glTF (GLB)");
  assert.equal(name, "wavy-torus-circle-step0002.glb");
  const { meshes, accessors } = gltf(bytes);
  const [{ attributes, indices }] = meshes[0].primitives;
  assert.equal(accessors[attributes.POSITION].count, 1152);
  assert.equal(accessors[indices].count, 3 * 2304);
  assert.deepEqual(faults, []);
  await close();
});

test("the saved history is the plot's", async () => {
  const { page, faults, close } = await stepped();
  const { name, bytes } = await download(page, "History, CSV");
  assert.equal(name, "wavy-torus-circle-step0002.csv");
  const [header, ...lines] = bytes.toString("utf8").trim().split(/\r?\n/);
  const columns = header.split(",");
  assert.equal(columns[0], "step");
  const rows = lines.map((line) => line.split(",").map(Number));
  assert.deepEqual(
    rows.map(([step]) => step),
    [0, 1, 2].slice(-rows.length),
  );
  const last = rows.at(-1)?.[columns.indexOf("energy")] ?? 0;
  assert.ok(Math.abs(last / (await energy(page)) - 1) < 1e-5);
  assert.deepEqual(faults, []);
  await close();
});

test("the saved picture shows the surface", async () => {
  const { page, faults, close } = await stepped();
  await untilDrawn(page);
  const { name, bytes } = await download(page, "Picture, PNG");
  assert.equal(name, "wavy-torus-circle-step0002.png");
  const { width, height, colours } = measure(bytes);
  const box = await page.locator("#surface").boundingBox();
  assert.deepEqual([width, height], [box?.width, box?.height]);
  assert.ok(colours > 200, `${colours} colours`);
  assert.deepEqual(faults, []);
  await close();
});
