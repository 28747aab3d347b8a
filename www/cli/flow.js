// @ts-check
// `umbilic flow`: runs a flow and reports every step.

import { isBreakdown, isOver } from "../standing.js";
import { say } from "../words.js";
import { Failure, orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, readMesh, readSelection, writeOutput } from "./files.js";
import { number, parse } from "./options.js";
import { entries, format, inWords, table } from "./text.js";

/** @typedef {import("../protocol.js").FlowOptions} FlowOptions */
/** @typedef {import("../protocol.js").StepReport} StepReport */
/** @typedef {import("../protocol.js").Fault} Fault */
/** @typedef {import("../protocol.js").Status} Status */
/** @typedef {import("../protocol.js").CurvatureJump} CurvatureJump */
/** @typedef {import("./options.js").Values} Values */
/** @typedef {import("./solver.js").Session} Session */

const curvatureFlows = ["mean-curvature", "surface-diffusion", "willmore", "mmcv"];
const flows = ["circle", "p-willmore", ...curvatureFlows];

/** How long a flow may go on, for every command that runs one. @type {import("./options.js").Options} */
export const budgetOptions = {
  steps: { value: "N", help: "at most so many steps, however long they take" },
  seconds: {
    value: "S",
    help: "at most so many seconds of computing (default, without --steps: until rest, or 120)",
  },
  "until-converged": { help: "until it comes to rest, however long that takes" },
};

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "runs a flow on a mesh",
  operands: ["MESH"],
  options: {
    flow: {
      value: flows.join("|"),
      help: "which flow (default circle: the circle-angle Willmore flow)",
    },
    scheme: {
      value: "SCHEME",
      choices: ["auto", "paper"],
      help: "auto chooses the step size; paper keeps the paper's integrator and a constant --dt",
    },
    integrator: {
      value: "NAME",
      choices: ["semi-implicit", "forward-euler", "backward-euler", "l-bfgs"],
      help: "how a step is taken",
    },
    ...budgetOptions,
    dt: { value: "auto|VALUE", help: "step size, in squared lengths of the mesh" },
    tau: {
      value: "VALUE",
      help: "step size without a unit: in squared mean edge lengths; p-willmore: in (A/4π)^(p/2+1); the other flows: in the size of the free patches to the power of their order (default 1)",
    },
    p: { value: "P", help: "p-willmore: the exponent, 0 or from 1 (default 2)" },
    keep: { value: "area,volume", help: "p-willmore: what is kept, one or both" },
    regularise: {
      value: "MODE",
      choices: ["off", "linear", "nonlinear"],
      help: "p-willmore: conformal regularisation after each step (default nonlinear)",
    },
    "regularise-epsilon": { value: "VALUE", help: "p-willmore: its ε (default 0.01)" },
    "tau-growth": {
      value: "S",
      help: "p-willmore, paper's scheme: factor on the step (default 1.2)",
    },
    "tau-max": { value: "VALUE", help: "p-willmore, paper's scheme: largest step without a unit" },
    "reduced-volume": { value: "V", help: "p-willmore: leads the volume there; both are kept" },
    perturbation: {
      value: "SHARE",
      help: "p-willmore: pushes the start along its normals by up to so many mean edge lengths (at most 0.3)",
    },
    "spontaneous-curvature": { value: "H0", help: "p-willmore, p = 2: times √(A/4π)" },
    tension: { value: "VALUE", help: "p-willmore, p = 2: times A/4π" },
    pressure: { value: "VALUE", help: "p-willmore, p = 2: times (A/4π)^(3/2)" },
    rungs: {
      value: "N",
      help: "mmcv: so many steps of surface diffusion first (default: as a rough start needs)",
    },
    goal: {
      value: "GOAL",
      choices: ["relax", "smooth"],
      help: "relax goes to a minimum; smooth removes a set amount of detail",
    },
    detail: { value: "L", help: "smooth: removes detail below so many mean edge lengths" },
    mass: { value: "MASS", choices: ["auto", "uniform", "area"], help: "weight of a vertex" },
    epsilon: { value: "VALUE", help: "smoothing of the angles, in radians" },
    sharpen: { help: "lets epsilon go to 0 at the end (--no-sharpen: keeps it)" },
    prefill: { help: "lays the free vertices out smoothly before the first step" },
    boundary: {
      value: "CONDITION",
      choices: ["fixed", "clamped", "free"],
      help: "what holds at the boundary of an open mesh",
    },
    free: { value: "FILE.json", help: "only these vertices move" },
    fixed: { value: "FILE.json", help: "these vertices do not move" },
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
    const { operands, values } = parse(parameters, syntax);
    const options = flowOptions(values);
    checkOutputs([values.out, values.history, values.report]);
    const outFormat = values.out && formatOf(values.out);
    const { bytes, name } = readMesh(operands[0], io);

    const session = await open();
    orExit(3, () => session.load(bytes, name));
    orExit(3, () => session.configure(options));
    const powers = options.p === undefined ? [] : [options.p];
    const energyOptions = { p: powers, ...(options.boundary && { boundary: options.boundary }) };
    const readings = () => ({ ...session.energy(energyOptions), ...crossings(session, values) });
    const initial = orExit(3, readings);
    const { steps, fault, ...end } = runSteps(session, (step) => io.log(stepLine(step)));
    const { status } = end;
    const final = status === "failed" ? orNull(readings) : readings();
    const { monitored } = session.state();
    const outcome = { ...end, ...fault, monitored };
    const report = {
      ...outcome,
      steps: steps.map(inWords),
      initial,
      final,
      ...jump(session, options),
    };

    if (values.out) writeOutput(values.out, session.export(outFormat));
    if (values.history) writeOutput(values.history, session.history());
    if (values.report) writeOutput(values.report, `${JSON.stringify(report, null, 1)}\n`);
    if (values.json) io.write(`${JSON.stringify(report)}\n`);
    else io.write(summary(report));
    return isBreakdown(status) ? 4 : 0;
  },
};

