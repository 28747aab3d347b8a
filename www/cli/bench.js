// `umbilic bench`: the tables of the documentation, measured on this machine.

import { readdirSync } from "node:fs";
import path from "node:path";
import { formatShort } from "../number.js";
import { say } from "../words.js";
import { attempt, refused } from "./failure.js";
import { isMesh, readHelp, readInput } from "./files.js";
import { readFlags, typed } from "./options.js";
import { table } from "./text.js";

/** @type {import("./run.js").Spec} */
export const bench = {
  operands: [],
  own: { meshes: "DIR" },
  refusal: 4,
  ask(values) {
    const options = readFlags("bench", typed("bench", values));
    if (values.meshes === undefined) return options;
    if (options.table !== "robustness") throw refused("usage-meshes");
    return { ...options, meshes: meshesIn(values.meshes) };
  },
  run({ perform, asked: options, io }) {
    const { columns, left, digits, row } = perform("bench", { options });
    const cells = [];
    const rows = [];
    for (let next = row; next; next = perform("bench").row) {
      const said = next.map((/** @type {any} */ value) => (value?.id ? say(value) : value));
      const shown = said.map((value) => cell(value, digits));
      io.log(columns.map((column, i) => `${column} ${shown[i]}`).join("  "));
      cells.push(shown);
      rows.push(Object.fromEntries(columns.map((column, i) => [column, said[i]])));
    }
    if (rows.length === 0) throw refused("usage-no-rows");
    const text = `${say(`bench-${options.table}`)}\n\n${table([columns, ...cells], left)}`;
    return { result: { table: options.table, rows }, text };
  },
};

/** @param {unknown} value @param {number | null} digits  significant ones; else one after the point */
function cell(value, digits) {
  if (typeof value !== "number" || Number.isInteger(value)) return String(value ?? "–");
  return digits ? formatShort(value, digits) : value.toFixed(1);
}

/** Mesh files of a folder, by name. @param {string} folder */
function meshesIn(folder) {
  const files = attempt(
    () => readdirSync(folder),
    () => refused("usage-no-folder", { folder }),
  );
  const names = files.filter(isMesh).sort();
  if (names.length === 0) throw refused("usage-empty-folder", { folder, formats: readHelp });
  return names.map((name) => ({ name, bytes: readInput(path.join(folder, name)) }));
}
