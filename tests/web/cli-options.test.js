// @ts-check
// A bad value of an option is refused with the same words by the command line, a link, a recipe
// and the function that the page calls, and nothing has changed then. Needs the wasm build.

import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { openSession } from "../../www/cli/solver.js";
import { main } from "../../www/cli.js";
import { options } from "../../www/generated/schema.js";
import { asText, defaults, isRead, rowOf, toFlow } from "../../www/options.js";
import { perform } from "../../www/session.js";
import { sayFault } from "../../www/words.js";
import { FakeSession } from "./support/fake-session.js";
import { readScene } from "./support/scene.js";

/** @typedef {{ kind: string, message: string }} Refusal */

let folder = "";
before(() => {
  folder = mkdtempSync(path.join(tmpdir(), "umbilic-"));
  writeFileSync(path.join(folder, "mesh.obj"), "v 0 0 0\n");
});
after(() => rmSync(folder, { recursive: true }));

/** @param {Refusal} refusal */
const said = ({ kind, message }) => ({ kind, message });

/** @param {() => unknown} call @returns {Refusal | null} */
function refusalOf(call) {
  try {
    call();
    return null;
  } catch (error) {
    return said(sayFault(/** @type {any} */ (error)));
  }
}

/** @param {string[]} parameters @param {number} expected  exit code @returns {Promise<Refusal>} */
async function refusedLine(parameters, expected) {
  let out = "";
  // Recipes are read by the solver itself.
  const isReplay = parameters[0] === "replay";
  const [fake, real] = [new FakeSession(), await openSession()];
  const io = {
    write: (/** @type {string} */ text) => {
      out += text;
    },
    log: () => {},
    read: () => Buffer.from(""),
  };
  const line = [...parameters, "--json"];
  assert.equal(
    await main(line, io, async () => /** @type {any} */ (isReplay ? real : fake)),
    expected,
    out,
  );
  assert.deepEqual(fake.calls, [], `${parameters}: nothing reaches the session`);
  assert.throws(
    () => perform(/** @type {any} */ (real), "state"),
    { kind: "NoMesh" },
    `${parameters}: nothing is opened`,
  );
  return said(JSON.parse(out));
}

/** Name, as text, and as a recipe or a page has it. @type {[string, string, unknown][]} */
const bad = [
  ["epsilonn", "0.1", 0.1],
  ["constructor", "1", 1],
  ["epsilon", "7", 7],
  ["epsilon", "-0.1", -0.1],
  ["p", "0.5", 0.5],
  ["p", "17", 17],
  ["p", "NaN", NaN],
  ["tau", "Infinity", Infinity],
  ["dt", "0", 0],
  ["perturbation", "0.31", 0.31],
  ["reducedVolume", "1.5", 1.5],
  ["maxSteps", "1.5", 1.5],
  ["smoothSteps", "0", 0],
  ["epsilon", "small", "small"],
  ["integrator", "rk4", "rk4"],
  ["flow", "ricci", "ricci"],
  ["goal", "", ""],
  ["epsilon", " ", " "],
  ["keep", "area,shape", ["area", "shape"]],
];

test("the same bad values are refused in the same words, four ways", async () => {
  const session = await openSession();
  perform(session, "sample", { name: "icosahedron", parameters: { level: 2 } });
  perform(session, "configure", { options: { flow: "circle", epsilon: 0.2 } });
  perform(session, "step");
  const standing = () => [
    session.frame().flow,
    perform(session, "state"),
    session.frame().positions,
  ];
  const untouched = standing();
  const recipe = {
    umbilic: "0.1.0",
    mesh: { shape: "icosahedron", parameters: { level: 2 } },
    steps: 0,
    result: { energy: 0, area: 1, volume: 1, minAngleDegrees: 1, time: 0 },
  };
  for (const [name, text, value] of bad) {
    const about = `${name}=${text}`;
    const flag = options.find((row) => row.name === name)?.flag ?? name;
    const mesh = path.join(folder, "mesh.obj");
    const line = await refusedLine(["flow", mesh, `--${flag}=${text}`], 2);
    assert.ok(line.message.includes(`\`${name}\``), line.message);

    const hash = `#sample=icosahedron&${new URLSearchParams([[name, text]])}`;
    assert.deepEqual(
      refusalOf(() => readScene({ search: "", hash })),
      line,
      `link: ${about}`,
    );

    // JSON has no such numbers: as the text that somebody wrote instead.
    const json = JSON.stringify({ ...recipe, flow: { [name]: value } })
      .replace(`{"p":null}`, `{"p":"NaN"}`)
      .replace(`{"tau":null}`, `{"tau":"Infinity"}`);
    const file = path.join(folder, "recipe.json");
    writeFileSync(file, json);
    assert.deepEqual(await refusedLine(["replay", file], 3), line, `recipe: ${about}`);

    for (const way of /** @type {const} */ (["configure", "continueWith"])) {
      /** @type {any} */
      const fields = { options: { [name]: value } };
      assert.deepEqual(
        refusalOf(() => perform(session, way, fields)),
        line,
        `${way}: ${about}`,
      );
      assert.deepEqual(standing(), untouched, `${way}: ${about}`);
    }
  }
});

test("a bad value is refused wherever in a recipe or a link it stands", () => {
  /** @param {string} words */
  const refusal = (words) =>
    refusalOf(() => readScene({ search: "", hash: `#sample=pipe&${words}` }));
  const expected = { kind: "BadOption", message: "`epsilon` cannot be `7`" };
  assert.deepEqual(refusal("panes=same*epsilon_7"), expected);
  const base64 = (/** @type {unknown} */ value) => btoa(JSON.stringify(value)).replace(/=+$/, "");
  const path = base64([{ steps: 2 }, { flow: { epsilon: 7 } }, { steps: 1 }]);
  assert.deepEqual(refusal(`step=3&path=${path}`), expected);
  const edits = base64([{ flow: { epsilon: 7 }, path: [], edit: "adopt" }]);
  assert.deepEqual(refusal(`edits=${edits}`), expected);
  assert.equal(refusal("flipsPerStep=0")?.message, "`flipsPerStep` cannot be `0`");
  // Words of others may stand in a query, and a region that makes no sense in neither.
  assert.equal(
    readScene({ search: "?utm_source=mail&epsilon=0.5", hash: "" }).options.epsilon,
    0.5,
  );
  assert.equal(refusal("free=r__")?.message, "`free` cannot be `r__`");
});

test("every default is read back from its text, and what was chosen too", () => {
  for (const { name, kind } of options) {
    if (kind === "vertices") continue;
    const value = /** @type {any} */ (defaults)[name];
    const words = new URLSearchParams([[name, asText(value, name)]]);
    const scene = readScene({ search: "", hash: `#${words}` });
    assert.deepEqual(scene.options, { [name]: value }, name);
  }
});

test("a change of flow takes back what means nothing to it", () => {
  assert.deepEqual(toFlow("mmcv"), {
    ...{ flow: "mmcv", boundary: null, goal: "relax", tau: null, dt: null },
  });
  assert.ok(isRead("detail", { ...defaults, goal: "smooth" }) && !isRead("detail", defaults));
  assert.ok(!isRead("tauMax", { ...defaults, flow: "p-willmore" }));
  assert.deepEqual(rowOf("p").flows, ["p-willmore"]);
});
