// `npm run format`: writes the one format of the Rust and JavaScript source.

import { nodePackages } from "./prerequisites.js";
import { run, runNode, script } from "./process.js";

await script(() => {
  nodePackages();
  run("cargo", ["fmt"]);
  runNode(["node_modules/@biomejs/biome/bin/biome", "check", "--write"]);
});
