// @ts-check
// `umbilic shape`: writes a sample shape.

import { perform } from "../session.js";
import { orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, writeOutput } from "./files.js";
import { number, parse } from "./options.js";
import { loadSolver } from "./solver.js";
import { format, table } from "./text.js";

/** @typedef {import("../generated/types.js").Info} Info */

/**
 * @typedef {{ name: string, label: string, default: number, low: number, high: number,
 *             integer: boolean }} Parameter
 * @typedef {{ name: string, label: string, parameters: Parameter[] }} Shape
 */

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "writes a sample shape; its parameters are options",
  operands: ["NAME"],
  options: {
    out: { value: "FILE", help: "the mesh: .obj, .off, .ply, .stl or .glb" },
    selection: { value: "FILE.json", help: "the vertices that a flow should hold or move, if any" },
    list: { help: "all shapes and their parameters" },
  },
};

/** @type {import("./commands.js").Command} */
export const shape = {
  syntax,
  async run({ parameters, io, open }) {
    const session = await open();
    /** @type {Shape[]} */
    const shapes = /** @type {any} */ (session.constructor).shapes();
    if (parameters.includes("--list")) {
      const { values } = await parse(parameters, { ...syntax, operands: [] });
      io.write(values.json ? `${JSON.stringify(shapes)}\n` : list(shapes));
      return 0;
    }

    const chosen = await find(shapes, parameters[0]);
    const { operands, values } = await parse(parameters, {
      ...syntax,
      options: { ...syntax.options, ...options(chosen) },
    });
    if (values.out === undefined) throw usage("--out FILE is missing.");
    const outFormat = formatOf(values.out);
    checkOutputs([values.out, values.selection]);

    const sample = orExit(2, () =>
      perform(session, "sample", { name: operands[0], parameters: asked(chosen, values) }),
    );
    writeOutput(
      values.out,
      orExit(3, () => perform(session, "export", { format: outFormat })),
    );
    if (values.selection) {
      const [free, fixed] = [sample.free, sample.fixed].map((list) => list && Array.from(list));
      writeOutput(values.selection, `${JSON.stringify({ free, fixed })}\n`);
    }
    const { vertices, faces } = /** @type {Info} */ (sample.info);
    if (values.json) io.write(`${JSON.stringify(sample.info)}\n`);
    else io.write(`${values.out}: ${vertices} vertices, ${faces} faces\n`);
    return 0;
  },
};

/**
 * @param {Shape[]} shapes
 * @param {string | undefined} name
 * @returns {Promise<Shape>}
 */
async function find(shapes, name) {
  if (name === undefined || name.startsWith("-")) {
    throw usage("Name the shape first: umbilic shape NAME.", "--list shows all there are.");
  }
  const found = shapes.find((shape) => shape.name === name);
  if (found) return found;
  const { nearest } = await loadSolver();
  const near = nearest(
    name,
    shapes.map((shape) => shape.name),
  );
  const hint = near ? `Did you mean \`${near}\`?` : "--list shows all there are.";
  throw usage(`There is no shape \`${name}\`.`, hint);
}

/**
 * The parameters of a shape as options.
 * @param {Shape} shape
 * @returns {import("./options.js").Options}
 */
function options({ parameters }) {
  return Object.fromEntries(
    parameters.map(({ name, label }) => [name, { value: "NUMBER", help: label }]),
  );
}

/**
 * @param {Shape} shape
 * @param {import("./options.js").Values} values
 * @returns {Record<string, number>}
 */
function asked({ parameters }, values) {
  /** @type {Record<string, number>} */
  const given = {};
  for (const { name, integer } of parameters) {
    const value = number(values, name, { integer });
    if (value !== undefined) given[name] = value;
  }
  return given;
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
