// Messages as sentences. A message is `{ id, values }`; the words of each language stand in
// `locales/<language>/*.ftl`, in the syntax of Fluent (projectfluent.org). The solver, the worker
// and recipes speak in messages, so that a sentence is made once, where it is read.
//
// A value is a number, a text, a truth, another message, which is said in its place, or a list of
// these. Numbers are shown with a decimal point in every language (see language.js), whole
// numbers in full and others to three significant digits, `NUMBER($x, digits: 5)` to five.
// `LIST($all, most: 6)` shows the first six of a list, `COUNT($all)` how many there are. `VERTEX($v)`
// is a vertex, or a list of them, as the file numbers it, `FACE($f)` a face: with a word where the
// file counts from 1, unless `bare`, as another number that says so follows.

import { FluentBundle, FluentNumber, FluentResource, FluentType } from "@fluent/bundle";
import { english, fetchWords } from "#locales";
import { formatShort } from "./number.js";
import { firstNumber, numberOf } from "./numbers.js";

/** @import { Message, Fault as Refusal } from "./generated/types.js" */

/**
 * A refusal as people read it.
 * @typedef {Omit<Refusal, "message" | "hint"> & { message: string, hint: string }} Fault
 */
/** @typedef {null | boolean | number | string | Message | { [n: number]: any, length: number }} Value */

class Numeral extends FluentNumber {
  /** @param {number} value @param {number} [digits] significant, of numbers that are not whole */
  constructor(value, digits) {
    super(value);
    this.digits = digits;
  }

  toString() {
    const isPlain = Number.isSafeInteger(this.value) && this.digits === undefined;
    return isPlain ? String(this.value) : formatShort(this.value, this.digits);
  }
}

/** @extends {FluentType<(string | FluentType<any>)[]>} */
class List extends FluentType {
  /** @param {(string | FluentType<any>)[]} values @param {number} [most] */
  constructor(values, most = values.length) {
    super(values);
    this.most = most;
  }

  /** @param {any} scope */
  toString(scope) {
    const shown = this.value.slice(0, this.most).map((value) => value.toString(scope));
    return [...shown, ...(this.value.length > this.most ? ["…"] : [])].join(", ");
  }
}

/** @param {"vertices" | "faces"} what @returns {(args: any[], named: Record<string, any>) => string} */
const named =
  (what) =>
  ([{ value }], { bare }) => {
    const of = (/** @type {any} */ n) => numberOf(what, Number(n.value ?? n));
    const all = Array.isArray(value) ? value.map(of).join(", ") : `${of(value)}`;
    return bare || !firstNumber()
      ? all
      : `${all} (${say("counted-from", { first: firstNumber() })})`;
  };

/** @type {Record<string, (args: any[], named: Record<string, any>) => any>} */
const functions = {
  VERTEX: named("vertices"),
  FACE: named("faces"),
  // What could not be measured is shown as such.
  NUMBER: ([value], { digits }) =>
    typeof value === "string" ? value : new Numeral(Number(value), digits && Number(digits)),
  LIST: ([list], { most }) => new List(list.value, Number(most)),
  COUNT: ([list]) => new Numeral(list.value.length),
};

/** @param {string} language @param {string} words  @returns {FluentBundle} */
function bundleOf(language, words) {
  // Without marks around values: sentences are copied into files and other programs.
  const bundle = new FluentBundle(language, { functions, useIsolating: false });
  const errors = bundle.addResource(new FluentResource(words));
  if (errors.length > 0) throw errors[0];
  return bundle;
}

/** @type {FluentBundle | null} made for the first message */
let bundle = null;
/** Sentences without values, which views ask for at every change. @type {Map<string, string>} */
const said = new Map();

/** @param {Value} value @returns {string | FluentType<any>} */
function shown(value) {
  if (typeof value === "number") return new Numeral(value);
  if (value === null || typeof value !== "object") return String(value ?? "–");
  if ("id" in value) return say(value);
  return new List(Array.from(value, shown));
}

/**
 * A message in the language of its reader. `name.part` is a further sentence of the message
 * `name`, as `.hint`. A message without words is a mistake, and shown by its id.
 * @param {string | Message} message
 * @param {Readonly<Record<string, any>>} [values]  of a message that is given by its id
 */
export function say(message, values) {
  if (typeof message !== "string") return say(message.id, message.values);
  if (values) return put(message, values);
  const known = said.get(message) ?? put(message, {});
  said.set(message, known);
  return known;
}

/** @param {string} message @param {Readonly<Record<string, any>>} values @returns {string} */
function put(message, values) {
  bundle ??= bundleOf("en", english);
  const [name, part] = message.split(".");
  const words = bundle.getMessage(name);
  const pattern = part === undefined ? words?.value : words?.attributes[part];
  if (!pattern) return message;
  const args = Object.entries(values).map(([key, value]) => [key, shown(value)]);
  // A value that is missing shows as its name.
  return bundle.formatPattern(pattern, Object.fromEntries(args), []);
}

/** A refusal in words. @param {Refusal} refusal @returns {Fault} */
export const sayFault = ({ message, hint, ...rest }) => ({
  ...rest,
  message: say(message),
  hint: hint ? say(hint) : "",
});

/**
 * What went wrong, in words: a refusal, which has a kind, or an error of the page's own. A worker
 * that could not be asked refuses in no language.
 * @param {any} error @returns {Fault}
 */
export function faultOf(error) {
  if (typeof error?.message === "object") return sayFault(error);
  if (error?.kind) return error;
  return { kind: "", message: String(error?.message ?? error), hint: "", detail: {} };
}

/**
 * What the page itself refuses, in words.
 * @param {string} kind @param {string} id  of the words @param {Record<string, unknown>} [values]
 * @param {string} [hint]  id of its words; empty for none @returns {Fault}
 */
export const fault = (kind, id, values, hint = `${id}.hint`) => ({
  kind,
  message: say(id, values),
  hint: hint && say(hint, values),
  detail: {},
});

/** Words that are read only once there is a solver. @type {Promise<string> | null} */
let rest = null;
let speaking = /** @type {"en" | "de"} */ ("en");
export const currentLanguage = () => speaking;

/** Says what follows in another language. @param {"en" | "de"} language */
export async function speak(language) {
  const words = await fetchWords(language, "first");
  const more = rest ? await fetchWords(language, "rest") : "";
  speaking = language;
  bundle = bundleOf(language, `${words}\n${more}`);
  said.clear();
}

/** All other words of the language, once. */
export async function fetchRest() {
  if (rest) return rest;
  const language = speaking;
  rest = fetchWords(language, "rest").catch((error) => {
    rest = null;
    throw error;
  });
  bundle ??= bundleOf("en", english);
  const words = await rest;
  // The language may have been changed meanwhile, with all its words.
  if (language === speaking) bundle.addResource(new FluentResource(words));
  said.clear();
  return rest;
}
