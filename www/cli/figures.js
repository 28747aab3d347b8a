// @ts-check
// The figures of the papers as `umbilic bench --table figures` prints them.

import { figures } from "../generated/library.js";
import { sayFigure } from "../library.js";
import { say } from "../words.js";
import { Failure, orExit, usage } from "./failure.js";

/** @import { Figure, Finding } from "../library.js" */
/** @typedef {import("./solver.js").Session} Session */

/**
 * The figures of a comma-separated list of ids, all without one.
 * @param {string | undefined} ids
 * @param {boolean} quick  only those that take a few seconds
 * @returns {readonly Figure[]}
 */
export function chosen(ids, quick) {
  const asked = ids?.split(",");
  const stray = asked?.find((id) => !figures.some((figure) => figure.id === id));
  if (stray !== undefined) {
    const known = figures.map(({ id }) => id).join(", ");
    throw usage(`There is no figure \`${stray}\`.`, `There are: ${known}.`);
  }
  return figures.filter(
    (figure) => (asked?.includes(figure.id) ?? true) && (!quick || figure.quick),
  );
}

/** @param {Session} session @param {readonly Figure[]} list */
export function* figureRows(session, list) {
  for (const figure of list) {
    const begun = performance.now();
    const { ok, measured, steps } = outcome(session, figure);
    yield {
      id: figure.id,
      figure: sayFigure(figure),
      expected: sayFigure(figure, "expected"),
      measured,
      verdict: ok ? "✓" : "✗",
      steps,
      milliseconds: Math.round(performance.now() - begun),
    };
  }
}

/** A figure that cannot be run is a cross, and the others go on. */
/** @param {Session} session @param {Figure} figure */
function outcome(session, figure) {
  const run = session.figureRun(figure.id);
  try {
    /** @type {Finding | null} */
    let finding = null;
    while (!finding) finding = orExit(4, () => run.advance());
    return { ok: finding.ok, measured: say(finding.message), steps: run.steps };
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    return { ok: false, measured: `${error.kind}: ${error.message}`, steps: run.steps };
  } finally {
    run.free();
  }
}
