// What stands in a ZIP archive, and its files unpacked: APPNOTE.TXT of PKWARE, version 6.3, with
// 64-bit sizes; stored and deflated files. Nothing is unpacked past the size that was announced.

import { refusal } from "./refusal.js";

/**
 * @typedef {object} Entry
 * @property {string} name  with its folders
 * @property {number} size  once unpacked
 * @property {() => Promise<Uint8Array<ArrayBuffer>>} read
 */

/** At most so many bytes are unpacked, */
const MOST = 2 ** 30;
/** or, of what is small already, so many times its size: no mesh is compressed further. */
const RATIO = 200;
const SMALL = 2 ** 24;

const damaged = () => refusal("Damaged", "unpack-damaged");

/** @param {Uint8Array} packed */
const mostOf = (packed) => Math.min(MOST, Math.max(SMALL, RATIO * packed.length));

/** @param {number} most */
const tooLarge = (most) =>
  refusal("TooLarge", "unpack-too-large", { megabytes: Math.round(most / 2 ** 20) });

/**
 * @param {"gzip" | "deflate-raw"} format @param {Uint8Array<ArrayBuffer>} packed
 * @param {number} most  bytes; what would be more is refused
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
async function inflated(format, packed, most) {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream(format));
  const reader = stream.getReader();
  /** @type {Uint8Array[]} */
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw damaged();
    });
    if (done) break;
    length += value.length;
    if (length > most) {
      reader.cancel().catch(() => {});
      throw tooLarge(most);
    }
    parts.push(value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** @param {Uint8Array} bytes */
export const isGzip = (bytes) => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** @param {Uint8Array<ArrayBuffer>} bytes */
export const gunzip = (bytes) => inflated("gzip", bytes, mostOf(bytes));

/** @param {Uint8Array} bytes */
export const isZip = ([p, k, a, b]) =>
  p === 0x50 && k === 0x4b && ((a === 3 && b === 4) || (a === 5 && b === 6));

/** Remainders of bytes, for the sum of a file. */
const remainders = Uint32Array.from({ length: 256 }, (_, n) => {
  let r = n;
  for (let bit = 0; bit < 8; bit += 1) r = r & 1 ? (r >>> 1) ^ 0xedb88320 : r >>> 1;
  return r;
});

/** @param {Uint8Array} bytes */
function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) sum = (sum >>> 8) ^ remainders[(sum ^ byte) & 255];
  return ~sum >>> 0;
}

/** Where the list of files begins, and how many it has. @param {DataView} view */
function listOf(view) {
  // A comment of any length may follow.
  const last = view.byteLength - 22;
  for (let at = last; at >= Math.max(0, last - 0xffff); at -= 1) {
    if (view.getUint32(at, true) !== 0x06054b50) continue;
    const count = view.getUint16(at + 10, true);
    const start = view.getUint32(at + 16, true);
    if (count !== 0xffff && start !== 0xffffffff) return { count, start };
    if (at < 20 || view.getUint32(at - 20, true) !== 0x07064b50) break;
    const wide = Number(view.getBigUint64(at - 12, true));
    if (wide + 56 > view.byteLength || view.getUint32(wide, true) !== 0x06064b50) break;
    return {
      count: Number(view.getBigUint64(wide + 32, true)),
      start: Number(view.getBigUint64(wide + 48, true)),
    };
  }
  throw damaged();
}

/**
 * Sizes and place of a file, where 32 bits were too few.
 * @param {DataView} view @param {number} at  of the extra fields @param {number} end
 * @param {{ size: number, packed: number, offset: number }} narrow
 */
function widened(view, at, end, narrow) {
  const found = { ...narrow };
  while (at + 4 <= end) {
    const [kind, length] = [view.getUint16(at, true), view.getUint16(at + 2, true)];
    let next = at + 4;
    const stop = Math.min(end, next + length);
    if (kind === 1) {
      for (const name of /** @type {const} */ (["size", "packed", "offset"])) {
        if (found[name] !== 0xffffffff || next + 8 > stop) continue;
        found[name] = Number(view.getBigUint64(next, true));
        next += 8;
      }
    }
    at = stop;
    if (length === 0 && kind === 0) break;
  }
  return found;
}

/** The files of an archive. @param {Uint8Array<ArrayBuffer>} bytes @returns {Entry[]} */
export function entriesOf(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const { count, start } = listOf(view);
  /** @type {Entry[]} */
  const entries = [];
  let at = start;
  for (let n = 0; n < count; n += 1) {
    if (at + 46 > view.byteLength || view.getUint32(at, true) !== 0x02014b50) throw damaged();
    const [nameLength, extra, comment] = [28, 30, 32].map((k) => view.getUint16(at + k, true));
    const [flags, method] = [8, 10].map((k) => view.getUint16(at + k, true));
    const [sum, packed, size] = [16, 20, 24].map((k) => view.getUint32(at + k, true));
    const offset = view.getUint32(at + 42, true);
    const nameEnd = at + 46 + nameLength;
    const next = nameEnd + extra + comment;
    if (next > view.byteLength) throw damaged();
    const name = new TextDecoder().decode(bytes.subarray(at + 46, nameEnd)).replaceAll("\\", "/");
    const own = widened(view, nameEnd, nameEnd + extra, { size, packed, offset });
    at = next;
    if (name.endsWith("/")) continue;
    entries.push({ name, size: own.size, read: () => unpacked({ ...own, flags, method, sum }) });
  }
  return entries;

  /** @param {{ size: number, packed: number, offset: number, flags: number, method: number, sum: number }} entry */
  async function unpacked({ size, packed, offset, flags, method, sum }) {
    if (flags & 1) throw refusal("Encrypted", "unpack-encrypted");
    if (offset + 30 > view.byteLength || view.getUint32(offset, true) !== 0x04034b50) {
      throw damaged();
    }
    const lengths = [26, 28].map((k) => view.getUint16(offset + k, true));
    const from = offset + 30 + lengths[0] + lengths[1];
    if (from + packed > view.byteLength) throw damaged();
    const inside = bytes.subarray(from, from + packed);
    if (size > mostOf(inside)) throw tooLarge(mostOf(inside));
    if (method !== 0 && method !== 8) throw refusal("Unsupported", "unpack-method", { method });
    const plain = method === 8 ? await inflated("deflate-raw", inside, size) : inside.slice();
    if (plain.length !== size || crc32(plain) !== sum) throw damaged();
    return plain;
  }
}
