// @ts-check
// The program as it is started, on the wasm solver as it is shipped: closed forms, files
// and exit codes. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
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

/** @param {string} name */
const file = (name) => path.join(folder, name);

/**
 * @param {string[]} parameters
 * @param {string} [input]
 */
function umbilic(parameters, input) {
  const result = spawnSync(process.execPath, [program, ...parameters], { input, encoding: "utf8" });
  return { exit: result.status, out: result.stdout, log: result.stderr };
}

/**
 * The JSON of a command that must succeed.
 * @param {string[]} parameters
 */
function json(parameters) {
  const { exit, out, log } = umbilic([...parameters, "--json"]);
  assert.equal(exit, 0, `${parameters.join(" ")}\n${out}\n${log}`);
  return JSON.parse(out);
}

/**
 * @param {number} actual
 * @param {number} expected
 * @param {number} tolerance  relative to `expected`, absolute when that is 0
 */
function assertNear(actual, expected, tolerance) {
  const error = Math.abs(actual - expected) / (Math.abs(expected) || 1);
  assert.ok(error <= tolerance, `${actual} is not ${expected} (off by ${error})`);
}

/**
 * Corners of an OFF file's vertices.
 * @param {string} name
 */
function vertices(name) {
  const lines = readFileSync(file(name), "utf8")
    .split("\n")
    .filter((line) => line && !line.startsWith("#"));
  const count = Number(lines[1].split(" ")[0]);
  return lines.slice(2, 2 + count).map((line) => line.trim().split(/\s+/).map(Number));
}

test("an icosahedron subdivided in its faces: W = 4π (2ᵏ − 1), Figure 6 of the paper", () => {
  for (const level of [1, 2, 3]) {
    const name = file(`icosahedron${level}.off`);
    json(["shape", "icosahedron", "--level", String(level), "--out", name]);
    const energy = json(["energy", name]);
    assertNear(energy.circle, 4 * Math.PI * (2 ** level - 1), 1e-12);
    assertNear(energy.circleNormalised, energy.circle / 2, 1e-15);
    assert.deepEqual(Object.keys(energy), [
      ...["circle", "circleNormalised", "willmore", "willmoreConsistent", "pWillmore", "area"],
      ...["volume", "conformalDistortion", "gradientNorm"],
    ]);
  }
});

test("a sphere: W = 0, ∫|H|^p dA = 4π, whatever the file format", () => {
  const readings = ["off", "obj", "ply"].map((format) => {
    const name = file(`sphere.${format}`);
    json(["shape", "icosphere", "--level", "4", "--out", name]);
    return json(["energy", name, "--p", "2.5"]);
  });
  const [energy, ...others] = readings;
  assertNear(energy.circle, 0, 1e-9);
  assertNear(energy.willmore, 4 * Math.PI, 5e-3);
  assertNear(energy.willmoreConsistent, 4 * Math.PI, 1e-3);
  assert.ok(energy.willmore < energy.willmoreConsistent);
  assert.deepEqual(Object.keys(energy.pWillmore).sort(), ["0", "1", "2", "2.5", "3", "4"]);
  for (const value of Object.values(energy.pWillmore)) assertNear(value, 4 * Math.PI, 1e-2);
  assertNear(energy.volume, (4 / 3) * Math.PI, 5e-3);
  for (const other of others) assert.deepEqual(other, energy);
});

test("info: the keys, and a torus told from a sphere", () => {
  json(["shape", "torus", "--around", "24", "--tube", "12", "--out", file("torus.stl")]);
  const info = json(["info", file("torus.stl")]);
  assert.deepEqual(Object.keys(info), [
    ...["vertices", "edges", "faces", "components", "boundaryLoops", "eulerCharacteristic"],
    ...["genus", "closed", "oriented", "area", "volume", "meanEdgeLength", "minAngleDegrees"],
    ...["selfIntersections", "warnings", "repairs", "warningIds"],
  ]);
  assert.equal(info.selfIntersections, 0);
  const { vertices, edges, faces, genus, closed, boundaryLoops } = info;
  assert.deepEqual(
    [vertices, edges, faces, genus, closed, boundaryLoops],
    [288, 864, 576, 1, true, 0],
  );
});

