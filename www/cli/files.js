// Files in and out.

import { accessSync, constants, existsSync, readFileSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import * as formats from "../mesh-format.js";
import { say } from "../words.js";
import { attempt, refused } from "./failure.js";

/** @typedef {import("../cli.js").Terminal} Terminal */
/** @typedef {import("./run.js").Perform} Perform */

/** Formats, as help names them: those that are written, and those that are read. */
const list = new Intl.ListFormat("en-GB", { type: "disjunction" });
export const writtenHelp = list.format(formats.writtenEndings);
const [read, packed] = [formats.readEndings, formats.packedEndings].map((all) => list.format(all));
export const readHelp = say("overview-formats", { read, packed });

/** Whether a file's name is that of a mesh that can be read, packed or not. @param {string} file */
export const isMesh = (file) =>
  formats.isMeshName(file) || formats.packedEndings.includes(formats.endingOf(file));

/**
 * The mesh in a file, unpacked, with the files beside it that it names; `-` is standard input.
 * @param {Perform} perform @param {string} file @param {Terminal} io
 */
export function readMesh(perform, file, io) {
  const bytes = readInput(file, io);
  const name = file === "-" ? "stdin" : path.basename(file);
  const beside = formats.endingOf(name) === ".gltf" ? buffersBeside(file, bytes) : [];
  const { others, ...mesh } = perform("unpack", { files: [{ name, bytes }, ...beside] });
  if (others.length > 0) io.log(say("unpack-others", { name: mesh.name, others }));
  return mesh;
}

/** Files that a glTF file keeps its numbers in. @param {string} file @param {Uint8Array} bytes */
function buffersBeside(file, bytes) {
  const uris = [...new TextDecoder().decode(bytes).matchAll(/"uri"\s*:\s*"([^":]+)"/g)];
  const places = uris.map(([, uri]) => [decodeURI(uri), beside(file, decodeURI(uri))]);
  const found = places.filter(([, place]) => existsSync(place));
  return found.map(([name, place]) => ({ name, bytes: readInput(place) }));
}

/** A file in the folder of another. @param {string} file @param {string} name */
export const beside = (file, name) => path.join(path.dirname(file), name);

/**
 * Vertex numbers from a JSON file: a list, or an object that has the list under `key`
 * (as `shape --selection` writes).
 * @param {string} file @param {"free" | "fixed"} key @returns {number[]}
 */
export function readSelection(file, key) {
  const content = attempt(
    () => JSON.parse(readText(file)),
    (error) =>
      error.exit
        ? error
        : refused("selection-no-json", { file, reason: error.message }, "BadSelection"),
  );
  const list = Array.isArray(content) ? content : content?.[key];
  if (Array.isArray(list) && list.every((v) => Number.isInteger(v) && v >= 0)) return list;
  throw refused("selection-no-list", { file, key }, "BadSelection");
}

/** Why a file cannot be read or written. @param {NodeJS.ErrnoException} error */
const causeOf = ({ code = "", message: reason }) => ({
  id: "file-fault",
  values: { code, reason },
});

/** @param {string} file @param {Terminal} [io]  of which `-` is the standard input */
export const readInput = (file, io) =>
  Uint8Array.from(
    attempt(
      () => (io && file === "-" ? io.read() : readFileSync(file)),
      (error) => refused("file-unreadable", { file, cause: causeOf(error) }, "Unreadable"),
    ),
  );

/** @param {string} file @param {Terminal} [io] */
export const readText = (file, io) => new TextDecoder().decode(readInput(file, io));

/** What is not possible with a place to write to is refused. @param {string} file @param {() => void} work */
const toWrite = (file, work) =>
  attempt(work, (error) => refused("usage-unwritable", { file, cause: causeOf(error) }));

/** Tries a place before the work begins and not after it. @param {string} file */
export const checkOutput = (file) =>
  toWrite(file, () => {
    accessSync(path.dirname(file), constants.W_OK);
    if (statSync(file, { throwIfNoEntry: false })?.isDirectory()) throw new Error("a folder");
  });

/** @param {string} file @param {string | Uint8Array} content */
export const writeOutput = (file, content) => toWrite(file, () => writeFileSync(file, content));

/** The mesh format that a file's ending asks for. @param {string} file */
export function formatOf(file) {
  const format = formats.writtenAs(file);
  if (!format) throw refused("usage-format", { file, formats: writtenHelp });
  return format;
}
