// @ts-check
// The words of each language in the page: English comes along, any other when it is asked for.

/** @type {Record<string, string>} */
const files = import.meta.glob("./en/*.ftl", { query: "?raw", import: "default", eager: true });

export const english = Object.values(files).join("\n");

/** @param {"en" | "de"} language */
export const fetchWords = async (language) =>
  language === "en" ? english : (await import("./german.js")).german;
