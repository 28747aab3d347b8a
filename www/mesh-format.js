// What the endings of mesh files say, from the solver's table of formats.

import { meshFormats } from "./generated/schema.js";

/** Formats that are written. */
export const written = meshFormats.filter((format) => format.isWritten);

/** Endings of file names. @param {typeof meshFormats} formats */
const endings = (formats) => [
  ...new Set(formats.flatMap(({ extensions }) => extensions.map((one) => `.${one}`))),
];

/** Endings of files that are read, such as `.obj`. */
export const readEndings = endings(meshFormats);
/** Of files that are written. */
export const writtenEndings = endings(written);
/** Of files that a mesh may be packed in. */
export const packedEndings = [".gz", ".zip"];

/** @param {string} name */
export const endingOf = (name) => /\.[^./\\]+$/.exec(name)?.[0].toLowerCase() ?? "";

/** Whether a file's name is that of a mesh that can be read. @param {string} name */
export const isMeshName = (name) => readEndings.includes(endingOf(name));

/** The format that a file's name asks for; the first of several. @param {string} name */
export const writtenAs = (name) =>
  written.find(({ extensions }) => extensions.includes(endingOf(name).slice(1)))?.name ?? null;

/** The ending of files of a format, without the dot; of other formats their name. @param {string} name */
export const extensionOf = (name) =>
  meshFormats.find((format) => format.name === name)?.extensions[0] ?? name;
