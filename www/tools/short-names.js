// A plugin of vite: shorter names for what a wasm file imports. Those of wasm-bindgen end in a hash
// each, which no compression makes smaller; only its own script knows them.

import { readFileSync } from "node:fs";
import path from "node:path";

const IMPORTS = 2;

/** A number as wasm writes it (LEB128, unsigned). @param {number} value @returns {number[]} */
const leb = (value) => (value < 128 ? [value] : [(value & 127) | 128, ...leb(value >>> 7)]);

/** What reads a wasm file from a place on. @param {Uint8Array} bytes @param {number} at */
function readerOf(bytes, at) {
  const take = (/** @type {number} */ count) => {
    at += count;
    return bytes.subarray(at - count, at);
  };
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const [byte] = take(1);
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  return { take, number, place: () => at };
}

/**
 * A wasm file with other names of the functions it imports, and which has become which.
 * @param {Uint8Array} wasm
 */
function shorten(wasm) {
  /** @type {Map<string, string>} */
  const names = new Map();
  const parts = [wasm.subarray(0, 8)];
  const file = readerOf(wasm, 8);
  while (file.place() < wasm.length) {
    const [kind] = file.take(1);
    const section = file.take(file.number());
    const body = kind === IMPORTS ? shortImports(section, names) : section;
    parts.push(Uint8Array.of(kind, ...leb(body.length)), body);
  }
  return { wasm: Buffer.concat(parts), names };
}

/** @param {Uint8Array} section @param {Map<string, string>} names  to which its own are added */
function shortImports(section, names) {
  const { take, number } = readerOf(section, 0);
  const count = number();
  /** @type {number[]} */
  const out = leb(count);
  for (let n = 0; n < count; n += 1) {
    const module = take(number());
    const name = Buffer.from(take(number())).toString();
    const [kind] = take(1);
    if (kind !== 0) throw new Error(`${name} is imported and no function`);
    const short = `i${n.toString(36)}`;
    names.set(name, short);
    out.push(...leb(module.length), ...module, ...leb(short.length), ...Buffer.from(short));
    out.push(kind, ...leb(number()));
  }
  return Uint8Array.from(out);
}

/** @returns {import("vite").Plugin} */
export function shortNames() {
  /** Files with shorter names, by their own. @type {Map<string, Buffer>} */
  const shortened = new Map();
  return {
    name: "short-names",
    apply: "build",
    transform(code, id) {
      const [, stem] = /^(.*\/pkg\/[\w-]+\/[\w-]+)\.js$/.exec(id) ?? [];
      if (!stem) return null;
      const { wasm, names } = shorten(readFileSync(`${stem}_bg.wasm`));
      shortened.set(path.basename(`${stem}_bg.wasm`), wasm);
      return code.replace(/\b__wb\w+/g, (name) => names.get(name) ?? name);
    },
    generateBundle(_, files) {
      for (const file of Object.values(files)) {
        const wasm = file.type === "asset" && shortened.get(file.names[0]);
        if (wasm) file.source = wasm;
      }
    },
  };
}
