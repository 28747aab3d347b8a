// @ts-check
// The command line around a written-down session: what reaches the solver, what comes
// out, and with which exit code. The real solver: cli-solver.test.js.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { main } from "../../www/cli.js";
import { FakeSession } from "./support/fake-session.js";

let folder = "";
let mesh = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  mesh = path.join(folder, "mesh.obj");
  writeFileSync(mesh, "v 0 0 0\n");
});
after(() => rmSync(folder, { recursive: true }));

/**
 * @param {string[]} parameters
 * @param {FakeSession} [session]
 */
async function umbilic(parameters, session = new FakeSession()) {
  /** @type {string[]} */
  const written = [];
  /** @type {string[]} */
  const logged = [];
  const io = {
    write: (/** @type {string} */ text) => void written.push(text),
    log: (/** @type {string} */ text) => void logged.push(`${text}\n`),
    read: () => Buffer.from("from standard input"),
  };
  const exit = await main(parameters, io, async () => /** @type {any} */ (session));
  const out = written.join("");
  return { exit, out, log: logged.join(""), session, json: () => JSON.parse(out) };
}

/** @param {string} name */
const file = (name) => path.join(folder, name);

/** What `configure` was given.
 * @param {FakeSession} session
 */
const configured = (session) => session.calls.find(([name]) => name === "configure")?.[1];

test("help and version", async () => {
  const overview = await umbilic(["--help"]);
  assert.equal(overview.exit, 0);
  for (const command of ["info", "energy", "flow", "shape", "bench"]) {
    assert.match(overview.out, new RegExp(`^ +${command} `, "m"));
    const help = await umbilic([command, "--help"]);
    assert.equal(help.exit, 0);
    assert.match(help.out, new RegExp(`^umbilic ${command} `));
    assert.equal((await umbilic([command, "-h"])).out, help.out);
  }
  const version = await umbilic(["--version"]);
  assert.match(version.out, /^umbilic \d+\.\d+\.\d+\n$/);
});

test("bad usage ends with 2 and says what would be right", async () => {
  /** @type {[string[], RegExp][]} */
  const cases = [
    [[], /command is missing/],
    [["flov", mesh], /Did you mean `flow`/],
    [["constructor"], /no command `constructor`/],
    [["fill", mesh, "--loops", "two"], /all, or any number of these/],
    [["fill", mesh, "--loops", "0,-1"], /a whole number from 0/],
    [["fill", mesh, "--steps", "3"], /needs --fair/],
    [["fill", mesh, "--until-converged"], /--until-converged needs --fair/],
    [["fill", mesh, "--fair", "mmcv", "--steps", "3", "--seconds", "3"], /cannot both/],
    [["fill", mesh, "--fair", "smooth"], /`--fair` cannot be `smooth`/],
    [["fill", mesh, "--fair", "circel"], /Did you mean `circle`/],
    [["flow", mesh, "--epsilon", "-0.1"], /`epsilon` cannot be `-0\.1`/],
    [["flow", mesh, "--no-remesh"], /takes a value, adaptive/],
    [["flow", mesh, "--hlep"], /Did you mean `help`/],
    [["flow", mesh, "--goal", "smooth", "--until-converged"], /is for --goal relax/],
    [["fill", mesh, "--max-vertices", "1.5"], /auto, or a whole number/],
    [["flips", mesh, "--criterion", "length"], /area, willmore, localised/],
    [["flips", mesh, "--max", "few"], /all, or a whole number/],
    [["flow", mesh, "--stepz", "3"], /Did you mean `maxSteps` \(--steps\)/],
    [["flow", mesh, "--steps"], /--steps/],
    [["flow", mesh, "--steps=-1"], /`maxSteps` cannot be `-1`/],
    [["flow", mesh, "--steps", "1.5"], /a whole number from 0/],
    [["flow", mesh, "--seconds", "0"], /a number above 0/],
    [["flow", mesh, "--steps", "3", "--until-converged"], /--until-converged or --steps, not both/],
    [["flow", mesh, "--seconds", "3", "--until-converged"], /not both/],
    [["flow", mesh, "--perturbation", "0.1"], /it is for p-willmore/],
    [["flow", mesh, "--dt", "0"], /above 0/],
    [["flow", mesh, "--dt", ""], /`dt` cannot be/],
    [["flow", mesh, "--dt", "0.1", "--tau", "1"], /cannot both/],
    [["flow", mesh, "--integrator", "rk4"], /semi-implicit, forward-euler/],
    [["flow", mesh, "--flow", "willmore", "--rungs", "3"], /it is for mmcv/],
    [["flow", mesh, "--flow", "mmcv", "--rungs=-1"], /`rungs` cannot be/],
    [["flow", mesh, "--flow", "mmcv", "--epsilon", "0.1"], /it is for circle/],
    [["flow", mesh, "--flow", "ricci"], /one of circle, p-willmore/],
    [["flow", mesh, "--flow", "flips"], /command of their own/],
    [["flow", mesh, "--keep", "area"], /it is for p-willmore/],
    [["flow", mesh, "--flow", "p-willmore", "--epsilon", "0.1"], /it is for circle/],
    [["flow", mesh, "--flow", "p-willmore", "--keep", "area,shape"], /any of area, volume/],
    [["flow", mesh, "--flow", "p-willmore", "--p=-1"], /`p` cannot be `-1`/],
    [["remesh", mesh, "--vertices", "9", "--target", "0.1"], /cannot both/],
    [["regularise", mesh, "--mode", "fast"], /one of linear, nonlinear/],
    [["regularise", mesh, "--mode", "off"], /one of linear, nonlinear/],
    [["regularise", mesh, "--epsilon", "0"], /above 0/],
    [["regularise", mesh, "--iterations=-1"], /a whole number from 0/],
    [["flow", mesh, "--detail", "2"], /it is for circle with goal smooth/],
    [["flow", mesh, "--out", "mesh.xyz"], /which format/],
    [["flow", mesh, "--out", "no/such/folder/mesh.obj"], /cannot be written/],
    [["energy", mesh, "--p", "two"], /any number of these/],
    [["energy", mesh, "--p", "2", "--p=-1"], /`p` cannot be/],
    [["energy", mesh, "--boundary", "open"], /clamped, fixed, free/],
    [["info"], /Arguments wanted: MESH; given: none/],
    [["info", mesh, mesh], /Arguments wanted: MESH/],
    [["shape", "torsu", "--out", "t.obj"], /Did you mean `torus`/],
    [["shape", "torus"], /--out FILE is missing/],
    [["bench"], /`table` is missing/],
    [["bench", "--table", "none"], /circle/],
    [["bench", "--table", "circle", "--steps", "0"], /a whole number from 1/],
    [["bench", "--table", "circle", "--quick"], /`quick` needs `table` to be `figures`/],
    [["bench", "--table", "figures", "--figures", "circle-1"], /circle-6/],
    [["bench", "--table", "circle", "--meshes", "."], /needs --table robustness/],
  ];
  for (const [parameters, words] of cases) {
    const { exit, out, log, session } = await umbilic(parameters);
    const line = parameters.join(" ");
    assert.equal(exit, 2, line);
    assert.equal(out, "", line);
    assert.match(log, words, line);
    assert.deepEqual(session.calls, [], `${line}: nothing reaches the solver`);
  }
});

