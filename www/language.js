// The language of the page: asked for in the address, chosen before, or the browser's.
//
// Numbers keep the decimal point in every language: they are copied into other programs, and
// stand beside the same numbers in files, tables and papers.

import { currentLanguage, speak } from "./words.js";

export { currentLanguage, speak };

/** Languages on offer, each by its own name. */
export const languages = /** @type {const} */ ({ en: "English", de: "Deutsch" });

/** @typedef {keyof typeof languages} Language */

/** @param {string | null | undefined} tag  as `de-CH` @returns {Language | null} */
function known(tag) {
  const name = (tag ?? "").toLowerCase().split("-")[0];
  return Object.hasOwn(languages, name) ? /** @type {Language} */ (name) : null;
}

/**
 * The language asked for in the address, or chosen before, or else the first that the browser
 * is set to and that is on offer.
 * @param {string} search @param {string | null} stored @param {readonly string[]} preferred
 */
export function chooseLanguage(search, stored, preferred) {
  const asked = known(new URLSearchParams(search).get("lang"));
  return asked ?? known(stored) ?? preferred.map(known).find(Boolean) ?? "en";
}

/** What the page remembers from visit to visit; storage may be forbidden. @param {string} key */
export function remembered(key) {
  try {
    return localStorage.getItem(`umbilic-${key}`);
  } catch {
    return null;
  }
}

/** @param {string} key @param {string} value */
export function remember(key, value) {
  try {
    localStorage.setItem(`umbilic-${key}`, value);
  } catch {
    // Then it lasts as long as the page.
  }
}

/** The page in the language of its reader, before any of it is built. */
export async function openLanguage() {
  const wanted = chooseLanguage(location.search, remembered("language"), navigator.languages);
  try {
    await speak(wanted);
  } catch (error) {
    // Better in English than not at all.
    console.error(error);
  }
  document.documentElement.lang = currentLanguage();
}
