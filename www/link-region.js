// @ts-check
// A set of vertices as a few characters of an address: run lengths where the vertices lie
// together, else a bit for each, whichever is shorter; as base64 that an address may hold.

/** No region or other word of more characters is put into a link: mail and chat programs cut longer ones. */
export const LONGEST = 6000;

/** No vertex beyond: a link must not make a browser set aside gigabytes. */
const MOST = 1 << 24;

/**
 * Lengths of the runs of absent and present vertices in turn, absent first; seven bits a
 * byte, low ones first.
 * @param {Uint32Array} sorted
 */
function runLengths(sorted) {
  /** @type {number[]} */
  const bytes = [];
  const put = (/** @type {number} */ length) => {
    let rest = length;
    for (; rest > 127; rest = Math.floor(rest / 128)) bytes.push((rest % 128) | 128);
    bytes.push(rest);
  };
  let end = 0;
  for (let i = 0; i < sorted.length; ) {
    const first = sorted[i];
    let last = first;
    for (i += 1; i < sorted.length && sorted[i] === last + 1; i += 1) last = sorted[i];
    put(first - end);
    put(last + 1 - first);
    end = last + 1;
  }
  return Uint8Array.from(bytes);
}

/** @param {Uint8Array} bytes @returns {number[] | undefined} */
function fromRunLengths(bytes) {
  /** @type {number[]} */
  const vertices = [];
  let [at, isIn, length, scale] = [0, false, 0, 1];
  for (const byte of bytes) {
    length += (byte & 127) * scale;
    scale *= 128;
    if (at + length > MOST) return undefined;
    if (byte > 127) continue;
    if (isIn) for (let v = at; v < at + length; v += 1) vertices.push(v);
    at += length;
    isIn = !isIn;
    [length, scale] = [0, 1];
  }
  // Cut off in the middle of a number, or of a pair of runs.
  return scale === 1 && !isIn ? vertices : undefined;
}

/** @param {Uint32Array} sorted */
function bits(sorted) {
  const bytes = new Uint8Array(sorted.length === 0 ? 0 : (sorted[sorted.length - 1] >> 3) + 1);
  for (const v of sorted) bytes[v >> 3] |= 1 << (v & 7);
  return bytes;
}

/** @param {Uint8Array} bytes */
function fromBits(bytes) {
  /** @type {number[]} */
  const vertices = [];
  for (const [n, byte] of bytes.entries()) {
    for (let bit = 0; bit < 8; bit += 1) if (byte & (1 << bit)) vertices.push(8 * n + bit);
  }
  return vertices;
}

/** @param {Uint8Array} bytes */
export function asBase64(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} text @throws where it is none */
export const fromBase64 = (text) =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (one) => one.charCodeAt(0));

/** @type {WeakMap<readonly number[], string | null>} the address is written at every frame */
const known = new WeakMap();

/**
 * @param {readonly number[]} vertices  in any order
 * @returns {string | null} null where it would be longer than {@link LONGEST}
 */
export function encodeRegion(vertices) {
  const before = known.get(vertices);
  if (before !== undefined) return before;
  const sorted = Uint32Array.from(new Set(vertices)).sort();
  const [runs, set] = [runLengths(sorted), bits(sorted)];
  const fits = 1 + Math.ceil((4 / 3) * Math.min(runs.length, set.length)) <= LONGEST;
  const text = !fits
    ? null
    : runs.length <= set.length
      ? `r${asBase64(runs)}`
      : `b${asBase64(set)}`;
  known.set(vertices, text);
  return text;
}

/** @param {string} text @returns {number[] | undefined} ascending; undefined where it makes no sense */
export function decodeRegion(text) {
  const parts = /^([rb])([\w-]*)$/.exec(text);
  if (!parts || text.length > LONGEST) return undefined;
  try {
    const bytes = fromBase64(parts[2]);
    return parts[1] === "r" ? fromRunLengths(bytes) : fromBits(bytes);
  } catch {
    return undefined;
  }
}
