// @ts-check
// What a recipe, or a part of one in a link, is made of. Its options the solver checks.

/** @import { Message, Chapter as RecipeChapter, Leg as RecipeLeg, Fault as Refusal } from "./generated/types.js" */

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** @param {unknown} value */
export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

/** @param {unknown} value */
export const isCount = (value) => Number.isSafeInteger(value) && Number(value) >= 0;

/**
 * A recipe that cannot be followed.
 * @param {string} id  of what is said
 * @param {Record<string, unknown>} [values]
 * @returns {Refusal}
 */
export const badRecipe = (id, values = {}) => ({
  kind: "BadRecipe",
  message: { id, values },
  hint: { id: `${id}.hint`, values: {} },
  detail: {},
});

/** @param {boolean} holds @param {string} key @param {string | Message} must  what it must be: `must-be-…` */
export function check(holds, key, must) {
  const said = typeof must === "string" ? { id: `must-be-${must}` } : must;
  if (!holds) throw badRecipe("recipe-malformed", { key, must: said });
}

/** @param {unknown} value */
export const isHash = (value) => typeof value === "string" && /^[0-9a-f]{64}$/.test(value);

/** @param {any} mesh */
export function checkMesh(mesh) {
  check(isObject(mesh), "mesh", "object");
  if ("shape" in mesh) {
    check(typeof mesh.shape === "string", "mesh.shape", "shape-name");
    const fits = isObject(mesh.parameters) && Object.values(mesh.parameters).every(isNumber);
    check(fits, "mesh.parameters", "numbers");
    return;
  }
  check(typeof mesh.name === "string", "mesh.name", "file-name");
  check(isHash(mesh.sha256), "mesh.sha256", "hash");
  check(isCount(mesh.bytes), "mesh.bytes", "count");
}

/** @param {any} flow @param {string} key */
export const checkFlow = (flow, key) => check(isObject(flow), key, "options");

/** @param {any} path @param {string} [key] */
export function checkPath(path, key = "path") {
  check(Array.isArray(path), key, "list");
  for (const [n, leg] of path.entries()) {
    if (isObject(leg) && isObject(leg.flow) && Object.keys(leg).length === 1) {
      checkFlow(leg.flow, `${key}[${n}].flow`);
      continue;
    }
    const known =
      leg === "anew" ||
      (isObject(leg) && isCount(leg.steps) && Object.keys(leg).length === 1) ||
      (isObject(leg) && isObject(leg.regularise) && Object.keys(leg).length === 1);
    check(known, `${key}[${n}]`, "path-part");
  }
}

/** @param {any} chapter @param {string} key */
function checkChapter(chapter, key) {
  check(isObject(chapter), key, "object");
  const { flow, path, edit } = chapter;
  if (flow !== null) checkFlow(flow, `${key}.flow`);
  checkPath(path, `${key}.path`);
  const { fill, flip, subdivide, invert } = isObject(edit) ? edit : {};
  const isCentre = Array.isArray(invert) && invert.length === 3 && invert.every(isNumber);
  const known = edit === "adopt" || [fill, flip, subdivide].some(isObject) || isCentre;
  check(known, `${key}.edit`, "edit");
}

/** @param {any} edits */
export function checkEdits(edits) {
  check(Array.isArray(edits), "edits", "list");
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
