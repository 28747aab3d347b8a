// @ts-check
// What the page promises of its looks: what is in sight in which window, how high drawers are, that
// nothing lies over the surface, and that it stands out from its ground.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { button, canvas, openTab, stillPicture, until, useSite } from "./support/app.js";
import { decodePng } from "./support/png.js";

/** @typedef {import("playwright-core").Page} Page */

const desk = { viewport: { width: 1280, height: 720 } };

const site = useSite();

/**
 * What of these cannot be seen whole.
 * @param {Page} page @param {string} selector
 */
const hidden = (page, selector) =>
  page.locator(selector).evaluateAll((all) =>
    all.flatMap((one) => {
      const { left, top, right, bottom } = one.getBoundingClientRect();
      const hits = [top + 2, bottom - 2].map((y) =>
        document.elementFromPoint((left + right) / 2, y),
      );
      const isSeen = hits.every((hit) => hit && (one.contains(hit) || hit.contains(one)));
      return isSeen ? [] : [`${one.className} ${one.textContent?.trim().slice(0, 30)}`];
    }),
  );

test("on a small desk Play, curve, energy, all flows and what they are for are in sight", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere", desk);
  await openTab(page, "Flow");
  const flows = page.locator(".panel .option");
  assert.ok((await flows.count()) >= 5);
  const goal = page.locator(".panel fieldset.field");
  assert.match((await goal.first().textContent()) ?? "", /Goal/);
  const all = ".play, .curve, .energy, .panel .option, .panel .segments";
  assert.deepEqual(await hidden(page, all), []);
  await close();
});

test("what holds at a boundary is asked about where there is one", async () => {
  for (const [sample, count] of /** @type {const} */ ([
    ["icosahedron", 0],
    ["pipe", 1],
  ])) {
    const { page, close } = await site.open(`sample=${sample}`, desk);
    await openTab(page, "Flow");
    const panel = page.locator(".panel");
    await panel.getByText("Goal", { exact: true }).waitFor();
    assert.equal(await panel.getByText("Boundary", { exact: true }).count(), count, sample);
    await close();
  }
});

test("no drawer is higher than a window and a half, whatever is open, and pictures in it are whole", async () => {
  // The flow with the most options, with those of its paper, under way.
  const scene = "flow=p-willmore&scheme=paper&remesh=off&colour=mean-curvature&step=1";
  const { page, close } = await site.open(`sample=bumpy-sphere&${scene}`, desk);
  const body = page.locator(".panel .body");
  const look = async (/** @type {string} */ where) => {
    const height = await body.evaluate((body) => body.scrollHeight);
    assert.ok(height <= 1.5 * 720, `${where}: ${height} px`);
  };
  for (const tab of ["Surface", "Flow", "Measure", "Compare", "Share"]) {
    await openTab(page, tab);
    await look(tab);
    // The numbers and how they are spread over the surface are seen at once.
    if (tab === "Measure") assert.deepEqual(await hidden(page, "[data-reading], .histogram"), []);
    // What lies over what comes next: less room than it asks for.
    const squeezed = await body.evaluate((body) => {
      const boxes = [...body.children].map((child) => child.getBoundingClientRect());
      return boxes.filter((box, n) => n > 0 && box.top < boxes[n - 1].bottom - 1).length;
    });
    assert.equal(squeezed, 0, tab);
    // One thing is opened at a time, and nothing in what is opened is opened once more.
    assert.equal(await page.locator(".more .more").count(), 0);
    const parts = body.locator(".more h3 button");
    for (let n = 0; n < (await parts.count()); n += 1) {
      await parts.nth(n).click();
      await body.locator(".inner > *").first().waitFor();
      // What is said of a field waits until one is there.
      assert.equal(await body.locator(".field .hint:visible").count(), 0, tab);
      await look(`${tab}, ${await parts.nth(n).textContent()}`);
    }
  }
  await openTab(page, "Flow");
  await page.getByRole("spinbutton", { name: "Exponent p" }).focus();
  await body.getByText("the exponent of").waitFor();
  await close();
});

