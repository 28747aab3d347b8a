// The text of slides and guide in the language of its reader: the English text is the key. A
// sentence with marks in it, as `Press <kbd>F</kbd> twice.`, is one sentence.

import { openLanguage } from "./language.js";

/** Attributes that are read by people. */
const ATTRIBUTES = ["aria-label", "title", "placeholder", "alt"];
/** Not for people, or as it is in every language. */
const SKIPPED = "script, style, math, [translate=no]";

/** @param {() => Promise<{ default: Record<string, string> }>} fetchGerman */
export async function openProse(fetchGerman) {
  await openLanguage();
  if (document.documentElement.lang !== "de") return;
  const german = (await fetchGerman()).default;
  const of = (/** @type {string | null} */ text) =>
    german[(text ?? "").replace(/\s+/g, " ").trim()];
  for (const element of document.querySelectorAll("*")) {
    if (element.closest(SKIPPED)) continue;
    for (const name of ATTRIBUTES) {
      const text = of(element.getAttribute(name));
      if (text) element.setAttribute(name, text);
    }
    const marked = element.childElementCount > 0 && of(element.innerHTML);
    if (marked) element.innerHTML = marked;
    for (const node of element.childNodes) {
      const text = node instanceof Text && of(node.data);
      // The space around a text keeps it apart from its neighbours.
      if (text) node.nodeValue = node.data.replace(/\S(?:.*\S)?/s, () => text);
    }
  }
}
