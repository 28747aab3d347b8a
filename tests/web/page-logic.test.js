// @ts-check
// The page without a browser: state, links, the words of the status line, file names.

import assert from "node:assert/strict";
import { test } from "node:test";
import { flows } from "../../www/generated/schema.js";
import { defaults, settled, smoothingTau } from "../../www/options.js";
import { createStore, initial, transitions as to } from "../../www/state.js";
import { fileName } from "../../www/ui/download.js";
import { formatNumber } from "../../www/ui/number.js";
import { grown, painted, rim } from "../../www/ui/selection.js";
import { reasonText, statusText, symbol } from "../../www/ui/status.js";

/** @typedef {import("../../www/generated/types.js").State} Reading */

/** @param {Partial<Reading>} [change] @returns {Reading} */
const reading = (change) => ({
  step: 0,
  time: 0,
  status: "ready",
  message: null,
  energy: 8,
  energyNormalised: 4,
  dt: 0.1,
  tau: 1,
  area: 12,
  volume: 4,
  minAngleDegrees: 30,
  monitored: "smoothedCircle",
  objective: 8,
  gradientNorm: 1,
  milliseconds: 0,
  canStepBack: false,
  multipliers: null,
  reducedVolume: null,
  flips: null,
  ...change,
});

/** A page with a mesh on it. @param {import("../../www/state.js").Source} [source] */
function page(source = { kind: "sample", id: "icosahedron" }) {
  const store = createStore();
  const loaded = /** @type {any} */ ({ name: "icosphere", positions: new Float32Array(9) });
  store.update(to.solverReady, "1");
  store.update(to.loading, "icosphere");
  store.update(to.loaded, source, loaded);
  const configured = { freeVertices: 3, meanEdgeLength: 1, dt: 0.1, tau: 1, state: reading() };
  const heldVertices = new Uint8Array(3);
  store.update(to.configured, defaults, { ...configured, heldVertices });
  return store;
}

/** @param {number} step @param {number} energy @returns {any} the frame after a step */
const frame = (step, energy) => ({
  state: reading({ step, energy }),
  reports: [{ step, energy, time: step, dt: 0.1 }],
  positions: new Float32Array(9),
  field: null,
  flippedTriangles: new Uint32Array(0),
  panes: [],
  curves: null,
  jump: null,
});

test("the status line says what is going on", () => {
  assert.equal(statusText(initial), "Starting the solver…");
  const store = page();
  assert.equal(statusText(store.get()), "Ready");
  store.update(to.started, null);
  assert.equal(statusText(store.get()), "Running");
  store.update(to.stopped, reading({ step: 12 }));
  assert.equal(statusText(store.get()), "Paused at step 12");
  store.update(to.stopped, reading({ step: 24, status: "converged" }));
  assert.equal(statusText(store.get()), "Converged after 24 steps");
  store.update(to.stopped, reading({ step: 1, status: "stalled" }));
  assert.equal(statusText(store.get()), "Stalled after 1 step");
  store.update(to.stopped, reading({ step: 7, status: "stepLimit" }));
  assert.equal(statusText(store.get()), "Stopped after 7 steps");
  store.update(to.stopped, reading({ step: 2, status: "singular" }));
  assert.equal(statusText(store.get()), "Singular after 2 steps");
  store.update(to.stopped, reading({ step: 2, status: "collapsed" }));
  assert.equal(statusText(store.get()), "Collapsed after 2 steps");
});

test("the reason is what the solver says beyond the status line", () => {
  const of = (/** @type {Partial<Reading>} */ change) => {
    const store = page();
    store.update(to.stopped, reading(change));
    return reasonText(store.get());
  };
  const [cause, advice] = [{ id: "cause-fold" }, { id: "advice-finer-mesh" }];
  const message = { id: "reason-refused", values: { cause, advice } };
  assert.equal(
    of({ step: 1, status: "stalled", message }),
    "every step tried was refused, the last because faces would fold over; a finer mesh helps",
  );
  const place = { time: 0.04, vertex: 7, place: [0.5, 1e-9, 2], advice };
  const pinch = { id: "reason-pinched-neck", values: place };
  assert.match(
    of({ step: 12, status: "singular", message: pinch }),
    /^at time 0\.04 a neck pinches off at vertex 7, near \(0\.5, 1e-9, 2\);.* a finer mesh helps$/,
  );
  const limit = { id: "reason-step-limit", values: { steps: 10 } };
  assert.equal(
    of({ step: 10, status: "stepLimit", message: limit }),
    "the limit of 10 steps is reached. Play goes on.",
  );
  assert.equal(of({ step: 3 }), "");
});

test("what never rises is kept beside the energy, of stored steps too", () => {
  const store = page();
  store.update(to.started, null);
  const first = frame(1, 7);
  store.update(to.frame, { ...first, reports: [{ ...first.reports[0], objective: 7.5 }] });
  assert.deepEqual(
    store.get().history.map(({ energy, objective }) => [energy, objective]),
    [
      [8, 8],
      [7, 7.5],
    ],
  );
});

