#!/usr/bin/env node
// The command line: arguments in, one `Session`, JSON and mesh files out.

import { readFileSync, realpathSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { perform } from "./cli/command.js";
import { commands, overview } from "./cli/commands.js";
import { Failure, usage } from "./cli/failure.js";
import { loadSolver, openSession, packageVersion } from "./cli/solver.js";

/** @typedef {import("./cli/solver.js").Session} Session */
/**
 * The streams of the process. Tests put others in their place.
 * @typedef {object} Terminal
 * @property {(text: string) => void} write  results, on standard output
 * @property {(text: string) => void} log    a line about the work, on standard error
 * @property {() => Uint8Array} read         all of standard input
 */

/**
 * Runs one command.
 * @param {string[]} parameters  without the program's name @param {Terminal} io
 * @param {() => Promise<Session>} open
 * @returns {Promise<number>}  0 done, 2 bad usage, 3 refused input, 4 numerical failure
 */
export async function main(parameters, io, open) {
  try {
    return await dispatch(parameters, io, open);
  } catch (error) {
    const { exit, kind, message, hint, repairs } = failureOf(error);
    if (parameters.includes("--json")) {
      const offer = repairs.length > 0 ? { repairs } : {};
      io.write(`${JSON.stringify({ kind, message, hint, ...offer })}\n`);
    } else {
      const would = repairs.map(({ message: change }) => `repair: ${change}`);
      io.log([`umbilic: ${message}`, ...(hint ? [hint] : []), ...would].join("\n  "));
    }
    return exit;
  }
}

/** @type {typeof main} */
async function dispatch([name = "", ...parameters], io, open) {
  if (name === "--version" || name === "--help") {
    io.write(name === "--help" ? overview() : `umbilic ${packageVersion()}\n`);
    return 0;
  }
  if (Object.hasOwn(commands, name)) return perform(name, commands[name], { parameters, io, open });
  const { nearest } = await loadSolver();
  const near = nearest(name, Object.keys(commands));
  const hint = near ? `Did you mean \`${near}\`?` : "umbilic --help lists the commands.";
  throw usage(name ? `There is no command \`${name}\`.` : "A command is missing.", hint);
}

/**
 * What a command ends with. Anything but a refusal in words is a defect of ours and is thrown on,
 * stack and all.
 * @param {unknown} error
 */
function failureOf(error) {
  if (error instanceof Failure) return error;
  if (!(error instanceof WebAssembly.RuntimeError)) throw error;
  const hint = "This is a defect of the solver; the mesh and the options will reproduce it.";
  return new Failure(4, "Crashed", `The solver crashed: ${error.message}.`, hint);
}

/** @type {Terminal} */
const terminal = {
  write: (text) => void process.stdout.write(text),
  log: (text) => void process.stderr.write(`${text}\n`),
  read: () => readFileSync(0),
};

// `umbilic … | head` closes the pipe early, which is no failure.
process.stdout.on("error", (error) => {
  if (/** @type {NodeJS.ErrnoException} */ (error).code !== "EPIPE") throw error;
});

/** Whether this file is the program and not imported; npm starts it through a link. */
const started = process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url);
if (started) process.exitCode = await main(process.argv.slice(2), terminal, openSession);
