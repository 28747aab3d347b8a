// @ts-check
// Questions to the solver that change nothing; the worker answers them between steps.

/** @param {import("../solver.js").Solver} solver */
export const createQuestions = (solver) => ({
  /** @param {import("../library.js").Figure} figure */
  judge: ({ id }) => solver.judge(id),
  loops: () => solver.loops(),
  selfIntersections: () => solver.selfIntersections(),
  conjecture: () => solver.conjecture(),
  /** @param {number[]} corners */
  quadrilateral: (corners) => solver.quadrilateral(corners),
  /** @param {number} pairs */
  lab: (pairs) => solver.lab(pairs),
});
