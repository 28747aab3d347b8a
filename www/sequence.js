// The stored steps as files in a ZIP. Runs in the worker.

import { extensionOf } from "./mesh-format.js";
import { refusal } from "./refusal.js";
import { perform } from "./session.js";

/** @typedef {import("./pkg/solver/solver.js").Session} Session */

/** Bytes before compression at most: the ZIP is put together in memory. */
export const MOST_BYTES = 1 << 30;

/** How much of a file there is at once for the compressor. */
const PIECE = 1 << 20;

/** Stored steps: every n-th and the last. @param {Session} session @param {number} every */
function* chosen(session, every) {
  const { start, last } = perform(session, "timeline");
  perform(session, "seek", { step: start });
  for (let n = 0; ; n += 1) {
    const { at, next } = perform(session, "timeline");
    if (n % every === 0 || next === null) yield at;
    if (next === null || at > last) return;
    perform(session, "seek", { step: next });
  }
}

/** @param {Session} session @param {string} format @param {number} every */
export function sequenceSize(session, format, every) {
  const { stored } = perform(session, "timeline");
  const meshes = 1 + Math.ceil((stored - 1) / every);
  return { meshes, bytes: meshes * perform(session, "export", { format }).length };
}

/**
 * @param {Session} session @param {string} format  of the meshes
 * @param {number} every   n: every n-th stored step, and the last
 * @param {(share: number) => void} tell @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function sequence(session, format, every, tell) {
  const { meshes, bytes } = sequenceSize(session, format, every);
  if (bytes > MOST_BYTES) {
    const gigabytes = bytes / 2 ** 30;
    throw refusal("TooLarge", "sequence-too-large", { meshes, gigabytes });
  }
  const { Zip, ZipDeflate } = await import("fflate");
  // From here on in one go: nothing else may move the session meanwhile.
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  const zip = new Zip((error, part) => {
    if (error) throw error;
    parts.push(part);
  });
  const { at, last } = perform(session, "timeline");
  const stem = perform(session, "loaded").name.replace(/[^\p{L}\p{N}._-]+/gu, "-");
  const digits = Math.max(4, String(last).length);
  const seen = new Set();
  try {
    for (const step of chosen(session, every)) {
      const number = String(step).padStart(digits, "0");
      // A step that was regularised is there twice.
      const twice = seen.has(step) ? "-regularised" : "";
      seen.add(step);
      const entry = new ZipDeflate(`${stem}-step${number}${twice}.${extensionOf(format)}`);
      zip.add(entry);
      const file = perform(session, "export", { format });
      for (let i = 0; i < file.length; i += PIECE) {
        entry.push(file.subarray(i, i + PIECE), i + PIECE >= file.length);
      }
      tell(seen.size / meshes);
    }
  } finally {
    perform(session, "seek", { step: at });
  }
  zip.end();
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
