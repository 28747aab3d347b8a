// The small pictures of the library, taken from the built page: samples before and after their
// flow, and the figures of the papers. `node www/tools/thumbnails.js [id …]`.

import { writeFileSync } from "node:fs";
import path from "node:path";
import { stillPicture, until } from "../../tests/web/support/app.js";
import { launch, openPage } from "../../tests/web/support/browser.js";
import { serve } from "../../tests/web/support/server.js";
import { figures, samples } from "../generated/library.js";
import { asText } from "../options.js";
import { root } from "./process.js";

/** Steps that are worth waiting for in a picture. */
const MOST = 80;
/** Pixels that one of the picture is made of, along a side: edges are smooth then. */
const SCALE = 2;
/** A floor has more colours than this, and fewer than a surface. */
const FLOOR_COLOURS = 20;

const folder = path.join(root, "www", "thumbnails");
const wanted = process.argv.slice(2);
const server = await serve();
const browser = await launch();

/** Of flows side by side the first, without what is said of it. */
const FIRST = `#panes { --columns: 1 !important; }
  .pane + .pane { position: absolute; visibility: hidden; }
  .pane figcaption { display: none; }`;

/** A place from which the sample is not to be seen. */
const outOfSight = { sample: "icosahedron", camera: [1e4, 0, 0, 5, 0, 0, 0, 1, 0, 1, 0] };
/** How much a channel of the floor may be dimmed otherwise than another: a byte holds so few. */
const TINT = 0.1;
/** How much lighter a line is in the dark. */
const LINE = 80;

/**
 * The surface on nothing, so that it can lie on the ground of either theme. In the dark, floor is
 * what is no brighter than the backdrop, and of its colour.
 * @param {Record<"light" | "dark" | "backdrop", Buffer>} pictures
 */
async function asWebp({ light, dark, backdrop }) {
  const page = await browser.newPage();
  const bytes = [light, dark, backdrop].map((png) => [...png]);
  const webp = await page.evaluate(
    async ([pictures, SCALE, TINT, LINE]) => {
      /** @param {number[]} png */
      const pixelsOf = async (png) => {
        const bitmap = await createImageBitmap(new Blob([Uint8Array.from(png)]));
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
        context?.drawImage(bitmap, 0, 0);
        return /** @type {ImageData} */ (context?.getImageData(0, 0, bitmap.width, bitmap.height));
      };
      const [light, dark, backdrop] = await Promise.all(pictures.map(pixelsOf));
      const { data, width, height } = light;
      for (let n = 0; n < data.length; n += 4) {
        const ratios = [n, n + 1, n + 2].map((k) => dark.data[k] / backdrop.data[k]);
        const most = Math.max(...ratios);
        if (most < 1 + TINT && most - Math.min(...ratios) < TINT) data.fill(0, n, n + 4);
        // A line that is dark in the light and light in the dark is seen on either in between.
        else if (dark.data[n] - data[n] > LINE) data.fill(128, n, n + 3);
      }
      const large = new OffscreenCanvas(width, height);
      large.getContext("2d")?.putImageData(light, 0, 0);
      const small = new OffscreenCanvas(width / SCALE, height / SCALE);
      const context = small.getContext("2d");
      if (context) context.imageSmoothingQuality = "high";
      context?.drawImage(large, 0, 0, small.width, small.height);
      const blob = await small.convertToBlob({ type: "image/webp", quality: 0.5 });
      return [...new Uint8Array(await blob.arrayBuffer())];
    },
    /** @type {const} */ ([bytes, SCALE, TINT, LINE]),
  );
  await page.close();
  return Buffer.from(webp);
}

/**
 * In light and in dark.
 * @param {object} scene  words of a link @param {{ width: number, height: number }} viewport
 */
async function pictures(scene, viewport) {
  const texts = Object.entries(scene).map(([key, value]) => [key, asText(value, key)]);
  const { page, close } = await openPage(browser, {
    viewport,
    deviceScaleFactor: SCALE,
    colorScheme: "light",
  });
  page.setDefaultTimeout(120_000);
  await page.goto(`${server.url}?embed&controls=none&effects=always#${new URLSearchParams(texts)}`);
  await page.evaluate((css) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
    document.adoptedStyleSheets.push(sheet);
  }, FIRST);
  await until(page, /^(Ready|Paused|Converged|Stopped|Stalled|Singular|Collapsed)/);
  const still = async () => {
    await stillPicture(page, FLOOR_COLOURS);
    return page.locator("#surface").screenshot();
  };
  const light = await still();
  await page.emulateMedia({ colorScheme: "dark" });
  const dark = await still();
  await close();
  return { light, dark };
}

/** Of each width. @type {Map<number, Buffer>} */
const backdrops = new Map();

/**
 * @param {string} name  of the file @param {object} scene  words of a link
 * @param {{ width: number, height: number }} viewport
 */
async function take(name, scene, viewport) {
  const { width } = viewport;
  const backdrop = backdrops.get(width) ?? (await pictures(outOfSight, viewport)).dark;
  backdrops.set(width, backdrop);
  const webp = await asWebp({ ...(await pictures(scene, viewport)), backdrop });
  writeFileSync(path.join(folder, `${name}.webp`), webp);
  console.log(name);
}

/** @param {{ id: string }} one */
const isWanted = ({ id }) => wanted.length === 0 || wanted.includes(id);

for (const { id, options } of samples.filter(isWanted)) {
  const half = { width: 140, height: 140 };
  await take(id, { sample: id }, half);
  if (options.flow !== "flips") await take(`${id}-after`, { sample: id, step: MOST }, half);
}
for (const { id, sample, colour, steps, options, arrangement, back } of figures.filter(isWanted)) {
  // A film of two halves is known by its middle.
  const step = back ? 0 : steps === "rest" ? MOST : Math.min(steps, MOST);
  const words = { sample, ...options, ...arrangement, colour, ...(step > 0 && { step }) };
  await take(id, words, { width: 240, height: 150 });
}
await browser.close();
await server.close();
