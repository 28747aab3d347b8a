// @ts-check
// Recipes made of runs on the wasm solver and done again by `umbilic replay`, to the last
// bit; and those that must be refused. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { openSession, packageVersion } from "../../www/cli/solver.js";
import { sha256 } from "../../www/digest.js";
import { writeLink } from "../../www/link.js";
import { defaults } from "../../www/options.js";
import { follow, makeRecipe, prepare, readRecipe } from "../../www/recipe.js";
import { perform } from "../../www/session.js";
import { initial } from "../../www/state.js";
import { obj, wavyTorus } from "./support/meshes.js";
import { readScene } from "./support/scene.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

/** @typedef {import("../../www/recipe.js").Recipe} Recipe */
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

/**
 * The recipe of what `session` is now.
 * @param {Recipe["mesh"]} mesh
 */
async function recipe(mesh) {
  return makeRecipe({
    ...{ version: packageVersion(), mesh, arrangement: {} },
    ...{ story: perform(session, "recipe"), state: perform(session, "state") },
    positions: await sha256(session.frame(false).positions),
  });
}

/** @param {string} name @param {object} contents */
function write(name, contents) {
  writeFileSync(file(name), JSON.stringify(contents, null, 1));
  return file(name);
}

const sphere = { shape: "bumpy-sphere", parameters: { level: 3 } };

/** @param {import("../../www/generated/schema.js").FlowOptions} options */
function flow(options) {
  perform(session, "sample", { name: sphere.shape, parameters: sphere.parameters });
  perform(session, "configure", { options });
}

test("a plain run is reproduced to the last bit, and the mesh written", async () => {
  flow({ flow: "circle", epsilon: 0.03 });
  take(5);
  const made = await recipe(sphere);
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
  const mesh = { name: "torus.obj", sha256: await sha256(bytes), bytes: bytes.length };
  const made = await recipe(mesh);
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
  assert.match(refused.log, /other\.obj is not the recipe’s mesh torus\.obj/);
  rmSync(file("torus.obj"));
  const missing = replay(name);
  assert.equal(missing.exit, 2);
  assert.match(missing.log, /torus\.obj, which is missing/);
});

test("a fill and the flow that fairs it are done again", async () => {
  const tubes = { shape: "tubes", parameters: { count: 2 } };
  perform(session, "sample", { name: tubes.shape, parameters: tubes.parameters });
  perform(session, "fill", { options: { loops: [0, 2], connect: true } });
  perform(session, "configure", { options: { flow: "mmcv" } });
  take(3);
  const made = await recipe(tubes);
  assert.deepEqual(made.edits?.[0].edit, {
    fill: { loops: [0, 2], connect: true, maxVertices: null },
  });
  assert.equal(made.flow.free, null, "the new vertices, which are known");
  assert.equal(replay(write("filled.json", made)).exit, 0);
});

test("what differs is told, with exit code 4; of another version to a tolerance", async () => {
  flow({ flow: "circle" });
  take(2);
  const made = await recipe(sphere);
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

test("edits of every kind go through a link, and give the same surface to the last bit", async () => {
  const tubes = { shape: "tubes", parameters: { count: 2 } };
  perform(session, "sample", { name: tubes.shape, parameters: tubes.parameters });
  perform(session, "fill", { options: { loops: [0, 2], connect: true } });
  perform(session, "configure", { options: { flow: "mmcv" } });
  take(1);
  perform(session, "adopt");
  perform(session, "subdivide", { options: { scheme: "linear" } });
  perform(session, "invert", { centre: [3.1, 0.2, -1 / 3] });
  perform(session, "configure", {
    options: { flow: "circle", epsilon: 0.03, free: [5, 6, 7, 40, 41] },
  });
  take(2);
  perform(session, "adopt");
  perform(session, "configure", { options: { flow: "flips", criterion: "willmore" } });
  take(2);
  perform(session, "adopt");
  const options = /** @type {const} */ ({ ...defaults, flow: "circle" });
  perform(session, "configure", { options });
  take(3);
  perform(session, "seek", { step: 1 });
  take(1);
  const story = perform(session, "recipe");
  const { step, energy } = perform(session, "state");
  const state = /** @type {any} */ ({
    ...{ ...initial, story, options, reading: { step, energy, status: "ready" } },
    source: { kind: "file", name: "tubes" },
    origin: { kind: "sample", id: "two-tubes" },
  });
  const { edits, path, ...scene } = readScene({ search: "", hash: writeLink(state) });
  assert.deepEqual([edits, path, scene.step], [story.edits, story.path, step]);
  const positions = session.frame(false).positions;
  perform(session, "configure", { options: { flow: "circle" } });
  prepare(session, { mesh: tubes, edits: edits ?? [] }, null, () => {});
  perform(session, "configure", { options });
  follow(session, { flow: options, steps: step, path: path ?? [] }, () => {});
  assert.equal(perform(session, "state").energy, energy);
  assert.deepEqual(session.frame(false).positions, positions);
});

test("a recipe that cannot be followed is refused, with the line or the key", async () => {
  flow({ flow: "circle" });
  take(1);
  const made = await recipe(sphere);
  const text = JSON.stringify(made, null, 1);
  /** @param {string} contents @param {RegExp} said */
  function refused(contents, said) {
    writeFileSync(file("bad.json"), contents);
    const { exit, log } = replay(file("bad.json"));
    assert.match(log, said);
    assert.equal(exit, 3, log);
  }
  refused(text.replace('"steps": 1,', '"steps": 1;'), /line \d+ cannot be read/);
  const line = text.slice(0, text.indexOf('"steps"')).split("\n").length;
  refused(text.replace('"steps": 1,', '"steps": 1;'), new RegExp(`line ${line} `));
  refused("", /line 1/);
  /** @param {object} change @param {RegExp} said */
  const without = (change, said) => refused(JSON.stringify({ ...made, ...change }), said);
  without({ steps: -1 }, /“steps” must be a whole number from 0/);
  without({ flow: { ...made.flow, flo: 1 } }, /no option `flo`\n.*mean `flow`/);
  without({ flow: { ...made.flow, epsilon: "small" } }, /`epsilon` cannot be `small`/);
  without({ flow: { ...made.flow, maxSeconds: 0 } }, /`maxSeconds` cannot be `0`/);
  without({ path: [{ flow: { perturbation: 0.5 } }, { steps: 1 }] }, /`perturbation`/);
  without({ arrangement: { subdivide: 9 } }, /`subdivide` cannot be `9`/);
  // As versions wrote it that had a budget of steps only.
  const { maxSeconds: _, perturbation: __, ...before } = made.flow;
  const older = { ...made, flow: { ...before, maxSteps: 200 } };
  assert.deepEqual(readRecipe(JSON.stringify(older)), older);
  without({ mesh: { ...sphere, parameters: { level: "x" } } }, /“mesh\.parameters”/);
  without({ mesh: { name: "a.obj", sha256: "12", bytes: 3 } }, /“mesh\.sha256”/);
  without({ mesh: { ...sphere, shape: "potato" } }, /potato/);
  without({ path: [{ steps: 2 }] }, /“path”.*steps are 1 in all/);
  without({ edits: [{ flow: null, path: [], edit: "bend" }] }, /“edits\[0\]\.edit”/);
  without({ result: { ...made.result, area: null } }, /“result\.area”/);
  without({ umbilic: undefined }, /“umbilic”/);
});
