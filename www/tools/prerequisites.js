// What must be on the machine before anything is built. Uses nothing but Node
// itself, so that it runs before the first `npm ci`.

import { existsSync, statSync } from "node:fs";
import path from "node:path";
import { ask, Refusal, root, run, say } from "./process.js";

const wasmTarget = "wasm32-unknown-unknown";

/** Makes sure of Node's version, the node packages, Rust and its wasm target. */
export function prerequisites() {
  nodeVersion();
  nodePackages();
  rust();
}

/** Vite, the strictest of the packages, wants 20.19. */
function nodeVersion() {
  const { node } = process.versions;
  if (node.localeCompare("20.19", "en", { numeric: true }) < 0) {
    throw new Refusal(`Node 20.19 or newer is needed; this is ${node}.`);
  }
}

/** Installs the node packages when they are missing or older than the lock file. */
function nodePackages() {
  const installed = path.join(root, "node_modules", ".package-lock.json");
  const lock = path.join(root, "package-lock.json");
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(lock).mtimeMs) return;
  say("Installing the node packages of package-lock.json");
  const npm = process.env.npm_execpath;
  const parameters = ["ci", "--no-audit", "--no-fund"];
  if (npm?.endsWith(".js")) run(process.execPath, [npm, ...parameters]);
  else run("npm", parameters);
}

/** Checks for cargo and adds the wasm target to the toolchain when it is not there. */
function rust() {
  if (ask("cargo", ["--version"]) === null) {
    throw new Refusal("Rust is needed and cargo was not found. Install it from https://rustup.rs.");
  }
  const library = ask("rustc", ["--print", "target-libdir", "--target", wasmTarget]);
  if (library !== null && existsSync(library)) return;
  say(`Adding the Rust target ${wasmTarget}`);
  run("rustup", ["target", "add", wasmTarget]);
}
