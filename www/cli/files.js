// @ts-check
// Files in and out.

import { accessSync, constants, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { Failure, usage } from "./failure.js";

/** @typedef {import("./terminal.js").Terminal} Terminal */

/** The solver's name of a format by ending of the file name. */
const formats = new Map([
  [".obj", "obj"],
  [".off", "off"],
  [".ply", "ply"],
  [".stl", "stl"],
  [".glb", "glb"],
]);

/** Whether a file's name is that of a mesh that can be read. @param {string} file */
export const isMesh = (file) => /\.(?:obj|off|ply|stl)$/i.test(file);

/**
 * The bytes of a mesh file; `-` is standard input.
 * @param {string} file
 * @param {Terminal} io
 * @returns {{ bytes: Uint8Array, name: string }}
 */
export function readMesh(file, io) {
  if (file === "-") return { bytes: io.read(), name: "stdin" };
  return { bytes: readInput(file), name: path.basename(file) };
}

/**
 * Vertex numbers from a JSON file: a list, or an object that has the list under `key`
 * (as `shape --selection` writes).
 * @param {string} file
 * @param {"free" | "fixed"} key
 * @returns {number[]}
 */
export function readSelection(file, key) {
  const text = readInput(file).toString("utf8");
  let content;
  try {
    content = JSON.parse(text);
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    throw new Failure(3, "BadSelection", `${file} is not JSON: ${message}.`, "");
  }
  const list = Array.isArray(content) ? content : content?.[key];
  if (Array.isArray(list) && list.every((v) => Number.isInteger(v) && v >= 0)) return list;
  const hint = `Write [0, 1, 2] or {"${key}": [0, 1, 2]}; vertices count from 0.`;
  throw new Failure(3, "BadSelection", `${file} holds no list of vertex numbers.`, hint);
}

/** @param {string} file */
export function readInput(file) {
  try {
    return readFileSync(file);
  } catch (error) {
    throw new Failure(3, "Unreadable", `${file} cannot be read: ${reason(error)}.`, "");
  }
}

/**
 * Refuses a place that cannot be written before the work begins and not after it.
 * @param {(string | undefined)[]} files
 */
export function checkOutputs(files) {
  for (const file of files) {
    if (file === undefined) continue;
    try {
      const folder = path.dirname(file);
      accessSync(folder, constants.W_OK);
      if (statSync(file, { throwIfNoEntry: false })?.isDirectory()) throw new Error("a folder");
    } catch (error) {
      throw usage(`${file} cannot be written: ${reason(error)}.`);
    }
  }
}

/**
 * The mesh format that the ending of `file` asks for.
 * @param {string} file
 * @returns {any}  a name that `Session.export` knows
 */
export function formatOf(file) {
  const format = formats.get(path.extname(file).toLowerCase());
  if (format) return format;
  throw usage(
    `${file} does not say which format to write.`,
    `End its name in ${[...formats.keys()].join(", ")}.`,
  );
}

/**
 * @param {string} file
 * @param {string | Uint8Array} content
 */
export function writeOutput(file, content) {
  try {
    writeFileSync(file, content);
  } catch (error) {
    throw usage(`${file} cannot be written: ${reason(error)}.`);
  }
}

/** @param {unknown} error */
function reason(error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  if (code === "ENOENT") return "there is no such file or folder";
  if (code === "EACCES") return "permission denied";
  return code === "EISDIR" ? "it is a folder" : message;
}
