// @ts-check
// Recipes made of runs on the wasm solver and done again by `umbilic replay`, to the last bit; and
// how the command ends where that cannot be. What a recipe may hold is tested in Rust. Needs the
// wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openSession } from "../../www/cli/solver.js";
import { sha256 } from "../../www/digest.js";
import { perform } from "../../www/session.js";
import { obj, wavyTorus } from "./support/meshes.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

/** @typedef {import("../../www/generated/types.js").Origin} Origin */
/** @typedef {import("../../www/cli/solver.js").Session} Session */

let folder = "";
/** @type {Session} */
let session;
before(async () => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  session = await openSession();
});
after(() => rmSync(folder, { recursive: true }));

/** @param {string} name */
const file = (name) => path.join(folder, name);

/** @param {string[]} parameters */
function replay(...parameters) {
  const result = spawnSync(process.execPath, [program, "replay", ...parameters], {
    encoding: "utf8",
  });
  return { exit: result.status, out: result.stdout, log: result.stderr };
}

/** @param {number} steps */
function take(steps) {
  for (let n = 0; n < steps; n += 1)
    assert.ok(perform(session, "step"), `step ${n + 1} of ${steps}`);
}

/** The recipe of what `session` is now. @param {Origin} origin */
const recipe = (origin) => JSON.parse(perform(session, "writeRecipe", { origin }));

/** @param {string} name @param {object} contents */
function write(name, contents) {
  writeFileSync(file(name), JSON.stringify(contents, null, 1));
  return file(name);
}

/** @type {Extract<Origin, { kind: "shape" }>} */
const sphere = { kind: "shape", shape: "bumpy-sphere", parameters: { level: 3 } };

/** @param {import("../../www/generated/schema.js").FlowOptions} options */
function flow(options) {
  perform(session, "sample", { name: sphere.shape, parameters: sphere.parameters });
  perform(session, "configure", { options });
}

test("a plain run is reproduced to the last bit, and the mesh written", async () => {
  flow({ flow: "circle", epsilon: 0.03 });
  take(5);
  const made = recipe(sphere);
  assert.deepEqual(Object.keys(made), ["umbilic", "mesh", "flow", "steps", "result"]);
  assert.deepEqual([made.steps, made.flow.epsilon], [5, 0.03]);
  const { exit, out } = replay(write("plain.json", made), "--out", file("end.ply"), "--json");
  const { same, exact, expected, got } = JSON.parse(out);
  assert.deepEqual([exit, same, exact], [0, true, true]);
  assert.deepEqual(got, expected);
  assert.deepEqual(
    readFileSync(file("end.ply")),
    Buffer.from(perform(session, "export", { format: "ply" })),
  );
  assert.match(replay(file("plain.json")).out, /^Reproduced after 5 steps, to the last bit\./);
});

test("edits, regularisations, flips and looks back are done again", async () => {
  const bytes = Buffer.from(obj(wavyTorus(24, 12)));
  writeFileSync(file("torus.obj"), bytes);
  perform(session, "load", { bytes, name: "torus.obj" });
  perform(session, "configure", { options: { flow: "p-willmore", regularise: "off" } });
  take(3);
  perform(session, "seek", { step: 1 });
  perform(session, "regularise", { options: { epsilon: 0.02 } });
  take(2);
  perform(session, "adopt");
  perform(session, "configure", { options: { flow: "flips", criterion: "area" } });
  perform(session, "arrange", {
    arrangement: { compare: "criteria", subdivide: 0, flipsPerStep: 3 },
  });
  for (let n = 0; n < 400 && perform(session, "step"); n += 1);
  perform(session, "seek", { step: 6 });
  perform(session, "adopt");
  perform(session, "arrange", { arrangement: { compare: "none", subdivide: 0, flipsPerStep: 1 } });
  perform(session, "configure", {
    options: { flow: "circle", integrator: "l-bfgs", fixed: [0, 1, 2] },
  });
  take(6);
  perform(session, "seek", { step: 3 });
  take(2);
  const made = recipe({
    ...{ kind: "file", name: "torus", file: "torus.obj" },
    ...{ sha256: await sha256(bytes), bytes: bytes.length },
  });
  assert.equal(made.edits?.length, 2);
  assert.deepEqual(made.path, [{ steps: 3 }, "anew", { steps: 2 }]);
  assert.deepEqual(made.edits?.[0].path.slice(0, 2), [{ steps: 1 }, "anew"]);
  assert.deepEqual(made.edits?.[1].path, [{ steps: 6 }]);
  const name = write("edited.json", made);
  assert.equal(replay(name).exit, 0, "the mesh beside it is found");
  assert.equal(replay(name, file("torus.obj")).exit, 0);

  // Another mesh is refused, and none too.
  writeFileSync(file("other.obj"), obj(wavyTorus(24, 14)));
  const refused = replay(name, file("other.obj"));
  assert.equal(refused.exit, 3);
  assert.match(refused.log, /given is not the mesh torus\.obj: its SHA-256 begins with/);
  rmSync(file("torus.obj"));
  const missing = replay(name);
  assert.equal(missing.exit, 2);
  assert.match(missing.log, /torus\.obj, which is missing/);
});

