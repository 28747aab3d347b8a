// The small pictures of the library, taken from the built page: samples before and after their
// flow, and the figures of the papers. `node www/tools/thumbnails.js [id …]`.

import { writeFileSync } from "node:fs";
import path from "node:path";
import { until, untilDrawn } from "../../tests/web/support/app.js";
import { launch, openPage } from "../../tests/web/support/browser.js";
import { serve } from "../../tests/web/support/server.js";
import { figures, samples } from "../generated/library.js";
import { asText } from "../options.js";
import { root } from "./process.js";

/** Steps that are worth waiting for in a picture. */
const MOST = 30;

const folder = path.join(root, "www", "thumbnails");
const wanted = process.argv.slice(2);
const server = await serve();
const browser = await launch();

/** Of flows side by side the first, without what is said of it. */
const FIRST = `#panes { --columns: 1 !important; }
  .pane + .pane { position: absolute; visibility: hidden; }
  .pane figcaption { display: none; }`;

/** A fifth of the bytes. @param {Buffer} png */
async function asWebp(png) {
  const page = await browser.newPage();
  const webp = await page.evaluate(
    async (data) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(data)]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
      const blob = await canvas.convertToBlob({ type: "image/webp", quality: 0.7 });
      return [...new Uint8Array(await blob.arrayBuffer())];
    },
    [...png],
  );
  await page.close();
  return Buffer.from(webp);
}

/**
 * @param {string} name  of the file @param {object} scene  words of a link
 * @param {{ width: number, height: number }} viewport
 */
async function take(name, scene, viewport) {
  const texts = Object.entries(scene).map(([key, value]) => [key, asText(value, key)]);
  const { page, close } = await openPage(browser, { viewport, colorScheme: "light" });
  page.setDefaultTimeout(120_000);
  await page.goto(`${server.url}?embed&controls=none&effects=always#${new URLSearchParams(texts)}`);
  await page.evaluate((css) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets.push(sheet);
  }, FIRST);
  await until(page, /^(Ready|Paused|Converged|Stopped|Stalled|Singular|Collapsed)/);
  await untilDrawn(page);
  const png = await page.locator("#surface").screenshot();
  writeFileSync(path.join(folder, `${name}.webp`), await asWebp(png));
  console.log(name);
  await close();
}

/** @param {{ id: string }} one */
const isWanted = ({ id }) => wanted.length === 0 || wanted.includes(id);

for (const { id, options } of samples.filter(isWanted)) {
  const half = { width: 150, height: 150 };
  await take(id, { sample: id }, half);
  if (options.flow !== "flips") await take(`${id}-after`, { sample: id, step: MOST }, half);
}
for (const { id, sample, colour, steps, options, arrangement } of figures.filter(isWanted)) {
  const step = steps === "rest" ? MOST : Math.min(steps, MOST);
  const words = { sample, ...options, ...arrangement, colour, ...(step > 0 && { step }) };
  await take(id, words, { width: 240, height: 150 });
}
await browser.close();
await server.close();
