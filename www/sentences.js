// @ts-check
// Translations of sentences with values in them. The solver says whole English sentences with its
// numbers in place; here they are recognised by what stands between the values.

/**
 * @typedef {object} Template
 * @property {string} key      the English sentence, `{}` for each value
 * @property {RegExp} pattern
 * @property {number} weight   characters outside the values
 */

/** @param {string} text */
const literal = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");

/** Sentences with values, the most particular first. @param {Readonly<Record<string, string>>} strings @returns {Template[]} */
function templatesOf(strings) {
  return Object.keys(strings)
    .filter((key) => key.includes("{}"))
    .map((key) => {
      const parts = key.split("{}");
      const pattern = new RegExp(`^${parts.map(literal).join("(.*?)")}$`, "s");
      return { key, pattern, weight: parts.join("").length };
    })
    .sort((a, b) => b.weight - a.weight);
}

/**
 * @param {Readonly<Record<string, string>>} strings
 * @returns {(english: string) => { key: string, values: string[] } | null} the entry for a sentence
 */
export function createFinder(strings) {
  /** @type {Template[] | null} made for the first sentence that needs them */
  let templates = null;
  return (english) => {
    if (Object.hasOwn(strings, english)) return { key: english, values: [] };
    templates ??= templatesOf(strings);
    for (const { key, pattern } of templates) {
      const found = pattern.exec(english);
      if (found) return { key, values: found.slice(1) };
    }
    return null;
  };
}

/**
 * A value may be a phrase with an entry of its own: the reason in a sentence that gives one.
 * @param {Readonly<Record<string, string>>} strings  `{}` or, where their order changes, `{1}`,
 *   `{2}`, … for the values
 * @returns {(english: string) => string}
 */
export function createTranslator(strings) {
  const find = createFinder(strings);
  /** @param {string} english @returns {string} */
  return function translate(english) {
    const found = find(english);
    // A clause that is appended brings its space along.
    const clause = english.trim();
    if (!found)
      return clause === english ? english : english.replace(clause, () => translate(clause));
    const { key, values } = found;
    // Names in braces are filled in by whoever asked.
    if (values.length === 0) return strings[key];
    let next = 0;
    return strings[key].replace(/\{(\d*)\}/g, (_, place) => {
      const n = place === "" ? next++ : Number(place) - 1;
      return translate(values[n] ?? "");
    });
  };
}