/**
 * The command line's options in the words of `Session.configure`; what was not asked
 * for is left out, so that the defaults stay in one place.
 * @param {Values} values
 * @returns {FlowOptions}
 */
function flowOptions(values) {
  const flow = values.flow ?? "circle";
  if (!flows.includes(flow)) {
    throw usage(`There is no flow \`${flow}\`.`, `This version has: ${flows.join(", ")}.`);
  }
  onlyFor(flow, values);

  const smooth = values.goal === "smooth";
  if (values.detail !== undefined && !smooth) throw usage("--detail needs --goal smooth.");
  if (smooth && values["until-converged"]) {
    throw usage("--goal smooth takes a set number of steps: --until-converged has no meaning.");
  }
  const automatic = values.dt === "auto";
  const dt = automatic ? null : positive(values, "dt");
  const tau = positive(values, "tau");
  if (typeof dt === "number" && tau !== undefined) throw usage("Give --dt or --tau, not both.");

  const budget = budgetOf(values);
  const given = {
    flow,
    scheme: values.scheme,
    integrator: values.integrator,
    boundary: values.boundary,
    goal: values.goal,
    detail: positive(values, "detail"),
    smoothSteps: smooth ? budget.maxSteps : undefined,
    dt,
    tau,
    mass: values.mass,
    epsilon: number(values, "epsilon", { low: 0 }),
    sharpen: values.sharpen,
    prefill: values.prefill,
    free: values.free && readSelection(values.free, "free"),
    fixed: values.fixed && readSelection(values.fixed, "fixed"),
    ...budget,
    perturbation: number(values, "perturbation", { low: 0 }),
    p: number(values, "p", { low: 0 }),
    keep: keep(values),
    regularise: values.regularise,
    regulariseEpsilon: positive(values, "regularise-epsilon"),
    tauGrowth: positive(values, "tau-growth"),
    tauMax: positive(values, "tau-max"),
    reducedVolume: positive(values, "reduced-volume"),
    spontaneousCurvature: number(values, "spontaneous-curvature"),
    tension: number(values, "tension"),
    pressure: number(values, "pressure"),
    rungs: number(values, "rungs", { low: 0, integer: true }),
  };
  return /** @type {FlowOptions} */ (
    Object.fromEntries(Object.entries(given).filter(([, value]) => value !== undefined))
  );
}