test("there is one Play, the space bar plays, and nothing lies over the surface", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere", desk);
  const over = () =>
    page.evaluate(() => {
      const box = /** @type {Element} */ (document.getElementById("stage")).getBoundingClientRect();
      /** @type {Set<string>} */
      const over = new Set();
      for (let n = 0; n < 400; n += 1) {
        const [x, y] = [((n % 20) + 0.5) / 20, (Math.floor(n / 20) + 0.5) / 20];
        const hit = document.elementFromPoint(box.left + x * box.width, box.top + y * box.height);
        if (hit && hit.id !== "surface" && !hit.closest(".legend")) over.add(hit.outerHTML);
      }
      return [...over];
    });
  assert.deepEqual(await over(), []);
  await openTab(page, "Share");
  assert.equal(await button(page, "Play").count(), 1);
  await page.keyboard.press("Space");
  await page.waitForFunction(() =>
    /step [1-9]/.test(document.querySelector("#surface")?.ariaLabel ?? ""),
  );
  await page.keyboard.press("Space");
  await until(page, /^(Paused|Converged)/);
  // Two things to say at once are one line.
  const line = page.locator(".status");
  const { height } = (await line.boundingBox()) ?? { height: 0 };
  await button(page, "Copy link").click();
  await page.locator(".status .link.quiet").waitFor();
  assert.deepEqual(await over(), []);
  assert.equal((await line.boundingBox())?.height, height);
  assert.equal(await line.locator(".text").count(), 1);
  await close();
});

test("where edges are too close to be drawn the page says so, until one is near enough", async () => {
  const { page, faults, close } = await site.open("sample=genus-4&wireframe=true", desk);
  await page.getByRole("group", { name: "Legend" }).getByRole("button").last().click();
  const hint = page.getByText("Zoom in to see edges");
  await hint.waitFor();
  await canvas(page).hover();
  for (let n = 0; n < 6; n += 1) await page.mouse.wheel(0, -400);
  await hint.waitFor({ state: "detached" });
  assert.deepEqual(faults, []);
  await close();
});

test("an option over decades has a slider, which the field follows", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere&goal=smooth", desk);
  await openTab(page, "Flow");
  const slider = page.getByRole("slider", { name: /^Smooth away detail/ });
  const field = page.getByRole("spinbutton", { name: /^Smooth away detail/ });
  assert.equal(await field.inputValue(), "4");
  // Four mean edge lengths lie in the middle of the decades about them, as far as these are allowed.
  const [least, most] = await slider.evaluate((one) => {
    const { min, max } = /** @type {HTMLInputElement} */ (one);
    return [10 ** Number(min), 10 ** Number(max)];
  });
  assert.ok(Math.abs(least - 0.1) < 1e-9 && Math.abs(most - 400) < 1e-6, `${least} to ${most}`);
  await slider.fill("2");
  assert.equal(await field.inputValue(), "100");
  await page.waitForFunction(() => /detail=100/.test(location.hash));
  await field.fill("40");
  await field.press("Enter");
  await page.waitForFunction(() => /detail=40/.test(location.hash));
  assert.ok(Math.abs(Number(await slider.inputValue()) - 1.6) < 0.006);
  await close();
});

test("a picture of the library shows what becomes of it, but not where motion is reduced", async () => {
  for (const reducedMotion of /** @type {const} */ (["no-preference", "reduce"])) {
    const { page, close } = await site.open("sample=bumpy-sphere", { ...desk, reducedMotion });
    await page.keyboard.press("/");
    const pictures = page.locator(".entry .two").first().locator("img");
    const [before, after] = [pictures.first(), pictures.last()];
    const place = async () => [await before.boundingBox(), await after.boundingBox()];
    const [left, right] = await place();
    assert.ok(left && right && left.x + left.width <= right.x + 1, "beside each other");
    await before.hover();
    const [over, under] = await place();
    const moves = reducedMotion === "no-preference";
    assert.equal(over?.x === under?.x, moves, reducedMotion);
    const running = await after.evaluate((picture) => picture.getAnimations().length);
    assert.equal(running, moves ? 1 : 0, reducedMotion);
    await close();
  }
});

for (const [width, height] of [
  [844, 390],
  [667, 375],
  [568, 320],
]) {
  test(`on a phone on its side, ${width} × ${height}, a surface is seen beside the welcome`, async () => {
    const viewport = { width, height };
    const { page, close } = await site.blank({ viewport, hasTouch: true });
    await page.goto(`${site.url}?msaa=1`);
    await until(page, "Ready");
    assert.deepEqual(
      await hidden(page, ".welcome h2, .welcome .go, .starter:visible, .status"),
      [],
    );
    const stage = await page.locator("#stage").boundingBox();
    const card = await page.locator(".welcome").boundingBox();
    assert.ok(stage && card);
    // The middle of the picture, where the surface stands, is free, and so is as much as is high.
    const free = stage.x + stage.width - (card.x + card.width);
    assert.ok(free >= 0.8 * stage.height, `${free} of ${stage.width} px`);
    const picture = await canvas(page).boundingBox();
    assert.ok(picture && picture.x + picture.width / 2 > card.x + card.width);
    await button(page, "Play: Watch it flow").click();
    await until(page, /^Converged/);
    assert.deepEqual(await hidden(page, ".play, .energy, .curve .plot"), []);
    await close();
  });
}

