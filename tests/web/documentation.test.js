// @ts-check
// What the source says in formulas can be set, and what it cites is listed, each once.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import temml from "temml";
import * as schema from "../../www/generated/schema.js";

const src = path.join(import.meta.dirname, "../../src");
const files = readdirSync(src, { recursive: true, encoding: "utf8" })
  .filter((name) => name.endsWith(".rs"))
  .map((name) => ({ name, text: readFileSync(path.join(src, name), "utf8") }));

/** @param {string} formula */
const set = (formula) =>
  temml.renderToString(formula, { displayMode: true, throwOnError: true, strict: true });

test("the formulas of the documentation can be set", () => {
  let count = 0;
  for (const { name, text } of files) {
    for (const [, block] of text.matchAll(
      /^ *\/\/[/!] ```math\n((?: *\/\/[/!].*\n)+?) *\/\/[/!] ```$/gm,
    )) {
      assert.doesNotThrow(() => set(block.replaceAll(/^ *\/\/[/!]/gm, "")), name);
      count += 1;
    }
  }
  assert.ok(count > 15, `${count} formulas`);
  for (const { id, formula } of Object.values(schema.flows)) {
    assert.doesNotThrow(() => set(formula), id);
  }
});

test("what is cited is in the bibliography, and what is there is cited", () => {
  const listed = new Set();
  const cited = new Set();
  for (const { name, text } of files) {
    if (name === "bibliography.rs") {
      for (const [, key] of text.matchAll(/^\/\/! ## (\w+)$/gm)) listed.add(key);
    }
    for (const [, key, place] of text.matchAll(/\[(\w+)\]\((?:crate::)?bibliography#(\w+)\)/g)) {
      assert.equal(place, key.toLowerCase(), name);
      cited.add(key);
    }
  }
  assert.deepEqual([...cited].sort(), [...listed].sort());
});
