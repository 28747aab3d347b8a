// @ts-check
// `umbilic bench`: the tables of the documentation, measured on this machine.

import { perform } from "../session.js";
import { isOver } from "../standing.js";
import { say } from "../words.js";
import { Failure, orExit, usage } from "./failure.js";
import { chosen, figureRows } from "./figures.js";
import { number, parse } from "./options.js";
import { refinementColumns, refinementRows } from "./refinement.js";
import { robustnessColumns, robustnessRows } from "./robustness.js";
import { memoryBytes } from "./solver.js";
import { table } from "./text.js";

/** @typedef {import("./solver.js").Session} Session */
/** @typedef {import("../generated/types.js").StepReport} StepReport */

/**
 * @typedef {object} Bench
 * @property {string} title
 * @property {string[]} columns  keys of a row, in order
 * @property {number} [left]      how many of them are set flush left (default 1)
 * @property {number} [digits]    significant ones of a number (default: one after the point)
 * @property {(session: Session, limits: Limits) => Generator<Row>} rows
 */
/**
 * @typedef {object} Limits
 * @property {number} maxVertices
 * @property {number} steps
 * @property {readonly import("../library.js").Figure[]} figures
 * @property {string} [meshes]  a folder
 */
/** @typedef {Record<string, number | string | null>} Row */

/** @type {Record<string, Bench>} */
const tables = {
  circle: {
    title:
      "One step of the circle-angle flow on a torus, and one trial of a step, in milliseconds (medians)",
    columns: ["vertices", "faces", "assemble", "factor", "solve", "step", "trial", "rejected"],
    rows: circleRows,
  },
  "p-willmore": {
    title:
      "p-Willmore flow, p = 2, on a torus: a step with area and volume kept and nonlinear\n" +
      "regularisation, or one pass of regularisation alone; milliseconds (medians of steps),\n" +
      "and those of table 1 of the paper, measured on another machine",
    columns: [
      ...["case", "faces", "first", "step", "assemble", "factor", "solve", "rejected"],
      ...["megabytes", "paper"],
    ],
    rows: pWillmoreRows,
  },
  flips: {
    title:
      "Edge flips to the end on a torus of jittered points, its cells cut at random: milliseconds,\n" +
      "thousands of flips a second, and nanoseconds over E log₂ E",
    columns: [
      "edges",
      "criterion",
      "flips",
      "milliseconds",
      "kiloflips",
      "nanoseconds",
      "megabytes",
    ],
    rows: flipRows,
  },
  mmcv: {
    title:
      "Minimal mean-curvature-variation flow: milliseconds of the first step and of a later one\n" +
      "(medians), steps to rest, and forming and solving the system in table 5.1 of the paper,\n" +
      "measured on another machine, with the ratio of its step to ours",
    columns: [
      ...["figure", "free", "first", "step", "assemble", "factor", "solve", "steps"],
      ...["megabytes", "paperUnknowns", "paperSteps", "paper", "ratio"],
    ],
    rows: mmcvRows,
  },
  refinement: {
    title:
      "Area, W/2 and ∫H² by cotangents and by fits under refinement, with observed orders; the\n" +
      "circle energy tends to ∫(H² − K) dA only along lines of curvature",
    columns: refinementColumns,
    digits: 5,
    rows: refinementRows,
  },
  robustness: {
    title:
      "How flows end, left to themselves: on shapes with noise (h the mean edge length), or on the\n" +
      "meshes of a folder in 100 steps. The energy at first and last, the largest relative rise of\n" +
      "the monitored functional in a step, the smallest angle there was",
    columns: robustnessColumns,
    left: 3,
    digits: 4,
    rows: robustnessRows,
  },
  figures: {
    title: "The figures of the four papers: what is expected, and what was measured here just now",
    columns: ["id", "figure", "expected", "measured", "verdict", "steps", "milliseconds"],
    left: 4,
    rows: (session, { figures }) => figureRows(session, figures),
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
    figures: { value: "ID,ID", help: "of the table figures only these" },
    quick: { help: "of the table figures only those that take a few seconds" },
    meshes: { value: "DIR", help: "of the table robustness: meshes to try every flow on" },
  },
};

