// A plugin of vite: the names of what a wasm file imports, which end in a hash each, by numbers. No
// compression makes hashes smaller, and only the script of wasm-bindgen knows them.

import { readFileSync } from "node:fs";
import path from "node:path";

const hashed = /__wb\w+_[0-9a-f]{16}/g;

/** @returns {import("vite").Plugin} */
export function shortNames() {
  /** Files with other names in them, by their own. @type {Map<string, Buffer>} */
  const renamed = new Map();
  return {
    name: "short-names",
    apply: "build",
    transform(code, id) {
      const [, stem] = /^(.*\/pkg\/[\w-]+\/[\w-]+)\.js$/.exec(id) ?? [];
      if (!stem) return null;
      const file = `${stem}_bg.wasm`;
      /** @type {Map<string, string>} */
      const names = new Map();
      // Of the same length, so that nothing moves in the file.
      const wasm = readFileSync(file, "latin1").replace(hashed, (name) => {
        names.set(name, names.size.toString(36).padStart(name.length, "_"));
        return names.get(name) ?? name;
      });
      renamed.set(path.basename(file), Buffer.from(wasm, "latin1"));
      return code.replace(hashed, (name) => names.get(name) ?? name);
    },
    generateBundle(_, files) {
      for (const file of Object.values(files)) {
        const wasm = file.type === "asset" && renamed.get(file.names[0]);
        if (wasm) file.source = wasm;
      }
    },
  };
}
