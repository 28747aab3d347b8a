// @ts-check
// The scene as text: whatever a page can show is read back as it was written.

import assert from "node:assert/strict";
import { test } from "node:test";
import { sha256 } from "../../www/digest.js";
import { samples } from "../../www/generated/library.js";
import { sharedLink, writeLink } from "../../www/link.js";
import { compareEnergy, verdict } from "../../www/link-check.js";
import { decodeEdits } from "../../www/link-edits.js";
import { decodeRegion, encodeRegion, LONGEST } from "../../www/link-region.js";
import { defaults } from "../../www/options.js";
import { initial } from "../../www/state.js";
import { elementCode, iframeCode, missing, pageAddress } from "../../www/ui/share.js";
import { readScene } from "./support/scene.js";

/** Numbers in [0, 1) that are the same every time. @param {number} seed */
function numbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** @param {() => number} random */
function chooser(random) {
  /** @template T @param {readonly T[]} list @returns {T} */
  const of = (list) => list[Math.floor(random() * list.length)];
  const real = (/** @type {number} */ low, /** @type {number} */ high) =>
    low * (high / low) ** random();
  const whole = (/** @type {number} */ most) => 1 + Math.floor(random() * most);
  /** @template T @param {T} value @returns {T | null} */
  const maybe = (value) => (random() < 0.5 ? value : null);
  const yes = () => random() < 0.5;
  return { of, real, whole, maybe, yes };
}

/** @param {() => number} random @param {number} most */
function someVertices(random, most) {
  const list = [];
  const dense = random();
  for (let v = 0; v < most; v += 1) if (random() < dense) list.push(v);
  return list;
}

/** A state of the page, anything in it that a link carries. @param {number} seed */
function randomState(seed) {
  const random = numbers(seed);
  const { of, real, whole, maybe, yes } = chooser(random);
  const flow = of(["circle", "p-willmore", "surface-diffusion", "willmore", "mmcv", "flips"]);
  const sample = of(samples);
  const own = yes();
  const step = yes() ? whole(5000) : 0;
  return /** @type {any} */ ({
    ...initial,
    phase: "paused",
    version: "0.1.0",
    source: own
      ? { kind: "file", name: of(["bunny", "a b&c=d#é", "100%"]), sha256: "ab".repeat(32) }
      : { kind: "sample", id: sample.id },
    figure: own || yes() ? null : { id: "circle-6", sample: sample.id },
    options: {
      ...defaults,
      flow,
      scheme: of(["auto", "paper"]),
      integrator: of(["semi-implicit", "l-bfgs"]),
      boundary: of([null, "clamped", "fixed", "free"]),
      goal: of(["relax", "smooth"]),
      detail: real(0.1, 1000),
      smoothSteps: whole(1000),
      tau: maybe(real(1e-9, 1e9)),
      dt: maybe(real(1e-100, 1e100)),
      mass: of(["auto", "uniform", "area"]),
      epsilon: real(1e-6, 1),
      sharpen: yes(),
      prefill: yes(),
      maxSteps: maybe(whole(9999)),
      maxSeconds: maybe(real(1e-3, 1e6)),
      perturbation: 0.3 * random(),
      p: real(1, 16),
      keep: of([[], ["area"], ["volume"], ["area", "volume"]]),
      regularise: of(["off", "linear", "nonlinear"]),
      reducedVolume: maybe(real(0.01, 1)),
      tension: real(1e-3, 1e3) * (yes() ? 1 : -1),
      criterion: of(["area", "willmore", "localised"]),
      guardFolds: yes(),
      rungs: of([null, 0, 7]),
      free: maybe(someVertices(random, whole(3000))),
      fixed: maybe(someVertices(random, whole(300))),
    },
    arrangement: {
      compare: of(["none", "start", "criteria"]),
      subdivide: of([0, 1, 2]),
      flipsPerStep: of([null, 1, 100]),
    },
    colour: of(["none", "mean-curvature", "displacement"]),
    camera: maybe(Float32Array.from({ length: 8 }, () => random() - 0.5)),
    view: {
      ...initial.view,
      shading: of(["smooth", "flat"]),
      wireframe: yes(),
      boundary: yes(),
      scale: of(["auto", "log", "linear"]),
    },
    reading: { step, energy: real(1e-12, 1e6), status: "ready" },
    history: [{ step: 0, time: 0, dt: 0, energy: 10 }],
  });
}

