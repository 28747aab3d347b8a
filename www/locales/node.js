// The words of each language, read from the files beside this one: the command line and tests.

import { readdirSync, readFileSync } from "node:fs";

/** @param {string} language */
function read(language) {
  const folder = new URL(`${language}/`, import.meta.url);
  const files = readdirSync(folder).filter((name) => name.endsWith(".ftl"));
  return files.map((name) => readFileSync(new URL(name, folder), "utf8")).join("\n");
}

export const english = read("en");

/** @param {string} language @param {"first" | "rest"} part  all of them are at hand at once */
export const fetchWords = async (language, part) => (part === "first" ? read(language) : "");
