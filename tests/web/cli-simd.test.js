// @ts-check
// The switch that a cargo feature throws and nothing else shows: without it the solver is
// right, and half as fast.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";

test("the dense kernels of the shipped solver use SIMD", async () => {
  const { Session, initSync } = await import("../../www/pkg/solver/solver.js");
  const wasm = new URL("../../www/pkg/solver/solver_bg.wasm", import.meta.url);
  initSync({ module: await readFile(wasm) });
  assert.equal(Session.simdEnabled(), true);
});
