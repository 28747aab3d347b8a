// @ts-check
// Accessibility rules run on a page as it stands. axe itself and not its Playwright
// package, which asks for a newer Node than we do.

import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

const script = createRequire(import.meta.url).resolve("axe-core/axe.min.js");

/**
 * What breaks the WCAG 2.2 rules, levels A and AA, a line each.
 * @param {import("playwright-core").Page} page
 * @returns {Promise<string[]>}
 */
export async function accessibilityFaults(page) {
  // Evaluated, not added as a script element, which a page's own policy may forbid.
  await page.evaluate(await readFile(script, "utf8"));
  return page.evaluate(async () => {
    const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];
    const axe = /** @type {any} */ (globalThis).axe;
    const { violations } = await axe.run(document, { runOnly: tags });
    return violations.flatMap((/** @type {any} */ { id, help, nodes }) =>
      nodes.map((/** @type {any} */ node) => `${id}: ${help}: ${node.target.join(" ")}`),
    );
  });
}
