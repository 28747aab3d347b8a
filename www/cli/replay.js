// `umbilic replay`: does again what a recipe says, and compares with what it promised.

import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { perform } from "../session.js";
import { Failure, orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeMesh, writtenHelp } from "./files.js";
import { parse } from "./options.js";
import { table } from "./text.js";

/** @import { RecipeMesh, ReplayReport, ReplayResult } from "../generated/types.js" */
/** @typedef {import("../pkg/solver/solver.js").Session} Session */
/** @typedef {import("./terminal.js").Terminal} Terminal */

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "does again what a recipe says, and compares",
  operands: ["RECIPE.json", "[MESH]"],
  options: {
    out: { value: "FILE", help: `the mesh at the end: ${writtenHelp}` },
  },
};

/** @type {import("./commands.js").Command} */
export const replay = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    checkOutputs([values.out]);
    if (values.out) formatOf(values.out);
    const [file, given] = operands;
    const text = textOf(file, io);
    const session = await open();
    const { mesh, flow, estimate } = orExit(3, () => perform(session, "readRecipe", { text }));
    const script = { recipe: text };
    const bytes = await meshOf(mesh, file, given, io);
    if (estimate.isLong) io.log(`The recipe runs about ${estimate.steps} steps.`);
    orExit(3, () => {
      perform(session, "prepare", { script, bytes, name: "" });
      advance(session, io);
      perform(session, "configure", { options: flow });
    });
    orExit(4, () => {
      perform(session, "follow", { script });
      advance(session, io);
    });
    const report = perform(session, "compareRecipe", { text });
    if (values.out) writeMesh(session, values.out, io);
    const { same, exact, tolerance, steps, expected, got } = report;
    const how = { same, exact, ...(exact ? {} : { tolerance }) };
    if (values.json) io.write(`${JSON.stringify({ ...how, steps, expected, got })}\n`);
    else io.write(summary(report));
    return same ? 0 : 4;
  },
};

/** @param {string} file @param {Terminal} io */
function textOf(file, io) {
  if (file === "-") return new TextDecoder().decode(io.read());
  try {
    return readFileSync(file, "utf8");
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    throw new Failure(3, "Unreadable", `${file} cannot be read: ${message}.`, "");
  }
}

/**
 * The mesh of the recipe, if that is a file: the one given, or the one of its name beside it.
 * @param {RecipeMesh} mesh @param {string} file @param {string | undefined} given
 * @param {Terminal} io
 */
async function meshOf(mesh, file, given, io) {
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
  return (await readMesh(found, io)).bytes;
}

/** Does what was begun, to its end. @param {Session} session @param {Terminal} io */
function advance(session, io) {
  let tenths = 0;
  for (;;) {
    const { share, isDone } = perform(session, "advance");
    const now = Math.floor(10 * share);
    if (now > tenths) io.log(`${10 * now} %`);
    tenths = now;
    if (isDone) return;
  }
}

/** @param {ReplayReport} report */
function summary({ version, steps, same, exact, tolerance, expected, got, differing }) {
  /** @param {unknown} value */
  const cell = (value) => {
    if (typeof value === "string") return `${value.slice(0, 12)}…`;
    return value === null || value === undefined ? "–" : String(value);
  };
  // Bits of positions can only agree where all bits must.
  const names = /** @type {(keyof ReplayResult)[]} */ (Object.keys(expected)).filter(
    (name) => exact || name !== "positions",
  );
  const rows = names.map((name) => [
    name,
    cell(expected[name]),
    cell(got[name]),
    differing.includes(name) ? "differs" : "same",
  ]);
  const how = exact
    ? "to the last bit"
    : `to ${tolerance} (made by version ${version}, so that the last bits may differ)`;
  const heading = same
    ? `Reproduced after ${steps} steps, ${how}.`
    : `Not reproduced after ${steps} steps: these differ, compared ${how}.`;
  return `${heading}\n\n${table([["", "expected", "got", ""], ...rows])}`;
}
