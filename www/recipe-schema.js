// @ts-check
// What the options of a flow in a recipe may be.

import { asText, defaults, readers } from "./options.js";

/** @param {unknown} value @returns {value is Record<string, any>} */
export const isObject = (value) =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** @param {unknown} value */
export const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

/** @param {unknown} value */
export const isCount = (value) => Number.isSafeInteger(value) && Number(value) >= 0;

/** Options that are left to the solver by null, and what they are otherwise. @type {Readonly<Record<string, string>>} */
const optional = {
  ...{ boundary: "string", detail: "number", dt: "number", tau: "number" },
  ...{ tauMax: "number", reducedVolume: "number", rungs: "number" },
};

/**
 * The first option that cannot be.
 * @param {Record<string, any>} flow
 * @returns {{ key: string, wanted: string } | null}
 */
export function flowFault(flow) {
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
