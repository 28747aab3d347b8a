#!/usr/bin/env node
// The command line: arguments in, one `Session`, JSON and mesh files out.

import { realpathSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { commands, overview } from "./cli/commands.js";
import { failureOf, usage } from "./cli/failure.js";
import { help } from "./cli/options.js";
import { loadSolver, openSession, packageVersion } from "./cli/solver.js";
import { terminal } from "./cli/terminal.js";

/** @typedef {import("./cli/terminal.js").Terminal} Terminal */
/** @typedef {import("./cli/solver.js").Session} Session */

/**
 * Runs one command.
 * @param {string[]} parameters  without the program's name @param {Terminal} io
 * @param {() => Promise<Session>} open
 * @returns {Promise<number>}  0 done, 2 bad usage, 3 refused input, 4 numerical failure
 */
export async function main(parameters, io, open) {
  const json = parameters.includes("--json");
  try {
    return await dispatch(parameters, io, open);
  } catch (error) {
    const { exit, kind, message, hint, repairs } = failureOf(error);
    const offer = repairs.length > 0 ? { repairs } : {};
    if (json) io.write(`${JSON.stringify({ kind, message, hint, ...offer })}\n`);
    else {
      const would = repairs.map(({ message: change }) => `repair: ${change}`);
      const lines = [...(hint ? [hint] : []), ...would];
      io.log([`umbilic: ${message}`, ...lines].join("\n  "));
    }
    return exit;
  }
}

/**
 * @param {string[]} parameters @param {Terminal} io @param {() => Promise<Session>} open
 * @returns {Promise<number>}
 */
async function dispatch([name = "", ...rest], io, open) {
  if (name === "--version") {
    io.write(`umbilic ${packageVersion()}\n`);
    return 0;
  }
  if (name === "--help") {
    io.write(overview());
    return 0;
  }
  if (!Object.hasOwn(commands, name)) {
    const { nearest } = await loadSolver();
    const near = nearest(name, Object.keys(commands));
    const hint = near ? `Did you mean \`${near}\`?` : "umbilic --help lists the commands.";
    throw usage(name ? `There is no command \`${name}\`.` : "A command is missing.", hint);
  }
  const command = commands[name];
  if (rest.includes("--help")) {
    io.write(help(name, command.syntax));
    return 0;
  }
  return command.run({ parameters: rest, io, open });
}

/** Whether this file is the program and not imported; npm starts it through a link. */
const started = process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url);
if (started) process.exitCode = await main(process.argv.slice(2), terminal, openSession);
