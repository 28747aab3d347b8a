// @ts-check
// `umbilic bench --table robustness`: what its rows say. Needs the wasm build.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { robustnessColumns, robustnessRows, shaken } from "../../www/cli/robustness.js";
import { openSession } from "../../www/cli/solver.js";
import { perform } from "../../www/session.js";
import { FakeSession } from "./support/fake-session.js";

let folder = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
});
after(() => rmSync(folder, { recursive: true }));

/** @param {any} session */
const rows = (session) => [...robustnessRows(session, { maxVertices: Infinity, meshes: folder })];

test("a row tells the largest rise within a step, and the smallest angle of all", () => {
  writeFileSync(path.join(folder, "mesh.obj"), "v 0 0 0\n");
  writeFileSync(path.join(folder, "notes.txt"), "no mesh\n");
  const session = new FakeSession({ endAfter: 3, ending: "stalled" });
  const [step, state] = [session.step.bind(session), session.state.bind(session)];
  // Between the steps another functional was taken up: from 8 to 20 is no rise.
  const objectives = [
    [10, 8],
    [20, 21],
    [21, 21.42],
  ];
  const angles = [25, 12, 18];
  Object.assign(session, {
    load: () => {
      session.step_ = 0;
      session.over = false;
      return { info: { vertices: 3 } };
    },
    state: () => ({ ...state(), energy: 30 - session.step_, minAngleDegrees: 40 }),
    step: () => {
      const report = step();
      const [objectiveBefore, objective] = objectives[session.step_ - 1];
      const minAngleDegrees = angles[session.step_ - 1];
      return report && { ...report, objectiveBefore, objective, minAngleDegrees };
    },
  });
  const found = rows(session);
  assert.deepEqual(
    found.map(({ flow }) => flow),
    [
      ...["circle", "p-willmore", "p-willmore, area, volume"],
      ...["mean-curvature", "surface-diffusion", "willmore", "mmcv"],
    ],
  );
  for (const { seconds, flow: _, ...row } of found) {
    const ends = { ending: "stalled", steps: 3, first: 30, last: 27 };
    assert.deepEqual(row, { case: "mesh.obj", ...ends, rise: 0.05, angle: 12 });
    assert.equal(typeof seconds, "number");
  }
  for (const [name, options] of session.calls) {
    assert.equal(name, "configure");
    assert.equal(/** @type {any} */ (options).maxSteps, 100);
  }
});

test("what is refused is a row too, and the others go on", async () => {
  writeFileSync(path.join(folder, "mesh.obj"), "v 0 0 0\nf 1 2 3\n");
  // A square of two triangles: open, and too small for curvatures by fits.
  const square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  writeFileSync(path.join(folder, "square.off"), square);
  const session = await openSession();
  perform(session, "sample", { name: "ellipsoid", parameters: { level: 2 } });
  writeFileSync(path.join(folder, "tall.ply"), perform(session, "export", { format: "ply" }));
  const found = rows(session);
  const columns = robustnessColumns.toSorted();
  for (const row of found) assert.deepEqual(Object.keys(row).sort(), columns);
  const of = (/** @type {string} */ name) => found.filter((row) => row.case === name);
  assert.equal(of("mesh.obj").length, 1);
  assert.match(String(of("mesh.obj")[0].ending), /^refused: \w+$/);
  assert.equal(of("square.off").length, 7);
  assert.equal(of("square.off")[1].ending, "refused: NotClosed");
  const tall = of("tall.ply");
  assert.equal(tall.length, 7);
  for (const { flow, ending, steps, first, last, rise } of tall) {
    assert.doesNotMatch(String(ending), /refused|failed/, String(flow));
    assert.ok(Number(steps) > 0 && Number(steps) <= 100, String(flow));
    assert.ok(Number(last) < Number(first), String(flow));
    // A reading by fits may lie a thousandth above its least.
    assert.ok(Number(rise) <= (flow === "willmore" || flow === "mmcv" ? 1e-3 : 0), String(flow));
  }
});

test("noise is normally distributed, and the same each time", () => {
  // A strip of unit squares: the mean edge length is 1.
  const count = 2000;
  const points = Array.from({ length: 2 * count }, (_, n) => [n >> 1, n & 1, 0]);
  const faces = Array.from({ length: count - 1 }, (_, n) =>
    [0, 1, 3, 2].map((corner) => 2 * n + corner),
  );
  const moved = shaken({ points, faces }, 0.1).points;
  const moves = moved.flatMap((p, n) => p.map((x, k) => x - points[n][k]));
  const mean = moves.reduce((sum, x) => sum + x, 0) / moves.length;
  const moment = (/** @type {number} */ k) =>
    moves.reduce((sum, x) => sum + (x / 0.1) ** k, 0) / moves.length;
  // Of 12,000 numbers: standard errors are 0.0009, 0.013 and 0.09.
  assert.ok(Math.abs(mean) < 0.004, `${mean}`);
  assert.ok(Math.abs(moment(2) - 1) < 0.05, `${moment(2)}`);
  assert.ok(Math.abs(moment(4) - 3) < 0.36, `${moment(4)}`);
  assert.deepEqual(shaken({ points, faces }, 0.1).points, moved);
});
