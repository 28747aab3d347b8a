#!/usr/bin/env node
// The command line: arguments in, one `Session`, JSON and mesh files out.

import { readFileSync, realpathSync } from "node:fs";
import { commands, overview } from "./cli/commands.js";
import { failed, refused } from "./cli/failure.js";
import { execute } from "./cli/run.js";
import { openSession, unknown } from "./cli/solver.js";
import { pending } from "./cli/text.js";

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
 * @param {() => Session | Promise<Session>} open
 * @returns {Promise<number>}  0 done, 2 bad usage, 3 refused input, 4 numerical failure
 */
export async function main(parameters, io, open) {
  try {
    return await dispatch(parameters, io, open);
  } catch (error) {
    const { exit, ...told } = failed(3, error);
    const lines = [`umbilic: ${told.message}`, told.hint, ...pending(told.repairs)];
    if (parameters.includes("--json")) io.write(`${JSON.stringify(told)}\n`);
    else io.log(lines.filter((line) => line !== "").join("\n  "));
    return exit;
  }
}

/** @type {typeof main} */
async function dispatch([name = "", ...parameters], io, open) {
  if (Object.hasOwn(commands, name)) return execute(name, commands[name], { parameters, io, open });
  if (["--help", "-h", "help"].includes(name)) io.write(overview());
  else if (name === "--version") {
    const file = new URL("../package.json", import.meta.url);
    io.write(`umbilic ${JSON.parse(readFileSync(file, "utf8")).version}\n`);
  } else {
    throw name
      ? unknown("usage-command", name, Object.keys(commands))
      : refused("usage-no-command");
  }
  return 0;
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
const started = process.argv[1] && realpathSync(process.argv[1]) === import.meta.filename;
if (started) process.exitCode = await main(process.argv.slice(2), terminal, openSession);
