// @ts-check
// `umbilic bench`: the tables of the documentation, measured on this machine.

import { Failure, orExit, usage } from "./failure.js";
import { number, parse } from "./options.js";
import { table } from "./text.js";

/** @typedef {import("./solver.js").Session} Session */
/** @typedef {import("../protocol.js").StepReport} StepReport */

/**
 * @typedef {object} Bench
 * @property {string} title
 * @property {string[]} columns  keys of a row, in order
 * @property {(session: Session, limits: Limits) => Generator<Row>} rows
 */
/** @typedef {{ maxVertices: number, steps: number }} Limits */
/** @typedef {Record<string, number>} Row */

/** @type {Record<string, Bench>} */
const tables = {
  circle: {
    title:
      "One step of the circle-angle flow on a torus, and one trial of a step, in milliseconds (medians)",
    columns: ["vertices", "faces", "assemble", "factor", "solve", "step", "trial", "rejected"],
    rows: circleRows,
  },
};

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "measures a table of the documentation",
  operands: [],
  options: {
    table: { value: "NAME", choices: Object.keys(tables), help: "which table" },
    "max-vertices": { value: "N", help: "leaves out larger meshes" },
    steps: { value: "N", help: "steps measured a row, after one that is not (default 3)" },
  },
};

/** @type {import("./commands.js").Command} */
export const bench = {
  syntax,
  async run({ parameters, io, open }) {
    const { values } = parse(parameters, syntax);
    const name = values.table;
    if (name === undefined) throw usage("--table NAME is missing.", `There are: ${names()}.`);
    const maxVertices = number(values, "max-vertices", { low: 1 }) ?? Infinity;
    const steps = number(values, "steps", { low: 1, integer: true }) ?? 3;

    const { title, columns, rows: measure } = tables[name];
    const session = await open();
    const rows = [];
    for (const row of measure(session, { maxVertices, steps })) {
      io.log(columns.map((column) => `${column} ${cell(row[column])}`).join("  "));
      rows.push(row);
    }
    if (values.json) {
      io.write(`${JSON.stringify({ table: name, rows })}\n`);
    } else {
      const cells = rows.map((row) => columns.map((column) => cell(row[column])));
      io.write(`${title}\n\n${table([columns, ...cells])}`);
    }
    return 0;
  },
};

function names() {
  return Object.keys(tables).join(", ");
}

/** @param {number} value */
function cell(value) {
  return Number.isInteger(value) ? String(value) : value.toFixed(1);
}

/** Sides of square lattices on a torus: 2.6, 10, 37, 100 and 350 thousand vertices. */
const sides = [51, 100, 192, 316, 592];

/**
 * @param {Session} session
 * @param {Limits} limits
 * @returns {Generator<Row>}
 */
function* circleRows(session, { maxVertices, steps }) {
  for (const side of sides) {
    if (side * side > maxVertices) return;
    const { info } = session.sample("torus", { around: side, tube: side });
    session.configure({ flow: "circle", maxSteps: steps + 1 });
    // The first step also analyses the matrix's pattern.
    oneStep(session);
    const reports = Array.from({ length: steps }, () => oneStep(session));
    yield {
      vertices: info.vertices,
      faces: info.faces,
      assemble: median(reports.map((report) => report.assembleMilliseconds)),
      factor: median(reports.map((report) => report.factorMilliseconds)),
      solve: median(reports.map((report) => report.solveMilliseconds)),
      step: median(reports.map((report) => report.milliseconds)),
      trial: median(reports.map((report) => report.milliseconds / (1 + report.rejected))),
      rejected: reports.reduce((sum, report) => sum + report.rejected, 0),
    };
  }
}

/** @param {Session} session @returns {StepReport} */
function oneStep(session) {
  const report = orExit(4, () => session.step());
  if (report) return report;
  throw new Failure(4, "NoStep", `There is no step to measure: ${session.state().message}.`, "");
}

/** @param {number[]} values */
function median(values) {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}
