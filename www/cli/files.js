// Files in and out.

import { accessSync, constants, existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import {
  endingOf,
  isMeshName,
  packedEndings,
  readEndings,
  writtenAs,
  writtenEndings,
} from "../mesh-format.js";
import { perform } from "../session.js";
import { meshAmong } from "../unpack.js";
import { say } from "../words.js";
import { Failure, failed, orExit, usage } from "./failure.js";

/** @typedef {import("../pkg/solver/solver.js").Session} Session */
/** @typedef {import("./terminal.js").Terminal} Terminal */

/** Whether a file's name is that of a mesh that can be read, packed or not. @param {string} file */
export const isMesh = (file) => isMeshName(file) || packedEndings.includes(endingOf(file));

/** Formats, as help names them: those that are written, and those that are read. */
export const writtenHelp = list(writtenEndings, "or");
export const readHelp = `${list(readEndings, "or")}, also in ${list(packedEndings, "or")}`;

/** @param {string[]} names @param {string} word  before the last */
function list(names, word) {
  return `${names.slice(0, -1).join(", ")} ${word} ${names.at(-1)}`;
}

/**
 * The mesh in a file, unpacked, with the files beside it that it names; `-` is standard input.
 * @param {string} file @param {Terminal} io
 */
export async function readMesh(file, io) {
  const bytes = Uint8Array.from(readInput(file, io));
  const name = file === "-" ? "stdin" : path.basename(file);
  const beside = endingOf(name) === ".gltf" ? buffersBeside(file, bytes) : [];
  try {
    const { others, ...mesh } = await meshAmong([{ name, bytes }, ...beside]);
    if (others.length > 0) io.log(say("unpack-others", { name: mesh.name, others }));
    return mesh;
  } catch (error) {
    throw failed(3, error);
  }
}

/** Files that a glTF file keeps its numbers in. @param {string} file @param {Uint8Array} bytes */
function buffersBeside(file, bytes) {
  const uris = [...new TextDecoder().decode(bytes).matchAll(/"uri"\s*:\s*"([^":]+)"/g)];
  const names = uris.map(([, uri]) => decodeURI(uri));
  const found = names.filter((name) => existsSync(path.join(path.dirname(file), name)));
  return found.map((name) => ({
    name,
    bytes: Uint8Array.from(readInput(path.join(path.dirname(file), name))),
  }));
}

/**
 * Vertex numbers from a JSON file: a list, or an object that has the list under `key`
 * (as `shape --selection` writes).
 * @param {string} file @param {"free" | "fixed"} key @returns {number[]}
 */
export function readSelection(file, key) {
  const text = new TextDecoder().decode(readInput(file));
  let content;
  try {
    content = JSON.parse(text);
  } catch (error) {
    const { message } = /** @type {Error} */ (error);
    throw new Failure(3, "BadSelection", `${file} is not JSON: ${message}.`, "");
  }
  const list = Array.isArray(content) ? content : content?.[key];
  if (Array.isArray(list) && list.every((v) => Number.isInteger(v) && v >= 0)) return list;
  const hint = `Write [1, 2] or {"${key}": [1, 2]}, with the numbers of the mesh file: OBJ counts from 1, others from 0.`;
  throw new Failure(3, "BadSelection", `${file} holds no list of vertex numbers.`, hint);
}

/**
 * The vertices that a mesh file gives these numbers: all copies of one that was split.
 * @param {Iterable<number>} chosen @param {import("../generated/types.js").Numbers} numbers
 */
export function numbered(chosen, { first, vertices }) {
  /** @type {Map<number, number[]>} */
  const places = new Map();
  for (const [v, n] of vertices?.entries() ?? []) places.set(n, [...(places.get(n) ?? []), v]);
  return [...chosen].flatMap((number) => {
    const found = vertices ? places.get(number - first) : [number - first];
    if (found && number >= first) return found;
    const hint = `Vertices have the numbers of the mesh file, from ${first} on; one that no face uses is none.`;
    throw new Failure(3, "BadSelection", `The mesh has no vertex ${number}.`, hint);
  });
}

/** @param {string} file @param {Terminal} [io]  of which `-` is the standard input */
export function readInput(file, io) {
  try {
    return io && file === "-" ? io.read() : readFileSync(file);
  } catch (error) {
    throw new Failure(3, "Unreadable", `${file} cannot be read: ${reason(error)}.`);
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
 * @param {string} file @returns {any}  a name that `Session.export` knows
 */
export function formatOf(file) {
  const format = writtenAs(file);
  if (format) return format;
  throw usage(
    `${file} does not say which format to write.`,
    `End its name in ${list(writtenEndings, "or")}.`,
  );
}

/**
 * Writes the session's mesh in the format that the file's name asks for, and says what that lacks.
 * @param {Session} session @param {string} file @param {Terminal} io
 */
export function writeMesh(session, file, io) {
  const format = formatOf(file);
  const [bytes, losses] = orExit(3, () => [
    perform(session, "export", { format }),
    perform(session, "losses", { format }),
  ]);
  writeOutput(file, bytes);
  for (const loss of losses) io.log(say(loss));
}

/** @param {string} file @param {string | Uint8Array} content */
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