test("with --json a failure is one object on standard output", async () => {
  const refused = await umbilic(["info", mesh, "--json"], new FakeSession({ refuse: true }));
  assert.equal(refused.exit, 3);
  assert.equal(refused.log, "");
  const { hint, ...rest } = refused.json();
  const message = "the edge between vertices 3 and 4 has 3 faces (0, 1, 2)";
  assert.deepEqual(rest, { kind: "NonManifoldEdge", message });
  assert.match(hint, /^A surface has at most two faces at an edge/);
  const misspelt = await umbilic(["info", mesh, "--jsn", "--json"]);
  assert.equal(misspelt.exit, 2);
  assert.deepEqual(Object.keys(misspelt.json()), ["kind", "message", "hint"]);
});

test("a file that cannot be read is refused with 3", async () => {
  const { exit, json } = await umbilic(["energy", file("absent.obj"), "--json"]);
  assert.equal(exit, 3);
  assert.equal(json().kind, "Unreadable");
});

test("info and energy hand the solver's answer on, warnings in words", async () => {
  const info = await umbilic(["info", mesh, "--json"]);
  assert.equal(info.exit, 0);
  assert.deepEqual(info.json(), {
    ...new FakeSession().info(),
    warnings: ["Turned 1 face to agree with the neighbours."],
    warningIds: ["repair-turned-faces"],
  });
  assert.deepEqual(info.session.calls, [["load", "v 0 0 0\n", "mesh.obj"]]);

  const line = ["energy", mesh, "--p", "2.5", "--p", "6", "--boundary", "free", "--json"];
  const energy = await umbilic(line);
  assert.deepEqual(energy.json(), new FakeSession().energy({}));
  assert.deepEqual(energy.session.calls[1], ["energy", { p: [2.5, 6], boundary: "free" }]);
});

test("info and energy in words", async () => {
  const info = await umbilic(["info", mesh]);
  assert.match(info.out, /^vertices +3$/m);
  assert.match(info.out, /^volume +–$/m);
  assert.match(info.out, /^warning: Turned 1 face to agree with the neighbours\.$/m);
  const energy = await umbilic(["energy", mesh]);
  assert.match(energy.out, /^pWillmore\.2 +18$/m);
});