test("history follows the steps, forwards and backwards", () => {
  const store = page();
  store.update(to.started, null);
  for (const step of [1, 2, 3]) store.update(to.frame, frame(step, 8 - step));
  const steps = () => store.get().history.map(({ step }) => step);
  assert.deepEqual(steps(), [0, 1, 2, 3]);
  store.update(to.stopped, reading({ step: 3 }));
  store.update(to.frame, { ...frame(2, 6), reports: [] });
  assert.deepEqual(steps(), [0, 1, 2]);
  store.update(to.frame, { ...frame(0, 8), reports: [] });
  assert.deepEqual(steps(), [0]);
  assert.equal(store.get().phase, "ready");
});

test("a refused mesh leaves the one before", () => {
  const store = page();
  const before = store.get();
  store.update(to.loading, "broken.obj");
  assert.equal(store.get().phase, "loading");
  store.update(to.refused);
  assert.equal(store.get().mesh, before.mesh);
  assert.equal(store.get().phase, "ready");
});

test("files are named after mesh, flow and step", () => {
  const store = page();
  store.update(to.stopped, reading({ step: 12 }));
  assert.equal(fileName(store.get(), "ply"), "icosphere-circle-step0012.ply");
  assert.equal(fileName(store.get(), "stl-ascii"), "icosphere-circle-step0012.stl");
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

test("ten steps of τ = 0.01 remove detail below 3.8 edge lengths", () => {
  // 6.7 (N τ)^¼ with N τ = 0.1.
  assert.ok(Math.abs(smoothingTau(6.7 * 0.1 ** 0.25, 10) - 0.01) < 1e-15);
});

test("a brush paints what lies in its ball, and regions grow by rings", () => {
  const positions = Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0]);
  const set = Uint8Array.from([1, 1, 1, 1, 1]);
  painted(set, positions, [1.6, 0.2, 0], 0.7, 0);
  assert.deepEqual([...set], [1, 0, 0, 1, 1]);
  for (const aside of [
    [1.6, 0.9, 0],
    [1.6, 0, 0.9],
  ]) {
    painted(set, positions, aside, 0.7, 1);
    assert.deepEqual([...set], [1, 0, 0, 1, 1], "out of reach");
  }
  // A strip: each triangle has three vertices in a row.
  const strip = Uint32Array.from([0, 1, 2, 1, 2, 3, 2, 3, 4]);
  assert.deepEqual([...grown(set, strip, 0)], [0, 0, 0, 0, 0]);
  assert.deepEqual([...grown(set, strip.subarray(0, 6), 1)], [1, 1, 1, 1, 1]);
  assert.deepEqual([...grown(Uint8Array.from([0, 1, 1, 1, 1]), strip, 0)], [0, 0, 0, 1, 1]);
  assert.deepEqual([...set], [1, 0, 0, 1, 1], "the set itself is not changed by growing");
});

test("a new solver knows nothing of the edits of the old one", () => {
  const store = page();
  const { mesh, source, options } = store.get();
  const earlier = /** @type {any} */ ([{ source, options, what: "3 flips" }]);
  store.update(to.edited, /** @type {any} */ (source), /** @type {any} */ (mesh), earlier);
  assert.equal(store.get().earlier.length, 1);
  store.update(to.reviving);
  assert.equal(store.get().earlier.length, 0);
});

test("as many edits can be undone as the solver keeps", () => {
  const store = page();
  const { mesh, options } = store.get();
  const source = /** @type {const} */ ({ kind: "file", name: "icosphere" });
  const edit = { source, options, history: [] };
  const earlier = Array.from({ length: 9 }, (_, n) => ({ ...edit, what: String(n) }));
  store.update(to.edited, source, /** @type {any} */ (mesh), earlier);
  const kept = store.get().earlier.map(({ what }) => what);
  assert.deepEqual(kept, ["1", "2", "3", "4", "5", "6", "7", "8"]);
});

test("the rim of a region is where one end of an edge is in it", () => {
  const edges = Uint32Array.from([0, 1, 1, 2, 2, 3, 3, 0]);
  assert.deepEqual([...rim(Uint8Array.from([1, 1, 0, 0]), edges)], [1, 2, 3, 0]);
  assert.equal(rim(Uint8Array.from([1, 1, 1, 1]), edges).length, 0);
});

test("every flow has a symbol for what it lowers, whatever was chosen for another", () => {
  for (const { id } of flows) {
    const options = { ...defaults, flow: id };
    assert.match(symbol({ options }), /^(W|Area|∫H²|∫\|∇H\|²)$/, id);
    const before = { ...options, p: 4, tension: 3, keep: /** @type {"area"[]} */ (["area"]) };
    if (id === "p-willmore") assert.equal(symbol({ options: before }), "Energy");
    else assert.equal(symbol({ options: before }), symbol({ options }), id);
  }
  const asked = { ...defaults, flow: /** @type {const} */ ("volume-preserving"), tension: 3 };
  const { p, keep, tension } = settled({ ...asked, regularise: "off" });
  assert.deepEqual({ p, keep, tension }, { p: 0, keep: ["volume"], tension: 0 });
  assert.equal(settled({ ...asked, regularise: "off" }).regularise, "off");
});
