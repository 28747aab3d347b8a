// @ts-check
// The page under test: served below a sub-path, opened, and asked by the names that
// assistive technology uses.

import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { after, before } from "node:test";
import { fileURLToPath } from "node:url";
import { difference, launch, openPage, picture } from "./browser.js";
import { serve } from "./server.js";

/** @typedef {import("playwright-core").Page} Page */

const root = fileURLToPath(new URL("../../..", import.meta.url));

/** Software graphics on a busy machine: long, since nothing waits for longer than it must. */
const PATIENCE = Number(process.env.UMBILIC_PATIENCE ?? 90_000);

/**
 * One server and one browser for a test file.
 * @param {import("./chromium.js").Graphics} [options]
 */
export function useSite(options) {
  /** @type {Awaited<ReturnType<typeof serve>>} */
  let server;
  /** @type {import("playwright-core").Browser} */
  let browser;
  before(async () => {
    server = await serve();
    browser = await launch(options);
  });
  after(async () => {
    await browser?.close();
    await server?.close();
  });
  return {
    get url() {
      return server.url;
    },
    get browser() {
      return browser;
    },
    /**
     * A fresh page, not yet at any address.
     * @param {import("playwright-core").BrowserContextOptions} [context]
     */
    async blank(context) {
      const opened = await openPage(browser, context);
      opened.page.setDefaultTimeout(PATIENCE);
      return opened;
    },
    /**
     * A page with a scene on it. One sample a pixel and no effects: software draws it faster.
     * @param {string} [scene]  the address from `#` on, without it
     * @param {import("playwright-core").BrowserContextOptions} [context]
     * @param {string} [query]  the address from `?` on, without it
     */
    async open(scene = "sample=icosahedron", context = {}, query = "msaa=1&effects=never") {
      const opened = await this.blank(context);
      await opened.page.goto(`${server.url}?${query}#${scene}`);
      await until(opened.page, scene.includes("step=") ? /^Paused/ : "Ready");
      return opened;
    },
  };
}

/**
 * Waits for the status line to say something.
 * @param {Page} page
 * @param {string | RegExp} wanted  the whole line, or a pattern in it
 */
export async function until(page, wanted) {
  const status = page.locator("[role=status]");
  const exact = typeof wanted === "string" ? new RegExp(`^${wanted}$`) : wanted;
  try {
    await status.filter({ hasText: exact }).waitFor({ timeout: PATIENCE });
  } catch (error) {
    const said = await status.textContent().catch(() => "nothing");
    throw new Error(`waited for ${exact}; the status line says “${said}”`, { cause: error });
  }
}

/** The canvas. @param {Page} page */
export const canvas = (page) => page.locator("main").getByRole("img", { name: /^Surface:/ });

/**
 * Waits for a surface on the screen. The solver may be ready long before the graphics
 * are. A shaded surface has hundreds of greys, a cleared canvas one, text on it some.
 * @param {Page} page @param {number} [least]  colours that there are to be more of
 */
export async function untilDrawn(page, least = 200) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const { colours } = await picture(canvas(page));
    if (colours > least) return;
    if (Date.now() > end) throw new Error(`no surface on the screen: ${colours} colours`);
  }
}

/**
 * Takes pictures of the canvas until one compares as wanted. Status and readings change
 * first; the picture of the same state reaches the screen frames later, on a machine
 * that draws in software a second or more.
 * @param {Page} page
 * @param {Buffer} reference  a picture of the same size
 * @param {(mean: number) => boolean} wanted  of the mean difference from the reference
 * @returns {Promise<Buffer>} that picture
 */
export async function untilPictured(page, reference, wanted) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const taken = await canvas(page).screenshot();
    const { mean } = difference(reference, taken);
    if (wanted(mean)) return taken;
    if (Date.now() > end) throw new Error(`the pictures differ by ${mean}`);
  }
}

/**
 * A picture of the canvas that nothing drawn late changes any more.
 * @param {Page} page @param {number} [least]  colours that there are to be more of
 * @returns {Promise<Buffer>}
 */
export async function stillPicture(page, least) {
  await untilDrawn(page, least);
  let last = await canvas(page).screenshot();
  for (let same = 0; same < 3; ) {
    await page.waitForTimeout(250);
    const next = await canvas(page).screenshot();
    same = next.equals(last) ? same + 1 : 0;
    last = next;
  }
  return last;
}

/** @param {Page} page @param {string} name */
export const button = (page, name) => page.getByRole("button", { name, exact: true });

/** @param {Page} page @param {string} name */
export const choice = (page, name) => page.getByRole("combobox", { name, exact: true });

/** Opens a tab of the rail, where it is not open yet. @param {Page} page @param {string} name */
export async function openTab(page, name) {
  const tab = page.getByRole("tab", { name });
  if ((await tab.getAttribute("aria-selected")) !== "true") await tab.click();
  // It is fetched when it is first asked for.
  await page.getByRole("tabpanel").locator(".body > *").first().waitFor();
}

