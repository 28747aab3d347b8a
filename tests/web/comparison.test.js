// @ts-check
// Comparing flows without a browser: whose turn it is, what a pane does, how far surfaces are
// apart, and the words of a link.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  alone,
  changeOf,
  distances,
  lastTurn,
  newRival,
  nextTurn,
  optionsOf,
  sharedFields,
  timeExponent,
  timeUnitsAgree,
} from "../../www/comparison.js";
import { canStepBack, comparisonTransitions as on } from "../../www/comparison-state.js";
import { pageScene } from "../../www/link.js";
import { defaults } from "../../www/options.js";
import { initial, transitions as to } from "../../www/state.js";
import { curvesOf } from "../../www/ui/comparison-plot.js";
import { objection, presets } from "../../www/ui/comparison-presets.js";
import { captions, differences } from "../../www/ui/comparison-words.js";
import { readScene } from "./support/scene.js";

/** @param {Partial<import("../../www/generated/types.js").State>} [change] @returns {any} */
const reading = (change) => ({
  step: 0,
  time: 0,
  status: "ready",
  message: null,
  energy: 8,
  dt: 0.1,
  area: 12,
  volume: 4,
  minAngleDegrees: 30,
  canStepBack: false,
  ...change,
});

/** @param {number} step @param {number} time @param {boolean} [mayStep] */
const at = (step, time, mayStep = true) => ({ step, time, mayStep });

/** A page with panes beside the first. @param {Partial<import("../../www/options.js").Options>[]} changes */
function page(changes) {
  const mesh = /** @type {any} */ ({ name: "ball", positions: new Float32Array(9) });
  const source = /** @type {const} */ ({ kind: "sample", id: "icosahedron" });
  let state = to.loaded(initial, source, mesh);
  const configured = /** @type {any} */ ({ state: reading() });
  state = to.configured(state, defaults, configured);
  state = on.compared(state, { rivals: changes.map((change, n) => newRival(n + 1, change)) });
  for (const [n, change] of changes.entries()) {
    state = on.rivalConfigured(state, n + 1, change, configured);
  }
  return state;
}

/** @param {number} step @param {Partial<import("../../www/generated/types.js").State>} [change] @returns {any} */
const frame = (step, change) => ({
  state: reading({ step, time: step / 10, ...change }),
  reports: step > 0 ? [reading({ step, time: step / 10, ...change })] : [],
  positions: new Float32Array(9),
  field: null,
  flippedTriangles: new Uint32Array(),
  panes: [],
});

test("by step all step at once, and those behind catch up first", () => {
  assert.deepEqual(nextTurn([at(4, 0.1), at(4, 9)], "step"), [0, 1]);
  assert.deepEqual(nextTurn([at(4, 0.1), at(2, 9), at(2, 7)], "step"), [1, 2]);
  // Whoever has come to an end holds nobody up.
  assert.deepEqual(nextTurn([at(4, 0), at(1, 0, false), at(4, 0)], "step"), [0, 2]);
  assert.deepEqual(nextTurn([at(4, 0, false), at(4, 0)], "step"), [1]);
  assert.deepEqual(nextTurn([at(4, 0, false), at(1, 0, false)], "step"), []);
});

test("by time the one that is behind goes next", () => {
  assert.deepEqual(nextTurn([at(1, 0.3), at(5, 0.2), at(2, 0.4)], "time"), [1]);
  assert.deepEqual(nextTurn([at(0, 0), at(0, 0)], "time"), [0, 1]);
  // A step of 1 beside steps of ½: both, the small one, both, …
  const sizes = [1, 0.5];
  const panes = [at(0, 0), at(0, 0)];
  const turns = [1, 2, 3, 4].map(() => {
    const turn = nextTurn(panes, "time");
    for (const n of turn) {
      panes[n].step += 1;
      panes[n].time += sizes[n];
    }
    return turn;
  });
  assert.deepEqual(turns, [[0, 1], [1], [0, 1], [1]]);
  assert.deepEqual(
    panes.map(({ step }) => step),
    [2, 4],
  );
});

test("a step back is that of those in front", () => {
  const standing = (/** @type {number} */ step, /** @type {number} */ time, mayGoBack = true) => ({
    ...at(step, time),
    mayGoBack,
  });
  assert.deepEqual(lastTurn([standing(3, 1), standing(5, 0.5), standing(5, 2)], "step"), [1, 2]);
  assert.deepEqual(lastTurn([standing(3, 1), standing(5, 0.5), standing(5, 2)], "time"), [2]);
  assert.deepEqual(lastTurn([standing(3, 1), standing(5, 1, false)], "step"), [0]);
  assert.deepEqual(lastTurn([standing(0, 0, false)], "step"), []);
});

