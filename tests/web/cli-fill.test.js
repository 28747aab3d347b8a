// @ts-check
// `umbilic fill` as it is started, on the wasm solver as it is shipped. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
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

/** @param {string[]} parameters */
function umbilic(parameters) {
  const result = spawnSync(process.execPath, [program, ...parameters], { encoding: "utf8" });
  return { exit: result.status, out: result.stdout, log: result.stderr };
}

/**
 * The JSON of a command.
 * @param {string[]} parameters
 * @param {number} [expected]  exit code
 */
function json(parameters, expected = 0) {
  const { exit, out, log } = umbilic([...parameters, "--json"]);
  assert.equal(exit, expected, `${parameters.join(" ")}\n${out}\n${log}`);
  return JSON.parse(out);
}

/**
 * A sample shape as a file.
 * @param {string} name
 * @param {string[]} parameters
 */
function shape(name, ...parameters) {
  const out = file(`${name}.off`);
  json(["shape", name, ...parameters, "--out", out]);
  return out;
}

/**
 * Lines of an OFF file's vertices and faces.
 * @param {string} name
 */
function lines(name) {
  const text = readFileSync(name, "utf8").split("\n");
  const [header, ...rest] = text.filter((line) => line && line !== "OFF" && !line.startsWith("#"));
  const [vertices, faces] = header.split(" ").map(Number);
  return { vertices: rest.slice(0, vertices), faces: rest.slice(vertices, vertices + faces) };
}

test("fill closes a hemisphere and leaves what was there as it was", () => {
  const [mesh, out] = [shape("hemisphere"), file("closed.off")];
  const report = json(["fill", mesh, "--loops", "all", "--out", out]);
  assert.deepEqual(Object.keys(report), [
    ...["filled", "left", "newVertices", "warnings", "warningIds", "info"],
  ]);
  assert.deepEqual([report.filled, report.left], [[0], []]);
  assert.deepEqual(report.warnings, []);
  const { info } = report;
  assert.deepEqual([info.closed, info.genus, info.boundaryLoops], [true, 0, 0]);
  assert.deepEqual(json(["info", out]).vertices, info.vertices);
  const [before, after] = [lines(mesh), lines(out)];
  assert.deepEqual(after.vertices.slice(0, before.vertices.length), before.vertices);
  assert.deepEqual(after.faces.slice(0, before.faces.length), before.faces);
  assert.equal(after.vertices.length, before.vertices.length + report.newVertices);
  assert.equal(after.faces.length, info.faces);
});

test("fill --loops closes the loops named, --max-vertices bounds the patches", () => {
  const mesh = shape("cylinder");
  const one = json(["fill", mesh, "--loops", "1"]);
  assert.deepEqual([one.filled, one.left, one.info.boundaryLoops], [[1], [0], 1]);
  const both = json(["fill", mesh, "--loops", "0,1"]);
  assert.deepEqual([both.filled, both.info.closed], [[0, 1], true]);
  const few = json(["fill", mesh, "--loops", "all", "--max-vertices", "30"]);
  assert.ok(few.newVertices <= 30 && both.newVertices > 30);
  assert.match(few.warnings[0], /limit of 30/);
  const words = umbilic(["fill", mesh, "--loops", "all", "--max-vertices", "30"]);
  assert.match(words.out, /^newVertices +\d+$[\s\S]*^warning: /m);
});

test("fill --connect blends tubes into one surface", () => {
  const mesh = shape("tubes", "--count", "2", "--around", "16", "--along", "4");
  const report = json(["fill", mesh, "--connect", "--loops", "0,2"]);
  const { components, genus, boundaryLoops } = report.info;
  assert.deepEqual([components, genus, boundaryLoops], [1, 0, 2]);
});

test("fill --fair runs a flow on the new vertices only", () => {
  const [mesh, out] = [shape("hemisphere", "--rings", "8"), file("faired.off")];
  const plain = json(["fill", mesh, "--loops", "all", "--out", file("plain.off")]);
  const report = json([
    "fill",
    mesh,
    "--loops",
    "all",
    "--fair",
    "circle",
    "--steps",
    "5",
    "--out",
    out,
  ]);
  assert.equal(report.fair.flow, "circle");
  assert.ok(report.fair.steps > 0 && report.fair.steps <= 5);
  assert.equal(report.info.vertices, plain.info.vertices);
  const [before, after] = [lines(mesh).vertices, lines(out).vertices];
  assert.deepEqual(after.slice(0, before.length), before);
  assert.notDeepEqual(after, lines(file("plain.off")).vertices);
});

