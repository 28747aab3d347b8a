// @ts-check
// The small pictures of the gallery, taken from the built page: `node www/tools/thumbnails.js`, of
// all figures or of those whose ids follow.

import { mkdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { launch, openPage } from "../../tests/web/support/browser.js";
import { serve } from "../../tests/web/support/server.js";
import { figures } from "../generated/library.js";
import { asText } from "../options.js";
import { root } from "./process.js";

/** Steps that are worth waiting for in a picture. */
const MOST = 30;

const folder = path.join(root, "www", "thumbnails");
mkdirSync(folder, { recursive: true });
const server = await serve();
const browser = await launch();
try {
  const asked = process.argv.slice(2);
  for (const figure of figures.filter(({ id }) => asked.length === 0 || asked.includes(id))) {
    const { page, close } = await openPage(browser, {
      viewport: { width: 240, height: 150 },
      colorScheme: "light",
    });
    const steps = figure.steps === "rest" ? MOST : Math.min(figure.steps, MOST);
    const words = new URLSearchParams({ sample: figure.sample });
    for (const [key, value] of Object.entries({ ...figure.options, ...figure.arrangement })) {
      words.set(key, asText(value, key));
    }
    words.set("colour", figure.colour);
    if (steps > 0) words.set("step", String(steps));
    page.setDefaultTimeout(100_000);
    await page.goto(`${server.url}#${words}`);
    const status = page.getByRole("status").first();
    await status
      .filter({ hasText: /Ready|Paused|Converged|Stopped|Stalled/ })
      .waitFor({ timeout: 120_000 });
    await page.keyboard.press("f");
    // The page's policy forbids style sheets from elsewhere.
    await page.evaluate(() => {
      for (const one of ["#header", "#transport", "#messages", "#colour-bar", "#own-caption"]) {
        const element = document.querySelector(one);
        if (element instanceof HTMLElement) element.style.display = "none";
      }
    });
    await page.waitForTimeout(700);
    writeFileSync(path.join(folder, `${figure.id}.png`), await page.screenshot());
    console.log(figure.id);
    await close();
  }
} finally {
  await browser.close();
  await server.close();
}
