// The icons of the installed page, drawn from www/icon.svg: `node www/tools/icons.js`.

import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { launch, openPage } from "../../tests/web/support/browser.js";
import { root } from "./process.js";

const svg = readFileSync(path.join(root, "www", "icon.svg"), "utf8");
const folder = path.join(root, "www", "public", "icons");

/** A maskable icon may be cut to a circle of 80 %: its ground reaches all edges. */
const icons = [
  { name: "icon-192", size: 192, isMaskable: false },
  { name: "icon-512", size: 512, isMaskable: false },
  { name: "maskable-512", size: 512, isMaskable: true },
];

const browser = await launch();
for (const { name, size, isMaskable } of icons) {
  const { page, close } = await openPage(browser, { viewport: { width: size, height: size } });
  const inset = isMaskable ? size / 10 : 0;
  await page.setContent(
    `<style>body { margin: 0; ${isMaskable ? "background: #0b6b78" : ""} }
    svg { display: block; margin: ${inset}px; width: ${size - 2 * inset}px }</style>${svg}`,
  );
  const file = path.join(folder, `${name}.png`);
  writeFileSync(file, await page.screenshot({ omitBackground: true }));
  console.log(`wrote ${file}`);
  await close();
}
await browser.close();
