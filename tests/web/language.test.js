// @ts-check
// Every label of the page has its German: collected from the sources, looked up in
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

const keyed = new Set([...spoken().found, ...tabled(), ...standing()]);

test("every sentence has its German", () => {
  const lacking = [...keyed].filter(
    (text) => /\p{L}{2}/u.test(text) && !Object.hasOwn(german, text),
  );
  const lines = lacking.map((text) => `  ${JSON.stringify(text)}: "",`);
  assert.deepEqual(lacking, [], `www/strings.js lacks\n${lines.join("\n")}\n`);
});

test("the German keeps every value and every mark", () => {
  const wrong = [];
  const all = (/** @type {RegExp} */ pattern, /** @type {string} */ text) =>
    [...text.matchAll(pattern)].map(([, name]) => name).sort();
  for (const [english, text] of Object.entries(german)) {
    const values = [english, text].map((one) => [...new Set(all(/\{(\w+)\}/g, one))].join());
    const marks = [english, text].map((one) => all(/<(\w+)>/g, one).join());
    if (values[0] !== values[1] || marks[0] !== marks[1]) wrong.push(english);
    if (text.trim() === "") wrong.push(`${english}: empty`);
  }
  assert.deepEqual(wrong, []);
});

test("no German is left of a sentence that is gone", () => {
  assert.deepEqual(
    Object.keys(german).filter((key) => !keyed.has(key)),
    [],
  );
});

test("a sentence is asked for when the language is known, and as a literal", () => {
  assert.deepEqual(spoken().wrong, []);
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
  assert.equal(translated("Edge flips"), "Kantenflips");
  await speak("en");
  assert.equal(t("Paused at step {step}", { step: 12 }), "Paused at step 12");
});
