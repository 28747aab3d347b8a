// @ts-check
// The page's side of a worker that crashes or falls silent, without a browser: the worker is made
// of numbers written down.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { createPage } from "../../www/actions.js";
import { LOST } from "../../www/channel.js";
import { loadSolver } from "../../www/cli/solver.js";
import { plyOf } from "../../www/ply.js";
import { perform } from "../../www/session.js";
import { createSolver } from "../../www/solver.js";
import { statusText } from "../../www/status.js";
import { createStore } from "../../www/store.js";
import { say } from "../../www/words.js";
import { FakeWorker } from "./support/fake-worker.js";
import { obj, wavyTorus } from "./support/meshes.js";

beforeEach(() => FakeWorker.begin());

/** What a listener was told, and a solver that tells it. @param {number} [patience] */
function listened(patience) {
  /** @type {any[][]} */
  const said = [];
  /** @param {string} name */
  const note =
    (name) =>
    (/** @type {any[]} */ ...values) =>
      said.push([name, ...values]);
  const listener = /** @type {any} */ ({});
  for (const name of ["onReady", "onFrame", "onStopped", "onProgress", "onCrashed", "onSilent"]) {
    listener[name] = note(name);
  }
  const solver = createSolver(listener, { patience, pause: 0 });
  const heard = (/** @type {string} */ name) => said.filter(([one]) => one === name);
  return { solver, heard };
}

/** A mesh from a file, and some steps of a flow on it. @param {import("../../www/solver.js").Solver} solver @param {number} steps */
async function run(solver, steps) {
  await solver.load("own.obj", Uint8Array.of(1, 2, 3));
  await solver.configure({ flow: "circle" });
  for (let n = 0; n < steps; n += 1) await solver.ask("step");
}

/** Positions of a binary PLY with `double` coordinates. @param {Uint8Array} bytes */
function positionsOf(bytes) {
  const end = new TextDecoder("latin1").decode(bytes).indexOf("end_header\n") + 11;
  const head = new TextDecoder().decode(bytes.subarray(0, end));
  assert.match(head, /binary_little_endian[\s\S]*property double x/);
  const count = Number(/element vertex (\d+)/.exec(head)?.[1]);
  const view = new DataView(bytes.buffer, bytes.byteOffset + end);
  const positions = Array.from({ length: 3 * count }, (_, n) => view.getFloat64(8 * n, true));
  const faces = [1, 5, 9].map((at) => view.getInt32(24 * count + at, true));
  return { positions, faces };
}

test("a scene outlives crashes in a row, those on the way back too, in double precision", async () => {
  const { solver, heard } = listened();
  await run(solver, 4);
  const before = FakeWorker.last.exact;
  // Wherever on the way.
  const order = ["load", "configure", "restore", "load", "restore"];
  FakeWorker.crashesAt = ({ name }, worker) => name === order[FakeWorker.all.indexOf(worker) - 1];
  FakeWorker.last.crash("the first");
  const state = await solver.revive();
  assert.equal(state?.step, 4);
  assert.equal(FakeWorker.all.length, order.length + 2);
  assert.deepEqual(heard("onCrashed"), [["onCrashed", "the first"]], "one crash is told");
  assert.deepEqual([...FakeWorker.last.exact], [...before]);
  assert.notEqual(Math.fround(before[0]), before[0], "a number that single precision lacks");
  assert.equal((await solver.ask("step"))?.step, 5);
});

