// @ts-check
// What a recipe, or a part of one in a link, is made of. Its options the solver checks.

/** @import { Chapter as RecipeChapter, Leg as RecipeLeg } from "./generated/types.js" */

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** @param {unknown} value */
export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

/** @param {unknown} value */
export const isCount = (value) => Number.isSafeInteger(value) && Number(value) >= 0;

/** A recipe that cannot be followed, told in the shape of a `Fault`. */
export class BadRecipe extends Error {
  /** @param {string} message @param {string} [hint] */
  constructor(message, hint = "Recipes are made by “Save as: Recipe”.") {
    super(message);
    this.kind = "BadRecipe";
    this.hint = hint;
    this.detail = {};
  }
}

/** @param {boolean} holds @param {string} key @param {string} wanted */
export function check(holds, key, wanted) {
  if (!holds) throw new BadRecipe(`The recipe’s “${key}” must be ${wanted}.`);
}

/** @param {unknown} value */
export const isHash = (value) => typeof value === "string" && /^[0-9a-f]{64}$/.test(value);

/** @param {any} mesh */
export function checkMesh(mesh) {
  check(isObject(mesh), "mesh", "an object");
  if ("shape" in mesh) {
    check(typeof mesh.shape === "string", "mesh.shape", "the name of a shape");
    const fits = isObject(mesh.parameters) && Object.values(mesh.parameters).every(isNumber);
    check(fits, "mesh.parameters", "an object of numbers");
    return;
  }
  check(typeof mesh.name === "string", "mesh.name", "the name of a file");
  check(isHash(mesh.sha256), "mesh.sha256", "a SHA-256, 64 digits from 0 to f");
  check(isCount(mesh.bytes), "mesh.bytes", "a whole number");
}

/** @param {any} flow @param {string} key */
export const checkFlow = (flow, key) => check(isObject(flow), key, "an object of options");

/** @param {any} path @param {string} [key] */
export function checkPath(path, key = "path") {
  check(Array.isArray(path), key, "a list");
  for (const [n, leg] of path.entries()) {
    if (isObject(leg) && isObject(leg.flow) && Object.keys(leg).length === 1) {
      checkFlow(leg.flow, `${key}[${n}].flow`);
      continue;
    }
    const known =
      leg === "anew" ||
      (isObject(leg) && isCount(leg.steps) && Object.keys(leg).length === 1) ||
      (isObject(leg) && isObject(leg.regularise) && Object.keys(leg).length === 1);
    check(known, `${key}[${n}]`, "{ steps }, { regularise }, { flow } or “anew”");
  }
}

/** @param {any} chapter @param {string} key */
function checkChapter(chapter, key) {
  check(isObject(chapter), key, "an object");
  const { flow, path, edit } = chapter;
  if (flow !== null) checkFlow(flow, `${key}.flow`);
  checkPath(path, `${key}.path`);
  const { fill, flip, subdivide, invert } = isObject(edit) ? edit : {};
  const isCentre = Array.isArray(invert) && invert.length === 3 && invert.every(isNumber);
  const known = edit === "adopt" || [fill, flip, subdivide].some(isObject) || isCentre;
  check(
    known,
    `${key}.edit`,
    "“adopt”, { fill }, { flip }, { subdivide } or { invert: [x, y, z] }",
  );
}

/** @param {any} edits */
export function checkEdits(edits) {
  check(Array.isArray(edits), "edits", "a list");
  for (const [n, chapter] of edits.entries()) checkChapter(chapter, `edits[${n}]`);
}

/**
 * The options of all flows in what was done.
 * @param {{ edits?: readonly RecipeChapter[] | null, path?: readonly RecipeLeg[] | null }} done
 * @returns {object[]}
 */
export function flowsIn({ edits, path }) {
  const on = (path ?? []).flatMap((leg) =>
    typeof leg === "object" && "flow" in leg ? leg.flow : [],
  );
  return [
    ...(edits ?? []).flatMap((chapter) => [chapter.flow ?? [], flowsIn(chapter)].flat()),
    ...on,
  ];
}

/** Steps of a path. @param {readonly RecipeLeg[]} path */
export const stepsIn = (path) =>
  path.reduce((sum, leg) => sum + (typeof leg === "object" && "steps" in leg ? leg.steps : 0), 0);

/** Whether a path is so many steps and nothing else. @param {readonly RecipeLeg[]} path */
export const isPlain = (path) =>
  path.every((leg) => typeof leg === "object" && "steps" in leg && leg.steps > 0);