test("two thousand random scenes come back from their links as they were", () => {
  for (let seed = 1; seed <= 2000; seed += 1) {
    const state = randomState(seed);
    const hash = sharedLink(state);
    const scene = readScene({ search: "?sample=saddle", hash });
    const { source, figure, reading, camera, view } = state;
    const about = `seed ${seed}: ${hash.slice(0, 400)}`;
    const base = samples.find(({ id }) => id === source.id)?.options;
    assert.deepEqual({ ...defaults, ...base, ...scene.options }, state.options, about);
    assert.equal(scene.sample, source.id ?? null, about);
    assert.equal(scene.mesh, source.name ?? null, about);
    assert.equal(scene.hash, source.sha256?.slice(0, 16) ?? null, about);
    assert.equal(scene.figure, figure?.id ?? null, about);
    assert.equal(scene.step, reading.step, about);
    assert.equal(scene.colour, state.colour, about);
    assert.equal(scene.version, "0.1.0", about);
    assert.equal(Number(scene.check), reading.energy, about);
    if (state.options.flow === "flips") {
      const plain = { compare: "none", subdivide: 0, flipsPerStep: 1 };
      assert.deepEqual({ ...plain, ...scene.arrangement }, state.arrangement, about);
    }
    const { theme, systemDark, ...drawn } = view;
    const { theme: _, systemDark: __, ...plain } = initial.view;
    assert.deepEqual({ ...plain, ...scene.view }, drawn, about);
    for (const [n, x] of (camera ?? []).entries()) {
      assert.ok(Math.abs((scene.camera?.[n] ?? NaN) - x) <= 5e-5 * Math.abs(x), about);
    }
  }
});

test("the address has nothing to check at the start, and nothing on the way to a step", () => {
  const state = { ...randomState(3), goal: null };
  const at = (/** @type {number} */ step) => ({ ...state, reading: { ...state.reading, step } });
  assert.ok(!/check=|version=/.test(writeLink(at(0))));
  assert.match(writeLink(at(4)), /version=0\.1\.0&check=/);
  assert.match(sharedLink(at(0)), /check=/);
  const running = { ...at(4), goal: 9 };
  assert.ok(!/check=/.test(writeLink(running)));
  assert.match(writeLink(running), /step=9/);
});

test("regions come back whole, however they lie, and nonsense is passed over", () => {
  const random = numbers(7);
  for (let n = 0; n < 500; n += 1) {
    const list = someVertices(random, Math.floor(random() * 400));
    assert.deepEqual(decodeRegion(encodeRegion(list) ?? ""), list);
  }
  assert.deepEqual(decodeRegion(encodeRegion([5, 1, 3, 1]) ?? ""), [1, 3, 5], "in any order");
  const far = Array.from({ length: 1000 }, (_, i) => 9_000_000 + i);
  assert.ok((encodeRegion(far) ?? "").length < 12, "a run is short, wherever it lies");
  assert.deepEqual(decodeRegion(encodeRegion(far) ?? ""), far);
  for (const text of [
    "",
    "x",
    "q12",
    "r%%",
    "r____________",
    "rgA",
    "r*",
    "rB",
    `b${"A".repeat(7000)}`,
  ]) {
    assert.equal(decodeRegion(text), undefined, text);
  }
});

test("a region must not make a browser set aside gigabytes", () => {
  // A run of 2²⁵ vertices, in five bytes.
  const bytes = String.fromCharCode(0, 0x80, 0x80, 0x80, 0x10);
  assert.ok(decodeRegion(`r${btoa(bytes).replace(/=+$/, "")}`) === undefined);
});

test("a region that no link can hold is left out, and that is said", () => {
  const scattered = Array.from({ length: 60_000 }, (_, i) => 2 * i);
  assert.equal(encodeRegion(scattered), null);
  const fits = Array.from({ length: 17_000 }, (_, i) => 2 * i);
  assert.ok((encodeRegion(fits) ?? "").length <= LONGEST);
  const state = randomState(11);
  const large = { ...state, options: { ...state.options, free: scattered, fixed: null } };
  assert.ok(!writeLink(large).includes("free="));
  assert.ok(writeLink(large).length < LONGEST);
  assert.match(missing(large).join(" "), /too large for a link/);
});

test("what a link lacks is said: a file, an edit by hand", () => {
  const state = randomState(1);
  const options = { ...state.options, free: null, fixed: null };
  const of = (/** @type {any} */ change, origin = change.source) =>
    missing({ ...state, options, origin, ...change }).join(" ");
  assert.equal(of({ source: { kind: "sample", id: "pipe" } }), "");
  assert.match(
    of({ source: { kind: "file", name: "a", sha256: "00" } }),
    /send the file along.*SHA-256/,
  );
  assert.doesNotMatch(of({ source: { kind: "file", name: "a", sha256: "" } }), /SHA-256/);
  assert.match(of({ source: { kind: "file", name: "a" } }, null), /edited by hand/);
});

