// @ts-check
// A first visit: a surface, a sentence and one button; then the clip of its flow.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  colourBy,
  plotted,
  stepOf,
  surface,
  until,
  untilDrawn,
  useSite,
} from "./support/app.js";

const site = useSite();

test("a sentence says what will happen, twelve controls at most, and no number", async () => {
  const { page, faults, close } = await site.blank({ viewport: { width: 1280, height: 720 } });
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  await untilDrawn(page);
  const controls = page.locator(
    "button:visible, select:visible, a:visible, input:not(#file):visible",
  );
  assert.ok((await controls.count()) <= 12, String(await controls.count()));
  const text = (await page.locator("body").allInnerTexts()).join("\n");
  assert.doesNotMatch(text, /\d/);
  assert.match(text, /In a few seconds it will be round/);
  // What it is called everywhere comes first, and what it says is part of it.
  await button(page, "Play: Watch it flow").click();
  assert.equal(await page.getByText("Watch a surface find its shape").count(), 0);

  // The clip: eight seconds, at least five pictures a second in software, ever less energy.
  const seen = await page.evaluate(async () => {
    const head = () => document.querySelector(".head")?.getAttribute("style") ?? "";
    /** @type {Set<string>} */
    const places = new Set();
    const status = () => document.querySelector("[role=status]")?.textContent ?? "";
    let begun = 0;
    while (!/^Converged/.test(status())) {
      await new Promise(requestAnimationFrame);
      if (head() && !begun) begun = performance.now();
      places.add(head());
    }
    return { places: places.size, seconds: (performance.now() - begun) / 1000 };
  });
  assert.ok(seen.places > 5 * 8, `${seen.places} pictures`);
  const rows = await plotted(page);
  assert.equal(rows[0][0], 0);
  assert.equal(rows.length, (await stepOf(page)) + 1, "every step is there");
  for (let n = 1; n < rows.length; n += 1) assert.ok(rows[n][3] <= rows[n - 1][3] + 1e-12);
  assert.match((await page.locator(".energy b").textContent()) ?? "", /^0$/);

  await button(page, "Why?").click();
  await button(page, "Next: Vesicle").waitFor();

  // Later visits open without the card; the scene is in the address.
  await page.goto(`${site.url}?msaa=1`);
  await until(page, "Ready");
  assert.equal(await page.getByText("Watch a surface find its shape").count(), 0);
  // What one may begin with is called as it is where it is open.
  await page.keyboard.press("?");
  await button(page, "Show the welcome again").click();
  await page.getByRole("button", { name: /^Vesicle/ }).click();
  await page.locator("#title").getByText("Vesicle", { exact: true }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});

test("the scale of colours is the same at the first and the last picture", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere");
  await colourBy(page, "Mean curvature H");
  const legend = page.getByRole("img", { name: /^Colours: Mean curvature H/ });
  const first = await legend.getAttribute("aria-label");
  const ticks = (await page.locator(".ticks").allInnerTexts()).join(" ");
  assert.match(ticks, /\b0\b/);
  await button(page, "Play").click();
  await until(page, /^Converged/);
  assert.equal(await legend.getAttribute("aria-label"), first);
  assert.match(
    (await page.locator(".ticks").allInnerTexts()).join(" "),
    /round/,
    "a finished ball has its place",
  );
  await close();
});

test("with reduced motion only true steps are shown", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere", { reducedMotion: "reduce" });
  await button(page, "Play").click();
  const seen = await page.evaluate(async () => {
    const head = () => document.querySelector(".head")?.getAttribute("style") ?? "";
    const places = new Set();
    const end = performance.now() + 3000;
    while (performance.now() < end) {
      await new Promise(requestAnimationFrame);
      places.add(head());
    }
    return places.size;
  });
  assert.ok(seen <= 9, `${seen} places in three seconds`);
  await close();
});

test("a file that is chosen while the page starts is opened", async () => {
  const { page, close } = await site.blank();
  /** @type {(value?: unknown) => void} */
  let release = () => {};
  const held = new Promise((resolve) => {
    release = resolve;
  });
  // The solver comes after the file was chosen, and so do the words of what it refuses.
  const late = /solver_bg[^/]*\.wasm$|refusal-[^/]*\.js$/;
  await page.route(late, (route) => held.then(() => route.continue()));
  await page.goto(`${site.url}?msaa=1`, { waitUntil: "commit" });
  const file = page.getByLabel("Open mesh", { exact: true });
  await file.waitFor({ state: "attached" });
  const text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  await page.waitForFunction(() => document.querySelector("#top button") !== null);
  await file.setInputFiles({
    name: "early.obj",
    mimeType: "text/plain",
    buffer: Buffer.from(text),
  });
  release();
  await canvas(page)
    .and(page.getByRole("img", { name: /early/ }))
    .waitFor();
  await until(page, "Ready");
  assert.match(await surface(page), /^Surface: early/);
  await close();
});