test("a solver that never comes back is given up, and a later request brings the scene first", async () => {
  const { solver } = listened();
  await run(solver, 2);
  const before = [...FakeWorker.last.exact];
  FakeWorker.crashesAt = ({ name }) => name === "configure";
  FakeWorker.last.crash("for good");
  await assert.rejects(solver.revive(), { kind: "SolverLostAgain" });
  const tried = FakeWorker.all.length;
  // What is shown can be had without one.
  const { format, bytes } = await solver.export("obj");
  assert.equal(format, "ply");
  assert.deepEqual(positionsOf(bytes), { positions: before, faces: [0, 1, 2] });
  assert.equal(FakeWorker.all.length, tried, "and asks for none");

  FakeWorker.crashesAt = () => false;
  assert.equal((await solver.ask("step"))?.step, 3);
  const names = FakeWorker.last.asked.map(({ name }) => name);
  assert.deepEqual(names, ["load", "configure", "restore", "step"]);
  const own = { format: "obj", bytes: Uint8Array.of(3), losses: [] };
  assert.deepEqual(await solver.export("obj"), own);
});

test("the page's own copy is to the bit what the solver writes, far from the origin too", async () => {
  const { Session } = await loadSolver();
  for (const far of [0, 1e6]) {
    const session = new Session();
    const text = obj(wavyTorus(12, 8)).replace(/^v (\S+)/gm, (_, x) => `v ${Number(x) + far}`);
    const bytes = new TextEncoder().encode(text);
    const { shift, triangles } = perform(session, "load", { bytes, name: "far.obj" });
    perform(session, "configure", { options: {} });
    perform(session, "step");
    const { exact } = session.frame();
    const own = plyOf(exact, shift, triangles, null);
    const body = (/** @type {Uint8Array} */ file) =>
      Buffer.from(file.subarray(Buffer.from(file).indexOf("end_header\n") + 11));
    assert.ok(body(own).equals(body(perform(session, "export", { format: "ply" }))), `at ${far}`);
    assert.equal(shift[0] !== 0, far !== 0);
    session.free();
  }
});

test("the page's own copy has the colours of the file", async () => {
  const { Session } = await loadSolver();
  const session = new Session();
  const ball = wavyTorus(12, 8);
  const text = obj(ball).replace(/^v .*/gm, (line, at) => `${line} 0.2 0.4 ${at % 2}`);
  const bytes = new TextEncoder().encode(text);
  const { positions, shift, triangles, colours } = perform(session, "load", {
    bytes,
    name: "a.obj",
  });
  assert.equal(colours?.length, 4 * 96);
  const own = plyOf(positions, shift, triangles, colours);
  const again = perform(session, "load", { bytes: own, name: "own.ply" });
  assert.deepEqual(again.colours, colours);
  session.free();
});

test("an export that a crash meets is of the page's own copy", async () => {
  const { solver } = listened();
  await run(solver, 1);
  FakeWorker.crashesAt = ({ name }) => name === "export";
  const { format, bytes } = await solver.export("stl");
  assert.equal(format, "ply");
  assert.equal(positionsOf(bytes).positions[0], 1 / 3);
});

test("a mesh that is refused or crashes the solver leaves the scene of before", async () => {
  const { solver } = listened();
  await run(solver, 2);
  FakeWorker.crashesAt = ({ fields }) => fields.name === "deadly.obj";
  await assert.rejects(solver.load("deadly.obj", Uint8Array.of(1)), { kind: LOST });
  await assert.rejects(solver.load("broken.obj", Uint8Array.of(1)), { kind: "BadMesh" });
  assert.equal((await solver.ask("step"))?.step, 3);
  assert.equal(FakeWorker.last.mesh, "own.obj");
});

test("a surface at the start comes back as the start, an edited one as a file", async () => {
  const { solver } = listened();
  await run(solver, 0);
  FakeWorker.last.crash("at the start");
  assert.equal((await solver.revive())?.step, 0);
  assert.equal(FakeWorker.last.asked.at(-1)?.name, "reset");
  await solver.ask("step");
  await solver.adopt();
  await solver.configure({ flow: "circle" });
  FakeWorker.last.crash("after an edit");
  await solver.revive();
  const { fields } = FakeWorker.last.asked[0];
  assert.equal(fields.name, "own.ply");
});

