// Files in and out.

import { accessSync, constants, existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import * as formats from "../mesh-format.js";
import { perform } from "../session.js";
import { meshAmong } from "../unpack.js";
import { say } from "../words.js";
import { Failure, failed, orExit, usage } from "./failure.js";

/** @typedef {import("../pkg/solver/solver.js").Session} Session */
/** @typedef {import("../cli.js").Terminal} Terminal */

/** Whether a file's name is that of a mesh that can be read, packed or not. @param {string} file */
export const isMesh = (file) =>
  formats.isMeshName(file) || formats.packedEndings.includes(formats.endingOf(file));

/** Formats, as help names them: those that are written, and those that are read. */
export const writtenHelp = list(formats.writtenEndings, "or");
export const readHelp = `${list(formats.readEndings, "or")}, also in ${list(formats.packedEndings, "or")}`;

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
  const beside = formats.endingOf(name) === ".gltf" ? buffersBeside(file, bytes) : [];
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
  const all = names.map((name) => ({ name, place: path.join(path.dirname(file), name) }));
  const found = all.filter(({ place }) => existsSync(place));
  return found.map(({ name, place }) => ({ name, bytes: Uint8Array.from(readInput(place)) }));
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

/** What is not possible with a place to write to is refused. @param {string} file @param {() => void} work */
function toWrite(file, work) {
  try {
    work();
  } catch (error) {
    throw usage(`${file} cannot be written: ${reason(error)}.`);
  }
}

/** Tries places before the work begins and not after it. @param {(string | undefined)[]} files */
export function checkOutputs(files) {
  for (const file of files.filter((one) => one !== undefined)) {
    toWrite(file, () => {
      accessSync(path.dirname(file), constants.W_OK);
      if (statSync(file, { throwIfNoEntry: false })?.isDirectory()) throw new Error("a folder");
    });
  }
}

/** The mesh format that a file's ending asks for. @param {string} file */
export function formatOf(file) {
  const format = formats.writtenAs(file);
  if (format) return format;
  const hint = `End its name in ${list(formats.writtenEndings, "or")}.`;
  throw usage(`${file} does not say which format to write.`, hint);
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
export const writeOutput = (file, content) => toWrite(file, () => writeFileSync(file, content));

/** @param {unknown} error */
function reason(error) {
  const { code, message } = /** @type {NodeJS.ErrnoException} */ (error);
  if (code === "ENOENT") return "there is no such file or folder";
  if (code === "EACCES") return "permission denied";
  return code === "EISDIR" ? "it is a folder" : message;
}
