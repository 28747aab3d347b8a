// `umbilic replay`: does again what a recipe says, and compares with what it promised.

import { existsSync } from "node:fs";
import path from "node:path";
import { say } from "../words.js";
import { orExit, refused } from "./failure.js";
import { beside, readMesh, readText } from "./files.js";
import { table } from "./text.js";

/** @import { RecipeMesh, ReplayReport } from "../generated/types.js" */
/** @typedef {import("./run.js").Perform} Perform */
/** @typedef {import("../cli.js").Terminal} Terminal */

/** @type {import("./run.js").Spec} */
export const replay = {
  operands: ["RECIPE.json", "[MESH]"],
  own: { out: "FILE" },
  ask: (_, [file], io) => readText(file, io),
  run({ perform, asked: text, operands: [file, given], io }) {
    const { mesh, flow, estimate } = perform("readRecipe", { text });
    const script = { recipe: text };
    const bytes = meshOf(perform, mesh, file, given, io);
    if (estimate.isLong) io.log(say("replay-long", { ...estimate }));
    perform("prepare", { script, bytes, name: "" });
    advance(perform, io);
    perform("configure", { options: flow });
    orExit(4, () => {
      perform("follow", { script });
      advance(perform, io);
    });
    const report = perform("compareRecipe", { text });
    const { same, exact, tolerance, steps, expected, got } = report;
    const result = { same, exact, ...(!exact && { tolerance }), steps, expected, got };
    return { result, text: summary(report), exit: same ? 0 : 4 };
  },
};

/**
 * The mesh of the recipe, if that is a file: the one given, or the one of its name beside it.
 * @param {Perform} perform @param {RecipeMesh} mesh @param {string} file @param {string | undefined} given
 * @param {Terminal} io
 */
function meshOf(perform, mesh, file, given, io) {
  if ("shape" in mesh) {
    if (given) throw refused("usage-recipe-shape", { shape: mesh.shape, given });
    return null;
  }
  const place = beside(file, path.basename(mesh.name));
  const found = given ?? (file !== "-" && existsSync(place) ? place : null);
  if (!found) throw refused("usage-recipe-mesh", { name: mesh.name });
  return readMesh(perform, found, io).bytes;
}

/** Does what was begun, to its end. @param {Perform} perform @param {Terminal} io */
function advance(perform, io) {
  let tenths = 0;
  for (;;) {
    const { share, isDone } = perform("advance");
    const now = Math.floor(10 * share);
    if (now > tenths) io.log(`${10 * now} %`);
    tenths = now;
    if (isDone) return;
  }
}

/** @param {ReplayReport} report */
function summary({ expected, got, differing, ...report }) {
  const cell = (/** @type {unknown} */ value) =>
    typeof value === "string" ? `${value.slice(0, 12)}…` : String(value ?? "–");
  const found = /** @type {Record<string, unknown>} */ ({ ...got });
  // Bits of positions can only agree where all bits must.
  const rows = Object.entries(expected)
    .filter(([name]) => report.exact || name !== "positions")
    .map(([name, value]) => {
      const how = differing.includes(name) ? "differs" : "same";
      return [name, cell(value), cell(found[name]), how];
    });
  const compared = { id: "replay-compared", values: report };
  return `${say("replay-result", { ...report, compared })}\n\n${table([["", "expected", "got", ""], ...rows])}`;
}