test("fill --fair tells how the flow ended and what the patch joins with", () => {
  const tubes = shape("tubes", "--count", "2", "--around", "20", "--along", "6");
  const connect = ["--connect", "--loops", "0,2"];
  const report = json(["fill", tubes, ...connect, "--fair", "mmcv"]);
  assert.deepEqual(Object.keys(report.fair), [
    ...["flow", "status", "message", "messageId", "steps", "curvatureJump"],
  ]);
  assert.deepEqual([report.fair.flow, report.fair.status], ["mmcv", "converged"]);
  assert.ok(report.fair.steps > 1 && report.fair.steps < 60);
  const { relative, vertices } = report.fair.curvatureJump;
  assert.ok(relative < 0.01 && vertices === 40, `${relative}`);

  // A membrane between them pinches off: told, and the last good patch is written.
  const out = file("pinched.off");
  const pinched = json(["fill", tubes, ...connect, "--fair", "mean-curvature", "--out", out], 4);
  assert.equal(pinched.fair.status, "singular");
  assert.match(pinched.fair.message, /a neck pinches off at vertex \d+/);
  assert.equal(json(["info", out]).vertices, pinched.info.vertices);
  const words = umbilic(["fill", tubes, ...connect, "--fair", "mmcv"]);
  assert.match(
    words.out,
    /^fair\.message +Converged after \d+ steps[\s\S]*^fair\.curvatureJump\.relative +0\.0/m,
  );
});

test("fill warns of what no flow can make good", () => {
  const said = (/** @type {string[]} */ parameters) =>
    json(["fill", ...parameters]).warnings.join();
  // One ring of surface is too little for curvature.
  const ring = shape("cylinder", "--along", "1", "--length", "0.2");
  assert.match(said([ring, "--loops", "0"]), /fewer than three rings/);
  assert.match(said([shape("disk"), "--loops", "all"]), /larger than a hemisphere/);
  // Nothing to move.
  const quad = "OFF\n6 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n-1 2 0\n";
  writeFileSync(file("quad.off"), `${quad}3 1 0 3\n3 3 2 1\n3 2 3 4\n3 3 5 4\n`);
  const none = json([
    "fill",
    file("quad.off"),
    "--loops",
    "all",
    "--max-vertices",
    "0",
    "--fair",
    "mmcv",
  ]);
  assert.equal(none.newVertices, 0);
  assert.equal(none.fair, undefined);
  assert.match(none.warnings.join(), /no new vertex, and nothing for mmcv to move/);
});

test("fill refuses in words", () => {
  const sphere = shape("icosphere", "--level", "1");
  assert.equal(json(["fill", sphere], 3).kind, "NoLoops");
  const cylinder = shape("cylinder");
  assert.equal(json(["fill", cylinder, "--loops", "5"], 3).kind, "LoopOutOfRange");
  assert.equal(json(["fill", shape("moebius")], 3).kind, "NotOrientable");
  assert.equal(json(["fill", shape("disk"), "--connect"], 3).kind, "TooFewLoops");
  // A single triangle has no room for a flow, but is closed all the same.
  writeFileSync(file("triangle.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  assert.equal(json(["fill", file("triangle.off"), "--loops", "all"]).info.closed, true);
  // Its rim is no hole.
  const rim = json(["fill", file("triangle.off")], 3);
  assert.deepEqual([rim.kind, /outer rim/.test(rim.message)], ["NoSmallLoops", true]);
});

test("info lists the boundary loops by the numbers that fill takes", () => {
  const mesh = shape("cylinder");
  const { loops, ...info } = json(["info", mesh]);
  assert.equal(loops.length, info.boundaryLoops);
  for (const { number, edges, length, vertex, small } of loops) {
    // Both mouths of the tube, which stay open unless chosen.
    assert.equal(small, false);
    const filled = json(["fill", mesh, "--loops", String(number)]);
    assert.deepEqual(filled.filled, [number]);
    // A circle of as many edges, about the axis at the vertex.
    const [x, y] = lines(mesh).vertices[vertex].split(" ").map(Number);
    const around = 2 * edges * Math.sin(Math.PI / edges) * Math.hypot(x, y);
    assert.ok(Math.abs(length - around) < 1e-9, `${length}, ${around}`);
  }
  const words = umbilic(["info", mesh]);
  assert.match(words.out, /^loop 1: \d+ edges, length [\d.]+, at vertex \d+; no small hole$/m);
  assert.equal(json(["info", shape("octahedron")]).loops, undefined);
});
