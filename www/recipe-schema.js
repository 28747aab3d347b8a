// @ts-check
// What a recipe, or a part of one in a link, may be.

/** @import { RecipeLeg } from "./protocol.js" */

import { asText, defaults, readers } from "./options.js";

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** @param {unknown} value */
export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

/** @param {unknown} value */
export const isCount = (value) => Number.isSafeInteger(value) && Number(value) >= 0;

/** Options that are left to the solver, or are no limit, by null, and what they are otherwise. @type {Readonly<Record<string, string>>} */
const optional = {
  ...{ boundary: "string", detail: "number", dt: "number", tau: "number" },
  ...{ tauMax: "number", reducedVolume: "number", rungs: "number" },
  ...{ maxSteps: "number", maxSeconds: "number" },
};

/**
 * The first option that cannot be.
 * @param {Record<string, any>} flow
 * @returns {{ key: string, wanted: string } | null}
 */
function flowFault(flow) {
  for (const [key, value] of Object.entries(flow)) {
    if (!Object.hasOwn(defaults, key)) return { key, wanted: "left out: there is no such option" };
    if (key === "free" || key === "fixed") {
      const fits = value === null || (Array.isArray(value) && value.every(isCount));
      if (!fits) return { key, wanted: "null or a list of vertex numbers" };
    } else if (value !== null || !Object.hasOwn(optional, key)) {
      const usual = /** @type {Record<string, unknown>} */ (defaults)[key];
      const type = optional[key] ?? typeof usual;
      const fits = typeof value === type && readers[key](asText(value)) !== undefined;
      if (!fits) {
        return { key, wanted: `another value: ${JSON.stringify(value)} is not one of this option` };
      }
    }
  }
  return null;
}

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
export function checkFlow(flow, key) {
  check(isObject(flow), key, "an object of options");
  const fault = flowFault(flow);
  if (fault) check(false, `${key}.${fault.key}`, fault.wanted);
}

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

/** Steps of a path. @param {readonly RecipeLeg[]} path */
export const stepsIn = (path) =>
  path.reduce((sum, leg) => sum + (typeof leg === "object" && "steps" in leg ? leg.steps : 0), 0);

/** Whether a path is so many steps and nothing else. @param {readonly RecipeLeg[]} path */
export const isPlain = (path) =>
  path.every((leg) => typeof leg === "object" && "steps" in leg && leg.steps > 0);
