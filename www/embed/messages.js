// What a page that embeds this one may ask, and how its words are read. Whoever embeds may be
// anybody: a message is taken apart here, and nothing of it goes on unread.
// EMBEDDING.md lists what may be asked and what is told.

import { asText, formats } from "../options.js";
import { fault } from "../words.js";

/** The version of what is said here. */
export const PROTOCOL = 1;

/** Requests that may wait for their turn: each may hold a mesh. */
export const MOST_WAITING = 100;

/** @typedef {{ id: string | number, type: string } & Record<string, unknown>} Request */

/** Null where it is no request of ours, and not to be answered. @param {unknown} data */
export function asRequest(data) {
  if (typeof data !== "object" || data === null) return null;
  const { umbilic, id, type } = /** @type {Record<string, unknown>} */ (data);
  if (umbilic !== PROTOCOL || typeof type !== "string") return null;
  if (typeof id !== "string" && typeof id !== "number") return null;
  return /** @type {Request} */ (data);
}

/** What was said, in a message about it. @param {unknown} said */
const short = (said) => String(said).slice(0, 60);

export const unknownRequest = (/** @type {string} */ type, /** @type {string[]} */ known) =>
  fault("UnknownRequest", "embed-no-request", { type: short(type), known }, "embed-known");

/** Words of a link, as text or as an object, from `#` on. @param {unknown} scene */
export function asHash(scene) {
  if (typeof scene === "string") return `#${scene.replace(/^#/, "")}`;
  const isObject = typeof scene === "object" && scene !== null && !Array.isArray(scene);
  const words = Object.entries(isObject ? scene : {}).map(([word, value]) => [
    word,
    ArrayBuffer.isView(value) ? String(value) : asText(value, word),
  ]);
  return `#${new URLSearchParams(words)}`;
}

/** Words of a link that say what is shown, and not how: a scene is loaded, not set. */
const ofScenes = [
  ...["sample", "mesh", "hash", "figure", "edits", "path", "check", "version"],
  ...["panes", "lockstep", "shown", "difference"],
];

/**
 * @param {unknown} words
 * @returns {{ hash: string, named: Set<string> }} the same as a link, and the words that were said
 * @throws {import("../words.js").Fault} that names a word that cannot be set
 */
export function wordsToSet(words) {
  const hash = asHash(words);
  const said = new URLSearchParams(hash.slice(1));
  for (const [word, text] of said) {
    if (!ofScenes.includes(word)) continue;
    throw fault("BadValue", "embed-bad-value", { word, text: short(text) });
  }
  return { hash, named: new Set(said.keys()) };
}

/** @param {Request} request @returns {number} */
export function stepOf({ step }) {
  if (typeof step === "number" && Number.isInteger(step) && step >= 0 && step < 1e7) return step;
  throw fault("BadStep", "embed-bad-step", { step: short(step) }, "");
}

/** @param {Request} request */
export function formatOf({ format = "ply" }) {
  const known = formats.find((id) => id === format);
  if (known) return known;
  const values = { format: short(format), known: formats };
  throw fault("UnknownFormat", "embed-no-format", values, "embed-known");
}

/** @param {Request} request @returns {File | null} the mesh that was sent along */
export function fileOf({ name, bytes }) {
  if (bytes === undefined) return null;
  const isBytes = bytes instanceof ArrayBuffer || bytes instanceof Uint8Array;
  if (!isBytes || typeof name !== "string" || !/^[^/\\]{1,200}$/.test(name)) {
    throw fault("BadMesh", "embed-bad-mesh", {}, "");
  }
  return new File([/** @type {ArrayBuffer} */ (bytes)], name);
}
