// @ts-check
// The figures of the four papers as the command line prints them: that they come out is tested
// natively, that they say so is tested here. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));
/** @param {string[]} parameters */
const umbilic = (...parameters) =>
  spawnSync(process.execPath, [program, "bench", ...parameters], { encoding: "utf8" });

test("what was measured is said with its numbers, a flow's end in words", () => {
  const ids = ["circle-6-adaptive", "p-willmore-7", "flips-7", "curvature-5.3", "p-willmore-10-p2"];
  const { rows } = JSON.parse(
    umbilic("--table", "figures", "--figures", ids.join(), "--json").stdout,
  );
  const said = Object.fromEntries(rows.map((/** @type {any} */ row) => [row.id, row.measured]));
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
  const [{ figure, expected }] = rows;
  assert.match(figure, /^Fig\. 6/);
  assert.ok(expected.length > 5 && !expected.startsWith("figure-"), expected);
  // A figure that falls short says so, and those on several meshes count the steps of one.
  const outcomes = rows.map((/** @type {any} */ { id, verdict, steps }) => [id, verdict, steps]);
  assert.deepEqual(outcomes.slice(1), [
    ["p-willmore-7", "✓", 0],
    ["p-willmore-10-p2", "✓", 30],
    ["flips-7", "✗", 1],
    ["curvature-5.3", "✓", outcomes[4][2]],
  ]);
});

test("bench prints the figures asked for, and refuses those there are not", () => {
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
});
