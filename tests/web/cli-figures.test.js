// @ts-check
// The figures of the four papers as the command line prints them: that they come out is tested
// natively, that they say so is tested here. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { chosen, figureRows } from "../../www/cli/figures.js";
import { openSession } from "../../www/cli/solver.js";
import { figures } from "../../www/generated/library.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
/** @param {string[]} parameters */
const umbilic = (...parameters) =>
  spawnSync(process.execPath, [program, "bench", ...parameters], { encoding: "utf8" });

test("what was measured is said with its numbers, a flow's end in words", async () => {
  const ids = ["circle-6-adaptive", "p-willmore-7", "flips-7", "curvature-5.3", "p-willmore-10-p2"];
  const rows = [...figureRows(await openSession(), chosen(ids.join(), false))];
  const said = Object.fromEntries(rows.map(({ id, measured }) => [id, measured]));
  const number = String.raw`\d+(\.\d+)?(e-\d+)?`;
  for (const [id, pattern] of Object.entries({
    "circle-6-adaptive": `W ${number} after \\d+ steps, converged`,
    "p-willmore-7": `inverted \\d+ → 0, angle ${number}° → ${number}°, distortion ${number} → ${number}, moved ${number} %, volume ${number} %`,
    "flips-7": `area/Willmore/localised: \\d+/\\d+/\\d+ flips, area (${number}/?){3}, W (${number}/?){3}`,
    "curvature-5.3": `0 loops left, converged in \\d+ steps, jump ${number}`,
    "p-willmore-10-p2": `(${number},? ?){3}: ratio ${number}`,
  })) {
    assert.match(said[id], new RegExp(`^${pattern}$`), id);
  }
  // A figure that falls short says so, and those on several meshes count the steps of one.
  const outcomes = rows.map(({ id, verdict, steps }) => [id, verdict, steps]);
  assert.deepEqual(outcomes.slice(1), [
    ["p-willmore-7", "✓", 0],
    ["p-willmore-10-p2", "✓", 30],
    ["flips-7", "✗", 1],
    ["curvature-5.3", "✓", outcomes[4][2]],
  ]);
});

test("a figure that cannot be run is a cross, and the others go on", () => {
  const freed = { count: 0 };
  /** @type {any} */
  const session = {
    figureRun: (/** @type {string} */ id) => ({
      steps: 3,
      advance() {
        if (id === "circle-9") throw { kind: "Singular", message: "no way on", hint: "" };
        return { ok: true, message: { id: "measured-lost", values: { lost: 0.5 } } };
      },
      free: () => {
        freed.count += 1;
      },
    }),
  };
  const rows = [...figureRows(session, chosen("circle-9,circle-10", false))];
  assert.deepEqual(
    rows.map(({ id, figure, measured, verdict, steps }) => [id, figure, measured, verdict, steps]),
    [
      ["circle-9", "Fig. 9", "Singular: no way on", "✗", 3],
      ["circle-10", "Fig. 10", "0.5 % lost", "✓", 3],
    ],
  );
  assert.equal(freed.count, 2);
});

test("bench prints the figures asked for, and refuses those there are not", () => {
  assert.deepEqual(
    chosen("flips-8,circle-9", false).map(({ id }) => id),
    ["circle-9", "flips-8"],
  );
  const asked = umbilic("--table", "figures", "--figures", "flips-8,circle-9", "--json");
  assert.equal(asked.status, 0, asked.stderr);
  const { table, rows } = JSON.parse(asked.stdout);
  assert.equal(table, "figures");
  assert.deepEqual(
    rows.map((/** @type {any} */ { id, verdict, steps }) => [id, verdict, steps]),
    [
      ["circle-9", "✓", 50],
      ["flips-8", "✓", 1],
    ],
  );
  const none = umbilic("--table", "figures", "--figures", "circle-1");
  assert.equal(none.status, 2);
  assert.match(none.stderr, /circle-1.*\n?.*circle-6/s);
  assert.equal(umbilic("--table", "circle", "--max-vertices", "1", "--quick").status, 2);
  assert.deepEqual(
    chosen(undefined, true),
    figures.filter(({ quick }) => quick),
  );
});
