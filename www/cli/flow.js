// `umbilic flow` runs a flow and reports every step; `umbilic fill` closes holes or connects
// boundary loops, and lets a flow fair what is new.

import * as schema from "../generated/schema.js";
import { byCurvature, rowOf } from "../options.js";
import { isOver } from "../session.js";
import { say } from "../words.js";
import { out } from "./command.js";
import { attempt, failed, isRefusal, usage } from "./failure.js";
import { numbered, readSelection } from "./files.js";
import { checkWord, flagsOf, readFlags, typed } from "./options.js";
import { format, inWords } from "./text.js";

/** @import { Outcome, StepReport } from "../generated/types.js" */
/** @import { Options, Values } from "./options.js" */
/** @import { Perform } from "./command.js" */
/** @import { Terminal } from "../cli.js" */

/** @typedef {import("./command.js").Spec} Spec */

/** Flows that move vertices: flips have a command of their own. */
const flows = schema.flows.filter(({ order }) => order > 0).map(({ id }) => id);
/** How long a flow may go on, for every command that runs one. */
const budget = ["maxSteps", "maxSeconds"].map(rowOf);
/** Options that are lists of vertices, in files. */
const selections = /** @type {const} */ (["free", "fixed"]);
/** @type {Options} */
const untilConverged = {
  "until-converged": { help: "until it comes to rest, however long that takes" },
};

/** The budget of steps or of time, as far as it was asked for. @param {Values} values */
function budgetOf(values) {
  const words = typed(budget, values);
  if (!values["until-converged"]) return words;
  const [other] = Object.keys(words);
  if (other) throw usage(`Give --until-converged or --${rowOf(other).flag}, not both.`);
  return { maxSeconds: "auto" };
}

/** Steps until the run is over, and the exit code of that. @param {Perform} perform @param {Terminal} io */
function runSteps(perform, io) {
  /** @type {StepReport[]} */
  const steps = [];
  try {
    while (!isOver(perform("state").status)) {
      const report = perform("step");
      if (!report) break;
      steps.push(report);
      const { step, energy, dt, gradientNorm: gradient, milliseconds } = report;
      const readings = { energy, dt, gradient, ms: Math.round(milliseconds) };
      const parts = Object.entries(readings).map(([name, value]) => `${name} ${format(value)}`);
      io.log(`step ${String(step).padStart(4)}  ${parts.join("  ")}`);
    }
  } catch (error) {
    // Why a step failed is part of the outcome.
    if (!isRefusal(error)) throw error;
  }
  const outcome = perform("outcome");
  return { steps, outcome, exit: outcome.isBreakdown ? 4 : 0 };
}

/** How a run ended, in words. @param {Outcome} outcome */
const ended = ({ status, message, reason, fault }) => ({
  status,
  message: say(message),
  messageId: reason?.id ?? null,
  ...(fault && { kind: fault.kind, hint: say(fault.hint) }),
});

/** @type {Spec} */
export const flow = {
  summary: "runs a flow on a mesh",
  rows: schema.options.filter((row) => row.flows.some((id) => flows.includes(id))),
  words: "option",
  options: {
    flow: { value: flows.join("|"), help: `${say("option-flow-help")} (default circle)` },
    ...untilConverged,
    "self-intersections": {
      help: "counts where the surface passes through itself, before and after",
    },
    ...out,
    history: { value: "FILE.csv", isWritten: true, help: "the readings of every step, as a table" },
    report: { value: "FILE.json", isWritten: true, help: "the report that --json prints" },
  },
  ask(values) {
    /** @type {Record<string, string | number[]>} */
    const words = { flow: "circle", ...typed(schema.options, values), ...budgetOf(values) };
    if (words.flow === "flips")
      throw usage("Edge flips have a command of their own: umbilic flips.");
    if (words.goal === "smooth" && values["until-converged"])
      throw usage("--until-converged is for --goal relax: smoothing takes a set amount of steps.");
    for (const name of selections) {
      const file = words[name] ?? "auto";
      if (file !== "auto") words[name] = readSelection(String(file), name);
    }
    return readFlags("flow", words);
  },
  run({ perform, asked, values, io, loaded }) {
    const options = { ...asked };
    for (const name of selections) {
      if (asked[name]) options[name] = numbered(asked[name], loaded.numbers);
    }
    attempt(
      () => perform("configure", { options }),
      // Options that cannot be together.
      (error) => failed(error.message?.id === "flow-option" ? 2 : 3, error),
    );
    const { p, boundary } = asked;
    const energies = { ...(p !== undefined && { p: [p] }), ...(boundary && { boundary }) };
    const readings = () => {
      const found = values["self-intersections"] && perform("selfIntersections");
      return {
        ...perform("energy", energies),
        // Null if there are too many triangles for that.
        ...(found !== undefined && { selfIntersections: found && found.pairs.length / 2 }),
      };
    };
    const initial = readings();
    const { steps, outcome, exit } = runSteps(perform, io);
    const { monitored, curvatureJump, soundness } = outcome;
    // Of what its steps warned of; how it ended is said already.
    const warnings = outcome.warnings.filter(({ id }) => id.startsWith("warning-"));
    const result = {
      ...ended(outcome),
      ...{ monitored, steps: steps.map(inWords), initial, final: readings() },
      ...(soundness && { soundness }),
      // Those who read the result rely on its keys.
      ...((soundness || warnings.length > 0) && inWords({ warnings })),
      ...(byCurvature.includes(asked.flow) && { curvatureJump }),
    };
    const history = () => perform("history");
    const report = () => `${JSON.stringify(result, null, 1)}\n`;
    return { result, files: { history, report }, exit };
  },
};

/** Flows that can hold what is around a patch. */
const fairing = ["none", ...rowOf("free").flows];

/** @type {Spec} */
export const fill = {
  summary: "closes holes, or connects boundary loops, and fairs the patches",
  rows: schema.fill,
  options: {
    fair: {
      value: fairing.join("|"),
      help: "a flow that moves the new vertices afterwards (default none)",
    },
    // It relaxes, and has no other goal.
    ...flagsOf(budget, "option", () => "--fair: "),
    ...untilConverged,
    ...out,
  },
  ask(values) {
    const { fair = "none" } = values;
    checkWord("fair", fair, fairing);
    const words = { flow: fair, boundary: "fixed", ...budgetOf(values) };
    const limit = [...budget.map(({ flag }) => flag), "until-converged"].find((key) => values[key]);
    if (fair === "none" && limit) throw usage(`--${limit} needs --fair FLOW.`);
    return {
      options: readFlags("fill", typed(schema.fill, values)),
      fair: fair === "none" ? null : readFlags("flow", words),
    };
  },
  run({ perform, asked: { options, fair }, io }) {
    const { firstVertex, ...filled } = perform("fill", { options });
    const report = (/** @type {object} */ faired, /** @type {typeof filled.warnings} */ more) => ({
      ...inWords({ ...filled, warnings: [...filled.warnings, ...more] }),
      ...faired,
      info: inWords(perform("info")),
    });
    if (!fair) return { result: report({}, []) };
    const { flow } = fair;
    if (filled.newVertices === 0) {
      return { result: report({}, [{ id: "fair-nothing", values: { flow } }]) };
    }
    // The new vertices are those that move: the solver knows them.
    perform("configure", { options: fair });
    const { steps, outcome, exit } = runSteps(perform, io);
    const { curvatureJump, warnings } = outcome;
    const faired = { flow, ...ended(outcome), steps: steps.length, curvatureJump };
    return { result: report({ fair: faired }, warnings), exit };
  },
};
