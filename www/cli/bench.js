// `umbilic bench`: the tables of the documentation, measured on this machine.

import { readdirSync } from "node:fs";
import path from "node:path";
import * as schema from "../generated/schema.js";
import { say } from "../words.js";
import { attempt, orExit, usage } from "./failure.js";
import { isMesh, readHelp, readInput } from "./files.js";
import { readFlags, typed } from "./options.js";
import { table } from "./text.js";

/** @type {import("./command.js").Spec} */
export const bench = {
  summary: "measures a table of the documentation",
  operands: [],
  rows: schema.bench,
  options: {
    meshes: { value: "DIR", help: "of the table robustness: meshes to try every flow on" },
  },
  ask(values) {
    const options = readFlags("bench", typed(schema.bench, values));
    if (values.meshes === undefined) return options;
    if (options.table !== "robustness") throw usage("--meshes needs --table robustness.");
    return { ...options, meshes: meshesIn(values.meshes) };
  },
  run({ perform, asked: options, io }) {
    const { columns, left, digits, row } = orExit(4, () => perform("bench", { options }));
    const cells = [];
    const rows = [];
    for (let next = row; next; next = orExit(4, () => perform("bench")).row) {
      const said = next.map((/** @type {any} */ value) => (value?.id ? say(value) : value));
      const shown = said.map((value) => cell(value, digits));
      io.log(columns.map((column, i) => `${column} ${shown[i]}`).join("  "));
      cells.push(shown);
      rows.push(Object.fromEntries(columns.map((column, i) => [column, said[i]])));
    }
    if (rows.length === 0) throw usage("No row of this table has so few vertices.");
    const text = `${say(`bench-${options.table}`)}\n\n${table([columns, ...cells], left)}`;
    return { result: { table: options.table, rows }, text };
  },
};

/** @param {unknown} value @param {number | null} digits  significant ones; else one after the point */
function cell(value, digits) {
  if (typeof value !== "number" || Number.isInteger(value)) return String(value ?? "–");
  return digits ? String(Number(value.toPrecision(digits))) : value.toFixed(1);
}

/** Mesh files of a folder, by name. @param {string} folder */
function meshesIn(folder) {
  const files = attempt(
    () => readdirSync(folder),
    () => usage(`${folder} is not a folder that can be read.`),
  );
  const names = files.filter(isMesh).sort();
  if (names.length === 0) throw usage(`${folder} holds no mesh.`, `Meshes end in ${readHelp}.`);
  return names.map((name) => ({
    name,
    bytes: Uint8Array.from(readInput(path.join(folder, name))),
  }));
}