test("an owed answer that stays away is noticed, and a sign of life takes that back", async (context) => {
  const { solver, heard } = listened(10_000);
  await run(solver, 1);
  context.mock.timers.enable({ apis: ["setTimeout"] });
  context.mock.timers.tick(60_000);
  assert.deepEqual(heard("onSilent"), [], "nothing is owed at rest");

  FakeWorker.ignores = ({ name }) => name === "step";
  const owed = solver.ask("step");
  owed.catch(() => {});
  await new Promise(setImmediate);
  context.mock.timers.tick(9000);
  FakeWorker.last.say({ type: "progress", run: 0, stage: "factor", fraction: 0.5 });
  context.mock.timers.tick(9000);
  assert.deepEqual(heard("onSilent"), []);
  context.mock.timers.tick(1000);
  assert.deepEqual(heard("onSilent"), [["onSilent", true]]);
  // It is not waited for.
  assert.equal((await solver.export("ply")).format, "ply");
  assert.equal(
    FakeWorker.last.asked.some(({ name }) => name === "export"),
    false,
  );
  FakeWorker.last.say({ type: "alive" });
  assert.deepEqual(heard("onSilent").at(-1), ["onSilent", false]);
  context.mock.timers.tick(10_000);
  assert.deepEqual(heard("onSilent").at(-1), ["onSilent", true]);
  solver.dismiss();
  await assert.rejects(owed, { kind: LOST });
  assert.deepEqual(heard("onSilent").at(-1), ["onSilent", false]);
});

test("a run owes frames until it has stopped, and each is acknowledged at once", async (context) => {
  const { solver, heard } = listened(10_000);
  await run(solver, 1);
  await new Promise(setImmediate);
  context.mock.timers.enable({ apis: ["setTimeout"] });
  await solver.run(null);
  FakeWorker.last.frame();
  assert.ok(FakeWorker.last.acknowledged > 0);
  context.mock.timers.tick(10_000);
  assert.deepEqual(heard("onSilent"), [["onSilent", true]]);
  FakeWorker.last.say({ type: "stopped", run: FakeWorker.last.run, state: {}, fault: null });
  context.mock.timers.tick(60_000);
  assert.deepEqual(heard("onSilent").at(-1), ["onSilent", false], "the run is over");
});

/** The page without its document. */
function page() {
  const store = createStore();
  const made = createPage(store, {
    isCalm: () => false,
    nextFrame: (draw) => setImmediate(() => draw(performance.now())),
    waits: { pause: 0 },
  });
  const file = /** @type {any} */ (new File(["v 0 0 0"], "own.obj"));
  const status = () =>
    statusText(store.get(), made.shown(), made.player.motion.value === "playing");
  const errors = () => store.get().notes.filter(({ kind }) => kind === "error");
  return { ...made, errors, status, load: () => made.open.open([file]) };
}

test("two crashes within a second cost the stored steps, and the page says so once", async () => {
  const { store, run, open, errors, status, load, lead, shown } = page();
  await load();
  for (let n = 0; n < 3; n += 1) await run.step();
  assert.equal(status(), "Paused at step 3");
  assert.equal(store.get().timeline?.stored, 4);
  assert.equal(lead.clip.points.length, 4);
  FakeWorker.crashesAt = ({ name }, worker) =>
    name === "restore" && FakeWorker.all.indexOf(worker) === 1;
  /** @type {string[]} */
  const statuses = [];
  store.state.subscribe(() => {
    if (statuses.at(-1) !== status()) statuses.push(status());
  });
  FakeWorker.last.crash("made by the test");
  await run.seek(3);
  await run.step();
  assert.equal(FakeWorker.all.length, 3);
  assert.deepEqual(statuses, [
    "Paused at step 3",
    "Restoring the surface…",
    "Paused at step 3",
    "Paused at step 4",
  ]);
  assert.equal(errors().length, 1);
  assert.match(errors()[0].text, /made by the test.*step 3/);
  assert.ok(errors()[0].hint.startsWith(say("lost-with-solver", { what: "steps" })));
  assert.equal(lead.clip.points[0].state.step, 3, "steps that are gone are not offered");
  // Back offers what is there.
  await run.back();
  assert.equal(shown()?.step, 3);
  assert.equal(store.get().reading?.canStepBack, false);
  // Which file it was is known, and why there is no recipe.
  const { origin } = store.get();
  assert.ok(origin && "file" in origin && origin.file === "own.obj");
  await assert.rejects(open.recipe(), { kind: "NoRecipe", message: say("app-no-recipe") });
});

