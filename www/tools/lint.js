// `npm run lint`: format, lints and types, nothing run.

import { formatChecks, rustChecks, typeCheck } from "./checks.js";
import { prerequisites } from "./prerequisites.js";
import { say, script } from "./process.js";

await script(() => {
  prerequisites();
  for (const check of [...formatChecks, ...rustChecks, typeCheck]) {
    say(check.title);
    check.run();
  }
});
