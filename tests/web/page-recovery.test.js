// @ts-check
// The solver's worker lost in the middle of a run: said in words, replaced by a new one
// that goes on from the last picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import { loadSolver } from "../../www/cli/solver.js";
import { perform } from "../../www/session.js";
import {
  button,
  choice,
  download,
  energy,
  openMesh,
  openTab,
  playAndPause,
  plotted,
  reading,
  stillPicture,
  surface,
  until,
  untilPictured,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

/** The error on screen, when there is one, with its hint. @param {Page} page */
async function firstError(page) {
  const said = page.getByRole("alert").filter({ has: page.locator(".what") });
  await said.waitFor();
  return ((await said.textContent()) ?? "").replace(/\s+/g, " ").trim();
}

/**
 * Gives workers a solver that reads outside its memory at a time of their own, or goes on for ever:
 * a true trap of true wasm.
 * @param {Page} page
 * @param {(n: number) => { at: string, how?: "trap" | "hang" } | null} spoils  when the nth worker is
 *   lost, in terms of `shown`, pictures, and `asked`, requests; null: never
 */
async function spoilWorkers(page, spoils) {
  let served = 0;
  await page.route(/worker-[^/]*\.js$/, async (route) => {
    served += 1;
    const spoil = spoils(served);
    if (!spoil) return route.continue();
    const { at, how = "trap" } = spoil;
    const response = await route.fetch();
    const trap = `{
      let shown = 0;
      let asked = 0;
      const spoil = ({ instance, module }) => {
        const { session_frame, session_perform } = instance.exports;
        const spoiled = {
          session_frame: (self) => {
            shown += 1;
            return session_frame(self);
          },
          session_perform: (self, command) => {
            asked += 1;
            while (${how === "hang"} && ${at});
            return session_perform(${at} ? -64 : self, command);
          },
        };
        return { module, instance: { exports: { ...instance.exports, ...spoiled } } };
      };
      for (const name of ["instantiate", "instantiateStreaming"]) {
        const original = WebAssembly[name];
        WebAssembly[name] = (...parameters) => original(...parameters).then(spoil);
      }
    }`;
    return route.fulfill({ response, body: trap + (await response.text()) });
  });
  return () => served;
}

/** @param {string} said @returns {number} the step an error says the solver goes on from */
const stepIn = (said) => Number(/step (\d+)/.exec(said)?.[1]);

test("a trap in the middle of a run costs nothing but the step it was in", async () => {
  const { page, faults, close } = await site.blank();
  // Those of both meshes at rest, and the first of a run.
  const workers = await spoilWorkers(page, (n) => (n === 1 ? { at: "shown === 3" } : null));
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  const atStart = await energy(page);
  await button(page, "Play").click();
  const said = await firstError(page);
  assert.match(said, /solver crashed.*goes on from step \d+/);
  assert.match(said, /memory/, "with what to do");
  const step = stepIn(said);
  assert.ok(step >= 1, `steps were shown, and it goes on from ${step}`);
  await until(page, `Paused at step ${step}`);
  assert.equal(workers(), 2);
  assert.match(await surface(page), new RegExp(`^Surface: \\S+, step ${step}, `));
  const restored = await energy(page);
  assert.ok(restored < atStart);

  const later = await playAndPause(page, 2);
  assert.ok(later >= step + 2);
  assert.ok((await energy(page)) < restored, "the new worker goes on downhill");
  assert.deepEqual(faults, []);
  await close();
});

test("an exception that nobody caught is survived, colours and options with it", async () => {
  const { page, faults, close } = await site.open(
    "sample=bumpy-sphere&epsilon=0.05&colour=willmore",
  );
  await openTab(page, "Measure");
  const started = await stillPicture(page);
  for (const step of [1, 2, 3]) {
    await button(page, "Step").click();
    await until(page, `Paused at step ${step}`);
  }
  const before = [await surface(page), await reading(page, "Time")];
  // Three steps are to be seen.
  await untilPictured(page, started, (mean) => mean > 0.5);
  const seen = await stillPicture(page);
  await page.workers()[0].evaluate(() => {
    setTimeout(() => {
      throw new Error("made by the test");
    });
  });
  const said = await firstError(page);
  assert.match(said, /made by the test/);
  assert.equal(stepIn(said), 3);
  await until(page, "Paused at step 3");
  assert.deepEqual([await surface(page), await reading(page, "Time")], before);
  await page.waitForFunction(() => location.hash.includes("epsilon=0.05"));
  await page.getByRole("img", { name: /^Colours: Willmore/ }).waitFor();
  await button(page, "Dismiss").click();
  // The picture is the last one's.
  await untilPictured(page, seen, (mean) => mean < 0.05);
  await button(page, "Step").click();
  await until(page, "Paused at step 4");
  assert.deepEqual(
    (await plotted(page)).map(([step]) => step),
    [3, 4],
    "the history has begun anew",
  );
  // The browser itself prints what the worker threw.
  assert.deepEqual(
    faults.filter((fault) => !fault.includes("made by the test")),
    [],
  );
  await close();
});

/** What a session that reads a PLY has of its mesh and its energy. @param {Buffer} bytes */
async function opened(bytes) {
  const { Session } = await loadSolver();
  const session = new Session();
  perform(session, "load", { bytes: new Uint8Array(bytes), name: "saved.ply" });
  const { vertices, edges, faces, closed, minAngleDegrees } = perform(session, "info");
  const { state } = perform(session, "configure", { options: { flow: "p-willmore" } });
  session.free();
  return { vertices, edges, faces, closed, minAngleDegrees, energy: state.energy };
}

test("a remeshed surface outlives its worker with its own triangles, as file and on screen", async () => {
  const { page, close } = await site.blank();
  let isBroken = true;
  // The last for good, until it is mended.
  await spoilWorkers(page, (n) => (n > 2 && isBroken ? { at: "asked === 2" } : null));
  await page.goto(`${site.url}?msaa=1#sample=morin&step=40`);
  await until(page, "Paused at step 40");
  const shown = async () => ({
    surface: await surface(page),
    energy: await energy(page),
    vertices: await reading(page, "Vertices"),
    faces: await reading(page, "Faces"),
  });
  const before = await shown();
  assert.notEqual(before.vertices, "1200", "passes were made");
  const saved = (await download(page, "PLY")).bytes;
  const whole = await opened(saved);
  assert.deepEqual([whole.vertices, whole.faces].map(String), [before.vertices, before.faces]);
  assert.ok(whole.closed && Math.abs(whole.energy / before.energy - 1) < 1e-5);

  const crash = (/** @type {string} */ word) =>
    page.workers()[0].evaluate((word) => {
      setTimeout(() => {
        throw new Error(word);
      });
    }, word);
  await crash("the first");
  assert.match(await firstError(page), /the first.*goes on from step 40.*stored steps are gone/);
  await until(page, "Paused at step 40");
  assert.deepEqual(await shown(), before);
  // To the last digit, though a face may begin at another corner.
  assert.deepEqual(await opened((await download(page, "PLY")).bytes), whole);
  await button(page, "Step").click();
  await until(page, "Paused at step 41");
  const next = await shown();
  assert.ok(next.energy < 1.02 * before.energy, `${next.energy} after ${before.energy}`);

  // Where none can be had, the page's own copy has the triangles that are shown.
  await crash("the second");
  await page
    .getByRole("alert")
    .getByText(/each time the surface was to be restored/)
    .waitFor();
  const own = await opened((await download(page, "OBJ")).bytes);
  assert.deepEqual([own.vertices, own.faces].map(String), [next.vertices, next.faces]);
  assert.ok(own.closed && Math.abs(own.energy / next.energy - 1) < 1e-5);
  isBroken = false;
  await button(page, "Restart the solver").click();
  await until(page, "Paused at step 41");
  assert.deepEqual(await shown(), next);
  // From the start on it is known again.
  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await reading(page, "Vertices"), "1200");
  await close();
});

