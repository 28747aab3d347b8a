// Running other programs, one line of explanation before each.

import { execFile, spawnSync } from "node:child_process";
import path from "node:path";
import { promisify } from "node:util";

/** The repository's folder. */
export const root = path.join(import.meta.dirname, "../../");

/** Where cargo builds; honours cargo's own variable. */
export const targetDir = path.resolve(root, process.env.CARGO_TARGET_DIR ?? "target");

/** A failure to be told to the person at the terminal in words, without a stack. */
export class Refusal extends Error {}

/** Says in one line what happens next. @param {string} text */
export function say(text) {
  console.log(`\x1b[1m• ${text}\x1b[0m`);
}

/**
 * Runs a program with the terminal attached and waits for it.
 * @param {string} program @param {string[]} parameters
 * @param {Record<string, string>} [env]
 * @throws {Refusal} when it cannot be started or ends with anything but 0
 */
export function run(program, parameters, env) {
  const { error, status, signal } = spawnSync(program, parameters, {
    cwd: root,
    stdio: "inherit",
    env: { ...process.env, ...env },
  });
  const line = [program, ...parameters].join(" ");
  if (error) throw new Refusal(`could not run: ${line}\n${error.message}`);
  if (status !== 0) throw new Refusal(`failed (${signal ?? `exit ${status}`}): ${line}`);
}

/**
 * Runs a program beside what is done meanwhile; what it says is shown when it is done. It ends with
 * this process.
 * @param {string} program @param {string[]} parameters @returns {Promise<void>}
 */
export function runLater(program, parameters) {
  const running = promisify(execFile)(program, parameters, { cwd: root, maxBuffer: 1e9 });
  process.on("exit", () => running.child.kill());
  const ended = running.catch((error) => error);
  const done = ended.then(({ stdout, stderr, message }) => {
    console.log(stdout, stderr);
    if (message) throw new Refusal(message.split("\n")[0]);
  });
  // Whoever waits for it learns of a failure; nobody may, where something else failed before.
  done.catch(() => {});
  return done;
}

/**
 * Runs a node program, among them those of the installed packages.
 * @param {string[]} parameters  script and its arguments
 */
export const runNode = (parameters) => run(process.execPath, parameters);

/**
 * Standard output of a program, or null when it is missing or fails.
 * @param {string} program @param {string[]} parameters @returns {string | null}
 */
export function ask(program, parameters) {
  const { status, stdout } = spawnSync(program, parameters, { cwd: root, encoding: "utf8" });
  return status === 0 ? stdout.trim() : null;
}

/** Runs a script's work; a refusal is printed, with exit code 1. @param {() => unknown} work */
export async function script(work) {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    console.error(`\x1b[31m✗ ${error.message}\x1b[0m`);
    process.exit(1);
  }
}
