// The picture in README.md, taken from the built page: `node www/tools/picture.js`.

import path from "node:path";
import { until } from "../../tests/web/support/app.js";
import { launch, openPage } from "../../tests/web/support/browser.js";
import { serve } from "../../tests/web/support/server.js";
import { root } from "./process.js";

/** What is in the picture, and how far it has flowed. */
const scene = "#sample=bumpy-sphere&colour=mean-curvature";
const steps = 3;

const server = await serve();
const browser = await launch();
const { page } = await openPage(browser, {
  viewport: { width: 1280, height: 720 },
  colorScheme: "light",
});
await page.goto(`${server.url}?effects=always${scene}`);
await until(page, "Ready");
for (let step = 1; step <= steps; step++) {
  await page.getByRole("button", { name: "Step", exact: true }).click();
  await until(page, `Paused at step ${step}`);
}
await page.mouse.move(5, 5);
const file = path.join(root, "www", "picture.png");
await page.screenshot({ path: file });
console.log(`wrote ${file}`);
await browser.close();
await server.close();
