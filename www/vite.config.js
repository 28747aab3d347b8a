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

/** The same of the words of a language. */
const compactWords = {
  name: "compact-words",
  enforce: /** @type {const} */ ("pre"),
  load(/** @type {string} */ id) {
    if (!id.endsWith(".ftl?raw")) return null;
    const words = readFileSync(id.replace("?raw", ""), "utf8").replace(/^(?:#.*)?\n/gm, "");
    return `export default ${JSON.stringify(words)};`;
  },
};

const here = (/** @type {string} */ file) => fileURLToPath(new URL(file, import.meta.url));

export default defineConfig({
  root: here(".."),
  // Relative addresses: the site works from any folder of any host.
  base: "./",
  // Copied as they are: the manifest and its icons.
  publicDir: "www/public",
  plugins: [
    ...[compactHtml, compactWords, shortNames(), webglOnDemand()],
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
      },
    },
  },
  worker: { format: "es" },
});