test("a link to a film has a step of the half that is shown backwards, which outlives its worker", async () => {
  const { store, run, open, status, shown, lead } = page();
  await open.sample("morin", { figure: "eversion", step: -2 });
  const asked = () =>
    FakeWorker.last.asked
      .filter(({ name }) => name !== "state")
      .map(({ name, fields }) => [name, fields]);
  assert.deepEqual(asked().slice(-2), [
    ["turn", { figure: "eversion" }],
    ["run", { until: 2 }],
  ]);
  /** @param {FakeWorker} worker */
  const arrive = (worker) => {
    for (let n = 0; n < 2; n += 1) {
      worker.perform("step", {});
      worker.frame();
    }
    worker.say({ type: "stopped", run: worker.run, state: worker.state(), fault: null });
  };
  arrive(FakeWorker.last);
  await run.pause();
  assert.equal(status(), "Paused at step -2");
  assert.equal(store.get().film, "back");
  const { exact } = FakeWorker.last;
  FakeWorker.last.crash("made by the test");
  await run.pause();
  assert.equal(FakeWorker.all.length, 2);
  const names = asked().map(([name]) => name);
  assert.deepEqual(names.slice(names.indexOf("turn")), ["turn", "restore"]);
  assert.deepEqual([...FakeWorker.last.exact], [...exact]);
  assert.equal(shown()?.step, -2);
  assert.deepEqual(
    lead.clip.points.map(({ state }) => state.step),
    [-2],
  );
  // The rest is lost: the film is made anew, from where both halves begin.
  await run.play();
  assert.equal(store.get().film, "back");
  const { last } = FakeWorker;
  assert.deepEqual(
    asked()
      .slice(-4)
      .map(([name]) => name),
    ["turn", "configure", "turn", "run"],
  );
  assert.deepEqual([last.at, last.other.at], [0, 0]);
});

test("a solver that is given up leaves its file and a way to start another", async () => {
  const { store, run, errors, status, load } = page();
  await load();
  await run.step();
  FakeWorker.crashesAt = ({ name }) => name === "restore";
  FakeWorker.last.crash("for good");
  // Behind it in the queue.
  await run.back();
  assert.equal(store.get().phase, "failed");
  assert.equal(errors().at(-1)?.text, say("solver-lost-again"));
  assert.equal((await run.export("obj")).format, "ply");
  FakeWorker.crashesAt = () => false;
  run.halt();
  await run.step();
  assert.equal(status(), "Paused at step 2");
});

test("“Restoring” is said of a lost solver and not of a mesh on its way", async () => {
  const { store, status, load } = page();
  /** @type {Set<string>} */
  const statuses = new Set();
  store.state.subscribe(() => statuses.add(status()));
  await load();
  assert.ok(statuses.has("Loading own.obj…"), [...statuses].join());
  assert.ok(!statuses.has("Restoring the surface…"), [...statuses].join());
});

test("colours chosen while a run goes on let it come to rest, colour, and go on", async () => {
  const { store, run, load } = page();
  await load();
  await run.play();
  assert.equal(store.get().running, true);
  const before = FakeWorker.last.asked.length;
  await run.colour("willmore");
  const asked = FakeWorker.last.asked.slice(before).map(({ name }) => name);
  assert.deepEqual(asked, ["pause", "colour", "run"]);
  assert.equal(store.get().running, true);
  await run.pause();
});