test("a pane does as the first but for its change", () => {
  const main = { ...defaults, tau: 0.5, boundary: /** @type {const} */ ("free"), epsilon: 0.2 };
  assert.deepEqual(optionsOf(main, { epsilon: 0.01 }), { ...main, epsilon: 0.01 });
  // Another flow: a size of step says nothing there.
  const other = optionsOf(main, { flow: "mmcv" });
  assert.deepEqual([other.tau, other.boundary, other.epsilon], [null, null, 0.2]);
  for (const change of [{}, { epsilon: 0.01 }, { flow: "mmcv", tau: 2 }, { keep: ["area"] }]) {
    const typed = /** @type {Partial<import("../../www/options.js").Options>} */ (change);
    assert.deepEqual(changeOf(main, optionsOf(main, typed)), change);
  }
  // What agrees with the first again is no change any more.
  assert.deepEqual(changeOf(main, { ...main, epsilon: 0.2 }), {});
  assert.deepEqual(differences(main, [{ epsilon: 0.01 }, { scheme: "paper" }]), [
    "recommended scheme, ε = 0.2",
    "recommended scheme, ε = 0.01",
    "the paper’s scheme, ε = 0.2",
  ]);
});

test("times are compared where they have one unit", () => {
  const of = (/** @type {Partial<import("../../www/options.js").Options>} */ change) => ({
    ...defaults,
    ...change,
  });
  assert.equal(timeExponent(of({ flow: "circle" })), 2);
  assert.equal(timeExponent(of({ flow: "p-willmore", p: 2 })), 4);
  assert.equal(timeExponent(of({ flow: "mmcv" })), 6);
  assert.ok(timeUnitsAgree([of({ flow: "surface-diffusion" }), of({ flow: "willmore" })]));
  assert.ok(timeUnitsAgree([of({ flow: "p-willmore", p: 0 }), of({ flow: "mean-curvature" })]));
  assert.ok(!timeUnitsAgree([of({ flow: "willmore" }), of({ flow: "mmcv" })]));
});

test("distances are those of the same vertices, on one scale for all panes", () => {
  const a = Float32Array.of(0, 0, 0, 1, 1, 1);
  const b = Float32Array.of(3, 4, 0, 1, 1, 1);
  const c = Float32Array.of(0, 0, 0, 1, 1, 3);
  assert.deepEqual([...distances(a, b)], [5, 0]);
  const picture = (/** @type {Float32Array} */ positions) => ({
    ...{ positions, field: null, flippedTriangles: new Uint32Array() },
  });
  const fields = sharedFields([picture(a), picture(b), picture(c)], 0);
  assert.deepEqual(
    fields.map((field) => field && [...field.values]),
    [
      [0, 0],
      [5, 0],
      [0, 2],
    ],
  );
  for (const field of fields) {
    assert.deepEqual([field?.low, field?.high, field?.label], [0, 5, "Distance to A"]);
  }
  assert.equal(sharedFields([picture(a), picture(b)], 1)[0]?.values[0], 5);
  // A pane that has nothing yet.
  assert.deepEqual(sharedFields([picture(a), null], 0)[1], null);
});

test("fields of all panes share the widest range", () => {
  const values = new Float32Array(3);
  const own = (/** @type {number} */ low, /** @type {number} */ high) => ({
    positions: new Float32Array(9),
    field: { name: /** @type {const} */ ("willmore"), label: "", values, low, high, signed: false },
    flippedTriangles: new Uint32Array(),
  });
  const fields = sharedFields([own(1, 3), own(0, 2)], null);
  assert.deepEqual(
    fields.map((field) => [field?.low, field?.high]),
    [
      [0, 3],
      [0, 3],
    ],
  );
  assert.deepEqual(sharedFields([{ ...own(0, 1), field: null }], null), [null]);
});