test("numbers below the curve do not run into each other, whatever the width", async () => {
  const { page, close } = await site.open("sample=bumpy-sphere&step=12");
  for (const width of [1280, 1000, 900, 760, 667, 390]) {
    await page.setViewportSize({ width, height: 600 });
    const boxes = await page.locator(".curve .step:visible").evaluateAll((all) =>
      all.map((one) => {
        const { left, right } = one.getBoundingClientRect();
        return [left, right];
      }),
    );
    assert.ok(boxes.length >= 2, `${boxes.length} at ${width} px`);
    for (let n = 1; n < boxes.length; n += 1) {
      const gap = boxes[n][0] - boxes[n - 1][1];
      assert.ok(gap >= 2, `${gap} px between numbers at ${width} px`);
    }
  }
  await close();
});

/** Relative luminance by WCAG 2. @param {ArrayLike<number>} rgb  bytes */
function luminance(rgb) {
  const [r, g, b] = [0, 1, 2].map((n) => {
    const c = rgb[n] / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** @param {number} a @param {number} b */
const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`the surface stands out from its ground all around, ${colorScheme}`, async () => {
    const context = { ...desk, colorScheme };
    const { page, close } = await site.open("sample=bumpy-sphere", context, "effects=always");
    const { width, height, channels, data } = decodePng(await stillPicture(page));
    const [edge, least] = [8, { ratio: Infinity, where: "" }];
    let places = 0;
    for (const [long, wide, isRow] of /** @type {const} */ ([
      [width, height, true],
      [height, width, false],
    ])) {
      /** A pixel of a row, or of a column. @param {number} along @param {number} n */
      const at = (along, n) => {
        const [x, y] = isRow ? [along, n] : [n, along];
        return data.subarray(channels * (y * width + x), channels * (y * width + x) + 3);
      };
      /** The glaze is green; ground and shadow are bluish. @param {number} along @param {number} n */
      const isSurface = (along, n) => {
        const [r, g, b] = at(along, n);
        return g > b && g > r + 3;
      };
      for (const way of [1, -1]) {
        let before = -1;
        for (let n = edge; n < wide - edge; n += 4) {
          let from = way > 0 ? edge : long - 1 - edge;
          const isInside = () => from >= edge && from < long - edge;
          while (isInside() && !(isSurface(from, n) && isSurface(from + 3 * way, n))) from += way;
          // Only where the outline is crossed at a large angle.
          const isSteep = isInside() && Math.abs(from - before) < 4;
          before = from;
          if (!isSteep) continue;
          places += 1;
          const [inside, outside] = [3, -4].map((by) => at(from + by * way, n));
          const ratio = contrast(luminance(inside), luminance(outside));
          const where = `${inside} on ${outside}, ${isRow ? "row" : "column"} ${n}`;
          if (ratio < least.ratio) Object.assign(least, { ratio, where });
        }
      }
    }
    assert.ok(places > 100, `${places} places at the outline`);
    assert.ok(least.ratio >= 1.3, `${least.ratio}: ${least.where}`);
    await close();
  });
}

test("text has a contrast of 4.5, lines and controls of 3, in both themes", async () => {
  const css = await readFile(new URL("../../www/style/tokens.css", import.meta.url), "utf8");
  const [, light, dark] = css.split(/:root[^{]*\{/);
  for (const theme of [light, dark]) {
    /** @param {string} name */
    const colour = (name) => {
      const hex = new RegExp(`--${name}: #([0-9a-f]+)`).exec(theme)?.[1] ?? "";
      const long = hex.length === 3 ? hex.replace(/./g, "$&$&") : hex;
      return luminance(Buffer.from(long, "hex"));
    };
    for (const on of ["panel", "raised"]) {
      for (const text of ["text", "dim", "accent", "warn", "danger", "pane-0", "pane-1"]) {
        const ratio = contrast(colour(text), colour(on));
        assert.ok(ratio >= 4.5, `${text} on ${on}: ${ratio}`);
      }
      const ratio = contrast(colour("edge"), colour(on));
      assert.ok(ratio >= 3, `edge on ${on}: ${ratio}`);
    }
    assert.ok(contrast(colour("on-accent"), colour("accent")) >= 4.5);
  }
});
