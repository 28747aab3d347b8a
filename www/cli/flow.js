// @ts-check
// `umbilic flow`: runs a flow and reports every step.

import * as schema from "../generated/schema.js";
import { byCurvature, rowOf } from "../options.js";
import { perform } from "../session.js";
import { isBreakdown, isOver } from "../standing.js";
import { say } from "../words.js";
import { Failure, orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, readMesh, readSelection, writeOutput } from "./files.js";
import { flagsOf, parse, typed } from "./options.js";
import { loadSolver } from "./solver.js";
import { entries, format, inWords, table } from "./text.js";

/** @typedef {import("../generated/schema.js").FlowOptions} FlowOptions */
/** @typedef {import("../generated/types.js").StepReport} StepReport */
/** @typedef {import("../generated/types.js").Fault} Fault */
/** @typedef {import("../generated/types.js").Status} Status */
/** @typedef {import("../generated/types.js").CurvatureJump} CurvatureJump */
/** @typedef {import("./options.js").Values} Values */
/** @typedef {import("./solver.js").Session} Session */

/** How long a flow may go on, for every command that runs one. */
const budget = ["maxSteps", "maxSeconds"].map(rowOf);

/** @type {import("./options.js").Options} */
export const budgetFlags = {
  ...flagsOf(budget),
  "until-converged": { help: "until it comes to rest, however long that takes" },
};

/** Flows that move vertices: flips have a command of their own. */
const flows = schema.flows.filter(({ order }) => order > 0).map(({ id }) => id);
const rows = schema.options.filter((row) => row.flows.some((flow) => flows.includes(flow)));

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "runs a flow on a mesh",
  operands: ["MESH"],
  options: {
    ...flagsOf(rows),
    flow: { value: flows.join("|"), help: `${say("option-flow-help")} (default circle)` },
    ...budgetFlags,
    "self-intersections": {
      help: "counts where the surface passes through itself, before and after",
    },
    out: { value: "FILE", help: "the mesh at the end: .obj, .off, .ply, .stl or .glb" },
    history: { value: "FILE.csv", help: "the readings of every step, as a table" },
    report: { value: "FILE.json", help: "the report that --json prints" },
  },
};

/** @type {import("./commands.js").Command} */
export const flow = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const options = await flowOptions(values);
    checkOutputs([values.out, values.history, values.report]);
    const outFormat = values.out && formatOf(values.out);
    const { bytes, name } = readMesh(operands[0], io);

    const session = await open();
    orExit(3, () => perform(session, "load", { bytes, name }));
    orExit(3, () => perform(session, "configure", { options }));
    const powers = options.p === undefined ? [] : [options.p];
    const energyOptions = { p: powers, ...(options.boundary && { boundary: options.boundary }) };
    const readings = () => ({
      ...perform(session, "energy", energyOptions),
      ...crossings(session, values),
    });
    const initial = orExit(3, readings);
    const { steps, fault, ...end } = runSteps(session, (step) => io.log(stepLine(step)));
    const { status } = end;
    const final = status === "failed" ? orNull(readings) : readings();
    const { monitored } = perform(session, "state");
    const outcome = { ...end, ...fault, monitored };
    const report = {
      ...outcome,
      steps: steps.map(inWords),
      initial,
      final,
      ...jump(session, options),
    };

    if (values.out) writeOutput(values.out, perform(session, "export", { format: outFormat }));
    if (values.history) writeOutput(values.history, perform(session, "history"));
    if (values.report) writeOutput(values.report, `${JSON.stringify(report, null, 1)}\n`);
    if (values.json) io.write(`${JSON.stringify(report)}\n`);
    else io.write(summary(report));
    return isBreakdown(status) ? 4 : 0;
  },
};

/**
 * The options that were asked for, read and checked by the solver; the others are left out, so
 * that the defaults stay in one place.
 * @param {Values} values
 * @returns {Promise<FlowOptions>}
 */
