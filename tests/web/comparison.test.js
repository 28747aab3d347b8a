// @ts-check
// Flows side by side as data: what a pane does otherwise, and what of two can be compared.

import assert from "node:assert/strict";
import { test } from "node:test";
import { changeOf, distances, letter, optionsOf, timeUnitsAgree } from "../../www/comparison.js";
import { defaults } from "../../www/options.js";

/** @typedef {Partial<import("../../www/options.js").Options>} Change */

test("what a pane does otherwise comes back from what it does", () => {
  for (const change of /** @type {Change[]} */ ([
    {},
    { epsilon: 0.01 },
    { flow: "p-willmore", p: 4 },
    { flow: "mean-curvature", boundary: "free" },
    { tau: 0.5 },
  ])) {
    assert.deepEqual(changeOf(defaults, optionsOf(defaults, change)), change);
  }
  // The same flow said anew is no difference.
  assert.deepEqual(changeOf(defaults, optionsOf(defaults, { flow: "circle" })), {});
});

test("another flow takes over what means the same to it, and not what is of one flow alone", () => {
  const main = { ...defaults, tau: 0.3, boundary: /** @type {const} */ ("free"), p: 3 };
  const other = optionsOf(main, { flow: "mean-curvature" });
  assert.deepEqual([other.tau, other.boundary, other.p], [null, null, 3]);
});

test("times are compared only where they have one unit", () => {
  const of = (/** @type {Change} */ change) => ({ ...defaults, ...change });
  assert.ok(timeUnitsAgree([of({}), of({ flow: "mean-curvature" })]));
  assert.ok(!timeUnitsAgree([of({}), of({ flow: "surface-diffusion" })]));
  assert.ok(!timeUnitsAgree([of({ flow: "p-willmore", p: 2 }), of({ flow: "p-willmore", p: 4 })]));
  assert.ok(timeUnitsAgree([of({ flow: "p-willmore", p: 2 }), of({ flow: "willmore" })]));
});

test("panes are lettered, and distances are of the same vertices", () => {
  assert.deepEqual([0, 1, 3].map(letter), ["A", "B", "D"]);
  const [a, b] = [Float32Array.of(0, 0, 0, 1, 1, 1), Float32Array.of(0, 3, 4, 1, 1, 1)];
  assert.deepEqual([...distances(a, b)], [5, 0]);
});
