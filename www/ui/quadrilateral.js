// @ts-check
// One quadrilateral: drawn flat, and its numbers.

/** @import { QuadReport as Quadrilateral } from "../generated/types.js" */

import { t } from "../language.js";
import { formatNumber } from "./number.js";

const SVG = "http://www.w3.org/2000/svg";
const SIZE = 100;
const MARGIN = 14;

/** @typedef {[number, number, number]} Point */

/** @param {Point} a @param {Point} b @returns {Point} */
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** @param {Point} a @param {Point} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {Point} a @param {Point} b @returns {Point} */
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * Both triangles unfolded about the edge (i, j), which lies along x: lengths are true.
 * @param {Point[]} points  i, j, k, l
 * @returns {[number, number][]}
 */
function unfold([i, j, k, l]) {
  const along = minus(j, i);
  const length = Math.sqrt(dot(along, along)) || 1;
  const place = (/** @type {Point} */ p, /** @type {number} */ side) => {
    const off = minus(p, i);
    const across = cross(along, off);
    return /** @type {[number, number]} */ ([
      dot(off, along) / length,
      (side * Math.sqrt(dot(across, across))) / length,
    ]);
  };
  return [[0, 0], [length, 0], place(k, -1), place(l, 1)];
}

/** @param {string} name @param {Record<string, string | number>} attributes */
function shape(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}

/** @param {Quadrilateral} quad */
function drawing({ points }) {
  const flat = unfold(points);
  const low = [0, 1].map((axis) => Math.min(...flat.map((p) => p[axis])));
  const high = [0, 1].map((axis) => Math.max(...flat.map((p) => p[axis])));
  const scale = (SIZE - 2 * MARGIN) / Math.max(high[0] - low[0], high[1] - low[1], 1e-300);
  const at = flat.map((p) =>
    [0, 1].map((axis) => SIZE / 2 + scale * (p[axis] - 0.5 * (low[axis] + high[axis]))),
  );
  const text = (/** @type {number[]} */ corners) => corners.map((c) => at[c].join(",")).join(" ");
  const svg = shape("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, "aria-hidden": "true" });
  svg.append(
    shape("polygon", { points: text([0, 2, 1]), class: "face" }),
    shape("polygon", { points: text([0, 1, 3]), class: "face" }),
    shape("polyline", { points: text([0, 1]), class: "edge" }),
    ...["i", "j", "k", "l"].map((name, n) => {
      const [x, y] = at[n];
      const out = [x - SIZE / 2, y - SIZE / 2].map((d) => d / (Math.hypot(x - 50, y - 50) || 1));
      const label = shape("text", { x: x + 8 * out[0], y: y + 8 * out[1] + 3 });
      label.textContent = name;
      return label;
    }),
  );
  return svg;
}

/** @param {Point} point */
const coordinates = (point) => `(${point.map((x) => Number(x.toPrecision(6))).join(", ")})`;

/** @param {Quadrilateral} quad */
function numbers(quad) {
  const { points, area, localised, totalArea, foldDegrees, minAngleDegrees } = quad;
  const list = document.createElement("dl");
  const both = (/** @type {number[]} */ [before, after]) =>
    `${formatNumber(before, 4)}° → ${formatNumber(after, 4)}°`;
  const rows = [
    [
      t("f_a, area gained"),
      t("{gained} of {area}", { gained: signed(area), area: formatNumber(totalArea, 5) }),
    ],
    [t("f_l, localised energy gained"), signed(localised)],
    [t("Angle between the faces"), both(foldDegrees)],
    [t("Smallest angle"), both(minAngleDegrees)],
    ["i, j, k, l", points.map(coordinates).join("\n")],
  ];
  for (const [term, value] of rows) {
    const dt = document.createElement("dt");
    const dd = document.createElement("dd");
    dt.textContent = term;
    dd.textContent = value;
    list.append(dt, dd);
  }
  return list;
}

/** With its sign, and a true minus. @param {number} value */
export const signed = (value) => `${value < 0 ? "−" : "+"}${formatNumber(Math.abs(value), 6)}`;

/** @param {HTMLElement} root @param {Quadrilateral | null} quad */
export function showQuadrilateral(root, quad) {
  root.hidden = !quad;
  if (quad) root.replaceChildren(drawing(quad), numbers(quad));
}