/** What has been said of the solver, in all. @param {Page} page */
const alerts = async (page) => page.getByRole("alert").locator(".what").count();

test("a second crash on the way back costs no more than the first", async () => {
  const { page, faults, close } = await site.blank();
  const workers = await spoilWorkers(page, (n) =>
    n > 1 && n < 5 ? { at: `asked === ${n}` } : null,
  );
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  for (const step of [1, 2, 3]) {
    await button(page, "Step").click();
    await until(page, `Paused at step ${step}`);
  }
  const before = [await surface(page), await energy(page)];
  const shown = (await download(page, "OBJ")).bytes.toString();
  await page.workers()[0].evaluate(() => {
    setTimeout(() => {
      throw new Error("made by the test");
    });
  });
  const said = await firstError(page);
  assert.match(said, /made by the test.*goes on from step 3.*stored steps are gone/);
  assert.equal(workers(), 5, "three were lost on the way back");
  await until(page, "Paused at step 3");
  assert.deepEqual([await surface(page), await energy(page)], before);
  assert.equal(await alerts(page), 1, "said once");
  // To the last digit.
  assert.equal((await download(page, "OBJ")).bytes.toString(), shown);
  // The history has begun anew.
  assert.equal(await button(page, "Back").getAttribute("aria-disabled"), "true");
  assert.equal(await page.getByRole("slider", { name: "History" }).count(), 0);
  await button(page, "Step").click();
  await until(page, "Paused at step 4");
  assert.equal(
    await page.getByRole("slider", { name: "History" }).getAttribute("aria-valuemin"),
    "3",
  );
  await button(page, "Back").click();
  await until(page, "Paused at step 3");
  assert.equal(await button(page, "Back").getAttribute("aria-disabled"), "true");
  assert.equal((await download(page, "OBJ")).bytes.toString(), shown);
  // How it came to be is not known; from the start on it is, and of which file.
  await openTab(page, "Share");
  await choice(page, "Save as").selectOption({ label: "Recipe, JSON" });
  await button(page, "Download").click();
  await page
    .getByRole("alert")
    .getByText(/how this surface came about is not known/i)
    .waitFor();
  await button(page, "Reset").click();
  await until(page, "Ready");
  const recipe = JSON.parse((await download(page, "Recipe, JSON")).bytes.toString());
  assert.equal(recipe.mesh.name, "wavy.obj");
  assert.deepEqual(
    faults.filter((fault) => !fault.includes("made by the test")),
    [],
  );
  await close();
});