test("an edit that is undone brings back the mesh that there was, not what a flow made of it", async () => {
  const { store, run, edit, load } = page();
  await load();
  const { mesh } = store.get();
  await run.step();
  await edit.adopt();
  assert.notEqual(store.get().mesh, mesh);
  await edit.undo();
  assert.equal(store.get().mesh, mesh);
});

test("each press of Step is a step, however fast they come", async () => {
  const { run, load, shown } = page();
  await load();
  for (let n = 0; n < 7; n += 1) run.step();
  await run.step();
  assert.equal(shown()?.step, 8);
  run.back();
  run.back();
  await run.back();
  assert.equal(shown()?.step, 5);
  // What was there is shown again, and not computed anew.
  const asked = FakeWorker.last.asked.filter(({ name }) => name === "step").length;
  await run.step();
  assert.equal(shown()?.step, 6);
  assert.equal(FakeWorker.last.asked.filter(({ name }) => name === "step").length, asked);
});

test("an edit and a single step are given up, and the worker and its steps stay", async () => {
  const { store, run, edit, load, errors, shown } = page();
  await load();
  await run.step();
  const { mesh } = store.get();
  /** @type {[string, () => Promise<unknown>][]} */
  const works = [
    ["remesh", () => edit.remesh({})],
    ["subdivide", () => edit.subdivide("loop")],
    ["step", () => run.step()],
  ];
  for (const [name, work] of works) {
    assert.equal(await run.giveUp(), false, "there is nothing in hand");
    FakeWorker.ignores = (request) => request.name === name;
    const done = work();
    const begun = () =>
      FakeWorker.last.asked.find((request) => request.name === name && !seen.has(request));
    const seen = new Set(name === "step" ? FakeWorker.last.asked : []);
    while (!begun()) await new Promise((resolve) => setTimeout(resolve));
    const request = begun();
    assert.equal(await run.giveUp(), true);
    assert.equal(
      FakeWorker.last.asked.at(-1)?.name,
      "pause",
      "which revokes the permit of the edit",
    );
    const cancelled = { kind: "Cancelled", message: say("app-cancelled"), hint: "", detail: {} };
    const answer = name === "step" ? { ok: null } : { error: cancelled };
    FakeWorker.last.say({ id: request?.id, ...answer });
    await done;
    assert.equal(store.get().progress, null);
  }
  assert.equal(store.get().mesh, mesh);
  assert.equal(shown()?.step, 1);
  assert.equal(FakeWorker.all.length, 1);
  assert.deepEqual(errors(), []);
});

test("a refused mesh leaves the one before, and a refused option what is in force", async () => {
  const { store, open, run, load, errors, status } = page();
  await load();
  const before = store.get().mesh;
  await open.open([new File(["v"], "broken.obj")]);
  assert.equal(store.get().mesh, before);
  assert.equal(status(), "Ready");
  assert.equal(errors().length, 1);
  FakeWorker.refuses = ({ name }) => name === "configure";
  const { options } = store.get();
  await run.configure({ epsilon: 0.5 });
  assert.deepEqual(store.get().options, options);
  assert.notEqual(store.get().options, options, "told again, so that the form shows it");
});

test("the display ends with the solver where it stands: at the last step", async () => {
  const { store, run, load, lead, player, shown, enqueue } = page();
  await load();
  player.speed.value = 200;
  await run.play();
  const worker = FakeWorker.last;
  for (let n = 0; n < 5; n += 1) {
    worker.perform("step", {});
    worker.frame();
  }
  const state = { ...worker.state(), status: "converged" };
  worker.say({ type: "stopped", run: worker.run, state, fault: null });
  while (player.motion.value !== "still") await new Promise(setImmediate);
  assert.equal(lead.clip.points.length, 6);
  assert.equal(shown()?.step, 5);
  // Looked back at, and played to the end once more.
  await run.seek(2);
  assert.equal(store.get().reading?.step, 2);
  await run.play();
  while (player.motion.value !== "still") await new Promise(setImmediate);
  await enqueue(async () => {});
  assert.equal(store.get().reading?.step, 5);
});
