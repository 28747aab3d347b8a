// @ts-check
// The rules of WCAG 2.2 A and AA that a program can check, in every state of the page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { button, choice, openMesh, playAndPause, until, upload, useSite } from "./support/app.js";
import { accessibilityFaults } from "./support/axe.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/** @typedef {import("playwright-core").Page} Page */

const desktop = { viewport: { width: 1280, height: 720 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true };

/** Everything that can be shown, shown. @param {Page} page */
async function crowd(page) {
  const panel = button(page, "Panel");
  if ((await panel.getAttribute("aria-expanded")) === "false") await panel.click();
  await openMesh(page, "wavy.obj", obj(wavyTorus()));
  const parts = ["#method", "#view", "#plot-data", ".explain", "#share", "#record"];
  for (const part of parts) {
    await page.locator(`${part} > summary`).filter({ visible: true }).click();
  }
  await choice(page, "Colour by").selectOption({ label: "Mean curvature H" });
  await page.getByRole("img", { name: /^Colours:/ }).waitFor();
  await playAndPause(page, 2);
  await upload(page, "broken.obj", "v 0 0 0\nf 1 2 3\n");
  await page.getByRole("alert").locator(".message").waitFor();
  await until(page, /^Paused/);
}

/** Opens every section. @param {Page} page */
const unfold = (page) =>
  page.evaluate(() => {
    for (const part of document.querySelectorAll("details")) part.open = true;
  });

for (const [device, shape] of Object.entries({ desktop, phone })) {
  // Without transitions: a colour on its way from one to the other is neither.
  const context = { ...shape, reducedMotion: /** @type {const} */ ("reduce") };

  /** In light and in dark. @param {Page} page @param {string} state */
  async function check(page, state) {
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await accessibilityFaults(page), [], `${state}, ${colorScheme}`);
    }
  }

  test(`${device}: no rule is broken, whatever is shown in the panel`, async () => {
    const { page, faults, close } = await site.open("", context);
    await check(page, "at the start");
    await crowd(page);
    await check(page, "with everything open, and an error");
    await page.keyboard.press("Escape");
    // Beside the error there may be a note of the flow.
    await page.locator("#errors").getByRole("button", { name: "Dismiss" }).click();
    await choice(page, "Flow").selectOption({ label: "p-Willmore" });
    await page.locator("#p-willmore").waitFor();
    await page.locator(".explain > summary").filter({ visible: true }).click();
    await page.getByLabel("Volume", { exact: true }).check();
    await until(page, "Ready");
    await button(page, "Step").click();
    await until(page, "Paused at step 1");
    await check(page, "under the p-Willmore flow");
    await choice(page, "Flow").selectOption({ label: "Edge flips" });
    await choice(page, "Beside it").selectOption({ label: "All three criteria" });
    await page.locator("#region").waitFor({ state: "hidden" });
    await page.locator("#conjecture > summary").click();
    await page.locator("#flip-data > summary").click();
    await page.locator("#lab > summary").click();
    await button(page, "Draw quadrilaterals").click();
    await page.locator("#lab-rows tr").first().waitFor();
    await button(page, "Stop").click();
    await button(page, "Flip to the end").click();
    await page
      .locator("#counterexamples option")
      .or(page.getByText(/holds for all/))
      .first()
      .waitFor();
    await check(page, "with edge flips side by side");
    await choice(page, "Sample").selectOption({ label: "Four bumps, flows compared" });
    await until(page, "Ready");
    await unfold(page);
    for (const label of ["Mean curvature", "Surface diffusion", "Willmore by fitted operators"]) {
      await choice(page, "Flow").selectOption({ label });
      await page.locator("#brief", { hasText: /^(Area|∫H²) = / }).waitFor({ state: "attached" });
      await check(page, `under ${label}`);
    }
    await choice(page, "Flow").selectOption({ label: "Minimal curvature variation, sixth order" });
    await page.locator("#brief", { hasText: "∫|∇H|² = " }).waitFor({ state: "attached" });
    await page.getByLabel("All four flows side by side").check();
    await page.locator("#loops input").first().check();
    await button(page, "Paint").click();
    await page.locator("#flows-rows tr").nth(3).waitFor();
    await check(page, "with flows side by side, a loop chosen and the brush in hand");
    assert.deepEqual(faults, []);
    await close();
  });

  test(`${device}: no rule is broken, running, presenting, in dialogs and in German`, async () => {
    const { page, faults, close } = await site.open("", context);
    await button(page, "Play").click();
    await until(page, /^Converged/);
    await check(page, "converged");
    await page.evaluate(() => {
      const box = /** @type {HTMLInputElement} */ (document.querySelector("[name=contrast]"));
      box.click();
    });
    await page.locator("#colour").selectOption("gauss-curvature", { force: true });
    await page.getByRole("img", { name: /^Colours:/ }).waitFor();
    await check(page, "with high contrast");
    await openMesh(page, "wavy.obj", obj(wavyTorus(160, 80)));
    await button(page, "Play").click();
    await until(page, "Running");
    await check(page, "running");
    await button(page, "Pause").click();
    await until(page, /^(Paused|Stopped|Converged)/);
    const panel = button(page, "Panel");
    await panel.click();
    await check(page, "with the panel opened or closed");
    await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
    await page.keyboard.press("?");
    await page.getByRole("dialog").waitFor();
    await check(page, "with the help open");
    await page.keyboard.press("Escape");
    await button(page, "Figures").click();
    await page.locator(".card").first().waitFor();
    await check(page, "with the gallery open");
    await page.locator(".card").first().click();
    await page.locator("#figure-heading", { hasText: "Fig. 6" }).waitFor({ state: "attached" });
    await until(page, "Ready");
    await page.keyboard.press("f");
    await page.locator("html.presenting").waitFor();
    await check(page, "presenting");
    await page.locator("html.idle").waitFor();
    await check(page, "presenting, its controls gone");
    await page.keyboard.press("Escape");
    await page.goto(`${site.url}?msaa=1&lang=de`);
    await page.locator("#status", { hasText: "Bereit" }).waitFor();
    if (device === "phone") await button(page, "Bedienfeld").click();
    await unfold(page);
    await check(page, "in German");
    assert.deepEqual(faults, []);
    await close();
  });
}

test("what the live regions say is short, and there is one heading of the first level", async () => {
  const { page, faults, close } = await site.open();
  assert.equal(await page.getByRole("status").count(), 1);
  assert.ok(((await page.getByRole("status").textContent()) ?? "").length < 60);
  assert.equal(await page.getByRole("heading", { level: 1 }).count(), 1);
  assert.equal(await page.getByRole("main").count(), 1);
  assert.equal(await page.locator("html").getAttribute("lang"), "en");
  assert.deepEqual(faults, []);
  await close();
});
