// @ts-check
// Messages as sentences: the words of every language are complete, of one kind, and are put
// together as they should be.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { after, test } from "node:test";
import { FluentResource } from "@fluent/bundle";
import { parseAst } from "vite";
import { languages, speak } from "../../www/language.js";
import { numberAs, vertexOf } from "../../www/numbers.js";
import { say } from "../../www/words.js";

after(() => speak("en"));

/** The entries of a language as Fluent reads them. @param {string} language @param {string} [only] */
function wordsOf(language, only) {
  const folder = new URL(`../../www/locales/${language}/`, import.meta.url);
  /** @type {Map<string, { variables: string[], text: string }>} */
  const found = new Map();
  for (const file of only ? [only] : readdirSync(folder)) {
    const source = readFileSync(new URL(file, folder), "utf8");
    const { body } = new FluentResource(source);
    // Fluent leaves out what it cannot read, without a word.
    const written = [...source.matchAll(/^(-?[a-zA-Z][\w-]*) =/gm)].map(([, id]) => id);
    assert.deepEqual(
      body.map(({ id }) => id),
      written,
      `${language}/${file}`,
    );
    for (const { id, value, attributes } of body) {
      for (const [part, pattern] of Object.entries({ "": value, ...attributes })) {
        if (pattern === null) continue;
        const name = part ? `${id}.${part}` : id;
        assert.ok(!found.has(name), `${language} says ${name} twice`);
        const text = JSON.stringify(pattern);
        const variables = [...text.matchAll(/"type":"var","name":"(\w+)"/g)].map(([, n]) => n);
        found.set(name, { variables: [...new Set(variables)].sort(), text });
      }
    }
  }
  return found;
}

test("every language has words for the same messages, with the same values", () => {
  const english = wordsOf("en");
  assert.ok(english.size > 0);
  for (const language of Object.keys(languages)) {
    const words = wordsOf(language);
    assert.deepEqual([...words.keys()].sort(), [...english.keys()].sort(), language);
    for (const [id, { variables }] of words)
      assert.deepEqual(variables, english.get(id)?.variables, `${language} ${id}`);
  }
});

/** What the page, the worker and the command line say by its id. */
function saidHere() {
  /** @type {Set<string>} */
  const found = new Set();
  const www = new URL("../../www/", import.meta.url);
  const names = readdirSync(www, { recursive: true, encoding: "utf8" });
  /** @param {any} node */
  const literal = (node) => (node?.type === "Literal" ? String(node.value) : null);
  /** @param {any} node */
  function walk(node) {
    if (Array.isArray(node)) return node.forEach(walk);
    if (typeof node?.type !== "string") return;
    if (node.type === "CallExpression") {
      const { name } = node.callee;
      const [first, second, , hint = `${second}.hint`] = node.arguments.map(literal);
      if (["say", "refused", "unknown"].includes(name) && first) found.add(first);
      if (name === "refusal" && second) found.add(second).add(`${second}.hint`);
      if (name === "fault" && second) found.add(second).add(hint || second);
    }
    if (node.type === "ObjectExpression") {
      const keys = node.properties.map((/** @type {any} */ { key }) => key?.name);
      const [id] = node.properties.map((/** @type {any} */ { value }) => literal(value));
      if (id && ["id", "id,values"].includes(keys.join())) found.add(id);
    }
    for (const value of Object.values(node)) if (value && typeof value === "object") walk(value);
  }
  for (const name of names.filter((one) => /^(?!pkg|tools).*\.js$/.test(one))) {
    walk(parseAst(readFileSync(new URL(name, www), "utf8")));
  }
  return found;
}

test("what the page says has words, and no words of its own are left over", () => {
  const [said, words] = [saidHere(), wordsOf("en")];
  assert.ok(said.size > 25, String(said.size));
  assert.deepEqual(
    [...said].filter((id) => !words.has(id)),
    [],
  );
  const own = [...wordsOf("en", "page.ftl").keys()];
  assert.deepEqual(
    own.filter((id) => !said.has(id)),
    [],
  );
});

test("every message can be said, with any values of their kind", async () => {
  const lists = new Set(["faces", "vertices", "loops", "known"]);
  for (const language of Object.keys(languages)) {
    await speak(/** @type {"en" | "de"} */ (language));
    for (const [id, { variables, text }] of wordsOf(language)) {
      const values = Object.fromEntries(
        variables.map((name) => {
          const isList = lists.has(name) && /"name":"(COUNT|LIST)"/.test(text);
          return [name, isList ? [3, 4] : 2];
        }),
      );
      assert.doesNotMatch(say(id, values), /\{[$A-Z-]|^$|undefined|NaN/, `${language} ${id}`);
    }
  }
});

test("numbers have a decimal point and no grouping in every language", async () => {
  const values = {
    passes: 12345,
    angle: 12.3456,
    angleNow: 1e-7,
    distortion: 0,
    distance: 250000.5,
  };
  for (const [language, start] of /** @type {const} */ ([
    ["en", "Regularised in 12345 passes: smallest angle 12.3° → 1e-7°, distortion 0 → "],
    ["de", "In 12345 Durchgängen regularisiert: kleinster Winkel 12.3° → 1e-7°, Verzerrung 0 → "],
  ])) {
    await speak(language);
    const text = say("regularised", { ...values, distortionNow: 0.5 });
    assert.ok(text.startsWith(`${start}0.5; `), text);
    assert.ok(text.includes(" 250000 % "), text);
  }
});

test("a message in a message is said in its place, a list with commas", async () => {
  await speak("en");
  const count = { id: "count-steps", values: { count: 1 } };
  assert.equal(say({ id: "filled", values: { count, vertices: 2 } }).slice(0, 13), "Filled 1 step");
  const list = say("filled", { count: [1, "b", count], vertices: 2 });
  assert.equal(list.slice(0, 20), "Filled 1, b, 1 step ");
  // No marks around values: sentences are copied into files.
  assert.doesNotMatch(list, /[\u2066-\u2069]/);
});

test("what could not be measured is shown as such, however many digits it would have", async () => {
  await speak("en");
  const status = { id: "measured-converged" };
  const values = { off: 0.01234, jump: null, steps: 3, status };
  assert.equal(say("measured-tube", values), "off 0.012, jump – in 3 steps, converged");
});

test("a message without words shows its id, and a value that is missing its name", async () => {
  await speak("de");
  assert.equal(say({ id: "no-such-message", values: { count: 1 } }), "no-such-message");
  assert.equal(say("no-such-message.hint"), "no-such-message.hint");
  assert.match(say("count-flips"), /\{\$?count\}/);
});

test("vertices and faces are named as the file numbers them", async () => {
  await speak("en");
  const flat = { id: "notice-flat-triangles", values: { count: 1, face: 2, vertices: [0, 1, 3] } };
  assert.match(say(flat), /face 2 at vertices 0, 1, 3:/);
  numberAs({ first: 1, vertices: Uint32Array.of(1, 2, 3, 5), faces: null });
  assert.match(say(flat), /face 3 at vertices 2, 3, 6 \(counted from 1\):/);
  assert.match(say("flow-unfit", { vertex: 3 }), /vertex 6 \(counted from 1\)/);
  assert.deepEqual([vertexOf(6), vertexOf(1)], [3, -1]);
  numberAs(undefined);
  assert.equal(say("flow-unfit", { vertex: 3 }), "the surface cannot be fitted at vertex 3");
});
