// `umbilic flow` runs a flow and reports every step; `umbilic fill` closes holes or connects
// boundary loops, and lets a flow fair what is new.

import * as schema from "../generated/schema.js";
import { byCurvature } from "../options.js";
import { isOver } from "../session.js";
import { say } from "../words.js";
import { attempt, failed, refused } from "./failure.js";
import { readSelection } from "./files.js";
import { readFlags, typed } from "./options.js";
import { unknown } from "./solver.js";
import { format, inWords } from "./text.js";

/** @import { Outcome, StepReport } from "../generated/types.js" */
/** @import { Perform, Spec } from "./run.js" */
/** @import { Values } from "./options.js" */
/** @import { Terminal } from "../cli.js" */

const untilRest = "until-converged";
/** Flows that fair a fill, and how long a flow may go on. */
const [fairing, ...budget] = schema.flags.fair;
/** Options that are lists of vertices, in files. */
const selections = /** @type {const} */ (["free", "fixed"]);

/**
 * What was asked of a flow, with the time that it takes to come to rest where that was.
 * @param {Record<string, any>} words @param {Values} values
 */
function withBudget(words, values) {
  if (!values[untilRest]) return words;
  const other = budget.find(({ name }) => words[name] !== undefined);
  if (other) throw refused("usage-both", { flag: other.flag });
  return { ...words, maxSeconds: "auto" };
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
  } catch (/** @type {any} */ error) {
    // Why a step failed is part of the outcome.
    if (!error?.kind) throw error;
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
  own: {
    ...{ [untilRest]: null, "self-intersections": null },
    ...{ out: "FILE", history: "FILE.csv", report: "FILE.json" },
  },
  ask(values) {
    const words = withBudget({ flow: "circle", ...typed("flow", values) }, values);
    if (words.flow === "flips") throw refused("usage-flips");
    if (words.goal === "smooth" && values[untilRest]) throw refused("usage-smooth");
    for (const name of selections) {
      const file = words[name] ?? "auto";
      if (file !== "auto") words[name] = readSelection(file, name);
    }
    return readFlags("flow", words);
  },
  run({ perform, asked, values, io }) {
    const options = { ...asked };
    for (const name of selections) {
      if (asked[name]) options[name] = perform("numbered", { numbers: asked[name] });
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

/** @type {Spec} */
export const fill = {
  tables: ["fill", "fair"],
  own: { [untilRest]: null, out: "FILE" },
  ask(values) {
    const { fair: flow = "none", ...limits } = typed("fair", values);
    const names = fairing.value?.split("|") ?? [];
    if (!names.includes(flow)) throw unknown("usage-fair", flow, names);
    const words = withBudget({ flow, boundary: "fixed", ...limits }, values);
    const flag = [...budget.map((limit) => limit.flag), untilRest].find((key) => values[key]);
    if (flow === "none" && flag) throw refused("usage-unfaired", { flag });
    return {
      options: readFlags("fill", typed("fill", values)),
      fair: flow === "none" ? null : readFlags("flow", words),
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