test("- is standard input", async () => {
  const { session } = await umbilic(["info", "-"]);
  assert.deepEqual(session.calls, [["load", "from standard input", "stdin"]]);
});

test("flow: only what was asked for reaches the solver", async () => {
  const plain = await umbilic(["flow", mesh, "--steps", "2", "--json"]);
  assert.deepEqual(configured(plain.session), { flow: "circle", maxSteps: 2 });

  writeFileSync(file("free.json"), "[4, 5]");
  writeFileSync(file("both.json"), '{"free": null, "fixed": [0, 2]}');
  const full = await umbilic([
    ...["flow", mesh, "--flow", "circle", "--scheme", "auto", "--integrator", "l-bfgs"],
    ...["--goal", "smooth", "--detail", "3", "--steps", "4", "--dt", "auto", "--mass", "area"],
    ...["--epsilon", "0", "--prefill", "--boundary", "clamped"],
    ...["--free", file("free.json"), "--fixed", file("both.json")],
  ]);
  assert.deepEqual(configured(full.session), {
    flow: "circle",
    scheme: "auto",
    integrator: "l-bfgs",
    boundary: "clamped",
    goal: "smooth",
    detail: 3,
    smoothSteps: 4,
    dt: null,
    mass: "area",
    epsilon: 0,
    prefill: true,
    free: [4, 5],
    fixed: [0, 2],
    maxSteps: 4,
  });

  const blunt = await umbilic(["flow", mesh, "--no-sharpen", "--steps", "0"]);
  assert.deepEqual(configured(blunt.session), { flow: "circle", sharpen: false, maxSteps: 0 });
  for (const name of ["dt", "tau"]) {
    const { session } = await umbilic(["flow", mesh, `--${name}`, "0.5", "--steps", "0"]);
    assert.equal(/** @type {any} */ (configured(session))[name], 0.5);
  }
});

test("flow and fill: until rest or for the default time, unless told otherwise", async () => {
  /** @type {[string[], object][]} */
  const budgets = [
    [[], {}],
    [["--steps", "0"], { maxSteps: 0 }],
    [["--seconds", "2.5"], { maxSeconds: 2.5 }],
    [["--until-converged"], { maxSeconds: null }],
  ];
  for (const [given, budget] of budgets) {
    const flow = ["flow", mesh, "--flow", "p-willmore", "--perturbation", "0.1"];
    const run = await umbilic([...flow, ...given], new FakeSession({ endAfter: 1 }));
    const options = { flow: "p-willmore", perturbation: 0.1, ...budget };
    assert.deepEqual(configured(run.session), options, given.join(" "));
    const fill = ["fill", mesh, "--fair", "mmcv", ...given];
    const fair = await umbilic(fill, new FakeSession({ endAfter: 1 }));
    const patch = { flow: "mmcv", boundary: "fixed", ...budget };
    assert.deepEqual(configured(fair.session), patch, given.join(" "));
  }
});

test("flow and fill: 4 where the surface could not be kept good, whose last state is written", async () => {
  const exits = { converged: 0, stalled: 0, stepLimit: 0, singular: 4, collapsed: 4, failed: 4 };
  for (const [ending, expected] of Object.entries(exits)) {
    const session = () => new FakeSession({ endAfter: 2, ending });
    const out = ["--out", file(`${ending}.obj`), "--json"];
    const flow = await umbilic(["flow", mesh, ...out], session());
    assert.equal(flow.exit, expected, `flow: ${ending}`);
    assert.equal(flow.json().status, ending);
    assert.equal(readFileSync(file(`${ending}.obj`), "utf8"), "obj of step 2");
    const fill = await umbilic(["fill", mesh, "--fair", "mmcv", ...out], session());
    assert.equal(fill.exit, expected, `fill: ${ending}`);
    const said = ending === "stalled" ? ["The patch is not at rest: the surface is at rest."] : [];
    assert.deepEqual(fill.json().warnings, said, ending);
  }
});

test("flow: a selection that is no list of vertices is refused with 3", async () => {
  for (const content of ["[0, -1]", '{"fixed": [0]}', "[0.5]", "0, 1"]) {
    writeFileSync(file("free.json"), content);
    const { exit, json } = await umbilic(["flow", mesh, "--free", file("free.json"), "--json"]);
    assert.equal(exit, 3, content);
    assert.equal(json().kind, "BadSelection", content);
  }
});

