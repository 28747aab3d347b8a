// @ts-check
// The address holds the scene: opened elsewhere it shows the same.

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  button,
  canvas,
  choice,
  energy,
  openMesh,
  stillPicture,
  surface,
  until,
  untilDrawn,
  untilPictured,
  useSite,
} from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

test("a copied address restores sample, method, camera, view and step", async () => {
  const first = await site.open();
  await choice(first.page, "Sample").selectOption({ label: "Bumpy sphere" });
  await first.page.waitForFunction(() => location.hash.includes("bumpy-sphere"));
  await until(first.page, "Ready");
  await choice(first.page, "Colour by").selectOption({ label: "Mean curvature H" });
  await first.page.locator("#method > summary").click();
  await first.page.getByRole("spinbutton", { name: "Angle smoothing ε" }).fill("0.02");
  await first.page.keyboard.press("Tab");
  await first.page.waitForFunction(() => location.hash.includes("epsilon=0.02"));
  await first.page.locator("#method > summary").click();
  for (const step of [1, 2, 3]) {
    await button(first.page, "Step").click();
    await until(first.page, `Paused at step ${step}`);
  }
  await untilDrawn(first.page);
  await canvas(first.page).focus();
  for (const key of ["ArrowLeft", "ArrowUp", "+", "]"]) await first.page.keyboard.press(key);
  await first.page.waitForFunction(
    () => location.hash.includes("camera=") && location.hash.includes("step=3"),
  );
  // The address follows at most twice a second: it is final when it has stood still.
  const address = await settled(first.page);
  for (const part of [
    "sample=bumpy-sphere",
    "flow=circle",
    "epsilon=0.02",
    "colour=mean-curvature",
  ]) {
    assert.ok(address.includes(part), `${part} is not in ${address}`);
  }

  const second = await site.open(address.slice(1));
  await until(second.page, "Paused at step 3");
  assert.equal(await surface(second.page), await surface(first.page));
  assert.equal(await energy(second.page), await energy(first.page));
  assert.equal(await second.page.locator("#option-epsilon").inputValue(), "0.02");
  assert.equal(await choice(second.page, "Colour by").inputValue(), "mean-curvature");
  // The ring of the focus is no part of the picture.
  await canvas(first.page).blur();
  const sent = await stillPicture(first.page);
  // The address has five digits of the camera.
  await untilPictured(second.page, sent, (mean) => mean < 0.3);
  assert.equal(await settled(second.page), address, "and it writes the same address");
  for (const { faults, close } of [first, second]) {
    assert.deepEqual(faults, []);
    await close();
  }
});

test("a link in the same tab is followed, even if the address is about to be written", async () => {
  const { page, faults, close } = await site.open();
  await page.evaluate(() => {
    location.hash = "#sample=coarse-torus&goal=smooth&detail=9&step=2";
    history.replaceState(null, "", "#sample=icosahedron&flow=circle");
  });
  await until(page, "Paused at step 2");
  assert.match(await surface(page), /^Surface: coarse-torus, step 2, /);
  assert.equal(await page.locator("#detail").inputValue(), "9");
  assert.deepEqual(faults, []);
  await close();
});

test("a link with a bad value is refused whole, and the scene stays", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&step=1");
  await until(page, "Paused at step 1");
  const before = [await surface(page), await energy(page)];
  for (const [words, message] of [
    ["epsilon=7", "`epsilon` cannot be `7`"],
    ["epsilonn=0.5", "there is no option `epsilonn`"],
    ["flow=mmcv&panes=tau_soon", "`tau` cannot be `soon`"],
    ["camera=Infinity,1", "“camera” cannot be “Infinity,1”"],
  ]) {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, `#sample=icosahedron&shading=flat&${words}`);
    await page.getByRole("alert").getByText(message).first().waitFor();
    assert.deepEqual([await surface(page), await energy(page)], before);
    assert.equal(await page.locator("#shading").inputValue(), "smooth");
  }
  await close();
  assert.deepEqual(faults, []);

  // Where nothing is shown yet, the page opens as without a link.
  const { page: fresh, close: end } = await site.blank();
  await fresh.goto(`${site.url}?msaa=1#sample=pipe&integrator=rk4`);
  await fresh.getByRole("alert").getByText("`integrator` cannot be `rk4`").waitFor();
  await until(fresh, "Ready");
  assert.match(await surface(fresh), /^Surface: icosahedron, /);
  await end();
});

test("a link of very many steps asks before it runs", async () => {
  const { page, faults, close } = await site.open("sample=coarse-torus&step=1");
  await until(page, "Paused at step 1");
  const before = [await surface(page), await energy(page)];
  /** @param {string} words */
  const go = (words) =>
    page.evaluate((hash) => {
      location.hash = hash;
    }, `#${words}`);
  const dialog = page.getByRole("dialog");
  await go("sample=icosahedron&flow=circle&step=1000000");
  await dialog.getByText("This link runs about 1,000,000 steps.").waitFor();
  assert.deepEqual(await accessibilityFaults(page), []);
  await dialog.getByRole("button", { name: "Leave it" }).click();
  await dialog.waitFor({ state: "hidden" });
  assert.deepEqual([await surface(page), await energy(page)], before);
  // Not by Escape either.
  await go("sample=icosahedron&flow=circle&step=1000001");
  await dialog.getByText("This link runs about 1,000,001 steps.").waitFor();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "hidden" });
  assert.deepEqual([await surface(page), await energy(page)], before);
  await go("sample=icosahedron&flow=circle&step=1000002");
  await dialog.getByRole("button", { name: "Run them" }).click();
  await page.waitForFunction(() =>
    /^Surface: icosahedron, step \d+/.test(
      document.querySelector("#surface")?.getAttribute("aria-label") ?? "",
    ),
  );
  assert.deepEqual(faults, []);
  await close();
});

test("a link to somebody's file asks for it, and goes on once it is opened", async () => {
  const { page, faults, close } = await site.blank();
  await page.goto(`${site.url}?msaa=1#mesh=theirs&flow=circle&step=2`);
  await page.getByRole("alert").getByText("theirs").waitFor();
  await page.getByRole("alert").getByText("Open that file").waitFor();
  await page.getByLabel("Open mesh", { exact: true }).setInputFiles({
    name: "theirs.obj",
    mimeType: "",
    buffer: Buffer.from(obj(wavyTorus(16, 8))),
  });
  await until(page, "Paused at step 2");
  assert.match(await surface(page), /^Surface: theirs, step 2, /);
  assert.deepEqual(faults, []);
  await close();
});

test("the address names a mesh from a file and nothing of what is in it", async () => {
  const { page, faults, close } = await site.open();
  await openMesh(page, "secret.obj", obj(wavyTorus(16, 8)));
  await page.waitForFunction(() => location.hash.includes("mesh=secret"));
  assert.ok((await settled(page)).length < 200);
  assert.deepEqual(faults, []);
  await close();
});

/** The address's part from `#` on, once it has stood for longer than it lags. @param {import("playwright-core").Page} page */
function settled(page) {
  return page.evaluate(async () => {
    for (;;) {
      const before = location.hash;
      await new Promise((resolve) => setTimeout(resolve, 1200));
      if (location.hash === before) return before;
    }
  });
}
