// @ts-check
// Which language the page speaks, and what its views say by their labels.

import assert from "node:assert/strict";
import { after, test } from "node:test";
import { commands, keyName } from "../../www/commands.js";
import { figures, samples } from "../../www/generated/library.js";
import { arrangement, flows, options } from "../../www/generated/schema.js";
import { chooseLanguage, languages, speak } from "../../www/language.js";
import { shelves } from "../../www/library.js";
import { choicesOf, colours, formats, named } from "../../www/options.js";
import { say } from "../../www/words.js";

after(() => speak("en"));

test("the address chooses the language, then an earlier choice, then the browser", () => {
  assert.equal(chooseLanguage("?lang=de", "en", ["en"]), "de");
  assert.equal(chooseLanguage("", "de", ["en"]), "de");
  assert.equal(chooseLanguage("", null, ["fr-CH", "de-AT", "en"]), "de");
  assert.equal(chooseLanguage("?lang=xx", null, ["C"]), "en", "no language tag at all");
});

test("every label that is made of data has words in every language", async () => {
  const ids = [
    ...commands.map(({ id }) => `command-${id}`),
    ...flows.flatMap(({ id }) => [`flow-${id}`, `flow-${id}.plain`]),
    ...flows
      .filter(({ family }) => family !== "p-willmore")
      .map(({ monitored }) => `symbol-${monitored[0]}`),
    ...[...options, ...arrangement].map(({ name }) => `option-${name}`),
    ...options.filter(({ kind }) => kind !== "vertices").map(({ name }) => `option-${name}-help`),
    ...samples.flatMap(({ id, group }) => [`sample-${id}`, `sample-${id}-shows`, `group-${group}`]),
    ...figures.map(({ paper }) => `paper-${paper}.authors`),
    ...["all", ...shelves].map((id) => `shelf-${id}`),
    ...shelves.map((id) => `shelf-${id}.about`),
    ...["surface", "flow", "measure", "compare", "share"].map((id) => `tab-${id}`),
    ...["paint", "fill", "subdivide", "invert", "pick"].flatMap((id) => [
      `tool-${id}`,
      `mode-${id}`,
    ]),
    ...["flow", "p", "regularise", "scheme", "then"].map((id) => `contrast-${id}`),
    ...["progress", "step", "time"].flatMap((id) => [`axis-${id}`, `lockstep-${id}`]),
    ...["editsTooLong", "editsUnknown", "file", "fileByDigest", "regionTooLong", "pathTooLong"].map(
      (id) => `lack-${id}`,
    ),
  ];
  for (const language of Object.keys(languages)) {
    await speak(/** @type {any} */ (language));
    for (const id of ids) assert.notEqual(say(id), id, `${language} ${id}`);
    const labels = [...named(colours, "colour"), ...named(formats, "save-as")];
    for (const { id, label } of labels) assert.doesNotMatch(label, /^(colour|save-as)-/, id);
    for (const { name, kind } of options) {
      if (kind === "choice")
        for (const { label } of choicesOf(name)) assert.doesNotMatch(label, /^option-/);
    }
    for (const key of commands.flatMap(({ keys }) => keys))
      assert.doesNotMatch(keyName(key), /^key-/);
  }
});

test("no two commands share a key", () => {
  const keys = commands.flatMap((command) => command.keys);
  assert.deepEqual([...new Set(keys)], keys);
});