/** What may have been done to a mesh. @param {number} seed */
function randomStory(seed) {
  const random = numbers(seed);
  const { of, real, whole, maybe, yes } = chooser(random);
  const flow = () => ({
    ...randomState(whole(1e6)).options,
    free: maybe(someVertices(random, whole(200))),
    fixed: maybe(someVertices(random, whole(200))),
  });
  const path = () =>
    Array.from({ length: whole(4) - 1 }, () =>
      of([
        "anew",
        { steps: whole(99) },
        { regularise: { mode: "linear", epsilon: real(1e-9, 1) } },
        { flow: flow() },
      ]),
    );
  const edit = () =>
    of([
      "adopt",
      { fill: { loops: of(["all", [0, 2]]), connect: yes(), maxVertices: whole(9999) } },
      { flip: { criterion: "area", maxFlips: whole(99) } },
      { subdivide: { scheme: of(["linear", "loop"]) } },
      { invert: [real(0.1, 9), -real(0.1, 9), real(1e-9, 1)] },
    ]);
  const chapter = () => ({ flow: maybe(flow()), path: path(), edit: edit() });
  return { edits: Array.from({ length: whole(4) }, chapter), flow: flow(), path: path() };
}

/** @param {any} story */
const edited = (story, seed = 1) => ({
  ...randomState(seed),
  source: { kind: "file", name: "icosphere" },
  origin: { kind: "sample", id: "icosahedron" },
  story,
});
/** @param {string} hash */
const wordsOf = (hash) => new URLSearchParams(hash.slice(1));

test("what was done by hand comes back from a link as it was", () => {
  let [paths, changed] = [0, 0];
  for (let seed = 1; seed <= 500; seed += 1) {
    const story = randomStory(seed);
    const steps = story.path.map((/** @type {any} */ leg) => leg.steps ?? 0);
    const step = steps.reduce((a, b) => a + b, 0);
    const state = { ...edited(story, seed), reading: { step, energy: 1, status: "ready" } };
    const about = `seed ${seed}: ${writeLink(state).slice(0, 400)}`;
    const scene = readScene({ search: "", hash: writeLink(state) });
    assert.equal(scene.sample, "icosahedron", about);
    assert.deepEqual(scene.edits, story.edits, about);
    const isPlain = step > 0 || story.path.length === 0;
    if (isPlain && steps.every(Boolean)) assert.equal(scene.path, null, about);
    else assert.deepEqual(scene.path, story.path, about);
    if (scene.path) paths += 1;
    // Where the flow changed on the way, the link's own words are those it began with.
    const changes = story.path.some((/** @type {any} */ leg) => leg.flow);
    if (changes) assert.deepEqual({ ...defaults, ...scene.options }, story.flow, about);
    changed += Number(changes);
    // On the way to a later step it is longer by what is left.
    const later = readScene({ search: "", hash: writeLink({ ...state, goal: step + 7 }) });
    if (scene.path) assert.deepEqual(later.path, [...story.path, { steps: 7 }], about);
  }
  assert.ok(paths > 100 && changed > 50, `${paths} paths, ${changed} with another flow`);
});

test("of an unedited mesh no edits are written, not even those a sample is made with", () => {
  const { edits, ...story } = randomStory(3);
  const source = { kind: "sample", id: "icosahedron" };
  const state = { ...edited({ ...story, edits: [edits[0]] }), source, origin: source };
  assert.ok(!wordsOf(writeLink(state)).has("edits"));
  const own = { kind: "file", name: "bunny", sha256: "ab".repeat(32) };
  const words = wordsOf(writeLink({ ...edited({ ...story, edits }), origin: own }));
  assert.deepEqual([words.get("mesh"), words.get("hash")], ["bunny", "ab".repeat(8)]);
  assert.deepEqual(decodeEdits(words.get("edits")), edits);
});

test("edits that fit no link are left out, and that is said", () => {
  const chapter = (/** @type {number[] | null} */ free) => ({
    flow: { ...defaults, free },
    path: [{ steps: 2 }],
    edit: "adopt",
  });
  const story = (/** @type {any[]} */ edits) => ({ edits, flow: defaults, path: [] });
  const scattered = Array.from({ length: 60_000 }, (_, i) => 2 * i);
  const many = Array.from({ length: 200 }, () => chapter([1, 2, 3]));
  for (const edits of [[chapter(scattered)], many]) {
    const state = edited(story(edits));
    const words = wordsOf(writeLink(state));
    assert.deepEqual([words.has("edits"), words.get("mesh")], [false, "icosphere"]);
    assert.match(missing(state).join(" "), /edits are too large for a link/);
  }
  const fits = edited(story(many.slice(0, 40)));
  assert.ok((wordsOf(writeLink(fits)).get("edits") ?? "").length <= LONGEST);
  assert.ok(wordsOf(writeLink(fits)).has("edits"));
  assert.doesNotMatch(missing(fits).join(" "), /edit/);
});

