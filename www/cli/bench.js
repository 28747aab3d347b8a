// @ts-check
// `umbilic bench`: the tables of the documentation, measured on this machine.

import { readdirSync } from "node:fs";
import path from "node:path";
import * as schema from "../generated/schema.js";
import { perform } from "../session.js";
import { say } from "../words.js";
import { command } from "./command.js";
import { orExit, usage } from "./failure.js";
import { isMesh, readInput } from "./files.js";
import { readFlags, typed } from "./options.js";
import { table } from "./text.js";

export const bench = command({
  name: "bench",
  summary: "measures a table of the documentation",
  operands: [],
  rows: schema.bench,
  options: {
    meshes: { value: "DIR", help: "of the table robustness: meshes to try every flow on" },
  },
  async ask(values) {
    const options = await readFlags("bench", typed(schema.bench, values));
    if (values.meshes === undefined) return options;
    if (options.table !== "robustness") throw usage("--meshes needs --table robustness.");
    return { ...options, meshes: meshesIn(values.meshes) };
  },
  run({ session, asked: options, io }) {
    const { columns, left, digits, row } = orExit(4, () => perform(session, "bench", { options }));
    const cells = [];
    const rows = [];
    for (let next = row; next; next = orExit(4, () => perform(session, "bench")).row) {
      const said = next.map((value) => (isMessage(value) ? say(value) : value));
      const shown = said.map((value) => cell(value, digits));
      io.log(columns.map((column, i) => `${column} ${shown[i]}`).join("  "));
      cells.push(shown);
      rows.push(Object.fromEntries(columns.map((column, i) => [column, said[i]])));
    }
    const text = `${say(`bench-${options.table}`)}\n\n${table([columns, ...cells], left)}`;
    return { result: { table: options.table, rows }, text };
  },
});

/** @param {unknown} value @returns {value is import("../generated/types.js").Message} */
const isMessage = (value) => typeof value === "object" && value !== null;

/** @param {unknown} value @param {number | null} digits  significant ones; else one after the point */
function cell(value, digits) {
  if (typeof value !== "number" || Number.isInteger(value)) return String(value ?? "–");
  return digits ? String(Number(value.toPrecision(digits))) : value.toFixed(1);
}

/** Mesh files of a folder, by name. @param {string} folder */
function meshesIn(folder) {
  let names;
  try {
    names = readdirSync(folder).filter(isMesh).sort();
  } catch (error) {
    throw usage(`${folder} is not a folder: ${/** @type {Error} */ (error).message}.`);
  }
  if (names.length === 0) {
    throw usage(`${folder} holds no mesh.`, "Meshes are OBJ, OFF, PLY or STL files.");
  }
  return names.map((name) => ({ name, bytes: readInput(path.join(folder, name)) }));
}
