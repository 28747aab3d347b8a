// @ts-check
// The page's own labels, in the language of its reader. The English sentence is the key of its
// translation. What the solver, the worker and recipes say comes in messages (see words.js).
//
// Numbers keep the decimal point in every language: they are copied into other programs, and
// stand beside the same numbers in files, tables and papers.

import { speakWords } from "./words.js";

/** Languages on offer, each by its own name. */
export const languages = /** @type {const} */ ({ en: "English", de: "Deutsch" });

/** @typedef {keyof typeof languages} Language */

const KEY = "umbilic-language";

/** @type {Language} */
let language = "en";
/** By the English sentence. @type {Readonly<Record<string, string>>} */
let german = {};

/** The language that the page is in. */
export const currentLanguage = () => language;

/** @typedef {Readonly<Record<string, string | number>>} Values  formatted before, where they are numbers */

/** @param {string} sentence  with `{name}` where a value stands @param {Values} values */
const filled = (sentence, values) =>
  sentence.replace(/\{(\w+)\}/g, (whole, name) =>
    Object.hasOwn(values, name) ? String(values[name]) : whole,
  );

/**
 * A sentence with its values in place.
 * @param {string} english  a literal
 * @param {Values} [values]
 */
export const t = (english, values = {}) => filled(translated(english), values);

/** A sentence that comes as data, from a table of labels. @param {string} english */
export const translated = (english) => (Object.hasOwn(german, english) ? german[english] : english);

/** @param {string | null | undefined} tag  as `de-CH` @returns {Language | null} */
function known(tag) {
  const name = (tag ?? "").toLowerCase().split("-")[0];
  return Object.hasOwn(languages, name) ? /** @type {Language} */ (name) : null;
}

/**
 * The language asked for in the address, or chosen before, or else the first that the browser
 * is set to and that is on offer.
 * @param {string} search
 * @param {string | null} stored
 * @param {readonly string[]} preferred
 * @returns {Language}
 */
export function chooseLanguage(search, stored, preferred) {
  const asked = known(new URLSearchParams(search).get("lang"));
  return asked ?? known(stored) ?? preferred.map(known).find(Boolean) ?? "en";
}

/** Storage may be forbidden. @returns {string | null} */
function remembered() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

/** @param {Language} wanted @returns {boolean} whether it is kept */
export function rememberLanguage(wanted) {
  try {
    localStorage.setItem(KEY, wanted);
    return true;
  } catch {
    return false;
  }
}

/**
 * Speaks another language from now on, in sentences that are made from now on.
 * @param {Language} wanted
 */
export async function speak(wanted) {
  language = wanted;
  await speakWords(wanted);
  german = wanted === "de" ? (await import("./strings.js")).german : {};
}

/** The page in the language of its reader. To be done before any part of it is built. */
export async function openLanguage() {
  const wanted = chooseLanguage(location.search, remembered(), navigator.languages);
  if (wanted === "en") return;
  try {
    await speak(wanted);
    const { translateDocument } = await import("./document-text.js");
    translateDocument(document.documentElement, translated);
    document.documentElement.lang = wanted;
    document.documentElement.dir = "ltr";
  } catch (error) {
    // Better in English than not at all.
    await speak("en");
    console.error(error);
  }
}
