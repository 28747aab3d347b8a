// `npm run build`: both wasm halves and the static site in `dist`.

import { prerequisites } from "./prerequisites.js";
import { script } from "./process.js";
import { buildSite } from "./site.js";
import { buildWasm } from "./wasm.js";

await script(() => {
  prerequisites();
  buildWasm();
  buildSite();
});