test("a Klein bottle passes through itself, before and after a step", () => {
  const bottle = file("bottle.off");
  json(["shape", "klein-bottle", "--along", "48", "--around", "24", "--out", bottle]);
  const { selfIntersections, warnings } = json(["info", bottle]);
  assert.ok(selfIntersections > 10);
  assert.ok(
    warnings.some((/** @type {string} */ w) => w.includes(`in ${selfIntersections} pairs`)),
  );
  const { initial, final } = json(["flow", bottle, "--steps", "1", "--self-intersections"]);
  assert.equal(initial.selfIntersections, selfIntersections);
  // There is no Klein bottle without.
  assert.ok(final.selfIntersections > 10);
});

test("flow: an icosahedron becomes a sphere; report, history and mesh agree", () => {
  const mesh = file("round.off");
  json(["shape", "icosahedron", "--level", "3", "--out", mesh]);
  const report = json([
    ...["flow", mesh, "--until-converged", "--out", file("round.ply")],
    ...["--history", file("round.csv"), "--report", file("round.json")],
  ]);
  assert.equal(report.status, "converged");
  assert.deepEqual(JSON.parse(readFileSync(file("round.json"), "utf8")), report);
  assert.deepEqual(report.initial, json(["energy", mesh]));
  assert.deepEqual(report.final, json(["energy", file("round.ply")]));
  assertNear(report.final.circle, 0, 1e-8);

  for (const [i, step] of report.steps.entries()) {
    assert.equal(step.step, i + 1);
    assert.ok(step.objective <= step.objectiveBefore, `step ${step.step} went up`);
  }
  const keys = [
    ...["step", "time", "dt", "energy", "objectiveBefore", "objective", "gradientNorm", "area"],
    ...["volume", "minAngleDegrees", "rejected", "iterations", "milliseconds"],
  ];
  assert.deepEqual(
    keys.filter((key) => !(key in report.steps[0])),
    [],
  );
  const rows = readFileSync(file("round.csv"), "utf8").trim().split("\n");
  assert.equal(rows.length, report.steps.length + 1);
});

test("flow --scheme paper keeps --dt; --steps is a limit", () => {
  const mesh = file("paper.off");
  json(["shape", "icosahedron", "--level", "3", "--out", mesh]);
  const report = json(["flow", mesh, "--scheme", "paper", "--dt", "0.01", "--steps", "4"]);
  assert.equal(report.status, "stepLimit");
  assert.deepEqual(
    report.steps.map((/** @type {any} */ step) => step.dt),
    [0.01, 0.01, 0.01, 0.01],
  );
});

test("flow: --fixed holds its vertices, --free all others", () => {
  const mesh = file("selected.off");
  json(["shape", "bumpy-sphere", "--level", "2", "--out", mesh]);
  const start = vertices("selected.off");
  const chosen = Array.from({ length: start.length / 3 }, (_, v) => 3 * v);
  writeFileSync(file("chosen.json"), JSON.stringify(chosen));
  for (const option of ["fixed", "free"]) {
    const line = ["--steps", "2", `--${option}`, file("chosen.json"), "--out", file("end.off")];
    json(["flow", mesh, ...line]);
    const moved = vertices("end.off").map((position, v) =>
      position.some((x, i) => x !== start[v][i]),
    );
    const expected = start.map((_, v) => (v % 3 === 0) === (option === "free"));
    assert.deepEqual(moved, expected, option);
  }
});

test("flow: --fixed names vertices by the numbers that they have in the file", () => {
  const { out } = umbilic(["shape", "bumpy-sphere", "--level", "1", "--out", file("plain.obj")]);
  assert.match(out, /42 vertices/);
  // A vertex of no face before all others.
  const text = readFileSync(file("plain.obj"), "utf8");
  const shifted = text.replace(/^f .*/gm, (line) =>
    line.replace(/\d+/g, (n) => `${Number(n) + 1}`),
  );
  writeFileSync(file("numbered.obj"), `v 9 9 9\n${shifted}`);
  const line = ["flow", file("numbered.obj"), "--steps", "2", "--out", file("end.off")];
  const start = text.match(/^v .*/gm)?.map((row) => row.slice(2).split(" ").map(Number)) ?? [];
  writeFileSync(file("chosen.json"), "[2, 5, 43]");
  json([...line, "--fixed", file("chosen.json")]);
  const kept = vertices("end.off").map((p, v) => p.every((x, i) => x === start[v][i]));
  const held = kept.flatMap((is, v) => (is ? [v] : []));
  assert.deepEqual(held, [0, 3, 41]);
  for (const none of [0, 1, 44]) {
    writeFileSync(file("chosen.json"), JSON.stringify([none]));
    const { exit, log } = umbilic([...line, "--fixed", file("chosen.json")]);
    assert.equal(exit, 3);
    assert.match(log, new RegExp(`no vertex ${none}`));
  }
});

