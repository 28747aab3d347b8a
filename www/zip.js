// What stands in a ZIP archive, and its files unpacked: APPNOTE.TXT of PKWARE, version 6.3, with
// 64-bit sizes; stored and deflated files. Nothing is unpacked past the size that was announced.

import { refusal } from "./refusal.js";

/**
 * A file in an archive: `name` with its folders, `size` once unpacked.
 * @typedef {{ name: string, size: number, read: () => Promise<Uint8Array<ArrayBuffer>> }} Entry
 */

/** At most so many bytes are unpacked, */
const MOST = 2 ** 30;
/** or, of what is small already, so many times its size: no mesh is compressed further. */
const RATIO = 200;
const SMALL = 2 ** 24;

const damaged = () => refusal("Damaged", "unpack-damaged");

/** @param {Uint8Array} packed */
const mostOf = (packed) => Math.min(MOST, Math.max(SMALL, RATIO * packed.length));

const tooLarge = (/** @type {number} */ most) =>
  refusal("TooLarge", "unpack-too-large", { megabytes: Math.round(most / 2 ** 20) });

/** @param {BlobPart[]} packed  gzip @param {number} most  bytes; what would be more is refused */
async function inflated(packed, most) {
  let length = 0;
  const counted = new TransformStream({
    transform(/** @type {Uint8Array} */ part, rest) {
      length += part.length;
      if (length > most) throw tooLarge(most);
      rest.enqueue(part);
    },
  });
  const plain = new Blob(packed).stream().pipeThrough(new DecompressionStream("gzip"));
  try {
    return new Uint8Array(await new Response(plain.pipeThrough(counted)).arrayBuffer());
  } catch {
    throw length > most ? tooLarge(most) : damaged();
  }
}

export const isGzip = (/** @type {Uint8Array} */ bytes) => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** Where the next member of a gzip file may begin, or its end. @param {Uint8Array} bytes @param {number} from */
function memberAfter(bytes, from) {
  for (let at = bytes.indexOf(0x1f, from); at >= 0; at = bytes.indexOf(0x1f, at + 1)) {
    if (bytes[at + 1] === 0x8b && bytes[at + 2] === 8) return at;
  }
  return bytes.length;
}

/** Out of gzip of one member or, as `cat` and `bgzip` put them, several. @param {Uint8Array<ArrayBuffer>} bytes */
export async function gunzip(bytes) {
  const most = mostOf(bytes);
  /** @type {BlobPart[]} */
  const members = [];
  let length = 0;
  let [from, to] = [0, bytes.length];
  let isOfSeveral = false;
  while (from < bytes.length) {
    try {
      const member = await inflated([bytes.subarray(from, to)], most - length);
      members.push(member);
      length += member.length;
      from = to;
    } catch (error) {
      // Where it is not one, it may be several; what looks like the next may be of the same.
      const isOver = isOfSeveral && to === bytes.length;
      if (isOver || /** @type {any} */ (error).kind !== "Damaged") throw error;
      if (!isOfSeveral) to = from;
      isOfSeveral = true;
    }
    to = memberAfter(bytes, to + 1);
  }
  return new Uint8Array(await new Blob(members).arrayBuffer());
}

/** @param {Uint8Array} bytes */
export const isZip = ([p, k, a, b]) =>
  p === 0x50 && k === 0x4b && ((a === 3 && b === 4) || (a === 5 && b === 6));

/** Bytes that are not compressed, in the blocks that deflate has for them. @param {Uint8Array<ArrayBuffer>} bytes */
function* blocksOf(bytes) {
  const most = 0xffff;
  for (let at = 0; at === 0 || at < bytes.length; at += most) {
    const block = bytes.subarray(at, at + most);
    const [low, high] = [block.length & 255, block.length >> 8];
    yield Uint8Array.of(Number(at + most >= bytes.length), low, high, ~low, ~high);
    yield block;
  }
}

