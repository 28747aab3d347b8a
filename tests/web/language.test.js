// @ts-check
// Every sentence that people see has its German: collected from the sources, looked up in
// www/strings.js. What is missing is printed so that it can be pasted there.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { parseAst } from "vite";
import { translateDocument, visitTexts } from "../../www/document-text.js";
import { chooseLanguage, speak, t, translated } from "../../www/language.js";
import { choices } from "../../www/options.js";
import { createFinder, createTranslator } from "../../www/sentences.js";
import { german } from "../../www/strings.js";
import { say } from "../../www/words.js";
import { parseHtml } from "./support/html.js";

const root = fileURLToPath(new URL("../..", import.meta.url));
/** @param {string} file */
const read = (file) => readFileSync(path.join(root, file), "utf8");
/** @param {string} folder @param {string} extension */
const filesIn = (folder, extension) =>
  readdirSync(path.join(root, folder), { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(extension))
    .map((name) => path.join(folder, name))
    .sort();

/** @typedef {any} Syntax  a node of an ESTree */

/** @param {Syntax} node @param {(node: Syntax, isInFunction: boolean) => void} visit */
function walk(node, visit, isInFunction = false) {
  if (!node || typeof node !== "object") return;
  if (Array.isArray(node)) {
    for (const one of node) walk(one, visit, isInFunction);
    return;
  }
  if (typeof node.type !== "string") return;
  visit(node, isInFunction);
  const inside = isInFunction || /Function/.test(node.type);
  for (const [key, value] of Object.entries(node)) {
    if (key !== "type") walk(value, visit, inside);
  }
}

/** @param {Syntax} node @returns {string | null} the text of a literal, `{}` for each value in it */
function literalOf(node) {
  if (node?.type === "Literal" && typeof node.value === "string") return node.value;
  if (node?.type === "TemplateLiteral") {
    return node.quasis.map((/** @type {Syntax} */ { value }) => value.cooked).join("{}");
  }
  if (node?.type === "BinaryExpression" && node.operator === "+") {
    const [left, right] = [literalOf(node.left), literalOf(node.right)];
    return left === null || right === null ? null : left + right;
  }
  return null;
}

const pageFiles = filesIn("www", ".js").filter(
  (file) => !/^www\/(pkg|cli|tools|locales)\/|^www\/(cli|strings)\.js$/.test(file),
);
const syntax = new Map(pageFiles.map((file) => [file, parseAst(read(file))]));

/** What `t` and its like are given. */
function spoken() {
  /** @type {Set<string>} */
  const found = new Set();
  /** @type {string[]} */
  const wrong = [];
  for (const [file, tree] of syntax) {
    walk(tree, (node, isInFunction) => {
      if (node.type === "CallExpression" && node.callee.name === "t") {
        const text = literalOf(node.arguments[0]);
        if (text === null || node.arguments[0].type === "TemplateLiteral") {
          if (file !== path.join("www", "language.js")) wrong.push(`${file}: t() of no literal`);
        } else {
          found.add(text);
          if (!isInFunction) wrong.push(`${file}: t("${text}") before the language is known`);
        }
      }
      if (node.type === "ObjectExpression") {
        const entries = node.properties.map((/** @type {Syntax} */ p) => [p.key?.name, p.value]);
        const { one, other } = Object.fromEntries(entries);
        const texts = [literalOf(one), literalOf(other)];
        if (texts.every((text) => text !== null)) for (const text of texts) found.add(text ?? "");
      }
    });
  }
  return { found, wrong };
}

/** Tables whose texts are translated where they are shown. */
const tables = [
  ["www/ui/status.js", "stages"],
  ["www/ui/status.js", "symbols"],
  ["www/standing.js", "standings"],
];

function tabled() {
  const found = new Set(
    Object.values(choices)
      .flat()
      .map(({ label }) => label),
  );
  for (const [file, name] of tables) {
    let seen = false;
    walk(syntax.get(file), (node) => {
      if (node.type !== "VariableDeclarator" || node.id.name !== name) return;
      seen = true;
      walk(node.init, (part) => {
        if (part.type === "Property") found.add(literalOf(part.value) ?? "");
      });
    });
    assert.ok(seen, `${file} has no table ${name}`);
  }
  return found;
}

/** Words in the two documents. */
function standing() {
  /** @type {Set<string>} */
  const found = new Set();
  for (const file of ["index.html", "demo.html"]) {
    visitTexts(parseHtml(read(file)), (english) => found.add(english));
  }
  return found;
}

/** What the worker says of itself. */
function working() {
  /** @type {Set<string>} */
  const found = new Set();
  walk(syntax.get(path.join("www", "worker.js")), (node) => {
    if (node.type !== "Property" || !["message", "hint"].includes(node.key.name)) return;
    const text = literalOf(node.value);
    if (text) found.add(text);
  });
  return found;
}

/**
 * Rust files whose strings no user of the page meets: assertions, shapes that only the command
 * line makes with parameters of its own, and what goes into files.
 */
const unseen = [
  /^src\/bin\//,
  /^src\/viewer\/(?!error|drawing)/,
  /^src\/linalg\/(?!error)/,
  /^src\/mesh\/(shape|validate|flip\.)/,
  /^src\/io\/(glb|ply\/write)/,
  /^src\/flow\/spec/,
  /\/tests\.rs$/,
];
/** What is put together of parts that cannot be told apart in the whole: the wholes. */
const wholes = {
  "The patch at {} {}, as {}.": [
    "The patch at {} meets the surface around it with its tangent planes but not its curvature, as {}.",
    "The patch at {} meets the surface around it with a kink, as {}.",
    "The patch at {} stays a membrane, as {}.",
  ],
  "meets the surface around it with its tangent planes but not its curvature": [],
  "meets the surface around it with a kink": [],
  "stays a membrane": [],
};
/** Phrases too short to be found, and sentences that no one reads. */
const phrases = ["curvature", "loop {}", "loops {}", "round", "prolate", "oblate"];
const unread = [
  ...["draw in", "binary STL {}"],
  ...["no enum", "names only", "a value of an option", "mean edge lengths"],
  "each is described at the command of its name",
];
/** Calls whose strings are for developers. */
const DEVELOPERS = /(?:expect|assert\w*!|unreachable!|panic!)\s*\([^"]*$/;

/** Strings of a Rust file outside its tests, comments and assertions. @param {string} source */
function rustStrings(source) {
  const code = source
    .split("#[cfg(test)]")[0]
    .replace(/^\s*\/\/.*$/gm, "")
    .replace(/\/\/[^"\n]*$/gm, "");
  /** @type {string[]} */
  const found = [];
  for (const { 1: text, index } of code.matchAll(/"((?:[^"\\]|\\.)*)"/gs)) {
    if (DEVELOPERS.test(code.slice(Math.max(0, index - 200), index))) continue;
    found.push(text.replace(/\\\n\s*/g, "").replaceAll('\\"', '"'));
  }
  return found;
}

/** Sentences and phrases of the solver, `{}` for each value. */
function solved() {
  /** @type {Set<string>} */
  const found = new Set();
  for (const file of filesIn("src", ".rs")) {
    if (unseen.some((pattern) => pattern.test(file))) continue;
    for (const text of rustStrings(read(file))) {
      if (text.includes("\\n") || text.includes("{:?}") || /^(Umbilic|#) ?[:{]/.test(text))
        continue;
      const sentence = text.replace(/\{[^{}]*\}/g, "{}").trim();
      // A phrase of words, and not a name, a key or a number.
      if (sentence.includes(" ") && /\p{Ll}{2}/u.test(sentence.replaceAll("{}", ""))) {
        found.add(sentence.replaceAll("{}{}", "{}"));
      }
    }
    for (const [, one, many] of read(file).matchAll(
      /counted\(\s*[^"]*?"([^"]+)",\s*"([^"]+)",?\s*\)/g,
    )) {
      found.add(`1 ${one}`).add(`{} ${many}`).delete(one);
      found.delete(many);
    }
  }
  for (const [part, whole] of Object.entries(wholes)) {
    assert.ok(found.delete(part), part);
    for (const sentence of whole) found.add(sentence);
  }
  for (const text of unread) assert.ok(found.delete(text), text);
  for (const text of phrases) found.add(text);
  return found;
}

/**
 * As people meet it: with values in place. A value glued to a word is the ending of its plural,
 * or a clause that may be missing.
 * @param {string} sentence
 */
function instances(sentence) {
  const filled = (/** @type {string} */ ending) =>
    sentence.replace(/(?<=\p{L})\{\}/gu, ending).replaceAll("{}", "7");
  return sentence.includes("{}") ? [...new Set([filled(""), filled("s")])] : [sentence];
}

const find = createFinder(german);
const keyed = new Set([...spoken().found, ...tabled(), ...standing()]);
const matched = new Set([...working(), ...solved()]);

test("every sentence has its German", () => {
  const lacking = [...keyed].filter(
    (text) => /\p{L}{2}/u.test(text) && !Object.hasOwn(german, text),
  );
  for (const text of matched) {
    if (!Object.hasOwn(german, text) && !instances(text).every(find)) lacking.push(text);
  }
  const lines = lacking.map((text) => `  ${JSON.stringify(text)}: "",`);
  assert.deepEqual(lacking, [], `www/strings.js lacks\n${lines.join("\n")}\n`);
});

test("the German keeps every value and every mark", () => {
  const wrong = [];
  for (const [english, text] of Object.entries(german)) {
    const names = (/** @type {string} */ of) => [...of.matchAll(/\{(\w+)\}/g)].map(([, n]) => n);
    const marks = (/** @type {string} */ of) => [...of.matchAll(/<(\w+)>/g)].map(([, n]) => n);
    const places = (english.match(/\{\}/g) ?? []).length;
    const wanted = new Set(
      places > 0 ? Array.from({ length: places }, (_, n) => String(n + 1)) : names(english),
    );
    const given = new Set(names(text));
    const inOrder = (text.match(/\{\}/g) ?? []).length;
    const same =
      inOrder > 0
        ? inOrder === places && given.size === 0
        : [...wanted].every((name) => given.has(name)) && given.size === wanted.size;
    if (!same || marks(english).sort().join() !== marks(text).sort().join()) wrong.push(english);
    if (text.trim() === "") wrong.push(`${english}: empty`);
  }
  assert.deepEqual(wrong, []);
});

test("no German is left of a sentence that is gone", () => {
  const used = new Set(keyed);
  /** With the phrases that stand in it. @param {string} text */
  const mark = (text) => {
    const found = find(text);
    if (!found || used.has(text)) return;
    used.add(found.key);
    for (const value of found.values) mark(value);
  };
  for (const text of matched) {
    if (Object.hasOwn(german, text)) used.add(text);
    else for (const one of instances(text)) mark(one);
  }
  assert.deepEqual(
    Object.keys(german).filter((key) => !used.has(key)),
    [],
  );
});

test("a sentence is asked for when the language is known, and as a literal", () => {
  assert.deepEqual(spoken().wrong, []);
});

test("sentences of the solver are recognised with their values, particular ones first", () => {
  const say = createTranslator({
    "face {} of {}": "Seite {2}/{1}",
    "{} of {}": "{} von {}",
    "Left open: {}.": "Offen: {}.",
    "line {}": "Zeile {}",
  });
  assert.equal(say("face 3 of 12"), "Seite 12/3");
  assert.equal(say("Left open: line 7."), "Offen: Zeile 7.");
  assert.equal(say("something else"), "something else");
  // Not a pattern: what stands between the values is taken as it is.
  assert.equal(createTranslator({ "a.b {} (c)": "{}" })("aXb 1 (c)"), "aXb 1 (c)");
});

test("text with marks in it keeps their elements, in the order of its translation", () => {
  const page = parseHtml(
    '<p>Press <kbd id="">F</kbd> or <em>Space</em>.</p><label><input title="How  it is"> Area</label>',
  );
  /** @type {string[]} */
  const seen = [];
  translateDocument(page, (english) => {
    seen.push(english);
    return (
      { Area: "Fläche", "How it is": "Wie es ist" }[english] ?? "<em>Leer</em> oder <kbd>F</kbd>!"
    );
  });
  assert.deepEqual(seen, ["Press <kbd>F</kbd> or <em>Space</em>.", "How it is", "Area"]);
  const [paragraph, label] = page.childNodes;
  assert.equal(paragraph.textContent, "Leer oder F!");
  assert.deepEqual(
    paragraph.childNodes.map((/** @type {any} */ { nodeName }) => nodeName),
    ["#text", "EM", "#text", "KBD", "#text"],
  );
  assert.equal(label.textContent, " Fläche");
  assert.equal(label.childNodes[0].getAttribute("title"), "Wie es ist");
});

test("the address chooses the language, then what was chosen before, then the browser", () => {
  assert.equal(chooseLanguage("?lang=de", "en", ["en"]), "de");
  assert.equal(chooseLanguage("?lang=DE-at", null, []), "de");
  assert.equal(chooseLanguage("?lang=tlh", "de", ["en"]), "de");
  assert.equal(chooseLanguage("", "en", ["de"]), "en");
  assert.equal(chooseLanguage("", null, ["fr-CH", "de-CH", "en"]), "de");
  assert.equal(chooseLanguage("", null, ["fr"]), "en");
  assert.equal(chooseLanguage("?lang=constructor", null, []), "en");
});

test("one and many, in English and in German", async () => {
  const count = (/** @type {number} */ n) => say("count-steps", { count: n });
  assert.deepEqual([1, 2].map(count), ["1 step", "2 steps"]);
  await speak("de");
  assert.deepEqual([0, 1, 2].map(count), ["0 Schritte", "1 Schritt", "2 Schritte"]);
  assert.equal(say("ended", { status: "stalled", steps: 2 }), "Stecken geblieben nach 2 Schritten");
  assert.equal(t("Paused at step {step}", { step: 12 }), "Angehalten bei Schritt 12");
  assert.equal(
    translated("the file is cut short: 84 bytes needed at byte 12, 7 there"),
    "die Datei bricht ab: 84 Bytes werden ab Byte 12 gebraucht, 7 sind da",
  );
  await speak("en");
  assert.equal(t("Paused at step {step}", { step: 12 }), "Paused at step 12");
});
