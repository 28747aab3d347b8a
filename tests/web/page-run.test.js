// @ts-check
// Play, Pause, Step, Back, Reset, the scrubber and its keys; changes of the flow, and branches.

import assert from "node:assert/strict";
import { test } from "node:test";
import { flows } from "../../www/generated/schema.js";
import {
  button,
  choice,
  energy,
  openMesh,
  openPart,
  openTab,
  playAndPause,
  playToEnd,
  plotted,
  reading,
  stepOf,
  surface,
  until,
  useSite,
} from "./support/app.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

test("steps forwards and backwards, each press one, and back to the start", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus");
  const first = await energy(page);
  for (let n = 0; n < 5; n += 1) await page.keyboard.press(".");
  await until(page, "Paused at step 5");
  assert.equal(await reading(page, "Step"), "5");
  const fifth = await energy(page);
  assert.ok(fifth < first);
  await button(page, "Back").click();
  await button(page, "Back").click();
  await until(page, "Paused at step 3");
  // The same steps give the same numbers, to the last digit shown.
  await page.keyboard.press(".");
  await page.keyboard.press(".");
  await until(page, "Paused at step 5");
  assert.equal(await energy(page), fifth);
  // To the start and to the latest step: nothing is forgotten on the way.
  await page.keyboard.press("Home");
  await until(page, "Ready");
  await page.keyboard.press("End");
  await until(page, "Paused at step 5");
  assert.equal(await energy(page), fifth);
  await button(page, "Reset").click();
  await until(page, "Ready");
  assert.equal(await energy(page), first);
  assert.match(await surface(page), /^Surface: Coarse torus, step 0, energy/);
  assert.deepEqual(faults, []);
  await close();
});

test("Pause stands on a true step, with its numbers, while the solver is far ahead", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  const step = await playAndPause(page, 3);
  await until(page, `Paused at step ${step}`);
  const rows = await plotted(page);
  assert.ok(rows.length > step + 1, "more steps are there already");
  assert.equal(await reading(page, "Step"), String(step));
  assert.ok(Math.abs(rows[step][3] - (await energy(page))) <= 1e-4 * rows[step][3]);
  // The curve is the scrubber: keys go step by step, and to both ends.
  const scrubber = page.getByRole("slider", { name: "History" });
  await scrubber.focus();
  await page.keyboard.press("ArrowRight");
  await until(page, `Paused at step ${step + 1}`);
  await page.keyboard.press("End");
  await until(page, /^Converged/);
  const last = rows.at(-1)?.[0] ?? 0;
  assert.equal(await scrubber.getAttribute("aria-valuenow"), String(last));
  await page.keyboard.press("Home");
  await until(page, "Ready");
  // Dragging shows any moment, and rests on a step.
  const box = await scrubber.boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + 2, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 20, { steps: 4 });
  await page.mouse.up();
  await until(page, /^Paused at step/);
  const there = Number(await reading(page, "Step"));
  assert.ok(there > 0 && there < last);
  // Play goes on from here and ends where it ended.
  await playToEnd(page, new RegExp(`^Converged after ${last} steps`));
  assert.deepEqual(faults, []);
  await close();
});

