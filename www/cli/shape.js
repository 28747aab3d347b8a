// `umbilic shape`: writes a sample shape.

import { orExit, usage } from "./failure.js";
import { formatOf, writtenHelp } from "./files.js";
import { loadSolver, unknown } from "./solver.js";
import { format, table } from "./text.js";

/** @typedef {{ name: string, label: string, default: number }} Parameter */
/** @typedef {{ name: string, label: string, parameters: Parameter[] }} Shape */

/** What shapes there are. @returns {Shape[]} */
const all = () => loadSolver().Session.shapes();

/** @param {string | undefined} name */
function find(name) {
  if (name === undefined || name.startsWith("-")) {
    throw usage("Name the shape first: umbilic shape NAME.", "--list shows all there are.");
  }
  const found = all().find((one) => one.name === name);
  if (found) return found;
  const names = all().map((one) => one.name);
  throw unknown("shape", name, names, "--list shows all there are.");
}

/** @type {import("./command.js").Spec} */
export const shape = {
  summary: "writes a sample shape; its parameters are options",
  operands: ["NAME"],
  options(line) {
    const isPlain = line.length === 0 || line.includes("--list");
    const parameters = isPlain ? [] : find(line[0]).parameters;
    return {
      out: { value: "FILE", isWritten: true, help: `the mesh: ${writtenHelp}` },
      selection: {
        value: "FILE.json",
        isWritten: true,
        help: "the vertices that a flow should hold or move, if any, by their numbers in the mesh",
      },
      list: { help: "all shapes and their parameters" },
      ...Object.fromEntries(
        parameters.map(({ name, label }) => [name, { value: "NUMBER", help: label }]),
      ),
    };
  },
  ask({ list, out, ...values }, [name]) {
    if (list) return all();
    const { parameters } = find(name);
    if (out === undefined) throw usage("--out FILE is missing.");
    const given = parameters.filter((one) => values[one.name] !== undefined);
    // What is no number is refused by the solver, as any number out of range.
    const number = (/** @type {string} */ text) => Number(text.trim() || Number.NaN);
    return Object.fromEntries(given.map((one) => [one.name, number(values[one.name])]));
  },
  run({ perform, asked, values, operands: [name] }) {
    if (values.list) return { result: asked, text: listed(asked) };
    const sample = orExit(2, () => perform("sample", { name, parameters: asked }));
    const { vertices, faces } = sample.info;
    // As the file that is written counts.
    const first = Number(formatOf(values.out) === "obj");
    const numbers = (/** @type {Uint32Array | null} */ list) =>
      list && Array.from(list, (v) => v + first);
    const lists = { free: numbers(sample.free), fixed: numbers(sample.fixed) };
    const text = `${values.out}: ${vertices} vertices, ${faces} faces\n`;
    return { result: sample.info, text, files: { selection: () => `${JSON.stringify(lists)}\n` } };
  },
};

/** @param {Shape[]} shapes */
function listed(shapes) {
  const rows = shapes.map(({ name, label, parameters }) => [
    name,
    label,
    parameters.map((p) => `--${p.name} ${format(p.default)}`).join(" "),
  ]);
  return table(rows, 3);
}
