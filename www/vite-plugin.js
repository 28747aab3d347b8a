// The plugin `umbilic/vite`: <umbilic-surface> in a project that Vite serves and builds. The
// element shows a page that comes in many files, which no bundler follows by itself; they are
// served, and copied to what is built, below `umbilic/`.

import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";

/** The built site. */
const site = path.join(import.meta.dirname, "../dist/");
const script = path.join(site, "embed.js");
/** How the element says where it is. */
const place = "import.meta.url";
/** Where the site is in the project's own. */
const folder = "umbilic/";

/** @type {Record<string, string>} */
const types = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".json": "application/json",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
  ".webp": "image/webp",
  ".woff2": "font/woff2",
};

/** What a web server says that a file of the site is. @param {string} file */
export const typeOf = (file) => types[path.extname(file)] ?? "application/octet-stream";

/** @param {string} within  a folder @returns {string[]} the files in it, with slashes, sorted */
export const filesIn = (within) =>
  readdirSync(within, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(within, path.join(entry.parentPath, entry.name)))
    .map((file) => file.split(path.sep).join("/"))
    .sort();

/** @returns {import("vite").Plugin} */
export function umbilic() {
  let base = "/";
  let isServing = false;
  return {
    name: "umbilic",
    // Bundled beforehand, the element would not come by here.
    config: () => ({ optimizeDeps: { exclude: ["umbilic"] } }),
    configResolved(config) {
      base = config.base;
      isServing = config.command === "serve";
    },

    configureServer({ middlewares }) {
      middlewares.use((request, response, next) => {
        const { pathname } = new URL(request.url ?? "/", "http://localhost");
        const start = `${base}${folder}`;
        const inside = decodeURIComponent(pathname.slice(start.length)) || "index.html";
        const file = path.join(site, inside);
        if (!pathname.startsWith(start) || !file.startsWith(site)) return next();
        try {
          const bytes = readFileSync(file);
          response.writeHead(200, { "content-type": typeOf(file) }).end(bytes);
        } catch {
          next();
        }
      });
    },

    transform(code, id) {
      if (path.normalize(id.split("?")[0]) !== script) return null;
      if (isServing) {
        const address = JSON.stringify(`${base}${folder}embed.js`);
        return code.replace(place, () => `new URL(${address}, location.origin).href`);
      }
      let copied = "";
      for (const name of filesIn(site)) {
        const source = readFileSync(path.join(site, name));
        const asset = this.emitFile({ type: "asset", fileName: folder + name, source });
        if (name === "embed.js") copied = asset;
      }
      // From there on: it may be a path from the root, and another place with a relative base.
      const address = `import.meta.ROLLUP_FILE_URL_${copied}`;
      return code.replace(place, () => `new URL(${address}, ${place}).href`);
    },
  };
}
