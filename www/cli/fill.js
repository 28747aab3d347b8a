// @ts-check
// `umbilic fill`: closes holes or connects boundary loops, and fairs what is new.

import { rowOf } from "../options.js";
import { perform } from "../session.js";
import { isBreakdown } from "../standing.js";
import { say } from "../words.js";
import { orExit, usage } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeOutput } from "./files.js";
import { budgetFlags, budgetOf, readFlags, runSteps } from "./flow.js";
import { number, parse } from "./options.js";
import { format, inWords } from "./text.js";

/** @typedef {import("../generated/types.js").FillOutcome} Filled */
/** @typedef {import("../generated/types.js").Info} Info */
/** @typedef {import("../generated/types.js").Message} Message */
/**
 * What `umbilic fill --fair` tells of the flow: it has come to rest only if `status` is
 * `converged`.
 * @typedef {object} Fairing
 * @property {string} flow
 * @property {import("../generated/types.js").Status} status
 * @property {string} message
 * @property {string | null} messageId
 * @property {number} steps
 * @property {import("../generated/types.js").CurvatureJump | null} curvatureJump  across the rims of the patches
 */
/** @typedef {import("../generated/types.js").StepReport} StepReport */
/** @typedef {import("./options.js").Values} Values */

/** Flows that can hold what is around a patch. */
const fairings = ["none", ...rowOf("free").flows];

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "closes holes, or connects boundary loops, and fairs the patches",
  operands: ["MESH"],
  options: {
    loops: { value: "all|0,2", help: "which boundary loops, counted from 0 (default all)" },
    connect: { help: "connects these loops by one patch instead of closing each" },
    fair: {
      value: "FLOW",
      choices: fairings,
      help: "a flow that moves the new vertices afterwards (default none)",
    },
    ...budgetFlags,
    "max-vertices": { value: "N", help: "at most so many new vertices (default 200000)" },
    out: { value: "FILE", help: "the filled mesh: .obj, .off, .ply, .stl or .glb" },
  },
};

/** @type {import("./commands.js").Command} */
export const fill = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const maxVertices = number(values, "max-vertices", { low: 0, integer: true });
    const options = {
      loops: loops(values),
      connect: values.connect === true,
      ...(maxVertices !== undefined && { maxVertices }),
    };
    const flow = values.fair ?? "none";
    const limit = Object.keys(budgetFlags).find((name) => values[name] !== undefined);
    if (limit && flow === "none") throw usage(`--${limit} needs --fair FLOW.`);
    const asked = { flow, boundary: "fixed", ...budgetOf(values) };
    const chosen = flow === "none" ? null : await readFlags(asked);
    checkOutputs([values.out]);
    const outFormat = values.out && formatOf(values.out);
    const { bytes, name } = readMesh(operands[0], io);
    const session = await open();
    orExit(3, () => perform(session, "load", { bytes, name }));

    /** @type {Filled} */
    const { firstVertex, ...filled } = orExit(3, () => perform(session, "fill", { options }));
    const { verticesAdded } = filled;
    /** @type {Fairing | undefined} */
    let fairing;
    if (chosen && verticesAdded === 0) {
      filled.warnings.push({ id: "fair-nothing", values: { flow } });
    } else if (chosen) {
      const { warnings, ...rest } = fair(session, chosen, firstVertex, verticesAdded, io);
      filled.warnings.push(...warnings);
      fairing = rest;
    }
    /** @type {Info} */
    const card = perform(session, "info");
    const info = inWords(card);
    const said = inWords(filled);

    if (values.out) writeOutput(values.out, perform(session, "export", { format: outFormat }));
    const report = { ...said, ...(fairing && { fair: fairing }), info };
    if (values.json) io.write(`${JSON.stringify(report)}\n`);
    else io.write(summary(said, fairing, info));
    return fairing && isBreakdown(fairing.status) ? 4 : 0;
  },
};

/**
 * The loops asked for.
 * @param {Values} values
 * @returns {"all" | number[]}
 */
function loops(values) {
  const text = values.loops ?? "all";
  if (text === "all") return text;
  const parts = text.split(",");
  if (parts.every((/** @type {string} */ part) => /^\d+$/.test(part.trim()))) {
    return parts.map(Number);
  }
  throw usage(`--loops is \`${text}\`, not all, or numbers like 0,2.`);
}

/**
 * Runs a flow on the new vertices, everything else held.
 * @param {import("./solver.js").Session} session
 * @param {import("../generated/schema.js").FlowOptions} options
 * @param {number} first
 * @param {number} count
 * @param {import("./terminal.js").Terminal} io
 * @returns {Fairing & { warnings: Message[] }}
 */
function fair(session, options, first, count, io) {
  const free = Array.from({ length: count }, (_, i) => first + i);
  orExit(3, () => perform(session, "configure", { options: { ...options, free } }));
  const { status, message, messageId, steps } = runSteps(session, ({ step, energy }) =>
    io.log(`step ${step}  energy ${energy}`),
  );
  const curvatureJump = perform(session, "curvatureJump");
  const warnings = told(steps);
  // The best patch there is, but not the one that was meant.
  const reason = perform(session, "state").message;
  if (status === "stalled") warnings.push({ id: "fair-not-at-rest", values: { reason } });
  const flow = String(options.flow);
  return { flow, status, message, messageId, steps: steps.length, curvatureJump, warnings };
}

/**
 * What the steps warned of, each once; folds as a count of steps.
 * @param {StepReport[]} steps
 */
function told(steps) {
  const folding = steps.filter(({ flippedFaces }) => flippedFaces > 0).length;
  const all = steps.flatMap(({ warnings }) => warnings);
  const others = new Map(
    all.filter(({ id }) => id !== "warning-folded-faces").map((warning) => [say(warning), warning]),
  );
  const values = { folding, steps: steps.length };
  return [...others.values(), ...(folding > 0 ? [{ id: "fair-folds", values }] : [])];
}

/**
 * @param {Omit<Filled, "firstVertex">} filled
 * @param {Fairing | undefined} fairing
 * @param {Info} info
 */
function summary({ loops, verticesAdded, facesAdded, warnings }, fairing, info) {
  const lines = [
    `${loops.length} boundary loops: ${verticesAdded} new vertices, ${facesAdded} new faces`,
    ...(fairing ? fairingLines(fairing) : []),
    `${info.boundaryLoops} boundary loops left`,
    ...warnings.map((warning) => `warning: ${warning}`),
  ];
  return `${lines.join("\n")}\n`;
}

/** @param {Fairing} fairing */
function fairingLines({ flow, message, curvatureJump }) {
  return [
    `${flow}: ${message}`,
    ...(curvatureJump ? [`jump of H across the rims: ${format(curvatureJump.relative)}`] : []),
  ];
}