test("flips: quadrilaterals are cut into triangles, with a word", () => {
  const quads =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n" +
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  writeFileSync(file("cube.obj"), quads);
  const found = json(["flips", file("cube.obj"), "--out", file("flipped.off")]);
  assert.deepEqual(found.warningIds, ["notice-polygons"]);
  assertNear(found.after.area, 6, 1e-12);
  assert.match(readFileSync(file("flipped.off"), "utf8"), /^8 12 /m);
});

test("shape --selection: a list that flow takes", () => {
  const line = ["--out", file("hole.obj"), "--selection", file("hole.json")];
  const { vertices } = json(["shape", "six-sided-hole", ...line]);
  const { free, fixed } = JSON.parse(readFileSync(file("hole.json"), "utf8"));
  assert.equal(free, null);
  assert.ok(fixed.length > 0 && fixed.length < vertices);
  const mesh = ["flow", file("hole.obj"), "--steps", "1", "--fixed", file("hole.json")];
  assert.equal(json(mesh).steps.length, 1);
});

test("standard input; nothing but the result on standard output", () => {
  const tetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
  const { exit, out, log } = umbilic(["flow", "-", "--steps", "1", "--json"], tetrahedron);
  assert.equal(exit, 0, log);
  // Any tetrahedron has vertices of valence three, whose circles meet in angles of sum 2π.
  assertNear(JSON.parse(out).initial.circle, 0, 1e-12);
});

test("exit codes: 2 bad usage, 3 refused input, 4 numerical failure", () => {
  const three = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
  const refused = umbilic(["info", "-", "--json"], three);
  assert.equal(refused.exit, 3);
  assert.equal(JSON.parse(refused.out).kind, "NonManifoldEdge");

  const level = umbilic(["shape", "icosphere", "--level", "99", "--out", file("x.off"), "--json"]);
  assert.equal(level.exit, 2);
  assert.equal(JSON.parse(level.out).kind, "OutOfRange");

  const around = ["--around", "7.5", "--out", file("x.off"), "--json"];
  const torus = umbilic(["shape", "torus", ...around]);
  assert.deepEqual([torus.exit, JSON.parse(torus.out).kind], [2, "NotAnInteger"]);
  const word = umbilic(["shape", "torus", ...around.with(1, "few")]);
  assert.deepEqual([word.exit, JSON.parse(word.out).kind], [2, "OutOfRange"]);

  const mesh = file("failing.off");
  json(["shape", "icosahedron", "--level", "2", "--out", mesh]);
  const far = ["--scheme", "paper", "--integrator", "forward-euler", "--dt", "1e300"];
  const failed = umbilic(["flow", mesh, ...far, "--json", "--out", file("failed.off")]);
  assert.equal(failed.exit, 4, failed.log);
  const { status, kind, message, hint, final } = JSON.parse(failed.out);
  assert.equal(status, "failed");
  assert.ok(kind && message && hint);
  assert.deepEqual(final, json(["energy", mesh]));
  assert.deepEqual(vertices("failed.off"), vertices("failing.off"));
});

test("bench: a row of positive times", () => {
  const { table, rows } = json(["bench", "--table", "circle", "--max-vertices", "3000"]);
  assert.equal(table, "circle");
  assert.equal(rows.length, 1);
  assert.equal(rows[0].vertices, 2601);
  for (const name of ["assemble", "factor", "solve", "step"]) assert.ok(rows[0][name] > 0, name);
});

