// @ts-check
// German in one file of its own, for the page.

/** @type {Record<string, string>} */
const files = import.meta.glob("./de/*.ftl", { query: "?raw", import: "default", eager: true });

export const german = Object.values(files).join("\n");