test("Play goes on from where Pause stood, and colours change on the way, while the solver is far ahead", async () => {
  const { page, faults, close } = await site.open("sample=letter-c");
  const step = await playAndPause(page, 3);
  const last = (await plotted(page)).length - 1;
  assert.ok(last > step + 10, `${last} steps are there already`);
  /** The steps that are shown from now on, until there are so many. @param {number} count */
  const shown = (count) =>
    page.evaluate(async (wanted) => {
      const label = () => document.querySelector("#surface")?.getAttribute("aria-label") ?? "";
      /** @type {Set<number>} */
      const steps = new Set();
      while (steps.size < wanted) {
        steps.add(Number(/step (\d+)/.exec(label())?.[1]));
        await new Promise(requestAnimationFrame);
      }
      return [...steps];
    }, count);
  await button(page, "Play").click();
  const on = await shown(3);
  assert.ok(on[2] > step && on[2] < last, `${on} after ${step}, of ${last}`);
  await page.keyboard.press("c");
  await page.waitForFunction(() => document.querySelector(".legend"));
  const coloured = await shown(3);
  assert.ok(coloured[0] >= on[2] && coloured[2] < last, `${coloured} after ${on}, of ${last}`);
  await button(page, "Pause").click();
  await until(page, /^Paused at step/);
  assert.ok((await plotted(page)).length > last, "no step is lost");
  assert.equal(await page.getByText(/branch/).count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("a change applies from the start, or from this step, which keeps what came as a branch", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  const step = await playAndPause(page, 2);
  await openTab(page, "Flow");
  await page.getByRole("radio", { name: "This step" }).check();
  await page.getByRole("option", { name: /^p-Willmore/ }).click();
  await until(page, `Paused at step ${step}`);
  await page.keyboard.press(".");
  await until(page, `Paused at step ${step + 1}`);
  await page.getByRole("combobox", { name: "Branches" }).selectOption({ index: 1 });
  await until(page, /^(Converged|Paused)/);
  assert.ok((await plotted(page)).length > step + 2, "the path of before is back");
  await openTab(page, "Flow");
  await page.getByRole("radio", { name: "Start", exact: true }).check();
  await page.getByRole("option", { name: /^Mean curvature/ }).click();
  await until(page, "Ready");
  assert.deepEqual(faults, []);
  await close();
});

test("forms come from the tables: what a flow does not read is not asked for", async () => {
  const { page, faults, close } = await site.open("sample=bumpy-sphere");
  await openTab(page, "Flow");
  const panel = page.getByRole("tabpanel");
  const list = page.getByRole("listbox", { name: "Flow" });
  assert.equal(await list.getByRole("option").count(), flows.length);
  assert.equal(await panel.getByLabel("Boundary").count(), 0, "there is none");
  await list.getByRole("option", { name: /^p-Willmore/ }).click();
  await until(page, "Ready");
  await panel.getByLabel("Exponent p").fill("3");
  await panel.getByLabel("Exponent p").press("Enter");
  await page.locator(".energy").getByText("∫|H|^3").waitFor();
  await panel.getByRole("checkbox", { name: "Area" }).check();
  await until(page, "Ready");
  // Refused in words, and the field shows what is in force.
  await panel.getByLabel("Exponent p").fill("0.5");
  await panel.getByLabel("Exponent p").press("Enter");
  await page.getByRole("alert").waitFor();
  await panel.locator("input[type=number]").first().and(page.locator(":valid")).waitFor();
  await openPart(page, "Flow", /^Advanced/);
  await panel.getByLabel("Time step τ").fill("1e-9");
  await panel.getByLabel("Time step τ").press("Enter");
  await until(page, "Ready");
  await page.keyboard.press("Escape");
  assert.deepEqual(faults, []);
  await close();
});

test("a boundary has its own choice, and a limit of steps goes on with Play", async () => {
  const { page, faults, close } = await site.open("sample=pipe&maxSteps=3");
  await openTab(page, "Flow");
  assert.ok((await choice(page, "Boundary").inputValue()) === "clamped");
  await playToEnd(page, /^Stopped after 3 steps/);
  await button(page, "Play").click();
  await until(page, /^Stopped after 6 steps/);
  await choice(page, "Boundary").selectOption({ label: "Free" });
  await until(page, "Ready");
  assert.deepEqual(faults, []);
  await close();
});

test("a mesh of one's own is loaded, named, and flows", async () => {
  const { page, faults, close } = await site.open("sample=pipe");
  await openMesh(page, "wavy.obj", obj(wavyTorus(24, 12)));
  assert.equal(await reading(page, "Vertices"), String(24 * 12));
  assert.equal(await reading(page, "Genus"), "1");
  const first = await energy(page);
  await page.keyboard.press(".");
  await until(page, "Paused at step 1");
  assert.ok((await energy(page)) < first);
  // One that cannot be read is refused in words; the one before stays.
  await page.getByLabel("Open mesh", { exact: true }).setInputFiles({
    name: "broken.obj",
    mimeType: "text/plain",
    buffer: Buffer.from("f 1 2 3"),
  });
  await page.getByRole("alert").waitFor();
  assert.equal(await reading(page, "Step"), "1");
  await page.getByRole("button", { name: "Dismiss" }).click();
  assert.equal(await page.getByRole("alert").count(), 0);
  assert.deepEqual(faults, []);
  await close();
});

test("keys rest while something is typed, and can be switched off", async () => {
  const { page, close } = await site.open("sample=coarse-torus");
  await page.keyboard.press("/");
  const search = page.getByRole("searchbox");
  await search.fill("b.f r");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  assert.equal(await stepOf(page), 0);
  await page.keyboard.press("?");
  await page.getByRole("checkbox", { name: "Single keys" }).uncheck();
  await page.keyboard.press("Escape");
  await page.keyboard.press(".");
  await page.keyboard.press("Control+k");
  assert.equal(await stepOf(page), 0);
  await close();
});

test("a surface that is given other triangles on its way goes on in one clip", async () => {
  const { page, faults, close } = await site.open("sample=morin&maxSteps=40");
  assert.match(await surface(page), /step 0, energy 50\.97/);
  await playToEnd(page, /^Stopped after 40 steps/);
  // Each pass is a tick on the curve, from the energy before it to the one after.
  const ticks = await page.locator(".curve .pass title").allTextContents();
  const passes = ticks.map((tick) =>
    /^step (\d+), after remeshing: energy (\S+) to (\S+)$/.exec(tick),
  );
  assert.ok(passes.length > 0 && passes.every(Boolean), ticks.join("; "));
  const [step, before, after] = (passes.at(-1) ?? []).slice(1).map(Number);
  assert.notEqual(before, after);
  const rows = await plotted(page);
  assert.ok(Math.abs(rows[step - 1][3] / before - 1) < 1e-4, `${rows[step - 1]}: ${before}`);
  // Half of Morin's surface: its energy is four times that of a sphere, and falls.
  const last = Number(/step 40, energy (\S+?),/.exec(await surface(page))?.[1]);
  assert.ok(last < 51 && last > 4 * Math.PI - 0.1, String(last));
  // Who does not see the tick is told of it at its step.
  const scrubber = page.getByRole("slider", { name: "History" });
  for (let at = 39; at >= step - 1; at -= 1) {
    await page.keyboard.press(",");
    await until(page, `Paused at step ${at}`);
    const told = at === step ? ticks.at(-1) : `step ${at}`;
    assert.equal(await scrubber.getAttribute("aria-valuetext"), told);
  }
  assert.match(await surface(page), new RegExp(`step ${step - 1}, energy `));
  assert.deepEqual(faults, []);
  await close();
});

/**
 * A large mesh, and what goes between the page and its worker: requests with their answers, and the
 * steps of frames, each with the time. `atProgress` is done once in the middle of a long step.
 * @param {Awaited<ReturnType<typeof site.blank>>} tab
 */
async function openLarge({ page }) {
  await page.addInitScript(() => {
    const self = /** @type {any} */ (globalThis);
    self.said = [];
    self.Worker = class extends Worker {
      /** @param {any} message @param {any[]} rest */
      postMessage(message, ...rest) {
        const { id, name } = message;
        if (name) self.said.push({ asked: name, id, at: performance.now() });
        super.postMessage(message, ...rest);
      }
      /** @param {any} handler */
      set onmessage(handler) {
        super.onmessage = (event) => {
          const { id, ok, type, state } = event.data;
          const step = (state ?? ok?.state ?? ok)?.step;
          self.said.push({ answered: id, type, step, at: performance.now() });
          if (type === "progress") {
            self.atProgress?.();
            self.atProgress = null;
          }
          handler(event);
        };
      }
    };
  });
  await page.goto(`${site.url}?msaa=1#sample=coarse-torus`);
  await until(page, "Ready");
  await openMesh(page, "large.obj", obj(wavyTorus(460, 230)));
}

/** @param {Page} page @returns {Promise<{ asked?: string, answered?: number, id?: number, type?: string, step?: number, at: number }[]>} */
const saidIn = (page) => page.evaluate(() => /** @type {any} */ (globalThis).said);

/**
 * From a request in the middle of a step to its answer: milliseconds, and the steps of the frames
 * that came between.
 * @param {Page} page @param {string} name
 */
async function answerTo(page, name) {
  const said = await saidIn(page);
  const from = said.findIndex((one, n) => one.asked === name && said[n - 1].type === "progress");
  const to = said.findIndex((one, n) => n > from && one.answered === said[from].id);
  const before = said.slice(0, from).findLast((one) => one.type === "frame");
  const between = said.slice(from, to).filter((one) => one.type === "frame");
  return {
    milliseconds: said[to].at - said[from].at,
    before: before?.step,
    steps: between.map((one) => one.step),
    answer: said[to].step,
  };
}

test("Pause is answered in the middle of a long step, which is taken again afterwards", async (t) => {
  const tab = await site.blank();
  const { page, faults, close } = tab;
  await openLarge(tab);
  await page.evaluate(() => {
    /** @type {any} */ (globalThis).atProgress = () =>
      /** @type {HTMLElement} */ (document.querySelector(".play")).click();
  });
  await button(page, "Play").click();
  await until(page, /^(Ready|Paused at step)/);
  const { milliseconds, before, steps, answer } = await answerTo(page, "pause");
  t.diagnostic(`answered after ${milliseconds.toFixed(0)} ms`);
  // The step that was in hand would have been the next.
  assert.equal(answer, before);
  assert.ok(steps.every((step) => step === before));
  assert.equal(Number(await reading(page, "Step")), before);
  // It was given up and not lost.
  const later = await playAndPause(page, 1);
  assert.ok(later > Number(before));
  assert.deepEqual(faults, []);
  await close();
});

test("an option is changed in the middle of a long step", async (t) => {
  const tab = await site.blank();
  const { page, faults, close } = tab;
  await openLarge(tab);
  await openTab(page, "Flow");
  await page.evaluate(() => {
    /** @type {any} */ (globalThis).atProgress = () => {
      const flows = [...document.querySelectorAll("[role=option]")];
      const other = flows.find((flow) => flow.textContent?.includes("p-Willmore"));
      /** @type {HTMLElement} */ (other).click();
    };
  });
  await button(page, "Play").click();
  await until(page, /^Ready/);
  const { milliseconds, before, steps, answer } = await answerTo(page, "pause");
  t.diagnostic(`answered after ${milliseconds.toFixed(0)} ms`);
  assert.equal(answer, before);
  assert.ok(steps.every((step) => step === before));
  await page.getByRole("option", { name: "p-Willmore", selected: true }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});
