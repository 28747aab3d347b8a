// What a page that embeds this one may ask, and how its words are read. Whoever embeds may be
// anybody: a message is taken apart here, and nothing of it goes on unread.
//
//   { umbilic: 1, id, type, … }        →  { umbilic: 1, id, ok } or { umbilic: 1, id, error }
//
// | type     | fields                                   | ok                               |
// | -------- | ---------------------------------------- | -------------------------------- |
// | `load`   | `scene`: words of a link, as text or as an object; or `name`, `bytes`: a mesh file, with `scene` as well | where it stands, once the scene is there |
// | `play`   |                                          | where it stands; hidden, it plays once it is seen |
// | `pause`, `step`, `back`, `reset` |                  | where it stands then             |
// | `seek`   | `step`                                   | where it stands then             |
// | `set`    | `words`: flow, parameters, `colour`, `camera`, `shading`, … as in a link | where it stands then |
// | `export` | `format`                                 | `{ name, bytes }`, transferred   |
// | `state`  |                                          | where it stands                  |
//
// At most 100 requests wait; those beyond are refused as `TooManyRequests`.
//
// Events, unasked: `{ umbilic: 1, event, detail }` with `listening` (requests are answered from
// now on), `ready` (a scene is there), `frame`, `statechange`, `error`, and `key` (Page Up or Page Down,
// pressed in the surface).

/** @import { Fault } from "../words.js" */

import { asText, formats } from "../options.js";
import { say } from "../words.js";

/** The version of what is said here. */
export const PROTOCOL = 1;

/** Requests that may wait for their turn: each may hold a mesh. */
export const MOST_WAITING = 100;

/** @typedef {{ id: string | number, type: string } & Record<string, unknown>} Request */

/**
 * @param {unknown} data
 * @returns {Request | null} null where it is no request of ours, and not to be answered
 */
export function asRequest(data) {
  if (typeof data !== "object" || data === null) return null;
  const { umbilic, id, type } = /** @type {Record<string, unknown>} */ (data);
  if (umbilic !== PROTOCOL || typeof type !== "string") return null;
  if (typeof id !== "string" && typeof id !== "number") return null;
  return /** @type {Request} */ (data);
}

/** @param {string} kind @param {string} message @param {string} hint @returns {Fault} */
export const fault = (kind, message, hint) => ({ kind, message, hint, detail: {} });

/** @returns {Fault} */
export const tooMany = () =>
  fault(
    "TooManyRequests",
    say("too-many-requests", { most: MOST_WAITING }),
    say("too-many-requests.hint"),
  );

/** @param {unknown} value @returns {Record<string, unknown>} */
const asObject = (value) =>
  typeof value === "object" && value !== null && !Array.isArray(value)
    ? /** @type {Record<string, unknown>} */ (value)
    : {};

/**
 * @param {unknown} scene  words of a link: text with or without `#`, or an object
 * @returns {string} the same from `#` on
 */
export function asHash(scene) {
  if (typeof scene === "string") return `#${scene.replace(/^#/, "")}`;
  const words = new URLSearchParams();
  for (const [word, value] of Object.entries(asObject(scene))) {
    words.set(word, ArrayBuffer.isView(value) ? String(value) : asText(value, word));
  }
  return `#${words}`;
}

/** Words of a link that say what is shown, and not how: a scene is loaded, not set. */
const ofScenes = [
  ...["sample", "mesh", "hash", "figure", "edits", "path", "check", "version"],
  ...["panes", "lockstep", "shown", "difference"],
];

/**
 * @param {unknown} words
 * @returns {{ hash: string, named: Set<string> }} the same as a link, and the words that were said
 * @throws {Fault} that names a word that cannot be set
 */
export function wordsToSet(words) {
  const hash = asHash(words);
  const said = new URLSearchParams(hash.slice(1));
  for (const [word, text] of said) {
    if (ofScenes.includes(word)) {
      throw fault(
        "BadValue",
        say("embed-bad-value", { word, text: text.slice(0, 60) }),
        say("embed-bad-value.hint"),
      );
    }
  }
  return { hash, named: new Set(said.keys()) };
}

/** @param {Request} request @returns {number} */
export function stepOf({ step }) {
  if (typeof step === "number" && Number.isInteger(step) && step >= 0 && step < 1e7) return step;
  throw fault("BadStep", say("embed-bad-step", { step: String(step).slice(0, 60) }), "");
}

/** @param {Request} request @returns {string} */
export function formatOf({ format = "ply" }) {
  if (formats.some((id) => id === format)) return /** @type {string} */ (format);
  throw fault(
    "UnknownFormat",
    say("embed-no-format", { format: String(format).slice(0, 60) }),
    say("embed-known", { known: [...formats] }),
  );
}

/** @param {Request} request @returns {File | null} the mesh that was sent along */
export function fileOf({ name, bytes }) {
  if (bytes === undefined) return null;
  const isBytes = bytes instanceof ArrayBuffer || bytes instanceof Uint8Array;
  if (!isBytes || typeof name !== "string" || !/^[^/\\]{1,200}$/.test(name)) {
    throw fault("BadMesh", say("embed-bad-mesh"), "");
  }
  return new File([/** @type {ArrayBuffer} */ (bytes)], name);
}
