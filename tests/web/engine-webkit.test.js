// @ts-check
// The page in WebKitGTK, on a system without a language: the browser's is then `C`, which is
// no tag of a language that `Intl` takes.

import assert from "node:assert/strict";
import { journey } from "./support/journey.js";
import { ensureWebkit, launchWebkit } from "./support/webkit.js";

const programs = ensureWebkit();
journey("WebKitGTK", programs ? () => launchWebkit(programs) : null, async (engine) => {
  assert.deepEqual(await engine.evaluate("navigator.languages"), ["C"]);
  assert.equal(await engine.evaluate("document.documentElement.lang"), "en");
});
