// @ts-check
// Errors against edge length, both logarithmic: a line of slope k is of order k.

/** @import { StudyReport as Study, Trend } from "../generated/types.js" */

import { formatShort } from "./number.js";

const space = "http://www.w3.org/2000/svg";
const box = { left: 44, right: 236, top: 10, bottom: 160 };
/** An error below this share of the largest is roundoff. */
const ROUNDOFF = 1e-11;

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {string} [text]
 */
function node(name, attributes, text) {
  const made = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text !== undefined) made.textContent = text;
  return made;
}

/**
 * @param {SVGElement} svg
 * @param {Study} study
 * @param {Readonly<Record<Trend["quantity"], string>>} names
 * @returns {boolean} whether there is anything to draw
 */
export function drawOrders(svg, { rows, trends }, names) {
  const h = rows.map((row) => Math.log10(row.h));
  const largest = Math.max(...trends.flatMap(({ errors }) => errors));
  const curves = trends.flatMap(({ quantity, errors }) => {
    const points = errors.flatMap((e, k) =>
      e > ROUNDOFF * largest ? [{ x: h[k], y: Math.log10(e) }] : [],
    );
    return points.length > 1 ? [{ quantity, points }] : [];
  });
  svg.replaceChildren();
  if (curves.length === 0 || rows.length < 2) return false;
  const all = curves.flatMap(({ points }) => points);
  const [low, high] = [Math.min(...all.map(({ y }) => y)), Math.max(...all.map(({ y }) => y))];
  const [first, last] = [Math.min(...h), Math.max(...h)];
  const range = Math.max(high - low, 0.5);
  const px = (/** @type {number} */ x) =>
    box.left + ((x - first) / (last - first)) * (box.right - box.left);
  const py = (/** @type {number} */ y) => box.bottom - ((y - low) / range) * (box.bottom - box.top);
  const frame = `M${box.left} ${box.top}V${box.bottom}H${box.right}`;
  svg.append(node("path", { d: frame, stroke: "currentColor" }));
  for (const x of h) {
    svg.append(
      node("path", { d: `M${px(x)} ${box.bottom}v4`, stroke: "currentColor" }),
      node("text", { x: px(x), y: box.bottom + 15, "text-anchor": "middle" }, formatShort(10 ** x)),
    );
  }
  for (const y of [low, high]) {
    svg.append(
      node(
        "text",
        { x: box.left - 5, y: py(y) + 3, "text-anchor": "end" },
        formatShort(Number((10 ** y).toPrecision(1))),
      ),
    );
  }
  svg.append(node("text", { x: box.right, y: box.bottom + 27, "text-anchor": "end" }, "h"));
  // Names below each other where their lines end together.
  const ends = curves
    .map(({ quantity, points }) => ({ quantity, y: py(points[0].y) }))
    .sort((a, b) => a.y - b.y);
  ends.forEach((end, k) => {
    if (k > 0) end.y = Math.max(end.y, ends[k - 1].y + 12);
  });
  for (const { quantity, points } of curves) {
    const d = points.map(({ x, y }, k) => `${k === 0 ? "M" : "L"}${px(x)} ${py(y)}`).join("");
    const label = ends.find((end) => end.quantity === quantity);
    svg.append(
      node("path", { d, class: `line-${quantity}` }),
      node(
        "text",
        { x: box.right + 6, y: (label?.y ?? 0) + 3, class: `name-${quantity}` },
        names[quantity],
      ),
    );
  }
  return true;
}
