// @ts-check
// `umbilic bench --table robustness --meshes`: the meshes of a folder and nothing else in it. What
// its rows say is tested natively. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

let folder = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
});
after(() => rmSync(folder, { recursive: true }));

const bench = () => {
  const line = ["bench", "--table", "robustness", "--meshes", folder, "--json"];
  const { status, stdout } = spawnSync(process.execPath, [program, ...line], { encoding: "utf8" });
  return { exit: status, json: JSON.parse(stdout) };
};

test("every mesh of a folder is tried, and nothing else in it", () => {
  writeFileSync(path.join(folder, "notes.txt"), "no mesh\n");
  const none = bench();
  assert.deepEqual([none.exit, none.json.kind], [2, "Usage"]);
  writeFileSync(path.join(folder, "mesh.obj"), "v 0 0 0\nf 1 2 3\n");
  // A square of two triangles: open, and too small for curvatures by fits.
  const square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  writeFileSync(path.join(folder, "square.off"), square);
  const { exit, json } = bench();
  assert.equal(exit, 0);
  const columns = ["case", "flow", "ending", "steps", "first", "last", "rise", "angle", "seconds"];
  for (const row of json.rows) assert.deepEqual(Object.keys(row), columns);
  const cases = json.rows.map((/** @type {any} */ row) => row.case);
  assert.deepEqual(cases, ["mesh.obj", ...Array(7).fill("square.off")]);
  assert.match(json.rows[0].ending, /^refused: \w+$/);
});
