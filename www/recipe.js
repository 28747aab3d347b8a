// @ts-check
// A recipe: how a surface came about, as a file that can be done again. Read strictly,
// carried out on a session, compared with what it promised. Page, worker and command line
// share it; nothing here touches the document.

/** @import { FlowOptions } from "./generated/schema.js" */
/** @import { Arrangement } from "./generated/types.js" */
/** @import { Chapter as RecipeChapter, Leg as RecipeLeg, State, Recipe as Story } from "./generated/types.js" */

import {
  badRecipe,
  check,
  checkEdits,
  checkFlow,
  checkMesh,
  checkPath,
  flowsIn,
  isCount,
  isHash,
  isNumber,
  isObject,
  isPlain,
  stepsIn,
} from "./recipe-schema.js";

import { perform } from "./session.js";

/** @typedef {import("./pkg/solver/solver.js").Session} Session */

/**
 * @typedef {{ sample?: string, shape: string, parameters: Record<string, number> }} SampleMesh
 * @typedef {{ name: string, sha256: string, bytes: number }} FileMesh
 */

/**
 * What is promised: the flow's own readings at the end, and the fingerprint of the positions
 * as single-precision numbers, relative to the mesh's frame.
 * @typedef {object} Result
 * @property {number} energy
 * @property {number} area
 * @property {number | null} volume
 * @property {number} minAngleDegrees
 * @property {number} time
 * @property {string} [positions]
 */

/**
 * @typedef {object} Recipe
 * @property {string} umbilic      the version it was made with
 * @property {SampleMesh | FileMesh} mesh
 * @property {RecipeChapter[]} [edits]  what made another mesh of it, oldest first
 * @property {FlowOptions} flow    all of them, as the flow began
 * @property {Partial<Arrangement>} [arrangement]  where it is not the plain one
 * @property {number} steps
 * @property {RecipeLeg[]} [path]  where it is more than so many steps
 * @property {Result} result
 */

/** Of another version of the solver: the last bits may differ, and a flow carries that on. */
export const TOLERANCE = 1e-6;

/** @param {State} state @returns {Result} */
export const resultOf = ({ energy, area, volume, minAngleDegrees, time }) => ({
  ...{ energy, area, volume, minAngleDegrees, time },
});

/**
 * @param {object} made
 * @param {string} made.version
 * @param {SampleMesh | FileMesh} made.mesh
 * @param {Story} made.story
 * @param {Partial<Arrangement>} made.arrangement
 * @param {State} made.state
 * @param {string} made.positions  fingerprint; empty where there is none
 * @returns {Recipe}
 */
export function makeRecipe({ version, mesh, story, arrangement, state, positions }) {
  if (!story.flow) throw badRecipe("recipe-without-flow");
  return {
    umbilic: version,
    mesh,
    ...(story.edits.length > 0 ? { edits: story.edits } : {}),
    flow: story.flow,
    ...(Object.keys(arrangement).length > 0 ? { arrangement } : {}),
    steps: stepsIn(story.path),
    ...(isPlain(story.path) ? {} : { path: story.path }),
    result: { ...resultOf(state), ...(positions ? { positions } : {}) },
  };
}

/** @param {Pick<Recipe, "steps" | "path">} recipe @returns {RecipeLeg[]} */
export const pathOf = ({ path, steps }) => path ?? (steps > 0 ? [{ steps }] : []);

/**
 * @param {string} text
 * @returns {Recipe}
 * @throws {Refusal}  naming the line or the key
 */
export function readRecipe(text) {
  /** @type {any} */
  let recipe;
  try {
    recipe = JSON.parse(text);
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    const place = /position (\d+)/.exec(message);
    const line = text.slice(0, place ? Number(place[1]) : text.length).split("\n").length;
    throw badRecipe("recipe-not-json", { line });
  }
  check(isObject(recipe) && typeof recipe.umbilic === "string", "umbilic", "version");
  checkMesh(recipe.mesh);
  if (recipe.edits !== undefined) checkEdits(recipe.edits);
  checkFlow(recipe.flow, "flow");
  const { arrangement = {}, steps, path, result } = recipe;
  check(isObject(arrangement), "arrangement", "object");
  check(isCount(steps), "steps", "count");
  if (path !== undefined) {
    checkPath(path);
    check(stepsIn(path) === steps, "path", { id: "must-be-steps", values: { steps } });
  }
  check(isObject(result), "result", "object");
  for (const key of ["energy", "area", "minAngleDegrees", "time"]) {
    check(isNumber(result[key]), `result.${key}`, "number");
  }
  check(result.volume === null || isNumber(result.volume), "result.volume", "number-or-null");
  const { positions } = result;
  check(positions === undefined || isHash(positions), "result.positions", "hash");
  return recipe;
}

