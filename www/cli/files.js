// Files in and out.

import { accessSync, constants, existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import * as formats from "../mesh-format.js";
import { say } from "../words.js";
import { attempt, Failure, usage } from "./failure.js";

/** @typedef {import("../cli.js").Terminal} Terminal */
/** @typedef {import("./command.js").Perform} Perform */

/** Whether a file's name is that of a mesh that can be read, packed or not. @param {string} file */
export const isMesh = (file) =>
  formats.isMeshName(file) || formats.packedEndings.includes(formats.endingOf(file));

/** Formats, as help names them: those that are written, and those that are read. */
const list = new Intl.ListFormat("en-GB", { type: "disjunction" });
export const writtenHelp = list.format(formats.writtenEndings);
export const readHelp = `${list.format(formats.readEndings)}, also in ${list.format(formats.packedEndings)}`;

/**
 * The mesh in a file, unpacked, with the files beside it that it names; `-` is standard input.
 * @param {Perform} perform @param {string} file @param {Terminal} io
 */
export function readMesh(perform, file, io) {
  const bytes = Uint8Array.from(readInput(file, io));
  const name = file === "-" ? "stdin" : path.basename(file);
  const beside = formats.endingOf(name) === ".gltf" ? buffersBeside(file, bytes) : [];
  const { others, ...mesh } = perform("unpack", { files: [{ name, bytes }, ...beside] });
  if (others.length > 0) io.log(say("unpack-others", { name: mesh.name, others }));
  return mesh;
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
  const content = attempt(
    () => JSON.parse(text),
    ({ message }) => new Failure(3, "BadSelection", `${file} is not JSON: ${message}.`),
  );
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
export const readInput = (file, io) =>
  attempt(
    () => (io && file === "-" ? io.read() : readFileSync(file)),
    (error) => new Failure(3, "Unreadable", `${file} cannot be read: ${reason(error)}.`),
  );

/** What is not possible with a place to write to is refused. @param {string} file @param {() => void} work */
const toWrite = (file, work) =>
  attempt(work, (error) => usage(`${file} cannot be written: ${reason(error)}.`));

/** Tries a place before the work begins and not after it. @param {string} file */
export const checkOutput = (file) =>
  toWrite(file, () => {
    accessSync(path.dirname(file), constants.W_OK);
    if (statSync(file, { throwIfNoEntry: false })?.isDirectory()) throw new Error("a folder");
  });

/** The mesh format that a file's ending asks for. @param {string} file */
export function formatOf(file) {
  const format = formats.writtenAs(file);
  if (format) return format;
  const hint = `End its name in ${writtenHelp}.`;
  throw usage(`${file} does not say which format to write.`, hint);
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
