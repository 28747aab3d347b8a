import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { serviceWorker } from "./tools/service-worker.js";
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

const guide = Object.fromEntries(
  ["first-look", "lecture", "mesh"].map((name) => [
    name,
    fileURLToPath(new URL(`guide/${name}.html`, import.meta.url)),
  ]),
);

export default defineConfig({
  root: fileURLToPath(new URL("..", import.meta.url)),
  // Relative addresses: the site works from any folder of any host.
  base: "./",
  // Copied as they are: the manifest and its icons.
  publicDir: "www/public",
  plugins: [
    compactHtml,
    compactWords,
    webglOnDemand(),
    serviceWorker(fileURLToPath(new URL("service-worker.js", import.meta.url))),
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
        index: fileURLToPath(new URL("../index.html", import.meta.url)),
        demo: fileURLToPath(new URL("../demo.html", import.meta.url)),
        ...guide,
        embed: fileURLToPath(new URL("embed.js", import.meta.url)),
      },
      output: {
        // Other pages name it: it keeps its name, and is all in one file.
        entryFileNames: ({ name }) => (name === "embed" ? "embed.js" : "assets/[name]-[hash].js"),
      },
    },
  },
  worker: { format: "es" },
});