test("a solver that cannot be had any more leaves the picture and its file, until it can", async () => {
  const { page, close } = await site.blank();
  let isBroken = true;
  await spoilWorkers(page, (n) => (n > 1 && isBroken ? { at: "asked === 2" } : null));
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  const before = await surface(page);
  const exact = (await download(page, "PLY")).bytes;
  await page.workers()[0].evaluate(() => {
    setTimeout(() => {
      throw new Error("made by the test");
    });
  });
  await page
    .getByRole("alert")
    .getByText(/each time the surface was to be restored/)
    .waitFor();
  await until(page, "The solver is not running");
  assert.equal(await surface(page), before);
  const saved = await download(page, "OBJ");
  assert.match(saved.name, /^wavy-circle-step0001\.ply$/);
  // The same numbers as the solver writes, behind another header.
  const body = (/** @type {Buffer} */ file) => file.subarray(file.indexOf("end_header\n") + 11);
  assert.ok(body(saved.bytes).equals(body(exact)));
  isBroken = false;
  await button(page, "Restart the solver").click();
  await until(page, "Paused at step 1");
  await button(page, "Step").click();
  await until(page, "Paused at step 2");
  assert.equal(await button(page, "Restart the solver").count(), 0);
  await close();
});

test("a solver that falls silent is noticed, and another goes on", async () => {
  const { page, faults, close } = await site.blank();
  // Ten seconds are long for a test.
  await page.addInitScript(() => {
    const { setTimeout } = globalThis;
    const hurried = (
      /** @type {any} */ work,
      /** @type {number} */ delay,
      /** @type {any[]} */ ...rest
    ) => setTimeout(work, delay === 10_000 ? 1500 : delay, ...rest);
    Object.assign(globalThis, { setTimeout: hurried });
  });
  await spoilWorkers(page, (n) => (n === 1 ? { at: "shown === 2", how: "hang" } : null));
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  await until(page, "Ready");
  await button(page, "Play").click();
  const restart = button(page, "Restart the solver");
  await restart.waitFor();
  await page.getByText(/No sign of life from the solver/).waitFor();
  assert.match((await download(page, "PLY")).name, /\.ply$/);
  await restart.click();
  const said = await firstError(page);
  await until(page, `Paused at step ${stepIn(said)}`);
  assert.equal(await restart.count(), 0);
  await button(page, "Step").click();
  await until(page, `Paused at step ${stepIn(said) + 1}`);
  assert.deepEqual(faults, []);
  await close();
});

test("a worker that dies twice is replaced twice", async () => {
  const { page, close } = await site.open();
  for (const word of ["first", "second"]) {
    await page.workers()[0].evaluate((word) => {
      setTimeout(() => {
        throw new Error(word);
      });
    }, word);
    await page.getByRole("alert").getByText(word).waitFor();
    await until(page, "Ready");
  }
  await button(page, "Step").click();
  await until(page, "Paused at step 1");
  await close();
});

test("a step that takes too long can be ended", async () => {
  const { page, faults, close } = await site.open();
  // Some seconds a step.
  await openMesh(page, "large.obj", obj(wavyTorus(360, 180)));
  await button(page, "Play").click();
  const stop = button(page, "Stop now");
  await stop.waitFor();
  assert.equal(await page.getByRole("progressbar").isVisible(), true);
  await stop.click();
  const said = await firstError(page);
  assert.match(said, /was ended/);
  const step = stepIn(said);
  await until(page, step > 0 ? `Paused at step ${step}` : "Ready");
  assert.equal(await stop.isVisible(), false);
  assert.equal(await reading(page, "Vertices"), String(360 * 180));

  await openMesh(page, "small.obj", obj(wavyTorus()));
  await playAndPause(page, 2);
  assert.deepEqual(faults, []);
  await close();
});

test("a solver that cannot be loaded is reported, with what to do", async () => {
  const { page, close } = await site.blank();
  await page.route(/solver_bg[^/]*\.wasm$/, (route) => route.abort());
  await page.goto(`${site.url}?msaa=1#sample=icosahedron`);
  assert.match(await firstError(page), /could not be started.*Reload/);
  await until(page, "The solver is not running");
  await close();
});
