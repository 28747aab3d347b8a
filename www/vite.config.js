import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { serviceWorker } from "./tools/service-worker.js";
import { shortNames } from "./tools/short-names.js";
import { webglOnDemand } from "./tools/webgl.js";

/** Indentation and comments are for whoever reads the source. */
const compactHtml = {
  name: "compact-html",
  apply: /** @type {const} */ ("build"),
  transformIndexHtml: {
    order: /** @type {const} */ ("post"),
    handler: (/** @type {string} */ html) =>
      html.replace(/<!--.*?-->/gs, "").replace(/\s*\n\s*/g, "\n"),
  },
};

/** The development server puts styles that come later into the page itself. */
const inlineStyles = {
  name: "inline-styles",
  apply: /** @type {const} */ ("serve"),
  transformIndexHtml: (/** @type {string} */ html) =>
    html.replace("style-src 'self'", "style-src 'self' 'unsafe-inline'"),
};

/** Comments of the words of a language, likewise. */
const compactWords = {
  name: "compact-words",
  enforce: /** @type {const} */ ("pre"),
  load(/** @type {string} */ id) {
    if (!id.endsWith(".ftl?raw")) return null;
    const words = readFileSync(id.replace("?raw", ""), "utf8").replace(/^(?:#.*)?\n/gm, "");
    return `export default ${JSON.stringify(words)};`;
  },
};

/**
 * The pages that cannot begin without a module.
 * @param {string} id @param {import("rolldown").ChunkingContext} graph
 * @param {Set<string>} [seen] @returns {string[]}
 */
function pagesWith(id, graph, seen = new Set()) {
  if (seen.has(id)) return [];
  seen.add(id);
  const info = graph.getModuleInfo(id);
  const own = info?.isEntry ? [id] : [];
  return [...own, ...(info?.importers ?? []).flatMap((one) => pagesWith(one, graph, seen))];
}

const here = (/** @type {string} */ file) => fileURLToPath(new URL(file, import.meta.url));

export default defineConfig({
  root: here(".."),
  // Relative addresses: the site works from any folder of any host.
  base: "./",
  // Copied as they are: the manifest and its icons.
  publicDir: "www/public",
  plugins: [
    ...[compactHtml, inlineStyles, compactWords, shortNames(), webglOnDemand()],
    serviceWorker(here("service-worker.js")),
  ],
  build: {
    outDir: "dist",
    emptyOutDir: true,
    target: "es2022",
    sourcemap: false,
    // Everything is a file of its own: the page's policy forbids `data:` but for pictures.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: {
        index: here("../index.html"),
        demo: here("../demo.html"),
        "first-look": here("guide/first-look.html"),
        lecture: here("guide/lecture.html"),
        mesh: here("guide/mesh.html"),
        embed: here("embed.js"),
      },
      output: {
        // Other pages name it: it keeps its name, and is all in one file.
        entryFileNames: ({ name }) => (name === "embed" ? "embed.js" : "assets/[name]-[hash].js"),
        // A small picture of before harms nobody: a hash of each in the script is two kilobytes.
        assetFileNames: ({ names: [name] }) =>
          name.endsWith(".webp") ? "assets/[name][extname]" : "assets/[name]-[hash][extname]",
        // What the page begins with is one file, whatever else uses a part of it: it is smaller than
        // many, and there is nothing to wait for in between. But for what waits for other files, which
        // may use it.
        codeSplitting: {
          includeDependenciesRecursively: false,
          groups: [
            {
              test: (id) => ![here("../index.html"), here("main.js")].includes(id),
              name: (id, graph) =>
                pagesWith(id, graph).join() === here("../index.html") ? "first" : null,
              debugName: "first",
            },
          ],
        },
      },
    },
  },
  worker: { format: "es" },
});