test("edits that make no sense are passed over", () => {
  const read = (/** @type {unknown} */ value, more = "") => {
    const text = typeof value === "string" ? value : btoa(JSON.stringify(value)).replace(/=+$/, "");
    return readScene({ search: "", hash: `#sample=icosahedron&edits=${text}${more}` });
  };
  const good = { flow: {}, path: [], edit: "adopt" };
  assert.deepEqual(read([good]).edits, [{ ...good, flow: defaults }]);
  for (const value of [
    ...["", "%%", "e30", "A".repeat(7000), null, 7, {}, [null], [[]], ["adopt"]],
    ...[[{ ...good, edit: "erase" }], [{ ...good, path: [{ steps: -1 }] }]],
    [{ path: [], edit: "adopt" }, 1],
  ]) {
    assert.equal(read(value).edits, null, JSON.stringify(value).slice(0, 80));
  }
  // Of an option that cannot be, nothing is passed over.
  for (const [flow, kind] of /** @type {const} */ ([
    [{ p: "2" }, "BadOption"],
    [{ free: "x" }, "BadOption"],
    [{ constructor: 1 }, "UnknownOption"],
  ])) {
    assert.throws(() => read([{ ...good, flow }]), { kind });
  }
  const gone = readScene({
    search: "",
    hash: `#sample=gone&edits=${btoa(JSON.stringify([good]))}`,
  });
  assert.equal(gone.edits, null, "of a sample that there is no more");
  // A path must end where the link says.
  const path = btoa(JSON.stringify([{ steps: 2 }, "anew", { steps: 3 }])).replace(/=+$/, "");
  assert.equal(read([good], `&step=5&path=${path}`).path?.length, 3);
  assert.equal(read([good], `&step=6&path=${path}`).path, null);
});

test("energies are compared to the last bit, or as far as they were written", () => {
  const energy = 188.49555921538757;
  assert.equal(compareEnergy(String(energy), energy), "same");
  assert.equal(compareEnergy("188.49555921538760", energy), "near");
  assert.equal(compareEnergy("188.4956", energy), "same");
  assert.equal(compareEnergy("188.4957", energy), "near");
  assert.equal(compareEnergy("188.50", energy), "off", "too few digits, and not that number");
  assert.equal(compareEnergy("188.4970", energy), "off");
  // All gone: what is left is rounding.
  assert.equal(compareEnergy("3e-15", 8e-16, 12), "near");
  assert.equal(compareEnergy("3e-5", 8e-6, 12), "off");
});

test("the verdict names what is off, and why it may be", () => {
  const state = randomState(5);
  const energy = 12.345678901234567;
  const here = { ...state, version: "0.2.0", reading: { step: 7, energy, status: "ready" } };
  const scene = { ...readScene({ search: "", hash: "#step=7&version=0.2.0&sample=pipe" }) };
  const say = (/** @type {any} */ change, /** @type {any} */ now = here, isFile = true) =>
    verdict({ ...scene, ...change }, now, "W", isFile);
  assert.equal(say({ check: null }), null);
  assert.match(say({ check: String(energy) })?.message ?? "", /as it was sent: W = 12\.34/);
  const off = say({ check: "13.0000000" });
  assert.equal(off?.isGood, false);
  assert.match(off?.message ?? "", /not as it was sent.*step 7.*13\.0000.*0\.65/);
  assert.match(off?.hint ?? "", /same version/);
  assert.match(say({ check: "13.0000000", version: "0.1.0" })?.hint ?? "", /0\.1\.0.*0\.2\.0/);
  assert.match(say({ check: "13.0000000" }, here, false)?.hint ?? "", /not the file/);
  const short = { ...here, reading: { step: 5, energy, status: "stalled" } };
  assert.match(say({ check: "13.0000000" }, short)?.message ?? "", /step 7.*ends at step 5/);
  // Paused by the user on the way, or played on.
  for (const step of [5, 9]) {
    const paused = { ...here, reading: { step, energy, status: "ready" } };
    assert.equal(say({ check: "13.0000000" }, paused), null);
  }
});

test("nonsense in a link is passed over", () => {
  const hash = "#mesh=a&hash=xyz&figure=<b>&check=1e999&version=<i>&scale=cubic&border=";
  const scene = readScene({ search: "", hash });
  assert.deepEqual(
    [scene.hash, scene.figure, scene.check, scene.version, scene.options, scene.view],
    [null, null, null, null, {}, { boundary: true }],
  );
  for (const check of ["", "12 ", "x", "NaN", "1,5", "Infinity"]) {
    assert.equal(readScene({ search: "", hash: `#check=${check}` }).check, null, check);
  }
  // A figure alone is a scene of its own; with a sample it is the sample's.
  assert.equal(readScene({ search: "", hash: "#figure=circle-6" }).sample, null);
  assert.equal(readScene({ search: "", hash: "#figure=circle-6&sample=pipe" }).sample, "pipe");
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
