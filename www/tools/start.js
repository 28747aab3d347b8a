// @ts-check
// `npm start`: from a fresh clone to the page in the browser.

import { prerequisites } from "./prerequisites.js";
import { script } from "./process.js";
import { serve } from "./site.js";
import { buildWasm } from "./wasm.js";

await script(() => {
  prerequisites();
  buildWasm();
  serve(process.argv.slice(2));
});
