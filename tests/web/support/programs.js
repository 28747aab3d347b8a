// @ts-check
// Programs that the tests need and that are no node packages: found, or installed where that
// is possible.

import { spawn, spawnSync } from "node:child_process";
import { accessSync, constants } from "node:fs";
import path from "node:path";

/**
 * The first of some programs that is there.
 * @param {string[]} names      as they are called on the PATH
 * @param {string[]} [places]   where else they may be
 * @param {string} [variable]   of the environment, that names another; it goes first
 * @returns {string | null} path of the program
 */
export function findProgram(names, places = [], variable = "") {
  const asked = process.env[variable];
  if (asked) {
    if (!isExecutable(asked)) throw new Error(`${variable} is not a program: ${asked}`);
    return asked;
  }
  const folders = (process.env.PATH ?? "").split(path.delimiter);
  const candidates = names.flatMap((name) => folders.map((folder) => path.join(folder, name)));
  return [...candidates, ...places].find(isExecutable) ?? null;
}

/**
 * Installs packages of Debian and its like, as root; elsewhere nothing happens.
 * @param {string[]} packages
 */
export function installPackages(packages) {
  if (process.platform !== "linux" || process.getuid?.() !== 0) return;
  if (!succeeds("apt-get", ["--version"], "ignore")) return;
  console.log(`  installing ${packages.join(", ")}`);
  succeeds("apt-get", ["update", "-q"]);
  succeeds("apt-get", ["install", "-q", "-y", "--no-install-recommends", ...packages]);
}

/**
 * @param {string} program
 * @param {string[]} parameters
 * @param {"inherit" | "ignore"} [stdio]
 */
export function succeeds(program, parameters, stdio = "inherit") {
  const env = { ...process.env, DEBIAN_FRONTEND: "noninteractive" };
  return spawnSync(program, parameters, { stdio, env }).status === 0;
}

/** @param {string} file */
export function isExecutable(file) {
  try {
    accessSync(file, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

/** @typedef {{ sign: string, stop: () => Promise<void> }} Started */

/**
 * Starts a program that runs beside the tests, with whatever it starts in turn.
 * @param {string} program
 * @param {string[]} parameters
 * @param {RegExp} [sign]  what it writes when it is ready, with the part of it that counts in
 *   brackets; without, it is ready when it runs
 * @param {NodeJS.ProcessEnv} [env]
 * @returns {Promise<Started>}
 */
export function start(program, parameters, sign, env = {}) {
  // In a group of its own, so that the whole of it can be ended.
  const child = spawn(program, parameters, { env: { ...process.env, ...env }, detached: true });
  const kill = () => {
    try {
      process.kill(-Number(child.pid), "SIGKILL");
    } catch {
      // It has ended already.
    }
  };
  process.once("exit", kill);
  const ended = new Promise((resolve) => child.once("exit", resolve));
  const stop = async () => {
    process.removeListener("exit", kill);
    kill();
    await ended;
  };
  return new Promise((resolve, reject) => {
    let said = "";
    const listen = (/** @type {Buffer} */ text) => {
      // Read on, else it waits for a reader.
      if (said.length < 10_000) said += text;
      const match = sign?.exec(said);
      if (match) resolve({ sign: match[1], stop });
    };
    child.stdout.on("data", listen);
    child.stderr.on("data", listen);
    child.once("error", reject);
    child.once("exit", (code) => reject(new Error(`${program} ended with ${code}: ${said}`)));
    if (!sign) child.once("spawn", () => resolve({ sign: "", stop }));
  });
}
