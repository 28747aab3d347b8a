// `umbilic shape`: writes a sample shape.

import { perform } from "../session.js";
import { command } from "./command.js";
import { orExit, usage } from "./failure.js";
import { formatOf, writtenHelp } from "./files.js";
import { parse } from "./options.js";
import { loadSolver } from "./solver.js";
import { format, table } from "./text.js";

/**
 * @typedef {{ name: string, label: string, default: number }} Parameter
 * @typedef {{ name: string, label: string, parameters: Parameter[] }} Shape
 */

/** What can be asked for of a shape. @param {Parameter[]} parameters */
const shapeWith = (parameters) =>
  command({
    name: "shape",
    summary: "writes a sample shape; its parameters are options",
    operands: ["NAME"],
    options: {
      out: { value: "FILE", help: `the mesh: ${writtenHelp}` },
      selection: {
        value: "FILE.json",
        written: true,
        help: "the vertices that a flow should hold or move, if any, by their numbers in the mesh",
      },
      list: { help: "all shapes and their parameters" },
      ...Object.fromEntries(
        parameters.map(({ name, label }) => [name, { value: "NUMBER", help: label }]),
      ),
    },
    async ask(values) {
      if (values.out === undefined) throw usage("--out FILE is missing.");
      const given = parameters.filter(({ name }) => values[name] !== undefined);
      // What is no number is refused by the solver, as any number out of range.
      const number = (/** @type {string} */ text) => Number(text.trim() || Number.NaN);
      return Object.fromEntries(given.map(({ name }) => [name, number(values[name])]));
    },
    run({ session, asked: parameters, values, operands: [name] }) {
      const sample = orExit(2, () => perform(session, "sample", { name, parameters }));
      const { vertices, faces } = sample.info;
      const lists = { free: sample.free, fixed: sample.fixed };
      const selection = () => {
        // As the file that is written counts.
        const first = Number(formatOf(values.out) === "obj");
        const plain = Object.entries(lists).map(([key, list]) => [
          key,
          list && Array.from(list, (v) => v + first),
        ]);
        return `${JSON.stringify(Object.fromEntries(plain))}\n`;
      };
      const text = `${values.out}: ${vertices} vertices, ${faces} faces\n`;
      return { result: sample.info, text, files: { selection } };
    },
  });

const any = shapeWith([]);

/** @type {import("./command.js").Command} */
export const shape = {
  syntax: any.syntax,
  async run(call) {
    const { Session } = await loadSolver();
    /** @type {Shape[]} */
    const shapes = Session.shapes();
    if (call.parameters.includes("--list")) {
      const { values } = await parse(call.parameters, { ...any.syntax, operands: [] });
      call.io.write(values.json ? `${JSON.stringify(shapes)}\n` : list(shapes));
      return 0;
    }
    return shapeWith((await find(shapes, call.parameters[0])).parameters).run(call);
  },
};

/** @param {Shape[]} shapes @param {string | undefined} name @returns {Promise<Shape>} */
async function find(shapes, name) {
  if (name === undefined || name.startsWith("-")) {
    throw usage("Name the shape first: umbilic shape NAME.", "--list shows all there are.");
  }
  const found = shapes.find((one) => one.name === name);
  if (found) return found;
  const { nearest } = await loadSolver();
  const near = nearest(
    name,
    shapes.map((one) => one.name),
  );
  const hint = near ? `Did you mean \`${near}\`?` : "--list shows all there are.";
  throw usage(`There is no shape \`${name}\`.`, hint);
}

/** @param {Shape[]} shapes */
function list(shapes) {
  const rows = shapes.map(({ name, label, parameters }) => [
    name,
    label,
    parameters.map((p) => `--${p.name} ${format(p.default)}`).join(" "),
  ]);
  return table(rows, 3);
}