/** @type {import("./commands.js").Command} */
export const bench = {
  syntax,
  async run({ parameters, io, open }) {
    const { values } = await parse(parameters, syntax);
    const name = values.table;
    if (name === undefined) throw usage("--table NAME is missing.", `There are: ${names()}.`);
    const maxVertices = number(values, "max-vertices", { low: 1 }) ?? Infinity;
    const steps = number(values, "steps", { low: 1, integer: true }) ?? 3;

    if (name !== "figures" && (values.figures !== undefined || values.quick)) {
      throw usage("--figures and --quick need --table figures.");
    }
    const { meshes } = values;
    if (name !== "robustness" && meshes !== undefined) {
      throw usage("--meshes needs --table robustness.");
    }
    const figures = chosen(values.figures, values.quick === true);

    const { title, columns, left, digits, rows: measure } = tables[name];
    const session = await open();
    const rows = [];
    for (const row of measure(session, { maxVertices, steps, figures, meshes })) {
      io.log(columns.map((column) => `${column} ${cell(row[column], digits)}`).join("  "));
      rows.push(row);
    }
    if (values.json) {
      io.write(`${JSON.stringify({ table: name, rows })}\n`);
    } else {
      const cells = rows.map((row) => columns.map((column) => cell(row[column], digits)));
      io.write(`${title}\n\n${table([columns, ...cells], left)}`);
    }
    return 0;
  },
};

function names() {
  return Object.keys(tables).join(", ");
}

/** Points around the tube of a torus with twice as many along: 10 to 3000 thousand edges. */
const tubes = [42, 128, 200, 224, 708];

/**
 * @param {Session} session
 * @param {Limits} limits
 * @returns {Generator<Row>}
 */
function* flipRows(session, { maxVertices }) {
  for (const tube of tubes) {
    // The shape has 1000 points at most each way.
    const around = Math.min(2 * tube, 1000);
    if (around * tube > maxVertices) return;
    for (const criterion of /** @type {const} */ (["area", "willmore", "localised"])) {
      const { info } = perform(session, "sample", {
        name: "sampled-torus",
        parameters: { around, tube },
      });
      const start = performance.now();
      const { flips } = perform(session, "flip", { options: { criterion } });
      const milliseconds = performance.now() - start;
      yield {
        edges: info.edges,
        criterion,
        flips,
        milliseconds,
        kiloflips: flips / milliseconds,
        nanoseconds: (1e6 * milliseconds) / (info.edges * Math.log2(info.edges)),
        megabytes: memoryBytes() / 1e6,
      };
    }
  }
}