test("flow: the report, on standard output and in the file", async () => {
  const { exit, json, log } = await umbilic([
    ...["flow", mesh, "--steps", "3", "--json"],
    ...["--report", file("report.json"), "--history", file("history.csv")],
    ...["--out", file("out.ply")],
  ]);
  assert.equal(exit, 0);
  const report = json();
  assert.deepEqual(Object.keys(report), [
    ...["status", "message", "messageId", "monitored", "steps", "initial", "final"],
  ]);
  assert.equal(report.monitored, "smoothedCircle");
  assert.equal(report.status, "stepLimit");
  assert.equal(report.message, "Stopped after 3 steps: the surface is at rest");
  assert.equal(report.messageId, "reason-at-rest");
  assert.deepEqual(
    report.steps.map((/** @type {any} */ step) => step.step),
    [1, 2, 3],
  );
  assert.deepEqual(report.initial, new FakeSession().energy({}));
  assert.deepEqual(JSON.parse(readFileSync(file("report.json"), "utf8")), report);
  assert.equal(readFileSync(file("history.csv"), "utf8"), "step,energy\n");
  assert.equal(readFileSync(file("out.ply"), "utf8"), "ply of step 3");
  assert.equal(log.trim().split("\n").length, 3);
});

test("flow: self-intersections are counted where they are asked for", async () => {
  const line = ["flow", mesh, "--steps", "2", "--json"];
  const plain = await umbilic(line);
  assert.ok(!("selfIntersections" in plain.json().final));
  assert.ok(!plain.session.calls.some(([name]) => name === "selfIntersections"));
  const { initial, final } = (await umbilic([...line, "--self-intersections"])).json();
  assert.deepEqual([initial.selfIntersections, final.selfIntersections], [2, 2]);
});

test("flow: ends when the session does", async () => {
  const session = new FakeSession({ endAfter: 5 });
  const { exit, out } = await umbilic(["flow", mesh, "--until-converged"], session);
  assert.equal(exit, 0);
  assert.match(out, /^Converged after 5 steps: the surface is at rest$/m);
  assert.match(out, /^circle +12 +12$/m);
});

test("flow: readings that cannot be believed are said to be so", async () => {
  const soundness = { bend: 2, alignment: 0.2, gaussBonnet: 0, fittedEnergy: 1, isSound: false };
  const values = { bend: 2, alignment: 0.2, topology: 0, energy: 1 };
  const outcome = {
    ...new FakeSession().outcome(),
    soundness,
    warnings: [
      { id: "warning-slivers", values: {} },
      { id: "warning-untrusted", values },
    ],
  };
  const told = () => Object.assign(new FakeSession({ endAfter: 5 }), { outcome: () => outcome });
  const line = ["flow", mesh, "--until-converged"];
  const { out } = await umbilic(line, told());
  assert.match(out, /^warning: Not to be trusted: the mesh is too coarse/m);
  assert.match(out, /^soundness\.alignment +0\.2$/m);
  assert.match(out, /^soundness\.isSound +false$/m);
  const { json } = await umbilic([...line, "--json"], told());
  assert.deepEqual(
    [json().soundness, json().warningIds],
    [soundness, ["warning-slivers", "warning-untrusted"]],
  );
});

test("flow: a numerical failure ends with 4 and keeps the last good state", async () => {
  const session = new FakeSession({ failAt: 3 });
  const line = ["flow", mesh, "--until-converged", "--json", "--out", file("last.obj")];
  const { exit, json } = await umbilic(line, session);
  assert.equal(exit, 4);
  const { status, kind, message, messageId, hint, steps } = json();
  assert.deepEqual([status, kind], ["failed", "NonFiniteEnergy"]);
  assert.equal(message, "Failed after 2 steps: the energy is not a finite number at step 3");
  assert.equal(messageId, "flow-non-finite-energy");
  assert.match(hint, /^Go back a step/);
  assert.equal(steps.length, 2);
  assert.equal(readFileSync(file("last.obj"), "utf8"), "obj of step 2");
});

test("a crash of the solver ends with 4", async () => {
  const session = new FakeSession();
  session.step = () => {
    throw new WebAssembly.RuntimeError("unreachable");
  };
  const { exit, json } = await umbilic(["flow", mesh, "--json"], session);
  assert.equal(exit, 4);
  assert.equal(json().kind, "Crashed");
});

test("shape: parameters, mesh and selection", async () => {
  const { exit, out, session } = await umbilic([
    ...["shape", "torus", "--around", "12", "--out", file("torus.stl")],
    ...["--selection", file("selection.json")],
  ]);
  assert.equal(exit, 0);
  assert.match(out, /torus\.stl: 3 vertices, 1 faces/);
  assert.deepEqual(session.calls, [["sample", "torus", { around: 12 }]]);
  assert.equal(readFileSync(file("torus.stl"), "utf8"), "stl of step 0");
  const selection = JSON.parse(readFileSync(file("selection.json"), "utf8"));
  assert.deepEqual(selection, { free: null, fixed: [0, 2] });
});

test("shape --list", async () => {
  const { exit, out } = await umbilic(["shape", "--list"]);
  assert.equal(exit, 0);
  assert.match(out, /^torus +Torus +--major 1 --minor 0\.35 --around 48 --tube 24$/m);
});
