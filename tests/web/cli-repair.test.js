// @ts-check
// `umbilic repair` as it is started, and what other commands say of a broken file. Needs the wasm
// build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { obj, wavyTorus } from "./support/meshes.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
const shared = fileURLToPath(new URL("../../../shared/cases/files/", import.meta.url));

let folder = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
});
after(() => rmSync(folder, { recursive: true }));

/** @param {string[]} parameters */
function umbilic(parameters) {
  const result = spawnSync(process.execPath, [program, ...parameters], { encoding: "utf8" });
  return { exit: result.status, out: result.stdout, log: result.stderr };
}

/** @param {string[]} parameters @param {number} [expected]  exit code */
function json(parameters, expected = 0) {
  const { exit, out, log } = umbilic([...parameters, "--json"]);
  assert.equal(exit, expected, `${parameters.join(" ")}\n${out}\n${log}`);
  return JSON.parse(out);
}

/** @param {string} name @param {string} text */
function written(name, text) {
  const file = path.join(folder, name);
  writeFileSync(file, text);
  return file;
}

/** A torus with a triangle too many. */
function withFin() {
  const mesh = wavyTorus(12, 8);
  mesh.positions.push([3, 3, 3]);
  mesh.triangles.push([0, 8, mesh.positions.length - 1]);
  return written("fin.obj", obj(mesh));
}

/** @param {{ kind: string, count: number }[]} items */
const kinds = (items) => items.map(({ kind, count }) => [kind, count]);

test("repair writes a surface, and lists what it changed", () => {
  const [fin, out] = [withFin(), path.join(folder, "whole.obj")];
  const { changes, before, after } = json(["repair", fin, "--out", out]);
  assert.deepEqual(kinds(changes), [["Fins", 1]]);
  assert.equal(before, null);
  assert.deepEqual([after.closed, after.genus, after.vertices], [true, 1, 96]);
  const info = json(["info", out]);
  assert.deepEqual([info.vertices, info.faces, info.repairs], [96, 192, []]);
  const words = umbilic(["repair", fin]);
  assert.match(words.out, /^Dropped 1 face of small sheets[\s\S]*^genus +1$/m);
  // Once is enough, and a whole file comes back as it was.
  const copy = path.join(folder, "again.obj");
  assert.deepEqual(json(["repair", out, "-o", copy]).changes, []);
  /** @param {string} file  less the line that has its name */
  const lines = (file) => readFileSync(file, "utf8").split("\n").slice(1);
  assert.deepEqual(lines(copy), lines(out));
  assert.match(umbilic(["repair", out]).out, /^Nothing was to be repaired/);
});

test("other commands say that a repair would help, and what it would do", () => {
  const fin = withFin();
  for (const command of ["info", "energy", "fill", "flow", "regularise", "flips"]) {
    const { kind, hint, repairs } = json([command, fin], 3);
    assert.equal(kind, "NonManifoldEdge");
    assert.match(hint, /umbilic repair MESH --out FILE/);
    assert.deepEqual(kinds(repairs), [["Fins", 1]]);
  }
  const { exit, log } = umbilic(["fill", fin]);
  assert.equal(exit, 3);
  assert.match(log, /counted from 1[\s\S]*umbilic repair[\s\S]*repair: Dropped 1 face/);
  // What is no mesh is not repaired.
  const empty = json(["repair", written("empty.obj", "v 0 0 0\n")], 3);
  assert.equal(empty.repairs, undefined);
});