test("what differs is told, with exit code 4; of another version to a tolerance", async () => {
  flow({ flow: "circle" });
  take(2);
  const made = recipe(sphere);
  const { energy } = made.result;
  /** @param {object} change */
  const changed = (change) => replay(write("changed.json", { ...made, ...change }));
  const next = { ...made.result, energy: energy * (1 + 2 ** -52) };
  const differs = changed({ result: next });
  assert.equal(differs.exit, 4);
  assert.match(differs.out, /^Not reproduced.*\n\n.*\nenergy +[\d.]+ +[\d.]+ +differs\n/);
  assert.ok(differs.out.includes(String(energy)));
  assert.equal(changed({ result: { ...made.result, positions: "0".repeat(64) } }).exit, 4);
  const older = changed({ umbilic: "0.0.1", result: next });
  assert.equal(older.exit, 0);
  assert.match(older.out, /to 0\.000001 \(made by version 0\.0\.1/);
  const far = { ...made.result, energy: energy * (1 + 1e-5) };
  assert.equal(changed({ umbilic: "0.0.1", result: far }).exit, 4);
});

test("a recipe that cannot be followed is refused, with the line or the key", () => {
  flow({ flow: "circle" });
  take(1);
  const made = recipe(sphere);
  const text = JSON.stringify(made, null, 1);
  /** @param {string} contents @param {RegExp} said */
  function refused(contents, said) {
    writeFileSync(file("bad.json"), contents);
    const { exit, log } = replay(file("bad.json"));
    assert.match(log, said);
    assert.equal(exit, 3, log);
  }
  const line = text.slice(0, text.indexOf('"steps"')).split("\n").length;
  refused(text.replace('"steps": 1,', '"steps": 1;'), new RegExp(`line ${line} cannot be read`));
  /** @param {object} change @param {RegExp} said */
  const without = (change, said) => refused(JSON.stringify({ ...made, ...change }), said);
  without({ flow: { ...made.flow, flo: 1 } }, /no option `flo`\n.*mean `flow`/);
  without({ mesh: { ...made.mesh, shape: "potato" } }, /potato/);
  without({ edits: [{ flow: null, path: [], edit: "bend" }] }, /“edits\[0\]\.edit”/);
});

test("a long recipe says so before it is followed, and one that ends early where", () => {
  perform(session, "sample", { name: "bumpy-sphere", parameters: { level: 1 } });
  perform(session, "configure", { options: { flow: "flips" } });
  while (perform(session, "step"));
  const made = recipe({ ...sphere, parameters: { level: 1 } });
  const { exit, log } = replay(write("long.json", { ...made, steps: 20_000 }));
  assert.match(log, /The recipe runs about 20000 steps\./);
  assert.match(log, /flow ends at step \d+ of 20000/);
  assert.equal(exit, 4);
});
