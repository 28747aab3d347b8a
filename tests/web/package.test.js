// @ts-check
// The package as others have it: installed from what `npm pack` makes into an empty project,
// imported in one line, checked by TypeScript, served and built by Vite.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, realpathSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build, createServer } from "vite";
import { launch, openPage, picture } from "./support/browser.js";
import { serve } from "./support/server.js";

const root = fileURLToPath(new URL("../..", import.meta.url));
// Not the link that a temporary folder is on some systems: Vite goes by where things are.
const project = realpathSync(mkdtempSync(path.join(tmpdir(), "umbilic-project-")));
/** Software graphics on a busy machine. */
const timeout = Number(process.env.UMBILIC_PATIENCE ?? 90_000);

const files = {
  "package.json": `{ "name": "notes", "private": true, "type": "module" }`,
  "index.html": `<!doctype html>
    <link rel="icon" href="data:," />
    <script type="module" src="./main.ts"></script>
    <umbilic-surface sample="icosahedron" colour="mean-curvature"></umbilic-surface>`,
  "main.ts": `
    import "umbilic/element";
    import type { UmbilicSurfaceAttributes } from "umbilic/element";

    const surface = document.querySelector("umbilic-surface");
    if (!surface) throw new Error("it is not there");
    surface.addEventListener("ready", async ({ detail }) => {
      const { step, energy } = await surface.step();
      const lower: boolean = energy !== null && detail.energy !== null && energy < detail.energy;
      document.title = \`step \${step}, \${detail.vertices} vertices, lower: \${lower}\`;
    });
    surface.addEventListener("error", ({ detail }) => {
      document.title = \`\${detail.message} \${detail.hint}\`;
    });

    // Never called: these are for the compiler.
    export async function typed() {
      const words: UmbilicSurfaceAttributes = { flow: "p-willmore", "smooth-steps": 3 };
      await surface?.set({ flow: "willmore", smoothSteps: 3 });
      // @ts-expect-error  no such flow
      await surface?.set({ flow: "whirlpool" });
      // @ts-expect-error  no such colour
      words.colour = "red";
      // @ts-expect-error  no number
      const file: number | undefined = await surface?.exportMesh("ply");
      // @ts-expect-error  nothing of the kind comes with this event
      surface?.addEventListener("key", ({ detail }) => detail.step);
      return [words, file];
    }`,
  "tsconfig.json": JSON.stringify({
    compilerOptions: {
      ...{ strict: true, noEmit: true, target: "es2022", module: "esnext", types: [] },
      ...{ moduleResolution: "bundler", lib: ["es2022", "dom"], skipLibCheck: true },
    },
    include: ["*.ts"],
  }),
  "vite.config.ts": `
    import { umbilic } from "umbilic/vite";
    export default { base: "/notes/", plugins: [umbilic()] };`,
  "plain.html": `<!doctype html>
    <link rel="icon" href="data:," />
    <script type="module" src="./node_modules/umbilic/dist/embed.js"></script>
    <umbilic-surface sample="icosahedron"></umbilic-surface>
    <script type="module">
      const surface = document.querySelector("umbilic-surface");
      surface.addEventListener("ready", async ({ detail }) => {
        const { step, energy } = await surface.step();
        document.title = \`step \${step}, \${detail.vertices} vertices, lower: \${energy < detail.energy}\`;
      });
    </script>`,
};

/** @param {string} program @param {string[]} parameters @param {string} cwd */
const run = (program, parameters, cwd) =>
  execFileSync(program, parameters, {
    cwd,
    encoding: "utf8",
    stdio: ["ignore", "pipe", "inherit"],
  });

/** @param {string[]} parameters @param {string} cwd */
function npm(parameters, cwd) {
  const quiet = [...parameters, "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"];
  const script = process.env.npm_execpath;
  return script?.endsWith(".js")
    ? run(process.execPath, [script, ...quiet], cwd)
    : run("npm", quiet, cwd);
}

/** @type {import("playwright-core").Browser} */
let browser;
before(async () => {
  for (const [name, text] of Object.entries(files)) writeFileSync(path.join(project, name), text);
  const [{ filename }] = JSON.parse(npm(["pack", "--json", "--pack-destination", project], root));
  npm(["install", "--offline", `./${filename}`], project);
  // As if it had been installed there as well.
  symlinkSync(path.join(root, "node_modules", "vite"), path.join(project, "node_modules", "vite"));
  browser = await launch({ webgpu: false });
});
after(async () => {
  await browser?.close();
  rmSync(project, { recursive: true, force: true });
});

/** What the surface of the project says of itself, once it is there. @param {string} url */
async function shown(url) {
  const { page, faults, close } = await openPage(browser, {
    viewport: { width: 500, height: 400 },
  });
  await page.goto(url);
  await page.waitForFunction(() => document.title !== "", null, { timeout });
  const title = await page.title();
  const end = Date.now() + timeout;
  while (title.startsWith("step") && (await picture(page.locator("iframe"))).colours <= 200) {
    assert.ok(Date.now() < end, "no surface on the screen");
  }
  assert.deepEqual(faults, []);
  await close();
  return title;
}

const there = "step 1, 2562 vertices, lower: true";
const settings = /** @type {const} */ ({ root: project, logLevel: "error" });

test("TypeScript knows attributes, methods and events", () => {
  run(process.execPath, [path.join(root, "node_modules/typescript/bin/tsc"), "-p", "."], project);
});

test("a project of Vite that imports it is built, and shows the surface", async (context) => {
  await build(settings);
  const server = await serve(path.join(project, "dist"), "/notes/");
  context.after(server.close);
  assert.equal(await shown(server.url), there);
});

test("the same project is served while it is written", async (context) => {
  const server = await createServer({ ...settings, server: { host: "127.0.0.1", port: 0 } });
  context.after(() => server.close());
  await server.listen();
  assert.equal(await shown(server.resolvedUrls?.local[0] ?? ""), there);
});

test("without the plugin the element says what is missing", async (context) => {
  const outDir = path.join(project, "without");
  await build({ ...settings, configFile: false, build: { outDir } });
  const server = await serve(outDir, "/");
  context.after(server.close);
  assert.match(await shown(server.url), /Add the plugin `umbilic\/vite`/);
});

test("the same files do behind a script tag on any host", async (context) => {
  const server = await serve(project, "/any/folder/");
  context.after(server.close);
  assert.equal(await shown(`${server.url}plain.html`), there);
});

test("the command line comes along", () => {
  const program = path.join(project, "node_modules", ".bin", "umbilic");
  const sphere = path.join(project, "sphere.obj");
  run(process.execPath, [realpathSync(program), "shape", "icosphere", "--out", sphere], project);
  const info = run(process.execPath, [realpathSync(program), "info", sphere, "--json"], project);
  assert.equal(JSON.parse(info).genus, 0);
});
