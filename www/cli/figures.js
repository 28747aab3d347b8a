// @ts-check
// Runs the figures of the papers, as `umbilic bench --table figures` prints them.

import { figures } from "../figures.js";
import { plainArrangement } from "../options.js";
import { samples } from "../samples.js";
import { isOver } from "../standing.js";
import { Failure, orExit, usage } from "./failure.js";

/** @import { Figure, Run } from "../figures.js" */
/** @import { BoundaryLoop, Pane, State } from "../protocol.js" */
/** @typedef {import("./solver.js").Session} Session */

/** Steps in which a figure comes to rest, or not: what is measured must not depend on the time. */
const REST = 400;

/**
 * The figures of a comma-separated list of ids, all without one.
 * @param {string | undefined} ids
 * @param {boolean} quick  only those that take a few seconds
 * @returns {readonly Figure[]}
 */
export function chosen(ids, quick) {
  const wanted = ids?.split(",");
  const stray = wanted?.find((id) => !figures.some((figure) => figure.id === id));
  if (stray !== undefined) {
    const known = figures.map(({ id }) => id).join(", ");
    throw usage(`There is no figure \`${stray}\`.`, `There are: ${known}.`);
  }
  return figures.filter(
    (figure) => (wanted?.includes(figure.id) ?? true) && (!quick || figure.quick),
  );
}

/**
 * Runs a figure, the coarser meshes of it first.
 * @param {Session} session
 * @param {Figure} figure
 * @returns {Run}
 */
export function runFigure(session, figure) {
  const { reference } = figure;
  const undamaged = reference
    ? orExit(3, () => session.sample(reference.shape, reference.parameters))
    : null;
  const refined = (figure.refine ?? []).map((parameters) => {
    prepare(session, figure, parameters);
    take(session, figure.steps);
    return state(session);
  });

  prepare(session, figure, {});
  const first = state(session);
  const start = session.positions();
  const steps = take(session, figure.steps);
  const regularised = figure.regularise
    ? orExit(4, () => session.regularise(figure.regularise))
    : null;
  const last = state(session);
  /** @type {Pane[]} */
  const panes = session.panes(figure.colour ?? "none");
  return {
    ...{ first, last, steps, start, panes, regularised, refined },
    info: session.info(),
    jump: session.curvatureJump(),
    jumps: Object.fromEntries(
      panes.flatMap(({ name, standing }) =>
        standing?.jump ? [[name, standing.jump.relative]] : [],
      ),
    ),
    positions: session.positions(),
    reference: undamaged,
  };
}

/**
 * @param {Session} session
 * @param {Figure} figure
 * @param {Record<string, number>} parameters  over those of the sample
 */
function prepare(session, figure, parameters) {
  const sample = samples.find(({ id }) => id === figure.sample);
  if (!sample) throw new Failure(3, "NoSuchSample", `There is no sample ${figure.sample}.`, "");
  const { shape, fill } = sample;
  orExit(3, () => session.sample(shape, { ...sample.parameters, ...parameters }));
  if (fill) {
    const options = fill === "inner" ? { loops: innerLoops(session) } : fill;
    orExit(3, () => session.fill(options, undefined));
  }
  orExit(3, () => session.arrange({ ...plainArrangement, ...figure.arrangement }));
  const maxSteps = figure.steps === "rest" ? REST : Math.max(figure.steps, 1);
  orExit(3, () => session.configure({ ...sample.options, maxSteps, ...figure.options }));
}

/** All boundary loops but the longest. @param {Session} session */
function innerLoops(session) {
  /** @type {BoundaryLoop[]} */
  const loops = session.boundaryLoops();
  const longest = Math.max(...loops.map(({ length }) => length));
  return loops.flatMap(({ length }, n) => (length < longest ? [n] : []));
}

/**
 * @param {Session} session
 * @param {number | "rest"} wanted
 * @returns {number}  steps taken
 */
function take(session, wanted) {
  let taken = 0;
  while ((wanted === "rest" || taken < wanted) && !isOver(state(session).status)) {
    if (orExit(4, () => session.step()) === null) break;
    taken += 1;
  }
  return taken;
}

/** @param {Session} session @returns {State} */
const state = (session) => session.state();

/** @param {Session} session @param {readonly Figure[]} list */
export function* figureRows(session, list) {
  for (const figure of list) {
    const { id, figure: number, expected } = figure;
    const begun = performance.now();
    const { measured, steps } = outcome(session, figure);
    yield {
      ...{ id, figure: number, expected, measured: measured.value },
      verdict: measured.ok ? "✓" : "✗",
      steps,
      milliseconds: Math.round(performance.now() - begun),
    };
  }
}

/** A figure that cannot be run is a cross, and the others go on. */
/** @param {Session} session @param {Figure} figure */
function outcome(session, figure) {
  try {
    const run = runFigure(session, figure);
    return { measured: figure.measure(run), steps: run.steps };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return { measured: { value: `${error.kind}: ${error.message}`, ok: false }, steps: 0 };
  }
}
