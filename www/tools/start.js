// `npm start`: from a fresh clone to the page in the browser. The viewer for browsers without
// WebGPU, which takes as long to compile as all else, follows when one asks for it (`webgl.js`).

import { prerequisites } from "./prerequisites.js";
import { runNode, say, script } from "./process.js";
import { vite } from "./site.js";
import { buildQuickly } from "./wasm.js";

await script(() => {
  prerequisites();
  buildQuickly("solver");
  buildQuickly("viewer");
  say("Serving the page; Ctrl-C ends it");
  runNode([...vite, ...process.argv.slice(2)]);
});