/** @param {number | string | null} value @param {number} [digits] */
function cell(value, digits) {
  if (value === null) return "–";
  if (typeof value === "string") return value;
  if (Number.isInteger(value)) return String(value);
  return digits ? String(Number(value.toPrecision(digits))) : value.toFixed(1);
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
    const { info } = perform(session, "sample", {
      name: "torus",
      parameters: { around: side, tube: side },
    });
    perform(session, "configure", { options: { flow: "circle", maxSteps: steps + 1 } });
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

/** The paper's sizes as tori, and its seconds a step. */
const steppingCases = [
  { around: 92, tube: 50, paper: 16_600 },
  { around: 100, tube: 86, paper: 27_500 },
  { around: 500, tube: 346, paper: 707_000 },
];
const restingCase = { around: 150, tube: 115, paper: { linear: 2100, nonlinear: 4300 } };

/**
 * @param {Session} session
 * @param {Limits} limits
 * @returns {Generator<Row>}
 */
function* pWillmoreRows(session, { maxVertices, steps }) {
  const megabytes = () => Math.round(memoryBytes() / 1e6);
  const torus = (/** @type {number} */ around, /** @type {number} */ tube) =>
    perform(session, "sample", { name: "torus", parameters: { around, tube } }).info.faces;
  const { around, tube } = restingCase;
  if (around * tube <= maxVertices) {
    for (const mode of /** @type {const} */ (["linear", "nonlinear"])) {
      const faces = torus(around, tube);
      const start = performance.now();
      orExit(4, () =>
        perform(session, "regularise", { options: { mode, iterations: 1, features: 0 } }),
      );
      const first = performance.now() - start;
      const paper = restingCase.paper[mode];
      yield { ...blank, case: `regularise, ${mode}`, faces, first, megabytes: megabytes(), paper };
    }
  }
  for (const { around, tube, paper } of steppingCases) {
    if (around * tube > maxVertices) continue;
    const faces = torus(around, tube);
    const maxSteps = steps + 1;
    perform(session, "configure", {
      options: { flow: "p-willmore", keep: ["area", "volume"], maxSteps },
    });
    const first = oneStep(session).milliseconds;
    const reports = Array.from({ length: steps }, () => oneStep(session));
    yield {
      case: "step",
      faces,
      first,
      step: median(reports.map((report) => report.milliseconds)),
      assemble: median(reports.map((report) => report.assembleMilliseconds)),
      factor: median(reports.map((report) => report.factorMilliseconds)),
      solve: median(reports.map((report) => report.solveMilliseconds)),
      rejected: reports.reduce((sum, report) => sum + report.rejected, 0),
      megabytes: megabytes(),
      paper,
    };
  }
}

/** Tubes with their inner ends connected, in the number that gives the paper's unknowns. */
const blend = (/** @type {number} */ count, /** @type {number} */ around) => ({
  sample: "tubes",
  parameters: { count, around },
  fill: { connect: true, loops: Array.from({ length: count }, (_, tube) => 2 * tube) },
});

/**
 * The figures that are made by code, with the paper's unknowns (three a vertex), steps and
 * seconds for forming and solving the system of one step; then larger ones. The surfaces of
 * figures 5.2 and 5.3 are not published: these have as many unknowns.
 * @type {{ figure: string, sample: string, parameters: Record<string, number>,
 *          fill?: { connect?: boolean, loops: "all" | number[] }, table: number[] | null }[]}
 */
const mmcvCases = [
  { figure: "5.1(c)", sample: "cylinder-gaps", parameters: {}, table: [3480, 100, 0.12, 2.11] },
  { figure: "5.1(f)", sample: "sphere-openings", parameters: {}, table: [11160, 350, 0.42, 6.72] },
  { figure: "5.2(c), 2 tubes", ...blend(2, 43), table: [3222, 5, 0.12, 1.62] },
  { figure: "5.2(f), 3 tubes", ...blend(3, 43), table: [4410, 50, 0.17, 2.75] },
  { figure: "5.2(i), 6 tubes", ...blend(6, 30), table: [2400, 10, 0.09, 1.43] },
  {
    figure: "5.3(c), 3 holes",
    sample: "holed-sphere",
    parameters: { holes: 3, radius: 0.265 },
    fill: { loops: "all" },
    table: [1296, 10, 0.05, 1.26],
  },
  { figure: "5.4(b)", sample: "dodecahedron", parameters: {}, table: null },
  { figure: "5.6(c)", sample: "four-bumps", parameters: {}, table: [2520, 5, 0.09, 1.5] },
  ...[45, 81, 121, 151, 291, 421].map((vertices) => ({
    figure: `5.6(c), ${vertices}`,
    sample: "four-bumps",
    parameters: { vertices },
    table: null,
  })),
];

/**
 * @param {Session} session
 * @param {Limits} limits
 * @returns {Generator<Row>}
 */
function* mmcvRows(session, { maxVertices, steps }) {
  for (const { figure, sample, parameters, fill, table } of mmcvCases) {
    const { info } = perform(session, "sample", { name: sample, parameters });
    if (info.vertices > maxVertices) continue;
    if (fill) orExit(4, () => perform(session, "fill", { options: fill }));
    const { freeVertices } = perform(session, "configure", {
      options: { flow: "mmcv", maxSteps: 60 },
    });
    const first = oneStep(session).milliseconds;
    /** @type {StepReport[]} */
    const reports = [];
    while (!isOver(perform(session, "state").status)) reports.push(oneStep(session));
    const measured = reports.slice(0, steps);
    const step = median(measured.map((report) => report.milliseconds));
    const [unknowns, paperSteps, forming, solving] = table ?? [];
    const paper = table ? 1000 * (forming + solving) : null;
    yield {
      figure,
      free: freeVertices,
      first,
      step,
      assemble: median(measured.map((report) => report.assembleMilliseconds)),
      factor: median(measured.map((report) => report.factorMilliseconds)),
      solve: median(measured.map((report) => report.solveMilliseconds)),
      steps: `${reports.length + 1} ${perform(session, "state").status}`,
      megabytes: Math.round(memoryBytes() / 1e6),
      paperUnknowns: unknowns ?? null,
      paperSteps: paperSteps ?? null,
      paper,
      ratio: paper === null ? null : paper / step,
    };
  }
}

const blank = { step: null, assemble: null, factor: null, solve: null, rejected: null };

/** @param {Session} session @returns {StepReport} */
function oneStep(session) {
  const report = orExit(4, () => perform(session, "step"));
  if (report) return report;
  const { message } = perform(session, "state");
  const why = message ? say(message) : "";
  throw new Failure(4, "NoStep", `There is no step to measure: ${why}.`, "");
}

/** @param {number[]} values */
function median(values) {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}