test("what works on a broken surface as it is says that a repair would help", () => {
  // A torus in two pieces: the second half of it has vertices of its own.
  const { positions, triangles } = wavyTorus(12, 8);
  const half = triangles.length / 2;
  const torn = written(
    "torn.obj",
    obj({
      positions: [...positions, ...positions],
      triangles: triangles.map((t, n) => (n < half ? t : t.map((v) => v + positions.length))),
    }),
  );
  const wouldWeld = /repair: Welded [\s\S]*umbilic repair MESH --out FILE/;
  for (const command of [["energy"], ["flips"], ["remesh"], ["flow", "--steps", "2"]]) {
    const { exit, log } = umbilic([...command, torn]);
    assert.equal(exit, 0, log);
    assert.match(log, wouldWeld, command[0]);
  }
  const info = umbilic(["info", torn]);
  assert.match(info.out, wouldWeld);
  assert.equal(info.log, "");
  assert.doesNotMatch(umbilic(["repair", torn]).log, /repair:/);
  // Two mouths of tubes are no holes, and here they are no mouths.
  const { exit, log } = umbilic(["fill", torn]);
  assert.equal(exit, 3);
  assert.equal(log.match(/repair: Welded/g)?.length, 1, log);
});

test("repair --weld welds within a length, or not at all", () => {
  // The torus as a heap of triangles, one side of it a little off.
  const { positions, triangles } = wavyTorus(12, 8);
  /** @param {number} gap */
  const heap = (gap) => ({
    positions: triangles.flatMap((t) =>
      t.map((v) => positions[v].map((c, axis) => c + (axis === 2 && v % 3 === 0 ? gap * t[0] : 0))),
    ),
    triangles: triangles.map((_, n) => [3 * n, 3 * n + 1, 3 * n + 2]),
  });
  const [near, apart] = [written("near.obj", obj(heap(0))), written("apart.obj", obj(heap(1e-5)))];
  const welded = json(["repair", near]);
  assert.deepEqual(kinds(welded.changes), [["Welded", 576 - 96]]);
  assert.deepEqual([welded.before.components, welded.after.genus], [192, 1]);
  assert.deepEqual(json(["repair", near, "--weld", "off"]).changes, []);
  // The default spelt out.
  assert.deepEqual(json(["repair", near, "--weld", "auto"]).changes, welded.changes);
  assert.equal(json(["repair", apart]).after.closed, false);
  // What may help is told, and helps.
  const [, length] = /: try --weld (\S+)\n/.exec(umbilic(["repair", apart]).out) ?? [];
  const tried = json(["repair", apart, "--weld", length]);
  assert.ok(tried.after.components < tried.before.components / 2);
  assert.equal(json(["repair", apart, "--weld", "0.01"]).after.closed, true);
  assert.deepEqual(kinds(json(["info", near]).repairs), [["Welded", 576 - 96]]);
  for (const wrong of ["0", "wide"]) {
    assert.equal(json(["repair", near, "--weld", wrong], 2).kind, "BadOption");
  }
});

test("files that people brought come out right", { skip: !existsSync(shared) }, () => {
  /** @param {string} name */
  const repaired = (name) => json(["repair", path.join(shared, name)]).after;
  /** @type {[string, number, number][]} */
  const spheres = [
    ["obj_uvseam_pole.obj", 114, 224],
    ["stl_unwelded_noise.stl", 162, 320],
    ["fin.obj", 162, 320],
    ["slit.obj", 642, 1280],
  ];
  for (const [name, vertices, faces] of spheres) {
    const after = repaired(name);
    const found = [after.vertices, after.faces, after.closed, after.genus, after.repairs];
    assert.deepEqual(found.slice(0, 4), [vertices, faces, true, 0], name);
  }
  const { closed, area, volume } = repaired("tjunction.obj");
  assert.ok(closed && Math.abs(area - 6) < 1e-9 && Math.abs(volume - 1) < 1e-9);
  assert.equal(repaired("zero_area.obj").minAngleDegrees > 1, true);
  /** @param {string} name */
  const filled = (name) => json(["fill", path.join(shared, name)]);
  const flat = filled("flat_hole.obj");
  assert.deepEqual([flat.filled.length, flat.info.boundaryLoops], [1, 1]);
  assert.ok(Math.abs(flat.info.area - 1) < 1e-9);
  const bowtie = filled("bowtie_hole.obj");
  assert.deepEqual([bowtie.filled.length, bowtie.info.boundaryLoops], [2, 1]);
});