test("p-Willmore flow: multipliers, constraints and the sphere's energies", () => {
  const name = file("ellipsoid.ply");
  json(["shape", "ellipsoid", "--level", "3", "--out", name]);
  const free = json(["flow", name, "--flow", "p-willmore", "--until-converged"]);
  assert.equal(free.status, "converged");
  assertNear(free.final.willmore, 4 * Math.PI, 6e-3);
  const last = free.steps.at(-1);
  assertNear(last.energyNormalised, last.energy / (4 * Math.PI), 1e-12);
  assert.ok(!("multipliers" in last) || last.multipliers.tension === null);

  const out = file("vesicle.ply");
  const kept = json(
    ["flow", name, "--flow", "p-willmore", "--keep", "area,volume", "--steps", "12"].concat([
      ...["--p", "3", "--regularise", "linear", "--remesh", "off", "--out", out],
    ]),
  );
  assertNear(kept.final.area, kept.initial.area, 1e-9);
  assertNear(kept.final.volume, kept.initial.volume, 1e-9);
  assert.ok("3" in kept.final.pWillmore);
  for (const step of kept.steps) {
    assert.ok(step.objective <= step.objectiveBefore);
    assert.ok(Number.isFinite(step.multipliers.tension + step.multipliers.pressure));
  }
  const info = json(["info", out]);
  assertNear(info.volume, kept.final.volume, 1e-12);

  const ramp = ["--reduced-volume", "0.8", "--steps", "8"];
  const led = json(["flow", name, "--flow", "p-willmore", ...ramp]);
  const volumes = led.steps.map((/** @type {any} */ step) => step.reducedVolume);
  assert.ok(volumes.at(-1) < volumes[0], "the volume is led down");
  assertNear(led.final.area, led.initial.area, 1e-9);
});

test("mean-curvature variation: a restored sphere, and jumps of curvature", () => {
  const [name, selection, out] = [file("openings.ply"), file("openings.json"), file("round.off")];
  const written = ["--out", name, "--selection", selection];
  json(["shape", "sphere-openings", "--level", "4", ...written]);
  const options = ["--flow", "mmcv", "--free", selection, "--until-converged", "--out", out];
  const restored = json(["flow", name, ...options]);
  assert.equal(restored.status, "converged");
  assert.ok(restored.steps.length <= 15);
  assert.ok(restored.curvatureJump.relative < 2e-3 && restored.curvatureJump.vertices > 100);
  for (const p of vertices("round.off")) assertNear(Math.hypot(...p), 1, 5e-4);
  // At rest is less than a thousandth of an edge; a smaller step that raised the reading is not
  // taken.
  const last = restored.steps.at(-1);
  assert.ok(last.update < 1e-3 && last.linearResidual < 1e-6);

  const [bumps, patch] = [file("bumps.ply"), file("bumps.json")];
  json(["shape", "four-bumps", "--vertices", "31", "--out", bumps, "--selection", patch]);
  const jump = (/** @type {string} */ flow) => {
    const found = json(["flow", bumps, "--flow", flow, "--free", patch, "--until-converged"]);
    assert.equal(found.status, "converged", flow);
    return found.curvatureJump.relative;
  };
  const flows = ["mean-curvature", "surface-diffusion", "willmore", "mmcv"];
  const [second, fourth, willmore, sixth] = flows.map(jump);
  assert.ok(second > 0.9 && sixth < 0.6 * Math.min(fourth, willmore));
  const paper = ["--scheme", "paper", "--dt", "2", "--steps", "5"];
  const whole = json(["flow", bumps, "--flow", "mmcv", "--free", patch, ...paper]);
  for (const step of whole.steps) assert.equal(step.dt, 2);
});

test("surfaces that the p-Willmore flow cannot take are refused with what to do", () => {
  const name = file("open.ply");
  json(["shape", "hemisphere", "--out", name]);
  const commands = [
    ["flow", name, "--flow", "p-willmore"],
    ["regularise", name],
  ];
  for (const command of commands) {
    const { exit, out } = umbilic([...command, "--json"]);
    const { kind, hint } = JSON.parse(out);
    assert.equal(kind, "NotClosed");
    assert.ok(exit === 3 || exit === 4);
    assert.match(hint, /circle-angle/);
  }
});

