// @ts-check
// The scene as text, through the seam: what a page shows is written by the solver, read back, and
// compared. What the solver does with the words is tested in Rust. Needs the wasm build.

import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession } from "../../www/cli/solver.js";
import { sha256 } from "../../www/digest.js";
import { samples } from "../../www/generated/library.js";
import { plainScene } from "../../www/link.js";
import { defaults, plainArrangement } from "../../www/options.js";
import { perform } from "../../www/session.js";
import { elementCode, iframeCode, pageAddress, sayLack } from "../../www/share.js";
import { initial } from "../../www/store.js";
import { say } from "../../www/words.js";
import { readScene, writeScene } from "./support/scene.js";

test("a scene comes back from its link as it was", async () => {
  const session = await openSession();
  const sample = samples.find(({ id }) => id === "thin-torus") ?? samples[0];
  const options = /** @type {const} */ ({
    ...{ ...defaults, ...sample.options, keep: ["area"], p: 3, tau: 1e-9, maxSeconds: null },
  });
  perform(session, "sample", { name: sample.shape, parameters: sample.parameters });
  perform(session, "configure", { options: /** @type {any} */ (options) });
  perform(session, "colour", { field: "mean-curvature" });
  perform(session, "step");
  const { step, energy } = perform(session, "state");
  const source = { kind: "sample", id: sample.id };
  const rivals = [{ change: { flow: "circle" }, reading: { step: 1 } }];
  const view = { ...initial.view, shading: "flat", wireframe: true, cut: 40, scale: "log" };
  const camera = Float32Array.from([1, 0.5, -0.25]);
  const comparison = { ...initial.comparison, rivals, shown: 1 };
  const state = { ...initial, ...{ source, origin: source, view, camera, comparison } };
  const { text, lacks } = writeScene(session, state);
  assert.deepEqual(lacks, []);
  const scene = readScene({ search: "?sample=saddle", hash: `#${text}` });
  assert.deepEqual({ ...defaults, ...sample.options, ...scene.options }, options);
  assert.deepEqual([scene.sample, scene.step, Number(scene.check)], [sample.id, step, energy]);
  assert.deepEqual([scene.colour, scene.camera], ["mean-curvature", camera]);
  assert.deepEqual(scene.view, { shading: "flat", wireframe: true, cut: 40, scale: "log" });
  assert.deepEqual(scene.comparison, {
    ...{ panes: [{ change: { flow: "circle" }, step: null }], lockstep: "step" },
    ...{ shown: 1, difference: null },
  });
  assert.deepEqual([scene.prepares, scene.follows, scene.manySteps], [undefined, undefined, 0]);
  assert.equal(perform(session, "checkLink", { sent: scene.check ?? "", step })?.outcome, "same");
});

test("selections cross as lists, and an arrangement of flips too", async () => {
  const session = await openSession();
  perform(session, "sample", { name: "sampled-torus", parameters: {} });
  perform(session, "configure", { options: { flow: "circle", fixed: [5, 3, 4], free: [9, 10] } });
  const source = { kind: "file", name: "a b&c", sha256: "ab".repeat(32) };
  const state = { ...initial, source, origin: source };
  const { text, lacks } = writeScene(session, state);
  assert.deepEqual(lacks, ["fileByDigest"]);
  const { options, mesh, hash } = readScene({ search: "", hash: `#${text}` });
  assert.deepEqual(
    [options.fixed, options.free],
    [
      [3, 4, 5],
      [9, 10],
    ],
  );
  assert.deepEqual([mesh, hash], ["a b&c", "ab".repeat(8)]);
  const arrangement = { compare: "criteria", subdivide: 2, flipsPerStep: null };
  perform(session, "configure", { options: { flow: "flips" } });
  perform(session, "arrange", { arrangement: /** @type {any} */ (arrangement) });
  const flips = readScene({ search: "", hash: `#${writeScene(session, state).text}` });
  assert.deepEqual({ ...plainArrangement, ...flips.arrangement }, arrangement);
});

test("a link is refused by its word, and a long one tells how long", () => {
  for (const [words, kind] of [
    ["camera=Infinity", "BadValue"],
    ["compare=all", "BadOption"],
    ["epsilonn=1", "UnknownOption"],
    ["step=1&step=2", "BadLink"],
  ]) {
    assert.throws(() => readScene({ search: "", hash: `#${words}` }), { kind });
  }
  assert.equal(readScene({ search: "", hash: "#step=1000000" }).manySteps, 1_000_000);
  const { manySteps, ...plain } = readScene({ search: "?utm_source=mail", hash: "" });
  const { arrangement: _, manySteps: none, ...expected } = plainScene;
  assert.deepEqual([{ ...plain }, manySteps], [{ ...expected, arrangement: {} }, none]);
});

test("what came of a link is said, with what is off and why it may be", () => {
  const values = { energy: 12.345678901234567, sent: 13, step: 7, wanted: 7 };
  const checked = (/** @type {string} */ outcome, more = {}) =>
    say("link-checked", { ...values, outcome, ...more });
  assert.match(checked("same"), /as it was sent: energy 12\.3457/);
  assert.match(checked("near"), /to six digits: energy 12\.3457/);
  assert.match(checked("off"), /not as it was sent.*12\.3457 at step 7.*13/);
  assert.match(checked("endsEarly", { step: 5 }), /step 7.*ends at step 5/);
  const why = (/** @type {string} */ reason) =>
    say("link-differs", { why: reason, theirs: "0.1.0", ours: "0.2.0" });
  assert.match(why("same"), /same version/);
  assert.match(why("version"), /0\.1\.0.*0\.2\.0/);
  assert.match(why("file"), /not the file/);
});

test("what a link lacks is said", () => {
  assert.match(sayLack("fileByDigest"), /send the file too.*SHA-256/);
  assert.doesNotMatch(sayLack("file"), /SHA-256/);
  assert.match(sayLack("editsTooLong"), /edits are too large for a link/);
});

test("a file's digest is SHA-256", async () => {
  // The example of FIPS 180-2, appendix B.1.
  const expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
  assert.equal(await sha256(new TextEncoder().encode("abc")), expected);
});

test("code to embed is well formed, whatever the mesh is called", () => {
  const page = pageAddress({ href: "https://host.example/umbilic/index.html?msaa=1#sample=pipe" });
  assert.equal(page, "https://host.example/umbilic/index.html");
  const hash = "#mesh=a%22%3Cb%3E%26c&flow=p-willmore&smoothSteps=3";
  const frame = iframeCode(page, hash, 'Umbilic: "<b>', [640, 480]);
  assert.match(
    frame,
    /src="https:\/\/host\.example\/umbilic\/index\.html\?embed#mesh=a%22%3Cb%3E%26c&amp;flow/,
  );
  assert.match(frame, /title="Umbilic: &quot;&lt;b>"/);
  const element = elementCode(page, hash, [640, 480]);
  assert.match(element, /src="https:\/\/host\.example\/umbilic\/embed\.js"/);
  assert.match(element, /mesh="a&quot;&lt;b>&amp;c" flow="p-willmore" smooth-steps="3"/);
});
