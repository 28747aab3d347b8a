// @ts-check
// The solver's worker lost in the middle of a run: said in words, replaced by a new one
// that goes on from the last picture.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  energy,
  openMesh,
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
  const lines = page.getByRole("alert").locator(".message p");
  await lines.first().waitFor();
  return (await lines.allTextContents()).join(" ").trim();
}

/**
 * Gives the first worker, and no later one, a solver that reads outside its memory after so many
 * pictures: a true trap of true wasm.
 * @param {Page} page @param {number} pictures
 */
async function trapFirstWorker(page, pictures) {
  let served = 0;
  await page.route(/worker-[^/]*\.js$/, async (route) => {
    served += 1;
    if (served > 1) return route.continue();
    const response = await route.fetch();
    const trap = `{
      let shown = 0;
      const spoil = ({ instance, module }) => {
        const { session_frame, session_perform } = instance.exports;
        const spoiled = {
          session_frame: (self) => {
            shown += 1;
            return session_frame(self);
          },
          session_perform: (self, command) =>
            session_perform(shown === ${pictures} ? -64 : self, command),
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
  // Those of both meshes at rest, and three of a run.
  const workers = await trapFirstWorker(page, 5);
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  const atStart = await energy(page);
  await button(page, "Play").click();
  const said = await firstError(page);
  assert.match(said, /stopped unexpectedly.*goes on from step \d+/);
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
  // The message lies over the picture.
  await button(page, "Dismiss").click();
  // The picture is the last one's.
  await untilPictured(page, seen, (mean) => mean < 0.05);
  await button(page, "Step").click();
  await until(page, "Paused at step 4");
  assert.deepEqual(
    (await plotted(page)).map(([step]) => step),
    [0, 1, 2, 3, 4],
  );
  // The browser itself prints what the worker threw.
  assert.deepEqual(
    faults.filter((fault) => !fault.includes("made by the test")),
    [],
  );
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
  await page.goto(`${site.url}?msaa=1`);
  assert.match(await firstError(page), /could not be started.*Reload/);
  await until(page, "The solver is not running");
  await close();
});