async function flowOptions(values) {
  /** @type {Record<string, string | number[]>} */
  const words = { flow: "circle", ...typed(rows, values), ...budgetOf(values) };
  if (words.flow === "flips") throw usage("Edge flips have a command of their own: umbilic flips.");
  for (const name of /** @type {const} */ (["free", "fixed"])) {
    if (name in words && words[name] !== "auto")
      words[name] = readSelection(String(words[name]), name);
  }
  // Smoothing takes a set number of steps, and leading a volume keeps it.
  if (words.goal === "smooth" && "maxSteps" in words) words.smoothSteps ??= words.maxSteps;
  if ("reducedVolume" in words) words.keep ??= "area,volume";
  return readFlags(words);
}

/**
 * @param {Record<string, unknown>} words  options by name, as text
 * @returns {Promise<FlowOptions>}
 */
export async function readFlags(words) {
  const solver = await loadSolver();
  return orExit(2, () => solver.readFlags(words));
}

/**
 * The budget of steps or of time, as far as it was asked for.
 * @param {Values} values
 * @returns {Record<string, string>}
 */
export function budgetOf(values) {
  const words = typed(budget, values);
  if (!values["until-converged"]) return words;
  const [other] = Object.keys(words);
  if (other) throw usage(`Give --until-converged or --${rowOf(other).flag}, not both.`);
  return { maxSeconds: "auto" };
}

/**
 * How the curvature jumps across the rim of what moved, under the flows that mind it.
 * @param {Session} session
 * @param {FlowOptions} options
 */
function jump(session, options) {
  if (!byCurvature.includes(options.flow ?? "")) return {};
  return { curvatureJump: perform(session, "curvatureJump") };
}

/**
 * Pairs of triangles that pass through each other, where it is asked for; null if there are too
 * many triangles for that.
 * @param {Session} session
 * @param {Values} values
 */
function crossings(session, values) {
  if (!values["self-intersections"]) return {};
  const found = perform(session, "selfIntersections");
  return { selfIntersections: found && found.pairs.length / 2 };
}

/**
 * Steps until the session says it is over.
 * @param {Session} session
 * @param {(step: StepReport) => void} onStep
 * @returns {{ status: Status, message: string, messageId: string | null, steps: StepReport[],
 *             fault?: { kind: string, hint: string } }}
 */
export function runSteps(session, onStep) {
  /** @type {StepReport[]} */
  const steps = [];
  try {
    while (!isOver(perform(session, "state").status)) {
      /** @type {StepReport | null} */
      const step = orExit(4, () => perform(session, "step"));
      // There was none to take: the state says why.
      if (step === null) break;
      steps.push(step);
      onStep(step);
    }
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    const { kind, message, hint, id = null } = error;
    const fault = { kind, hint };
    return { ...ending("failed", steps.length, message), messageId: id, steps, fault };
  }
  const { status, message, step } = perform(session, "state");
  return { ...ending(status, step, message), messageId: message?.id ?? null, steps };
}

/** @param {Status} status @param {number} steps @param {unknown} reason */
const ending = (status, steps, reason) => ({
  status,
  message: say("run-over", { ended: { id: "ended", values: { status, steps } }, reason }),
});

/**
 * @template T
 * @param {() => T} call
 * @returns {T | null}
 */
function orNull(call) {
  try {
    return orExit(4, call);
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return null;
  }
}

/** @param {StepReport} step */
function stepLine({ step, energy, dt, gradientNorm, milliseconds }) {
  const readings = { energy, dt, gradient: gradientNorm, ms: Math.round(milliseconds) };
  const parts = Object.entries(readings).map(([name, value]) => `${name} ${format(value)}`);
  return `step ${String(step).padStart(4)}  ${parts.join("  ")}`;
}

/**
 * @param {{ message: string, initial: any, final: any,
 *           curvatureJump?: CurvatureJump | null }} report
 */
function summary({ message, initial, final, curvatureJump }) {
  const last = final && new Map(entries(final));
  const rows = entries(initial).map(([key, value]) => [key, format(value), format(last?.get(key))]);
  if (curvatureJump) rows.push(["curvatureJump", "", format(curvatureJump.relative)]);
  return `${message}\n\n${table([["", "initial", "final"], ...rows])}`;
}
