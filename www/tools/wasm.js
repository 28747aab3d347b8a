// The wasm files, from Rust source to `www/pkg`: cargo, then wasm-bindgen's
// tool, then wasm-opt. Cargo decides what is out of date; what follows it is done
// again only when cargo's output has changed. Two builds: the one that is shipped, optimised
// as a whole and for size, the solver in two files (src/deferred.rs); and the quick one of the
// development server.

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { root, run, runNode, say, targetDir } from "./process.js";

/** A cargo feature, which is also the folder under `www/pkg`. @typedef {"solver" | "viewer" | "viewer-webgl"} Half */
/** As it is shipped, or for the development server. @typedef {"release" | "quick"} Profile */

/**
 * Our own crate's optimisation level, and that of all others, where it is not the release profile's;
 * whether it is shipped in two files.
 * @type {Record<Half, { level: string, rest?: string, splits?: boolean }>}
 */
const halves = {
  solver: { level: "s", splits: true },
  // What takes time in a picture is the browser's; the smallest code will do.
  viewer: { level: "z" },
  // Large with a shader compiler that runs once: for size, dependencies and all.
  "viewer-webgl": { level: "z", rest: "z" },
};
/** What wasm-opt does: what it does not know to be there, it leaves alone. */
const shrink = ["-Oz", "--strip-debug", "--strip-producers"];
/** What every file may use; the one that is split off does not say. */
const features = ["simd", "bulk-memory", "nontrapping-float-to-int", "sign-ext", "mutable-globals"];
/** What the build tools are made of. */
const toolSources = ["Cargo.lock", "src/bin/bindgen.rs", "src/bin/splitter.rs"].map((file) =>
  path.join(root, file),
);
/** Of the wasm files, as the splitter calls the second one. */
const DEFERRED = "split_deferred.wasm";

/** Builds one, if it is missing or out of date. @param {Half} name @param {Profile} profile */
export function buildHalf(name, profile) {
  const { level, rest, splits } = halves[name];
  const isSplit = splits && profile === "release";
  const target = "wasm32-unknown-unknown";
  say(`Compiling the ${name} (Rust to wasm; the first time takes minutes)`);
  // As a cdylib alone: with the rlib beside it cargo would leave out the link-time
  // optimisation that the release profile asks for. In a folder of its own: the two
  // halves have the same file name, and each would make the other out of date.
  const folder = path.join(targetDir, name);
  const parameters = [
    ...["rustc", "--lib", "--crate-type", "cdylib", "--profile", profile, "--locked"],
    ...["--target", target, "--target-dir", folder, "--no-default-features"],
    ...["--features", isSplit ? `${name},split` : name],
    ...["--config", `profile.${profile}.package.umbilic.opt-level="${level}"`],
    ...(rest ? ["--config", `profile.${profile}.opt-level="${rest}"`] : []),
    // The splitter goes by names and relocations.
    ...(isSplit ? ["--config", `profile.${profile}.strip="none"`] : []),
  ];
  const rustFlags = [...flags(), ...(isSplit ? ["-C", "link-arg=--emit-relocs"] : [])];
  run("cargo", parameters, { CARGO_ENCODED_RUSTFLAGS: rustFlags.join("\x1f") });
  const compiled = path.join(folder, target, profile, "umbilic.wasm");

  const out = path.join(root, "www", "pkg", name);
  const wasm = path.join(out, `${name}_bg.wasm`);
  const stampFile = path.join(out, ".stamp");
  const stamp = createHash("sha256")
    .update(readFileSync(compiled))
    .update(toolSources.map((file) => readFileSync(file, "utf8")).join(""))
    .update([...shrink, ...features].join())
    .digest("hex");
  const isBuilt = existsSync(wasm) && existsSync(stampFile);
  if (isBuilt && readFileSync(stampFile, "utf8") === stamp) return;

  const bindgen = tool("bindgen");
  const splitter = isSplit && tool("splitter");
  say(`Packing the ${name} into www/pkg/${name}`);
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const first = isSplit ? path.join(folder, `${name}.wasm`) : compiled;
  const deferred = path.join(out, DEFERRED);
  if (splitter) run(splitter, [compiled, first, deferred]);
  run(bindgen, [first, out, name, "--strip-names"]);
  for (const file of isSplit ? [wasm, deferred] : [wasm]) {
    if (profile === "release") {
      const may = features.map((feature) => `--enable-${feature}`);
      runNode(["node_modules/binaryen/bin/wasm-opt", ...shrink, ...may, file, "-o", file]);
    }
    const bytes = readFileSync(file);
    const [plain, packed] = [bytes, gzipSync(bytes)].map(({ length }) => Math.round(length / 1000));
    console.log(`  ${plain} kB, ${packed} kB gzipped: ${path.basename(file)}`);
  }
  writeFileSync(stampFile, stamp);
}

/**
 * Flags of the shipped build. SIMD as in `.cargo/config.toml`, which these replace; and no
 * folder of this machine in the messages of panics: it is nobody's business, and bytes.
 */
function flags() {
  const cargoHome = process.env.CARGO_HOME ?? path.join(homedir(), ".cargo");
  const remap = (/** @type {string} */ from, /** @type {string} */ to) =>
    `--remap-path-prefix=${from}=${to}`;
  return ["-C", "target-feature=+simd128", remap(cargoHome, "cargo"), remap(root, "umbilic")];
}

/**
 * Path of a build tool, built when it is missing or older than what it is made of.
 * @param {"bindgen" | "splitter"} name
 */
function tool(name) {
  const folder = path.join(targetDir, "tools");
  const suffix = process.platform === "win32" ? ".exe" : "";
  const program = path.join(folder, "tool", `${name}${suffix}`);
  const fresh =
    existsSync(program) &&
    toolSources.every((file) => statSync(file).mtimeMs < statSync(program).mtimeMs);
  if (!fresh) {
    say(`Building the tool ${name}`);
    run("cargo", [
      ...["build", "--bin", name, "--profile", "tool", "--locked", "--target-dir", folder],
      ...["--no-default-features", "--features", name],
    ]);
  }
  return program;
}
