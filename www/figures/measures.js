// @ts-check
// What is measured on the end of a run: small formulas on readings and positions.

/** @import { Run } from "../figures.js" */

/** @param {number} value @param {number} [digits] */
export const short = (value, digits = 4) => String(Number(value.toPrecision(digits)));
/** @param {number} value @param {number} expected @param {number} relative */
export const near = (value, expected, relative) => Math.abs(value / expected - 1) <= relative;

/** How far area and volume are from the start, relative: the larger one of those in `keep`. */
/** @param {Run} run @param {("area" | "volume")[]} keep */
export const drift = ({ first, last }, keep) =>
  Math.max(...keep.map((name) => Math.abs((last[name] ?? Number.NaN) / (first[name] ?? 1) - 1)));

/** @param {Float32Array} positions @returns {[number, number, number][]} */
const points = (positions) =>
  Array.from({ length: positions.length / 3 }, (_, i) => [
    positions[3 * i],
    positions[3 * i + 1],
    positions[3 * i + 2],
  ]);

/** @param {[number, number, number][]} list @returns {[number, number, number]} */
const centroid = (list) => {
  const sum = [0, 0, 0];
  for (const p of list) for (let k = 0; k < 3; k++) sum[k] += p[k];
  return [sum[0] / list.length, sum[1] / list.length, sum[2] / list.length];
};
/** @param {number[]} a @param {number[]} b */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @param {number[]} a @param {number[]} b */
const cross = (a, b) =>
  [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return a[i] * b[j] - a[j] * b[i];
  });
/** @param {number[]} list */
const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
/** @param {number[]} list */
const rms = (list) => Math.sqrt(mean(list.map((value) => value * value)));

/**
 * Distance from the sphere that fits best, root mean square over its radius: |p|² = 2 c·p + k in
 * least squares.
 * @param {Float32Array} positions
 */
export function offSphere(positions) {
  const all = points(positions);
  const middle = centroid(all);
  const list = all.map((p) => p.map((value, k) => value - middle[k]));
  const axes = [0, 1, 2];
  const rows = axes.map((i) => axes.map((j) => mean(list.map((q) => q[i] * q[j]))));
  const rhs = axes.map((i) => mean(list.map((q) => 0.5 * dot(q, q) * q[i])));
  const volume = dot(rows[0], cross(rows[1], rows[2]));
  const centre = axes.map((i) => dot(rhs, cross(rows[(i + 1) % 3], rows[(i + 2) % 3])) / volume);
  const radii = list.map((q) => Math.hypot(...axes.map((k) => q[k] - centre[k])));
  const radius = mean(radii);
  return rms(radii.map((r) => r / radius - 1));
}

/** Largest distance from the unit sphere or, with two coordinates, from the unit cylinder. */
/** @param {Float32Array} positions @param {2 | 3} coordinates */
export const offUnit = (positions, coordinates) =>
  points(positions).reduce(
    (most, p) => Math.max(most, Math.abs(Math.hypot(...p.slice(0, coordinates)) - 1)),
    0,
  );

/**
 * The torus of revolution about z that fits best, ρ² + z² = 2Rρ + c in least squares: R/r, and
 * the distance from it, root mean square over r.
 * @param {Float32Array} positions
 */
export function torusFit(positions) {
  const list = points(positions);
  const c = centroid(list);
  const profile = list.map((p) => [Math.hypot(p[0] - c[0], p[1] - c[1]), p[2] - c[2]]);
  const rho = mean(profile.map(([r]) => r));
  const square = mean(profile.map(([r, z]) => r * r + z * z));
  const covariance = mean(profile.map(([r, z]) => (r - rho) * (r * r + z * z)));
  const twoMajor = covariance / mean(profile.map(([r]) => (r - rho) ** 2));
  const major = twoMajor / 2;
  const tube = Math.sqrt(square - twoMajor * rho + major * major);
  const off = rms(profile.map(([r, z]) => Math.hypot(r - major, z) - tube)) / tube;
  return { ratio: major / tube, off };
}

/**
 * Thickness of the slab about the plane z = a x + b y + c that fits best, over the extent in x.
 * @param {Float32Array} positions
 */
export function offPlane(positions) {
  const list = points(positions);
  const m = centroid(list);
  let [xx, xy, yy, xz, yz] = [0, 0, 0, 0, 0];
  for (const p of list) {
    const [x, y, z] = [p[0] - m[0], p[1] - m[1], p[2] - m[2]];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xz += x * z;
    yz += y * z;
  }
  const determinant = xx * yy - xy * xy;
  const a = (xz * yy - yz * xy) / determinant;
  const b = (yz * xx - xz * xy) / determinant;
  const off = list.map((p) => Math.abs(p[2] - m[2] - a * (p[0] - m[0]) - b * (p[1] - m[1])));
  return Math.max(...off) / Math.sqrt((xx + yy) / list.length);
}

/**
 * Distance of vertices from the equally numbered ones of a surface along its normals, root mean
 * square: sliding along it does not count, nor does its boundary, which is held.
 * @param {Float32Array} positions
 * @param {Pick<import("../protocol.js").Loaded, "positions" | "triangles" | "boundaryEdges">} surface
 */
export function apart(positions, { positions: surface, triangles, boundaryEdges }) {
  const [moved, list] = [points(positions), points(surface)];
  const normals = list.map(() => [0, 0, 0]);
  const difference = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    a.map((value, k) => value - b[k]);
  for (let i = 0; i < triangles.length; i += 3) {
    const corners = [...triangles.subarray(i, i + 3)];
    const [a, b, c] = corners.map((v) => list[v]);
    const normal = cross(difference(b, a), difference(c, a));
    for (const v of corners) for (let k = 0; k < 3; k++) normals[v][k] += normal[k];
  }
  const held = new Set(boundaryEdges);
  const off = list.flatMap((p, v) =>
    held.has(v) ? [] : [dot(difference(moved[v], p), normals[v]) / Math.hypot(...normals[v])],
  );
  return rms(off);
}

/** Sum over the edges of a pane of how much its field differs between their ends. */
/** @param {Run} run @param {string} name */
export function variation({ panes }, name) {
  const pane = panes.find((one) => one.name === name);
  if (!pane?.field) return Number.NaN;
  const { values } = pane.field;
  let sum = 0;
  for (let i = 0; i < pane.wireEdges.length; i += 2) {
    sum += Math.abs(values[pane.wireEdges[i]] - values[pane.wireEdges[i + 1]]);
  }
  return sum;
}

/** Readings of edge flips by criterion. @param {Run} run */
export function flips({ last }) {
  const of = (/** @type {string} */ name) => {
    const reading = last.flips?.find(({ criterion }) => criterion === name);
    return reading ?? { flips: Number.NaN, area: Number.NaN, circle: Number.NaN };
  };
  return { area: of("area"), willmore: of("willmore"), localised: of("localised") };
}
