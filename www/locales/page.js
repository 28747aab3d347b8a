// The words of each language in the page. English comes along as far as it is read before there
// is a solver; all others are fetched.

import english from "./en/first.js";

/** @type {Record<string, any>}  a way to fetch each */
const fetched = import.meta.glob(["./*/{first,rest}.js", "!./en/first.js"], { import: "default" });

export { english };

/**
 * @param {"en" | "de"} language
 * @param {"first" | "rest"} part  what is read before there is a solver, or all else
 */
export const fetchWords = async (language, part) =>
  (await fetched[`./${language}/${part}.js`]?.()) ?? english;