/** Opens a part of a tab, where it is not open yet. @param {Page} page @param {string} tab @param {string | RegExp} name */
export async function openPart(page, tab, name) {
  await openTab(page, tab);
  const heading = page.getByRole("tabpanel").getByRole("button", { name, expanded: false });
  if ((await heading.count()) > 0) await heading.first().click();
}

/** Colours the surface. @param {Page} page @param {string} label */
export async function colourBy(page, label) {
  const title = page.getByRole("group", { name: "Legend" }).getByRole("button").last();
  if ((await title.getAttribute("aria-expanded")) !== "true") await title.click();
  await choice(page, "Colour by").selectOption({ label });
  await title.click();
}

/** A cell of the readings. @param {Page} page @param {string} name */
export async function reading(page, name) {
  await openTab(page, "Measure");
  const header = page.getByRole("rowheader", { name, exact: true });
  const row = page
    .getByRole("table", { name: "Readings" })
    .getByRole("row")
    .filter({ has: header });
  return (await row.getByRole("cell").textContent()) ?? "";
}

/**
 * Waits for a cell of the readings to hold something else: the message of a change may be
 * that of the one before, which says the same.
 * @param {Page} page @param {string} name @param {string} before
 */
export async function untilReadingIsNot(page, name, before) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const now = await reading(page, name);
    if (now !== before) return now;
    if (Date.now() > end) throw new Error(`${name} stays ${before}`);
    await page.waitForTimeout(50);
  }
}

/** @param {Page} page @returns {Promise<number>} */
export const energy = async (page) => Number(await reading(page, "Energy"));

/** Rows of the table of all steps, numbers each: step, time, step size, energy. @param {Page} page */
export async function plotted(page) {
  await openPart(page, "Measure", "Table of all steps");
  const rows = page.locator("#plot-rows tbody tr");
  return rows.evaluateAll((all) =>
    all.map((row) =>
      [...row.children].map((cell) =>
        Number(cell.querySelector("[title]")?.getAttribute("title") ?? cell.textContent),
      ),
    ),
  );
}

/** Number of the step that is shown, as the surface is told in words. @param {Page} page */
export const stepOf = async (page) => Number(/step (\d+)/.exec(await surface(page))?.[1] ?? 0);

/** The surface in words. @param {Page} page */
export const surface = async (page) =>
  (await page.locator("#surface").getAttribute("aria-label")) ?? "";

/**
 * @param {Page} page
 * @param {string} name  with the extension
 * @param {string | Buffer} contents
 */
export async function upload(page, name, contents) {
  const file = { name, mimeType: "application/octet-stream", buffer: Buffer.from(contents) };
  await page.getByLabel("Open mesh", { exact: true }).setInputFiles(file);
}

/**
 * As {@link upload}, and waits until the mesh is there.
 * @param {Page} page
 * @param {string} name
 * @param {string | Buffer} contents
 */
export async function openMesh(page, name, contents) {
  await upload(page, name, contents);
  const mesh = name.replace(/\.\w+$/, "");
  await page
    .locator("#title")
    .filter({ hasText: new RegExp(`^${mesh}$`) })
    .waitFor();
  await until(page, "Ready");
}

/**
 * Plays until some steps are shown, and pauses.
 * @param {Page} page
 * @param {number} steps  at least
 * @returns {Promise<number>} the step it stands at
 */
export async function playAndPause(page, steps) {
  const first = await stepOf(page);
  await button(page, "Play").click();
  await page.evaluate(async (wanted) => {
    const label = () => document.querySelector("#surface")?.getAttribute("aria-label") ?? "";
    const step = () => Number(/step (\d+)/.exec(label())?.[1] ?? 0);
    while (!(step() >= wanted)) await new Promise(requestAnimationFrame);
    /** @type {HTMLElement | null} */ (document.querySelector(".play"))?.click();
  }, first + steps);
  // A small surface may come to rest within a frame or two.
  await until(page, /^(Paused at step|Converged after) \d+/);
  const said = await page.locator("[role=status]").textContent();
  return Number(/\d+/.exec(said ?? "")?.[0]);
}

/** Plays to the end at four times the usual pace. @param {Page} page @param {RegExp} [end] */
export async function playToEnd(page, end = /^(Converged|Stalled|Stopped)/) {
  const speed = page.getByRole("button", { name: /^Speed/ });
  while (!/4×/.test((await speed.textContent()) ?? "")) await speed.click();
  await button(page, "Play").click();
  await until(page, end);
}

/**
 * @param {Page} page
 * @param {string} format  as the select shows it
 * @returns {Promise<{ name: string, bytes: Buffer }>}
 */
export async function download(page, format) {
  await openTab(page, "Share");
  await choice(page, "Save as").selectOption({ label: format });
  const [saved] = await Promise.all([
    page.waitForEvent("download"),
    button(page, "Download").click(),
  ]);
  return { name: saved.suggestedFilename(), bytes: await readFile(await saved.path()) };
}

/** Path of one of the developers' meshes, or null where they are not at hand. @param {string} name */
export function sharedMesh(name) {
  const file = path.join(root, "..", "shared", "meshes", name);
  return existsSync(file) ? file : null;
}
