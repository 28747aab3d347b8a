// `umbilic shape`: writes a sample shape.

import { say } from "../words.js";
import { refused } from "./failure.js";
import { formatOf } from "./files.js";
import { loadSolver, unknown } from "./solver.js";
import { format, table } from "./text.js";

/** @typedef {{ name: string, label: string, default: number }} Parameter */
/** @typedef {{ name: string, label: string, parameters: Parameter[] }} Shape */

/** What shapes there are. @returns {Shape[]} */
const all = () => loadSolver().Session.shapes();

/** The parameters of a shape. @param {string | undefined} name */
function parametersOf(name) {
  if (name === undefined || name.startsWith("-")) throw refused("usage-no-shape");
  const found = all().find((one) => one.name === name);
  if (found) return found.parameters;
  const names = all().map((one) => one.name);
  throw unknown("usage-shape", name, names);
}

/** @type {import("./run.js").Spec} */
export const shape = {
  operands: ["NAME"],
  own: { out: "FILE", selection: "FILE.json", list: null },
  refusal: 2,
  more(line) {
    const isPlain = line.length === 0 || line.includes("--list");
    const parameters = isPlain ? [] : parametersOf(line[0]);
    return parameters.map(({ name, label }) => ({ flag: name, value: "NUMBER", help: label }));
  },
  ask({ list, out, ...values }, [name]) {
    if (list) return all();
    const parameters = parametersOf(name);
    if (out === undefined) throw refused("usage-no-out");
    const given = parameters.filter((one) => values[one.name] !== undefined);
    // What is no number is refused by the solver, as any number out of range.
    const number = (/** @type {string} */ text) => Number(text.trim() || Number.NaN);
    return Object.fromEntries(given.map((one) => [one.name, number(values[one.name])]));
  },
  run({ perform, asked, values, operands: [name] }) {
    if (values.list) return { result: asked, text: listed(asked) };
    const { info, free, fixed } = perform("sample", { name, parameters: asked });
    // As the file that is written counts.
    const first = Number(formatOf(values.out) === "obj");
    const numbers = (/** @type {Uint32Array | null} */ list) =>
      list && Array.from(list, (v) => v + first);
    const lists = { free: numbers(free), fixed: numbers(fixed) };
    const text = `${say("shape-written", { ...info, file: values.out })}\n`;
    return { result: info, text, files: { selection: () => `${JSON.stringify(lists)}\n` } };
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
