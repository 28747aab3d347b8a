// @ts-check
// The page without a browser: the words of the status line, numbers, colours, selections, axes.

import assert from "node:assert/strict";
import { test } from "node:test";
import { flows } from "../../www/generated/schema.js";
import { formatBeside, formatNumber } from "../../www/number.js";
import { defaults, settled } from "../../www/options.js";
import { histogram, rangeOf, roundedUp } from "../../www/range.js";
import { fileName } from "../../www/save.js";
import { clause, statusText, surfaceLabel, symbol } from "../../www/status.js";
import { initial } from "../../www/store.js";
import { labelled, thinned } from "../../www/view/curve.js";
import { isLogarithmic, ticksOf } from "../../www/view/plot.js";

/** @param {any} [change] @returns {any} */
const reading = (change) => ({
  step: 0,
  status: "ready",
  message: null,
  energy: 8,
  area: 12,
  ...change,
});

/** A page with a mesh on it. @param {any} [change] @returns {any} */
const page = (change) => ({
  ...initial,
  ...{ version: "1", phase: "ready", source: { kind: "sample", id: "icosahedron" } },
  mesh: { name: "icosphere", positions: new Float32Array(9) },
  reading: reading(),
  ...change,
});

test("the status line says what is going on", () => {
  const status = (/** @type {any} */ s, /** @type {any} */ shown = s.reading, isPlaying = false) =>
    statusText(s, shown, isPlaying);
  assert.equal(status(initial), "Starting the solver…");
  assert.equal(status(page()), "Ready");
  assert.equal(status(page({ running: true })), "Running");
  assert.equal(status(page(), reading({ step: 3 }), true), "Running", "the clip is played");
  assert.equal(status(page({ running: true, goal: 20 })), "Running to step 20");
  // Of the step that is shown, wherever the solver is.
  const there = page({ reading: reading({ step: 24, status: "converged" }) });
  assert.equal(status(there, reading({ step: 12 })), "Paused at step 12");
  assert.equal(status(there), "Converged after 24 steps");
  for (const [state, said] of [
    ["stalled", "Stalled after 1 step"],
    ["stepLimit", "Stopped after 1 step"],
    ["singular", "Singular after 1 step"],
    ["collapsed", "Collapsed after 1 step"],
  ]) {
    assert.equal(status(page({ reading: reading({ step: 1, status: state }) })), said);
  }
  assert.equal(status(page({ phase: "loading", loadingName: "own.obj" })), "Loading own.obj…");
  assert.equal(status(page({ phase: "loading", loadingName: null })), "Restoring the surface…");
  assert.equal(status(page({ phase: "failed" })), "The solver is not running");
});

test("one clause follows: what to do, how far it is, or why it ended", () => {
  const of = (/** @type {any} */ change) => clause(page(), reading(change), false, 10);
  assert.equal(of({}), "Press Play or the space bar.");
  assert.equal(of({ step: 3 }), "");
  const [cause, advice] = [{ id: "cause-fold" }, { id: "advice-finer-mesh" }];
  const message = { id: "reason-refused", values: { cause, advice } };
  assert.equal(
    of({ step: 1, status: "stalled", message }),
    "every step tried was refused, the last because faces would fold over. A finer mesh helps",
  );
  const limit = { id: "reason-step-limit", values: { steps: 10 } };
  assert.equal(
    of({ step: 10, status: "stepLimit", message: limit }),
    "the limit of 10 steps is reached. Play goes on.",
  );
  assert.equal(clause(page(), reading({ step: 7 }), true, 23), "step 7 of 23");
});

test("the surface is told in words, with the name of its sample", () => {
  assert.equal(surfaceLabel(initial, null), "Surface: none yet");
  assert.equal(
    surfaceLabel(page(), reading({ step: 2, energy: 7.5 })),
    "Surface: Subdivided icosahedron, step 2, energy 7.500, area 12.00",
  );
});

test("what falls has a symbol", () => {
  const of = (/** @type {any} */ change) => symbol({ options: { ...initial.options, ...change } });
  assert.equal(of({}), "Willmore energy W");
  assert.equal(of({ flow: "p-willmore" }), "∫H²");
  assert.equal(of({ flow: "p-willmore", p: 4 }), "∫|H|^4");
  assert.equal(of({ flow: "p-willmore", p: 0 }), "Area");
  assert.equal(of({ flow: "p-willmore", tension: 1 }), "Energy");
  assert.equal(of({ flow: "mmcv" }), "∫|∇H|²");
});

