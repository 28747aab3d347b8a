// @ts-check
// `umbilic replay`: does again what a recipe says, and compares with what it promised.

import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { sha256 } from "../digest.js";
import {
  askedBy,
  compare,
  follow,
  isOwn,
  prepare,
  readRecipe,
  resultOf,
  TOLERANCE,
} from "../recipe.js";
import { perform } from "../session.js";
import { Failure, orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeOutput } from "./files.js";
import { parse } from "./options.js";
import { loadSolver, packageVersion } from "./solver.js";
import { table } from "./text.js";

/** @typedef {import("../recipe.js").Recipe} Recipe */
/** @typedef {import("./terminal.js").Terminal} Terminal */

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "does again what a recipe says, and compares",
  operands: ["RECIPE.json", "[MESH]"],
  options: {
    out: { value: "FILE", help: "the mesh at the end: .obj, .off, .ply, .stl or .glb" },
  },
};

/** @type {import("./commands.js").Command} */
export const replay = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    checkOutputs([values.out]);
    const outFormat = values.out && formatOf(values.out);
    const [file, given] = operands;
    const recipe = orRefuse(() => readRecipe(textOf(file, io)));
    const bytes = await meshOf(recipe, file, given, io);

    const { readOptions } = await loadSolver();
    orRefuse(() => readOptions(askedBy(recipe)));
    const session = await open();
    const tell = progress(io);
    orRefuse(() => prepare(session, recipe, bytes, tell));
    orRefuse(() => perform(session, "configure", { options: recipe.flow }));
    orExit(4, () => follow(session, recipe, tell));
    const positions = session.frame(false).positions;
    const got = { ...resultOf(perform(session, "state")), positions: await sha256(positions) };
    const verdict = compare(recipe, got, packageVersion());
    if (values.out) writeOutput(values.out, perform(session, "export", { format: outFormat }));
    const { same, exact } = verdict;
    const report = { same, exact, ...(exact ? {} : { tolerance: TOLERANCE }) };
    const { steps, result: expected } = recipe;
    if (values.json) io.write(`${JSON.stringify({ ...report, steps, expected, got })}\n`);
    else io.write(summary(recipe, verdict));
    return same ? 0 : 4;
  },
};

/**
 * What a recipe says wrong is refused input.
 * @template T
 * @param {() => T} call
 * @returns {T}
 */
const orRefuse = (call) => orExit(3, call);

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
 * @param {Recipe} recipe
 * @param {string} file
 * @param {string | undefined} given
 * @param {Terminal} io
 */
async function meshOf({ mesh }, file, given, io) {
  if (!isOwn(mesh)) {
    if (given) throw usage(`The recipe begins with the sample ${mesh.shape}: ${given} has no use.`);
    return null;
  }
  const beside = path.join(path.dirname(file), path.basename(mesh.name));
  const found = given ?? (file !== "-" && existsSync(beside) ? beside : null);
  if (!found) {
    const hint = "Give it after the recipe, or put it beside it.";
    throw usage(`The recipe begins with the mesh ${mesh.name}, which is missing.`, hint);
  }
  const { bytes } = readMesh(found, io);
  const hash = await sha256(Uint8Array.from(bytes));
  if (hash === mesh.sha256) return bytes;
  throw new Failure(
    3,
    "AnotherMesh",
    `${found} is not the recipe’s mesh ${mesh.name}: ${bytes.length} bytes with SHA-256 ` +
      `${hash.slice(0, 12)}…, not ${mesh.bytes} with ${mesh.sha256.slice(0, 12)}….`,
    "The recipe holds for that very file only, to the last byte.",
  );
}

/** @param {Terminal} io */
function progress(io) {
  let tenths = 0;
  return (/** @type {number} */ share) => {
    const now = Math.floor(10 * share);
    if (now > tenths) io.log(`${10 * now} %`);
    tenths = now;
  };
}

/**
 * @param {Recipe} recipe
 * @param {ReturnType<typeof compare>} verdict
 */
function summary({ umbilic, steps }, { same, exact, readings }) {
  /** @param {unknown} value */
  const cell = (value) => {
    if (typeof value === "string") return `${value.slice(0, 12)}…`;
    return value === null ? "–" : String(value);
  };
  const rows = readings.map(({ name, expected, got, same: agrees }) => [
    name,
    cell(expected),
    cell(got),
    agrees ? "same" : "differs",
  ]);
  const how = exact
    ? "to the last bit"
    : `to ${TOLERANCE} (made by version ${umbilic}, so that the last bits may differ)`;
  const heading = same
    ? `Reproduced after ${steps} steps, ${how}.`
    : `Not reproduced after ${steps} steps: these differ, compared ${how}.`;
  return `${heading}\n\n${table([["", "expected", "got", ""], ...rows])}`;
}