/** Numbers in an archive: where it ends before, it is damaged. @param {Uint8Array} bytes */
function numbersIn({ buffer, byteOffset, byteLength }) {
  const view = new DataView(buffer, byteOffset, byteLength);
  /** @param {"getUint16" | "getUint32" | "getBigUint64"} kind @returns {(at: number) => number} */
  const read = (kind) => (at) => {
    try {
      return Number(view[kind](at, true));
    } catch {
      throw damaged();
    }
  };
  return { u16: read("getUint16"), u32: read("getUint32"), u64: read("getBigUint64") };
}

/** The files of an archive. @param {Uint8Array<ArrayBuffer>} bytes @returns {Entry[]} */
export function entriesOf(bytes) {
  const { u16, u32, u64 } = numbersIn(bytes);

  /** Where the list of files begins, and how many it has. */
  function list() {
    // A comment of any length may follow.
    const last = bytes.length - 22;
    for (let at = last; at >= Math.max(0, last - 0xffff); at -= 1) {
      if (u32(at) !== 0x06054b50) continue;
      const [count, start] = [u16(at + 10), u32(at + 16)];
      if (count !== 0xffff && start !== 0xffffffff) return { count, start };
      const wide = u32(at - 20) === 0x07064b50 ? u64(at - 12) : at;
      if (u32(wide) === 0x06064b50) return { count: u64(wide + 32), start: u64(wide + 48) };
    }
    throw damaged();
  }

  /**
   * Sizes and place of a file, where 32 bits were too few.
   * @param {number} at  of the extra fields @param {number} end @param {number[]} narrow
   */
  function widened(at, end, narrow) {
    for (let field = at; field + 4 <= end; field += 4 + u16(field + 2)) {
      if (u16(field) !== 1) continue;
      let next = field - 4;
      return narrow.map((n) => {
        if (n === 0xffffffff) next += 8;
        return n === 0xffffffff ? u64(next) : n;
      });
    }
    return narrow;
  }

  /** @type {Entry[]} */
  const entries = [];
  let { count, start: at } = list();
  for (; count > 0; count -= 1) {
    if (u32(at) !== 0x02014b50) throw damaged();
    const [flags, method, sum] = [u16(at + 8), u16(at + 10), u32(at + 16)];
    const [nameEnd, offset] = [at + 46 + u16(at + 28), u32(at + 42)];
    const extraEnd = nameEnd + u16(at + 30);
    const own = widened(nameEnd, extraEnd, [u32(at + 24), u32(at + 20), offset]);
    const name = new TextDecoder().decode(bytes.subarray(at + 46, nameEnd)).replaceAll("\\", "/");
    at = extraEnd + u16(at + 32);
    if (at > bytes.length) throw damaged();
    if (name.endsWith("/")) continue;
    const [size, packed, from] = own;
    entries.push({ name, size, read: () => unpacked({ size, packed, from, flags, method, sum }) });
  }
  return entries;

  /** @param {Record<"size" | "packed" | "from" | "flags" | "method" | "sum", number>} entry */
  async function unpacked({ size, packed, from, flags, method, sum }) {
    if (flags & 1) throw refusal("Encrypted", "unpack-encrypted");
    if (u32(from) !== 0x04034b50) throw damaged();
    const begin = from + 30 + u16(from + 26) + u16(from + 28);
    if (begin + packed > bytes.length) throw damaged();
    const inside = bytes.subarray(begin, begin + packed);
    if (size > mostOf(inside)) throw tooLarge(mostOf(inside));
    if (method !== 0 && method !== 8) throw refusal("Unsupported", "unpack-method", { method });
    // As gzip, whose end has the sum and the size that the browser then checks.
    const head = Uint8Array.of(0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 255);
    const end = new DataView(new ArrayBuffer(8));
    end.setUint32(0, sum, true);
    end.setUint32(4, size, true);
    return inflated([head, ...(method === 8 ? [inside] : blocksOf(inside)), end], size);
  }
}