test("regularise tells what it gained, and writes quadrilaterals as such", () => {
  // A cube of 4 × 4 quadrilaterals a side, on a sphere, its vertices pushed about.
  const n = 4;
  /** @type {Map<string, number>} */
  const index = new Map();
  /** @type {string[]} */
  const vertexLines = [];
  /** @type {string[]} */
  const faceLines = [];
  const at = (/** @type {number[]} */ key) => {
    const found = index.get(key.join());
    if (found !== undefined) return found;
    const p = key.map((k, i) => (2 * k) / n - 1 + (k % n ? 0.1 * Math.sin(7 * (i + k)) : 0));
    const size = Math.hypot(...p);
    vertexLines.push(`v ${p.map((c) => c / size).join(" ")}`);
    index.set(key.join(), vertexLines.length);
    return vertexLines.length;
  };
  for (let axis = 0; axis < 3; axis += 1) {
    for (const side of [0, n]) {
      for (let i = 0; i < n; i += 1) {
        for (let j = 0; j < n; j += 1) {
          const corners = [
            [i, j],
            [i + 1, j],
            [i + 1, j + 1],
            [i, j + 1],
          ].map(([a, b]) => {
            const key = [0, 0, 0];
            [key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]] = [side, a, b];
            return at(key);
          });
          faceLines.push(`f ${(side === 0 ? corners.reverse() : corners).join(" ")}`);
        }
      }
    }
  }
  const name = file("quads.obj");
  writeFileSync(name, `${[...vertexLines, ...faceLines].join("\n")}\n`);
  const out = file("regular.obj");
  const outcome = json(["regularise", name, "--features", "0", "--out", out]);
  assert.ok(outcome.passes > 0);
  assert.ok(outcome.after.distortion < outcome.before.distortion);
  assert.ok(outcome.distance < 0.05);
  const faces = readFileSync(out, "utf8")
    .split("\n")
    .filter((line) => line.startsWith("f "));
  assert.equal(faces.length, 6 * n * n);
  assert.ok(faces.every((line) => line.trim().split(/\s+/).length === 5));
  const flow = json(["flow", name, "--flow", "p-willmore", "--steps", "5"]);
  assert.ok(flow.steps.at(-1).energy < flow.steps[0].energy);
});

test("regularise keeps a part of flat sides as it is, or refuses and writes nothing", () => {
  // A bar, its sides of two triangles each.
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1, (i >> 1) & 1, 6 * (i >> 2)]);
  const sides = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"];
  const faces = sides.flatMap((side) => {
    const [a, b, c, d] = side.split(" ");
    return [`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`];
  });
  const name = file("bar.obj");
  writeFileSync(name, `${[...corners.map((p) => `v ${p.join(" ")}`), ...faces].join("\n")}\n`);
  const out = file("refused.obj");
  const refused = umbilic(["regularise", name, "--out", out, "--json"]);
  assert.equal(refused.exit, 4);
  const { kind, message, hint } = JSON.parse(refused.out);
  assert.equal(kind, "OnlyCreases");
  assert.match(message, /all 8 vertices lie on creases/);
  assert.match(hint, /^Refine the mesh first/);
  assert.ok(!existsSync(out));
  const outcome = json(["regularise", name, "--iterations", "0"]);
  const keys = ["passes", "before", "after", "distance", "pinned", "milliseconds"];
  assert.deepEqual(Object.keys(outcome), keys);
  assert.deepEqual([outcome.passes, outcome.pinned, outcome.distance], [0, 8, 0]);
});

test("flips: connectivity by three criteria, with its history, readable again", () => {
  const name = file("rough.ply");
  json(["shape", "ellipsoid", "--level", "3", "--jitter", "0.2", "--out", name]);
  const energy = json(["energy", name]);
  /** @type {Record<string, any>} */
  const ends = {};
  for (const criterion of ["area", "willmore", "localised"]) {
    const [out, history] = [file(`${criterion}.off`), file(`${criterion}.csv`)];
    const outcome = json(
      ["flips", name, "--criterion", criterion, "--out", out].concat(["--history", history]),
    );
    assert.deepEqual(Object.keys(outcome), ["flips", "rejected", "before", "after"]);
    assertNear(outcome.before.circle, energy.circle, 1e-10);
    assertNear(outcome.before.area, energy.area, 1e-12);
    const after = json(["energy", out]);
    assertNear(outcome.after.circle, after.circle, 1e-9);
    assertNear(outcome.after.area, after.area, 1e-12);
    const rows = readFileSync(history, "utf8").trim().split("\n");
    assert.equal(rows.length, outcome.flips + 1);
    assert.equal(rows[0], "flip,fromA,fromB,toA,toB,reduction,area,circle");
    assertNear(Number(rows.at(-1)?.split(",")[7]), outcome.after.circle, 1e-12);
    ends[criterion] = outcome;
  }
  assert.ok(ends.area.after.area < ends.willmore.after.area);
  const few = json(["flips", name, "--max", "5"]);
  assert.equal(few.flips, 5);
  // The default is the localised energy, and its first flips are those of the whole run.
  const rows = readFileSync(file("localised.csv"), "utf8").split("\n");
  assertNear(few.after.circle, Number(rows[5].split(",")[7]), 1e-12);
});