test("each pane has its own history, and says where it stands", () => {
  let state = page([{ epsilon: 0.01 }, { scheme: "paper" }]);
  state = to.frame(state, { ...frame(1, { energy: 6 }), curves: null, jump: null });
  state = on.rivalFrame(state, 1, frame(1, { energy: 7, canStepBack: true }));
  state = on.rivalFrame(state, 1, frame(2, { energy: 5, status: "converged", canStepBack: true }));
  state = on.rivalLost(state, 2, "Its solver stopped: out of memory");
  state = on.bent(state, null, 1, 13);
  state = on.bent(state, 1, 2, 14);
  const own = curvesOf(state).map((curve) => curve.map(({ step, value }) => [step, value]));
  assert.deepEqual(own[0], [
    [0, 8],
    [1, 6],
  ]);
  assert.deepEqual(own[1], [
    [0, 8],
    [1, 7],
    [2, 5],
  ]);
  const bending = on.compared(state, { quantity: "bending" });
  assert.deepEqual(
    curvesOf(bending).map((curve) => curve.map(({ value }) => value)),
    [[null, 13], [null, null, 14], [null]],
  );
  const said = captions(state);
  assert.match(said[0], /^A: recommended scheme, ε = 0.1 · step 1, energy 6.000, t = 0.100$/);
  assert.match(said[1], /^B: .*ε = 0.01 · step 2, energy 5.000, t = 0.200 · converged$/);
  assert.match(said[2], /^C: the paper’s scheme.* · Its solver stopped: out of memory$/);
  assert.ok(canStepBack(state));
  // A step back forgets what came after.
  state = on.rivalFrame(state, 1, { ...frame(1, { energy: 7 }), reports: [] });
  assert.equal(curvesOf(state)[1].length, 2);
  const { bending: kept } = on.bent(state, 1, 1, 15).comparison.rivals[0];
  assert.deepEqual([kept.length, kept[1]], [2, 15]);
  // Another mesh: the panes stay, and nothing of what they had.
  const other = to.loaded(state, { kind: "file", name: "x" }, /** @type {any} */ ({}));
  assert.deepEqual(other.comparison.rivals[0], newRival(1, { epsilon: 0.01 }));
});

test("ready-made comparisons are offered where they make sense", () => {
  const mesh = (/** @type {boolean} */ closed, /** @type {any} */ free = null) =>
    /** @type {any} */ ({ info: { closed }, free, fixed: null });
  /** @param {any} on */
  const offered = (on) =>
    presets()
      .filter((preset) => objection(preset, on, defaults) === "")
      .map(({ id }) => id);
  const closed = ["epsilon", "scheme", "exponents", "regularised", "willmore"];
  assert.deepEqual(offered(mesh(true)), closed);
  assert.deepEqual(offered(mesh(false)), ["epsilon", "scheme", "curvature"]);
  // A patch of a closed surface.
  assert.ok(offered(mesh(true, new Uint32Array(1))).includes("curvature"));
});

test("a comparison closes with its last pane, and shows no pane that is gone", () => {
  let state = page([{}, {}]);
  state = on.compared(state, { shown: 1, difference: 2, lockstep: "time" });
  const fewer = on.compared(state, { rivals: state.comparison.rivals.slice(0, 1) });
  assert.deepEqual([fewer.comparison.shown, fewer.comparison.difference], [1, null]);
  assert.equal(on.compared(state, { rivals: [] }).comparison, alone);
});

test("a link names the panes in plain characters, and brings them back", () => {
  const changes = /** @type {Partial<import("../../www/options.js").Options>[]} */ ([
    { epsilon: 0.01 },
    { flow: "p-willmore", p: 2, keep: ["area", "volume"], tau: 1e-7 },
    {},
  ]);
  let state = page(changes);
  state = to.frame(state, { ...frame(3), curves: null, jump: null });
  for (const [id, step] of [
    [1, 3],
    [2, 1],
    [3, 3],
  ]) {
    state = on.rivalFrame(state, id, frame(step));
  }
  state = on.compared(state, { shown: 1, difference: 0 });
  const { comparison } = pageScene(state, false);
  assert.deepEqual(comparison, {
    panes: [
      { change: changes[0], step: 3 },
      { change: changes[1], step: 1 },
      { change: {}, step: 3 },
    ],
    lockstep: "step",
    shown: 1,
    difference: 0,
  });
  const panes = "epsilon_0.01*flow_p-willmore_p_2_keep_area,volume_tau_1e-7_step_1*same";
  const read = readScene({ search: "", hash: `#panes=${panes}&shown=B&difference=A` });
  assert.deepEqual(read.comparison, {
    panes: [
      { change: changes[0], step: null },
      { change: changes[1], step: 1 },
      { change: {}, step: null },
    ],
    lockstep: "step",
    shown: 1,
    difference: 0,
  });
  const all = readScene({ search: "", hash: "#panes=same" });
  assert.equal(all.comparison?.shown, "side");
});
