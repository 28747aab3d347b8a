// `umbilic replay`: does again what a recipe says, and compares with what it promised.

import { existsSync } from "node:fs";
import path from "node:path";
import { out } from "./command.js";
import { orExit, usage } from "./failure.js";
import { readInput, readMesh } from "./files.js";
import { table } from "./text.js";

/** @import { RecipeMesh, ReplayReport, ReplayResult } from "../generated/types.js" */
/** @typedef {import("./command.js").Perform} Perform */
/** @typedef {import("../cli.js").Terminal} Terminal */

/** @type {import("./command.js").Spec} */
export const replay = {
  summary: "does again what a recipe says, and compares",
  operands: ["RECIPE.json", "[MESH]"],
  options: out,
  ask: (_, [file], io) => new TextDecoder().decode(readInput(file, io)),
  run({ perform, asked: text, operands: [file, given], io }) {
    const { mesh, flow, estimate } = perform("readRecipe", { text });
    const script = { recipe: text };
    const bytes = meshOf(perform, mesh, file, given, io);
    if (estimate.isLong) io.log(`The recipe runs about ${estimate.steps} steps.`);
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
    if (given) throw usage(`The recipe begins with the sample ${mesh.shape}: ${given} has no use.`);
    return null;
  }
  const beside = path.join(path.dirname(file), path.basename(mesh.name));
  const found = given ?? (file !== "-" && existsSync(beside) ? beside : null);
  if (!found) {
    const hint = "Give it after the recipe, or put it beside it.";
    throw usage(`The recipe begins with the mesh ${mesh.name}, which is missing.`, hint);
  }
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
function summary({ version, steps, same, exact, tolerance, expected, got, differing }) {
  const cell = (/** @type {unknown} */ value) =>
    typeof value === "string" ? `${value.slice(0, 12)}…` : String(value ?? "–");
  // Bits of positions can only agree where all bits must.
  const names = /** @type {(keyof ReplayResult)[]} */ (Object.keys(expected));
  const rows = names
    .filter((name) => exact || name !== "positions")
    .map((name) => {
      const found = differing.includes(name) ? "differs" : "same";
      return [name, cell(expected[name]), cell(got[name]), found];
    });
  const how = exact
    ? "to the last bit"
    : `to ${tolerance} (made by version ${version}, so that the last bits may differ)`;
  const heading = same
    ? `Reproduced after ${steps} steps, ${how}.`
    : `Not reproduced after ${steps} steps: these differ, compared ${how}.`;
  return `${heading}\n\n${table([["", "expected", "got", ""], ...rows])}`;
}