/** What of a recipe the solver must check before anything is done. @param {Recipe} recipe */
export const askedBy = ({ flow, edits, path, arrangement = {} }) => ({
  flows: [flow, ...flowsIn({ edits, path })],
  arrangement,
});

/** Whether the recipe begins with a mesh of the author's. @param {Recipe["mesh"]} mesh @returns {mesh is FileMesh} */
export const isOwn = (mesh) => "sha256" in mesh;

/**
 * Loads the mesh and makes of it what the edits made.
 * @param {Session} session
 * @param {Pick<Recipe, "mesh" | "edits">} recipe
 * @param {Uint8Array | null} bytes  of the mesh, where that is a file
 * @param {(share: number) => void} tell
 */
export function prepare(session, { mesh, edits = [] }, bytes, tell) {
  if (!isOwn(mesh)) {
    perform(session, "sample", { name: mesh.shape, parameters: mesh.parameters });
  } else if (bytes) perform(session, "load", { bytes, name: mesh.name });
  else throw badRecipe("recipe-needs-mesh", { name: mesh.name });
  for (const { flow, path, edit } of edits) {
    if (flow) {
      perform(session, "configure", { options: flow });
      walk(session, flow, path, tell);
    }
    if (edit === "adopt") perform(session, "adopt");
    else if ("fill" in edit) perform(session, "fill", { options: edit.fill });
    else if ("flip" in edit) perform(session, "flip", { options: edit.flip });
    else if ("subdivide" in edit) perform(session, "subdivide", { options: edit.subdivide });
    else perform(session, "invert", { centre: edit.invert });
  }
}

/**
 * Takes the steps of a recipe, its flow being configured.
 * @param {Session} session
 * @param {Pick<Recipe, "flow" | "steps" | "path">} recipe
 * @param {(share: number) => void} tell
 */
export const follow = (session, recipe, tell) => walk(session, recipe.flow, pathOf(recipe), tell);

/**
 * @param {Session} session
 * @param {FlowOptions} flow
 * @param {readonly RecipeLeg[]} path
 * @param {(share: number) => void} tell
 */
function walk(session, flow, path, tell) {
  const total = Math.max(stepsIn(path), 1);
  let done = 0;
  for (const leg of path) {
    if (leg === "anew") perform(session, "renew");
    else if ("regularise" in leg) perform(session, "regularise", { options: leg.regularise });
    else if ("flow" in leg) perform(session, "continueWith", { options: leg.flow });
    else {
      if (flow.flow === "flips") {
        // One by one or all at once, they are the same.
        const compare = /** @type {const} */ ("none");
        const arrangement = { compare, subdivide: 0, flipsPerStep: Math.max(leg.steps, 1) };
        perform(session, "arrange", { arrangement });
      }
      advance(session, leg.steps, (taken) => tell((done + taken) / total));
      done += leg.steps;
    }
  }
}

/**
 * @param {Session} session
 * @param {number} steps
 * @param {(taken: number) => void} tell
 */
function advance(session, steps, tell) {
  const first = perform(session, "state").step;
  const goal = first + steps;
  let step = first;
  let isOver = false;
  while (step < goal) {
    const report = perform(session, "step");
    // At an end there is none to take; asked again, a flow goes on with its budget anew.
    if (!report && isOver) {
      const reason = perform(session, "state").message;
      throw badRecipe("recipe-ends-early", { step, goal, reason });
    }
    isOver = !report;
    step = report?.step ?? step;
    tell(step - first);
  }
}

/** @typedef {{ name: string, expected: number | string | null, got: number | string | null, same: boolean }} Compared */

/**
 * @param {Recipe} recipe
 * @param {Result} got
 * @param {string} version  of the solver at hand: the same must give the same bits
 * @returns {{ same: boolean, exact: boolean, readings: Compared[] }}
 */
export function compare({ umbilic, result: expected }, got, version) {
  const exact = umbilic === version;
  /** @param {unknown} a @param {unknown} b */
  const agree = (a, b) => {
    if (exact || typeof a !== "number" || typeof b !== "number") return Object.is(a, b);
    return Math.abs(a - b) <= TOLERANCE * Math.max(Math.abs(a), Math.abs(b), Number.MIN_VALUE);
  };
  const names = /** @type {(keyof Result)[]} */ (Object.keys(resultOf(/** @type {any} */ ({}))));
  // Bits of positions can only agree where all bits must.
  if (exact && expected.positions) names.push("positions");
  const readings = names.map((name) => {
    const [a, b] = [expected[name] ?? null, got[name] ?? null];
    return { name, expected: a, got: b, same: agree(a, b) };
  });
  return { same: readings.every(({ same }) => same), exact, readings };
}
