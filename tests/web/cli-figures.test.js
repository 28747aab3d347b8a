// @ts-check
// The figures of the four papers: none is left out, and those that take a few seconds come out
// as the papers and the closed forms want them. Needs the wasm build.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { chosen, runFigure } from "../../www/cli/figures.js";
import { openSession } from "../../www/cli/solver.js";
import { figures } from "../../www/figures.js";
import { choices } from "../../www/options.js";
import { samples } from "../../www/samples.js";

const program = fileURLToPath(new URL("../../www/cli.js", import.meta.url));

/** Numbers of the figures that show a result; the others explain notation. */
const results = {
  circle: ["6", "7", "8", "9", "10", "11", "12"],
  "p-willmore": ["1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"],
  flips: ["6", "7", "8"],
  curvature: ["5.1", "5.2", "5.3", "5.4", "5.5", "5.6"],
};

test("every figure that shows a result is there, and no other", () => {
  for (const [paper, numbers] of Object.entries(results)) {
    const ours = figures.filter((figure) => figure.paper === paper);
    const found = ours.map(({ figure }) => /^Fig\. ([\d.]+)/.exec(figure)?.[1]);
    assert.deepEqual(new Set(found), new Set(numbers), paper);
  }
  assert.ok(figures.every(({ paper }) => paper in results));
});

test("figures have ids of their own, samples there are, and words", () => {
  assert.equal(new Set(figures.map(({ id }) => id)).size, figures.length);
  const colours = choices.colour.map(({ id }) => id);
  for (const { id, sample, title, reports, expected, shortfall, colour, steps } of figures) {
    assert.ok(
      samples.some((one) => one.id === sample),
      `${id}: no sample ${sample}`,
    );
    for (const text of [title, reports, expected]) assert.match(text, /\S/, id);
    assert.notEqual(shortfall, "", id);
    assert.ok(colours.includes(colour ?? "none"), id);
    assert.ok(steps === "rest" || (Number.isInteger(steps) && steps >= 0), id);
  }
});

/** How many figures are run: enough of each paper for the table to mean something. */
const quick = figures.filter((figure) => figure.quick);

test("each paper has quick figures that come out", () => {
  for (const paper of Object.keys(results)) {
    const sound = quick.filter((figure) => figure.paper === paper && !figure.shortfall);
    assert.ok(sound.length >= 3, paper);
  }
});

for (const figure of quick) {
  test(`${figure.id}: ${figure.shortfall ? "falls short, as is said" : figure.expected}`, async () => {
    const { value, ok } = figure.measure(runFigure(await openSession(), figure));
    assert.doesNotMatch(value, /undefined/);
    // A shortfall that is no more must not be told any longer.
    assert.equal(ok, !figure.shortfall, value);
  });
}

test("a measurement does not pass what has not run", async () => {
  const session = await openSession();
  for (const figure of quick) {
    // Taking no step, regularising nothing, comparing nothing: the start is not the result.
    const { regularise, refine, ...rest } = figure;
    const { value, ok } = figure.measure(runFigure(session, { ...rest, steps: 0 }));
    assert.equal(ok, false, `${figure.id}: ${value}`);
  }
});

test("flows side by side are run to the rest of each, and only inner loops are filled", async () => {
  const session = await openSession();
  const [compared] = chosen("curvature-5.6", false);
  const { panes } = runFigure(session, compared);
  for (const { name, standing } of panes) assert.equal(standing?.status, "converged", name);
  assert.equal(panes.length, 4);
  const [scan] = chosen("curvature-5.3", false);
  const inner = { ...scan, sample: "holed-scan" };
  assert.equal(runFigure(session, inner).info.boundaryLoops, 1);
});

test("bench prints the figures asked for, and refuses those there are not", () => {
  const umbilic = (/** @type {string[]} */ ...parameters) =>
    spawnSync(process.execPath, [program, "bench", ...parameters], { encoding: "utf8" });
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
  assert.deepEqual(chosen(undefined, true), quick);
});
