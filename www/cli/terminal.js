// The streams of the process. Tests put others in their place.

import { readFileSync } from "node:fs";

/**
 * @typedef {object} Terminal
 * @property {(text: string) => void} write  results, on standard output
 * @property {(text: string) => void} log    a line about the work, on standard error
 * @property {() => Uint8Array} read         all of standard input
 */

/** @type {Terminal} */
export const terminal = {
  write: (text) => void process.stdout.write(text),
  log: (text) => void process.stderr.write(`${text}\n`),
  read: () => readFileSync(0),
};

// `umbilic … | head` closes the pipe early, which is no failure.
process.stdout.on("error", (error) => {
  if (/** @type {NodeJS.ErrnoException} */ (error).code !== "EPIPE") throw error;
});