test("files are named after mesh, flow and step", () => {
  const s = page({ reading: reading({ step: 12 }) });
  assert.equal(fileName(s, "ply"), "icosphere-circle-step0012.ply");
  assert.equal(fileName(s, "stl-ascii"), "icosphere-circle-step0012.stl");
  assert.equal(fileName(s, "recipe"), "icosphere-circle-step0012.recipe.json");
});

test("numbers keep their digits and stay readable by machines", () => {
  assert.equal(formatNumber(188.4955592), "188.50");
  assert.equal(formatNumber(4.9e-8), "4.9000e-8");
  assert.equal(formatNumber(0), "0");
  assert.equal(formatNumber(null), "–");
  for (const value of [1e-12, 0.02, 3.5, 99999.7, 1e9, -4.2]) {
    assert.ok(Math.abs(Number(formatNumber(value)) - value) <= 5e-5 * Math.abs(value));
  }
});

test("a number that is lost in rounding beside its start shows as 0", () => {
  assert.equal(formatBeside(113.957, 113.957), "114.0");
  assert.equal(formatBeside(35.393, 113.957), "35.39");
  assert.equal(formatBeside(0.0742, 113.957), "0.0742");
  assert.equal(formatBeside(3e-9, 113.957), "0");
  assert.equal(formatBeside(undefined, 1), "–");
});

test("a range of colours is round, and about zero where values are signed", () => {
  assert.deepEqual([0.31, 2.91, 4, 61].map(roundedUp), [0.4, 3, 4, 80]);
  assert.deepEqual(rangeOf({ high: 0.78, signed: true }), [-0.8, 0.8]);
  assert.deepEqual(rangeOf({ high: 0.78, signed: false }), [0, 0.8]);
  assert.deepEqual(rangeOf({ high: -3, signed: false }), [0, 1]);
});

test("a histogram counts everything, what is beyond the range at its ends", () => {
  const shares = histogram(Float32Array.of(-9, -0.9, 0.1, 0.9, 9, Number.NaN), [-1, 1], 4);
  assert.deepEqual(shares, [2 / 5, 0, 1 / 5, 2 / 5]);
});

test("steps below the curve have numbers where there is room", () => {
  const points = /** @type {any} */ (
    [0, 0.01, 0.3, 0.31, 0.5, 0.97, 1].map((sum, step) => ({ sum, state: { step } }))
  );
  assert.deepEqual(
    labelled(points, 1).map(([{ state }, room]) => [state.step, room]),
    [
      [0, 0],
      [2, 0],
      [4, 1],
      [6, 0],
    ],
  );
  const long = Array.from({ length: 5001 }, (_, step) => ({ sum: step, state: { step } }));
  const some = thinned(/** @type {any} */ (long));
  assert.ok(some.length <= 601);
  assert.equal(some.at(-1)?.state.step, 5000);
});

test("an axis has round ticks, and powers of ten where it falls far", () => {
  assert.deepEqual(ticksOf(0, 114, false), [0, 50, 100]);
  assert.deepEqual(ticksOf(0.01, 200, true).map(Math.log10).map(Math.round), [-2, -1, 0, 1, 2]);
  assert.equal(isLogarithmic("auto", [100, 1, 0]), true);
  assert.equal(isLogarithmic("auto", [100, 50]), false);
  assert.equal(isLogarithmic("linear", [100, 1]), false);
});

test("every flow has a symbol for what it lowers, whatever was chosen for another", () => {
  for (const { id } of flows) {
    const options = { ...defaults, flow: id };
    assert.match(symbol({ options }), /^(Willmore energy W|Area|∫H²|∫\|∇H\|²)$/, id);
    const before = { ...options, p: 4, tension: 3, keep: /** @type {"area"[]} */ (["area"]) };
    if (id === "p-willmore") assert.equal(symbol({ options: before }), "Energy");
    else assert.equal(symbol({ options: before }), symbol({ options }), id);
  }
  const asked = { ...defaults, flow: /** @type {const} */ ("volume-preserving"), tension: 3 };
  const { p, keep, tension } = settled({ ...asked, regularise: "off" });
  assert.deepEqual({ p, keep, tension }, { p: 0, keep: ["volume"], tension: 0 });
  assert.equal(settled({ ...asked, regularise: "off" }).regularise, "off");
});