/**
 * The budget of steps or of time, as far as it was asked for.
 * @param {Values} values
 * @returns {Pick<FlowOptions, "maxSteps" | "maxSeconds">}
 */
export function budgetOf(values) {
  const given = Object.keys(budgetOptions).filter((name) => values[name] !== undefined);
  if (given.length > 1) {
    throw usage(`Give --${given[0]} or --${given[1]}, not both.`, "Each says when to stop.");
  }
  if (values["until-converged"]) return { maxSeconds: null };
  const [maxSteps, maxSeconds] = [
    number(values, "steps", { low: 0, integer: true }),
    positive(values, "seconds"),
  ];
  if (maxSeconds !== undefined) return { maxSeconds };
  return maxSteps === undefined ? {} : { maxSteps };
}

/**
 * How the curvature jumps across the rim of what moved, under the flows that mind it.
 * @param {Session} session
 * @param {FlowOptions} options
 */
function jump(session, options) {
  if (!curvatureFlows.includes(options.flow ?? "")) return {};
  return { curvatureJump: session.curvatureJump() };
}

/**
 * Pairs of triangles that pass through each other, where it is asked for; null if there are too
 * many triangles for that.
 * @param {Session} session
 * @param {Values} values
 */
function crossings(session, values) {
  if (!values["self-intersections"]) return {};
  const found = session.selfIntersections();
  return { selfIntersections: found && found.pairs.length / 2 };
}

/** Options of open and partly held surfaces. */
const regional = ["prefill", "boundary", "free", "fixed"];

/** Options that not every flow has, by flow. @type {Record<string, string[]>} */
const own = {
  circle: [...["integrator", "goal", "detail", "mass", "epsilon", "sharpen"], ...regional],
  "p-willmore": [
    ...["p", "keep", "regularise", "regularise-epsilon", "reduced-volume"],
    ...["tau-growth", "tau-max", "perturbation"],
    ...["spontaneous-curvature", "tension", "pressure"],
  ],
  "mean-curvature": regional,
  "surface-diffusion": regional,
  willmore: regional,
  mmcv: [...regional, "rungs"],
};

/**
 * An option that would change nothing is a mistake.
 * @param {string} flow
 * @param {Values} values
 */
function onlyFor(flow, values) {
  for (const [name, options] of Object.entries(own)) {
    const stray = options.find((option) => option in values && !own[flow]?.includes(option));
    if (stray) throw usage(`--${stray} is an option of --flow ${name}, not of ${flow}.`);
  }
}

/** @param {Values} values @returns {string[] | undefined} */
function keep(values) {
  if (values.keep === undefined) {
    return values["reduced-volume"] === undefined ? undefined : ["area", "volume"];
  }
  const names = values.keep.split(",");
  const wrong = names.find((/** @type {string} */ name) => !["area", "volume"].includes(name));
  if (wrong !== undefined)
    throw usage(`--keep cannot be \`${values.keep}\`.`, "area, volume or area,volume.");
  return names;
}

/**
 * @param {Values} values
 * @param {string} name
 */
function positive(values, name) {
  const value = number(values, name);
  if (value !== undefined && value <= 0) throw usage(`--${name} must be above 0.`);
  return value;
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
    while (!isOver(session.state().status)) {
      /** @type {StepReport | null} */
      const step = orExit(4, () => session.step());
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
  const { status, message, step } = session.state();
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
