// @ts-check
// What people bring to the command line: files of other programs, packed or not, and meshes far
// from the origin. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { zipSync } from "fflate";
import { glb, gltf, msh, threeMf, vtk } from "./support/formats.js";
import { obj, wavyTorus } from "./support/meshes.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
const cases = fileURLToPath(new URL("../../../shared/cases/files/", import.meta.url));

let folder = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
});
after(() => rmSync(folder, { recursive: true }));

/** @param {string[]} line */
function umbilic(...line) {
  const all = [program, ...line, "--json"];
  const { status, stdout, stderr } = spawnSync(process.execPath, all, { encoding: "utf8" });
  return { exit: status, json: JSON.parse(stdout || "null"), stderr };
}

/** @param {string} name @param {string | Uint8Array} content */
function written(name, content) {
  const file = path.join(folder, name);
  mkdirSync(path.dirname(file), { recursive: true });
  writeFileSync(file, content);
  return file;
}

const mesh = wavyTorus(24, 12);
const text = obj(mesh);

test("files of other programs are read, packed or not", () => {
  const { "mesh.gltf": scene, "mesh.bin": numbers } = gltf(mesh);
  written("own/mesh.bin", numbers);
  const volume = umbilic("info", written("plain.obj", text)).json.volume;
  for (const [file, scale] of /** @type {[string, number][]} */ ([
    [written("a.obj.gz", gzipSync(text)), 1],
    [written("a.zip", zipSync({ "in/a.obj": Buffer.from(text), "a.mtl": Buffer.from("") })), 1],
    [written("a.3mf", threeMf(mesh)), 1],
    [written("a.vtk", vtk(mesh)), 1],
    [written("a.msh", msh(mesh)), 1],
    [written("a.glb", glb(mesh)), 2],
    [written("own/mesh.gltf", scene), 2],
    [written("b.zip", zipSync(gltf(mesh))), 2],
  ])) {
    const { exit, json } = umbilic("info", file);
    assert.equal(exit, 0, `${file}: ${json.message}`);
    const { vertices, faces, closed, genus, warnings } = json;
    assert.deepEqual(
      { vertices, faces, closed, genus },
      { vertices: 288, faces: 576, closed: true, genus: 1 },
      file,
    );
    assert.deepEqual(warnings, [], file);
    assert.ok(Math.abs(json.volume / scale ** 3 / volume - 1) < 1e-6, `${file}: ${json.volume}`);
  }
});

test("archives without a mesh, and damaged ones, are refused in words", () => {
  const none = umbilic(
    "info",
    written("none.zip", zipSync({ "a.txt": Buffer.from("x"), b: Buffer.from("y") })),
  );
  assert.deepEqual([none.exit, none.json.kind], [3, "NoMesh"]);
  assert.match(none.json.message, /a\.txt/);
  const cut = umbilic("info", written("cut.gz", gzipSync(text).subarray(0, 99)));
  assert.deepEqual([cut.exit, cut.json.kind], [3, "Damaged"]);
  const scene = umbilic("info", written("alone/mesh.gltf", gltf(mesh)["mesh.gltf"]));
  assert.deepEqual([scene.exit, scene.json.kind], [3, "Unsupported"]);
  assert.match(scene.json.hint, /\.gltf/);
});

test("of several meshes the largest is opened, with a word", () => {
  const files = { "small.off": Buffer.from("OFF"), "a.obj": Buffer.from(text) };
  const { exit, stderr } = umbilic("info", written("two.zip", zipSync(files)));
  assert.equal(exit, 0);
  assert.match(stderr, /a\.obj.*small\.off/);
});

test("a mesh far from the origin reads back from every format as it was", () => {
  const far = { ...mesh, positions: mesh.positions.map(([x, y, z]) => [x + 5e5, y + 5e6, z]) };
  const file = written("far.obj", obj(far));
  const { meanEdgeLength } = umbilic("info", file).json;
  for (const ending of ["ply", "obj", "off", "stl", "glb"]) {
    const to = path.join(folder, `far-out.${ending}`);
    const { exit, stderr } = umbilic("regularise", file, "--iterations", "0", "--out", to);
    assert.equal(exit, 0, ending);
    assert.equal(/moved to the origin/.test(stderr), ending === "stl", `${ending}: ${stderr}`);
    const { json } = umbilic("info", to);
    assert.deepEqual([json.vertices, json.closed, json.genus], [288, true, 1], ending);
    assert.ok(Math.abs(json.meanEdgeLength / meanEdgeLength - 1) < 1e-5, ending);
  }
});

test("the table of formats is what help and refusals name", () => {
  const { stdout } = spawnSync(process.execPath, [program, "--help"], { encoding: "utf8" });
  for (const ending of [".ply", ".3mf", ".vtu", ".msh", ".zip"]) assert.ok(stdout.includes(ending));
  const { json } = umbilic("info", written("some.txt", "nothing"));
  assert.match(json.hint, /ply.*3mf.*msh/);
  const { json: out } = umbilic(
    "regularise",
    written("c.obj", text),
    "--out",
    path.join(folder, "c.vtk"),
  );
  assert.match(out.hint, /\.ply.*\.stl or \.glb/);
});

test("collected files are read as they should be", {
  skip: !existsSync(cases) && "no cases here",
}, () => {
  for (const name of ["cube.obj.gz", "cube.zip", "cube.3mf", "cube.vtk", "cube.msh"]) {
    const { exit, json } = umbilic("info", path.join(cases, name));
    assert.equal(exit, 0, `${name}: ${json.message}`);
    assert.deepEqual([json.closed, json.volume], [true, 1], name);
  }
});
