// @ts-check
// The page inside pages of another origin: the element, a bare iframe, and what neither may do.

import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { measure } from "./support/browser.js";
import { obj, wavyTorus } from "./support/meshes.js";
import { site as built, serve } from "./support/server.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

const folder = mkdtempSync(path.join(tmpdir(), "umbilic-host-"));
/** @type {Awaited<ReturnType<typeof serve>>} */
let host;
before(async () => {
  writeFileSync(path.join(folder, "wavy.obj"), obj(wavyTorus(24, 12)));
  host = await serve(folder, "/");
});
after(async () => {
  await host?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** One sample a pixel, as everywhere in these tests. */
const quick = () => `page="${site.url}?msaa=1"`;

/**
 * A page of another origin, with something in it.
 * @param {string} body
 */
async function hostPage(body) {
  const name = `${Math.random().toString(36).slice(2)}.html`;
  writeFileSync(
    path.join(folder, name),
    `<!doctype html><html lang="en"><title>Host</title><link rel="icon" href="data:,">
    <script type="module" src="${site.url}embed.js"></script>
    <script>
      window.told = [];
      for (const type of ["ready", "frame", "statechange", "error"]) {
        addEventListener(type, (event) => event.detail && told.push([type, event.detail]), true);
      }
    </script>
    <style>umbilic-surface, iframe { width: 480px; height: 360px; aspect-ratio: auto }</style>
    <main><h1>Host</h1>${body}</main></html>`,
  );
  const opened = await site.blank();
  // As browsers do to pages in pages of others.
  await opened.page.addInitScript(() => {
    Object.defineProperty(globalThis, "localStorage", {
      get: () => {
        throw new DOMException("denied", "SecurityError");
      },
    });
  });
  await opened.page.goto(host.url + name);
  return opened;
}

/**
 * Calls a method of the first element, and answers what it comes to.
 * @param {Page} page @param {string} method @param {unknown[]} values
 */
const call = (page, method, ...values) =>
  page.evaluate(
    ([name, parameters]) => {
      const element = /** @type {any} */ (document.querySelector("umbilic-surface"));
      return element[/** @type {string} */ (name)](.../** @type {unknown[]} */ (parameters)).then(
        (/** @type {unknown} */ ok) => ok,
        (/** @type {any} */ { kind, message, hint }) => ({ refused: { kind, message, hint } }),
      );
    },
    /** @type {const} */ ([method, values]),
  );

/** What an event told last. @param {Page} page @param {string} type */
const last = (page, type) =>
  page.evaluate(
    (wanted) =>
      /** @type {any} */ (globalThis).told.findLast(
        (/** @type {any} */ [one]) => one === wanted,
      )?.[1],
    type,
  );

/** @param {Page} page @param {string} type @param {(detail: any) => boolean} [is] */
async function heard(page, type, is = () => true) {
  for (const end = Date.now() + 60_000; ; ) {
    const detail = await last(page, type);
    if (detail && is(detail)) return detail;
    if (Date.now() > end) throw new Error(`${type}: ${JSON.stringify(detail)}`);
    await page.waitForTimeout(50);
  }
}

/** The page in the iframe. @param {Page} page */
const inside = (page) => page.frameLocator("iframe").first();

test("the script is one small file", () => {
  const script = readFileSync(path.join(built, "embed.js"), "utf8");
  assert.ok(script.length < 8000, `${script.length} bytes`);
  assert.doesNotMatch(script, /\bimport\s*[({"']|\bfrom\s*["']/);
});

test("the element plays, steps, seeks, is set, and gives its mesh away", async () => {
  const { page, faults, close } = await hostPage(
    `<umbilic-surface ${quick()} sample="bumpy-sphere" colour="mean-curvature" max-steps="90"></umbilic-surface>`,
  );
  const ready = await heard(page, "ready");
  assert.equal(ready.name, "bumpy-sphere");
  assert.equal(ready.step, 0);
  assert.equal(ready.phase, "ready", "and does not play by itself");
  assert.match(ready.version, /^\d+\.\d+/);

  const stepped = await call(page, "step");
  assert.equal(stepped.step, 1);
  assert.ok(stepped.energy < ready.energy && stepped.area > 0 && stepped.time > 0);
  const sought = await call(page, "seek", 4);
  assert.equal(sought.step, 4);
  const back = await call(page, "seek", 3);
  assert.equal(back.step, 3);
  // The same steps give the same numbers: from the start, and from where it was.
  const again = await call(page, "seek", 1);
  assert.equal(again.step, 1);
  assert.equal(again.energy, stepped.energy);
  assert.deepEqual((await call(page, "reset")).energy, ready.energy);

  const set = await call(page, "set", { flow: "p-willmore", p: 2, keep: ["area", "volume"] });
  assert.equal(set.flow, "p-willmore");
  assert.notEqual(set.energy, ready.energy);
  await page.evaluate(() => {
    const element = /** @type {Element} */ (document.querySelector("umbilic-surface"));
    element.setAttribute("flow", "circle");
    element.setAttribute("shading", "flat");
  });
  await heard(page, "frame", ({ flow, step }) => flow === "circle" && step === 0);
  // Each flow has an energy of its own, and no frame tells that of another.
  const starts = await page.evaluate(() =>
    /** @type {any} */ (globalThis).told
      .filter((/** @type {any} */ [type, { step }]) => type === "frame" && step === 0)
      .map((/** @type {any} */ [, { flow, energy }]) => [flow, energy]),
  );
  assert.deepEqual(starts.slice(-2), [
    ["p-willmore", set.energy],
    ["circle", ready.energy],
  ]);
  for (const [flow, energy] of starts) {
    assert.equal(energy, flow === "circle" ? ready.energy : set.energy);
  }

  const playing = await call(page, "play");
  assert.equal(playing.phase, "running");
  await heard(page, "frame", ({ step }) => step >= 2);
  const paused = await call(page, "pause");
  assert.ok(["paused", "ready"].includes(paused.phase), paused.phase);
  assert.ok(paused.step >= 2);
  const phases = await page.evaluate(() =>
    /** @type {any} */ (globalThis).told
      .filter((/** @type {any} */ [type]) => type === "statechange")
      .map((/** @type {any} */ [, detail]) => detail.phase),
  );
  assert.ok(phases.includes("running"), String(phases));

  const mesh = await page.evaluate(async () => {
    const element = /** @type {any} */ (document.querySelector("umbilic-surface"));
    const file = await element.exportMesh("obj");
    return { name: file.name, text: await file.text() };
  });
  assert.match(mesh.name, /^bumpy-sphere-circle-step\d{4}\.obj$/);
  assert.equal(mesh.text.match(/^v /gm)?.length, 2562);

  // Words of other people are refused by name, and change nothing.
  for (const [words, said] of /** @type {const} */ ([
    [{ tau: -1 }, /`tau` cannot be `-1`/],
    [{ colour: "<img src=x>" }, /“colour” cannot be “<img src=x>”/],
    [{ innerHTML: "x" }, /no option `innerHTML`/],
  ])) {
    const { refused } = await call(page, "set", words);
    assert.match(refused?.message ?? "", said);
  }
  assert.match((await call(page, "seek", -3)).refused.message, /whole number/);
  assert.match((await call(page, "exportMesh", "exe")).refused.message, /no format “exe”/);
  assert.match(
    (await call(page, "load", { figure: "no-such" })).refused.message,
    /there is no figure `no-such`/,
  );
  assert.equal((await call(page, "state")).step, paused.step);
  // Another scene altogether.
  const loaded = await call(page, "load", "sample=pipe&step=2");
  assert.equal(loaded.name, "pipe");
  assert.equal(loaded.step, 2);

  assert.equal(await inside(page).locator("#drawer").isVisible(), false);
  const address = await inside(page).getByRole("link", { name: "Full page" }).getAttribute("href");
  assert.ok(address?.startsWith(site.url));
  const { colours } = measure(await page.locator("umbilic-surface").screenshot());
  assert.ok(colours > 200, `${colours} colours`);
  assert.deepEqual(await accessibilityFaults(page), []);
  assert.deepEqual(faults, []);
  await close();
});

test("a mesh of the embedding page is shown, and what cannot be had is said", async () => {
  const { page, faults, close } = await hostPage(
    `<umbilic-surface ${quick()} mesh="wavy.obj" step="1" title="A wavy torus"></umbilic-surface>`,
  );
  const ready = await heard(page, "ready");
  assert.deepEqual([ready.name, ready.vertices, ready.step], ["wavy", 288, 1]);
  assert.equal(await inside(page).getByRole("alert").count(), 0);
  assert.equal(await page.locator("iframe").getAttribute("title"), "A wavy torus");
  // A broken mesh is refused in words, and the one before stays.
  const refused = await page.evaluate(() =>
    /** @type {any} */ (document.querySelector("umbilic-surface"))
      .load(new File(["v 0 0 0\nf 1 2 3\n"], "broken.obj"))
      .then(null, (/** @type {Error} */ error) => error.message),
  );
  assert.match(refused, /vertex/i);
  assert.equal((await call(page, "state")).name, "wavy");
  assert.deepEqual(faults, []);
  await page.evaluate(() =>
    document.querySelector("umbilic-surface")?.setAttribute("mesh", "none.obj"),
  );
  const error = await heard(page, "error", ({ message }) => message.includes("none.obj"));
  assert.match(error.message, /404/);
  await close();
});

test("in a sandbox of no origin the page says what it lacks", async () => {
  const { page, close } = await hostPage(
    `<iframe title="Umbilic" sandbox="allow-scripts" src="${site.url}?msaa=1&embed#sample=pipe"></iframe>`,
  );
  const alert = inside(page).getByRole("alert");
  await alert.getByText(/The solver may not be started here/).waitFor();
  assert.match((await alert.textContent()) ?? "", /needs `allow-same-origin`/);
  await inside(page).getByRole("status").getByText("The solver is not running").waitFor();
  await close();
});

test("embedded, the page breaks no rule of accessibility, whatever its size", async () => {
  for (const [width, colorScheme] of /** @type {const} */ ([
    [960, "light"],
    [320, "dark"],
  ])) {
    const context = { viewport: { width, height: 400 }, colorScheme };
    const { page, faults, close } = await site.open("sample=pipe", context, "msaa=1&embed");
    assert.deepEqual(await accessibilityFaults(page), [], `${width} wide, ${colorScheme}`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    assert.equal(wide, false);
    await page.keyboard.press(".");
    await page.getByRole("status").getByText("Paused at step 1").waitFor();
    assert.deepEqual(faults, []);
    await close();
  }
});

test("a bare iframe answers its own parent, in order, and passes nonsense over", async () => {
  const { page, faults, close } = await hostPage(
    `<iframe id="bare" title="Umbilic" src="${site.url}?msaa=1&embed&controls=none#sample=icosahedron"></iframe>
    <script>
      window.said = [];
      addEventListener("message", ({ data, source }) => {
        if (source === document.querySelector("#bare").contentWindow) said.push(data);
      });
    </script>`,
  );
  const said = () => page.evaluate(() => /** @type {any} */ (globalThis).said);
  await page.waitForFunction(() =>
    /** @type {any} */ (globalThis).said.some((/** @type {any} */ { event }) => event === "ready"),
  );
  await page.evaluate(() => {
    const frame = /** @type {HTMLIFrameElement} */ (document.querySelector("#bare"));
    const post = (/** @type {unknown} */ data) => frame.contentWindow?.postMessage(data, "*");
    const nonsense = [null, 7, "umbilic", [], {}, { umbilic: 2, id: 1, type: "play" }];
    for (const data of nonsense) post(data);
    post({ umbilic: 1, type: "play" });
    post({ umbilic: 1, id: {}, type: "play" });
    post({ umbilic: 1, id: 1, type: 3 });
    post({ umbilic: 1, id: "a", type: "constructor" });
    post({ umbilic: 1, id: "b", type: "load", name: "../x", bytes: "no" });
    post({ umbilic: 1, id: "c", type: "seek", step: 2 });
    post({ umbilic: 1, id: "d", type: "export", format: "ply" });
  });
  await page.waitForFunction(() =>
    /** @type {any} */ (globalThis).said.some((/** @type {any} */ { id }) => id === "d"),
  );
  const replies = (await said()).filter((/** @type {any} */ data) => "id" in data);
  assert.deepEqual(
    replies.map((/** @type {any} */ { id }) => id),
    ["a", "b", "c", "d"],
  );
  assert.match(replies[0].error.message, /no request “constructor”/);
  assert.match(replies[1].error.message, /`bytes`/);
  assert.equal(replies[2].ok.step, 2);
  assert.equal(replies[3].ok.name, "icosahedron-circle-step0002.ply");
  assert.equal(await inside(page).locator(".transport").isVisible(), false);
  // Another window than the parent, even of its origin, is not answered.
  const before = (await said()).length;
  await page.evaluate(() => {
    const other = document.createElement("iframe");
    other.srcdoc = `<script>
      parent.document.querySelector("#bare").contentWindow.postMessage({ umbilic: 1, id: "e", type: "state" }, "*");
    </script>`;
    document.body.append(other);
    return new Promise((resolve) => other.addEventListener("load", resolve));
  });
  await page.waitForTimeout(400);
  assert.equal((await said()).length, before);
  assert.deepEqual(faults, []);
  await close();
});

test("a flood of requests is refused by name beyond a hundred, and the others are answered", async () => {
  const { page, faults, close } = await hostPage(
    `<iframe id="bare" title="Umbilic" src="${site.url}?msaa=1&embed&controls=none#sample=icosahedron"></iframe>
    <script>
      window.said = [];
      addEventListener("message", ({ data, source }) => {
        if (source === document.querySelector("#bare").contentWindow) said.push(data);
      });
    </script>`,
  );
  const answered = (/** @type {string} */ id) =>
    page.waitForFunction(
      (wanted) =>
        /** @type {any} */ (globalThis).said.some(
          (/** @type {any} */ one) => one.id === wanted || one.event === wanted,
        ),
      id,
    );
  await answered("ready");
  await page.evaluate(() => {
    const frame = /** @type {HTMLIFrameElement} */ (document.querySelector("#bare"));
    const post = (/** @type {any} */ data) =>
      frame.contentWindow?.postMessage({ umbilic: 1, ...data }, "*");
    // Behind one that takes its time.
    post({ id: 0, type: "load", scene: "sample=bumpy-sphere" });
    for (let n = 1; n < 250; n += 1) post({ id: n, type: "set", words: { shading: "flat" } });
    post({ id: "now", type: "state" });
  });
  await answered("now");
  await page.waitForFunction(
    () =>
      /** @type {any} */ (globalThis).said.filter((/** @type {any} */ one) => "id" in one)
        .length === 251,
  );
  const replies = await page.evaluate(() =>
    /** @type {any} */ (globalThis).said.filter(
      (/** @type {any} */ { id }) => typeof id === "number",
    ),
  );
  const refused = replies.filter((/** @type {any} */ { error }) => error);
  assert.equal(refused.length, 150);
  for (const { error } of refused) assert.equal(error.kind, "TooManyRequests");
  const done = replies
    .filter((/** @type {any} */ { ok }) => ok)
    .map((/** @type {any} */ { id }) => id);
  assert.deepEqual(
    done,
    Array.from({ length: 100 }, (_, n) => n),
  );
  // Room again.
  await page.evaluate(() => {
    const frame = /** @type {HTMLIFrameElement} */ (document.querySelector("#bare"));
    frame.contentWindow?.postMessage({ umbilic: 1, id: "after", type: "step" }, "*");
  });
  await answered("after");
  assert.deepEqual(faults, []);
  await close();
});

test("what nobody sees neither starts nor runs, and goes on when it is seen again", async () => {
  const { page, faults, close } = await hostPage(
    `<umbilic-surface ${quick()} sample="coarse-torus" autoplay max-steps="99999"></umbilic-surface>
    <div style="height: 6000px"></div>
    <umbilic-surface id="far" ${quick()} sample="pipe"></umbilic-surface>`,
  );
  await heard(page, "frame", ({ step }) => step >= 2);
  assert.equal(page.workers().length, 1, "the far one has no solver yet");
  await page.evaluate(() => scrollTo(0, 2500));
  const paused = await heard(page, "statechange", ({ phase }) => phase === "paused");
  assert.equal(paused.isWaiting, true);
  await page.waitForTimeout(500);
  assert.equal((await call(page, "state")).step, paused.step);
  // Played while it is hidden, it waits as well.
  const waits = await call(page, "play");
  assert.deepEqual([waits.isWaiting, waits.phase], [true, "paused"]);
  await page.evaluate(() => scrollTo(0, 0));
  await heard(page, "frame", ({ step }) => step > paused.step);
  // A pause that is asked for holds when it comes back.
  await call(page, "pause");
  const held = await call(page, "state");
  await page.evaluate(() => scrollTo(0, 2500));
  await page.waitForTimeout(300);
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForTimeout(300);
  assert.equal((await call(page, "state")).step, held.step);
  assert.deepEqual(faults, []);
  await close();
});
