// A camera turned so that a place of the surface is seen from in front.

/** @typedef {[number, number, number]} Vector */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {Vector} */
const cross = (a, b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** @param {Vector} v @returns {Vector | null} */
function unit(v) {
  const length = Math.hypot(...v);
  return length > 1e-12 ? [v[0] / length, v[1] / length, v[2] / length] : null;
}

/**
 * The vector area of some triangles: their mean normal.
 * @param {Float32Array} positions @param {Uint32Array} corners  of all triangles, three each
 * @param {ArrayLike<number>} triangles @returns {Vector}
 */
export function vectorArea(positions, corners, triangles) {
  const point = (/** @type {number} */ v) => positions.subarray(3 * v, 3 * v + 3);
  /** @type {Vector} */
  const sum = [0, 0, 0];
  for (const t of Array.from(triangles)) {
    const [a, b, c] = [0, 1, 2].map((k) => point(corners[3 * t + k]));
    const [u, v] = [b, c].map((p) => [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    cross(u, v).forEach((part, k) => {
      sum[k] += part;
    });
  }
  return sum;
}

/**
 * The same distance from the same point, looking against a direction.
 * @param {Float32Array} camera  target, distance, rotation (x, y, z, w), turntable axis
 * @param {Vector} direction
 * @returns {Float32Array | null} null where the direction is none, or that of the axis
 */
export function facing(camera, direction) {
  const backward = unit(direction);
  const right = backward && unit(cross(camera.subarray(8, 11), backward));
  if (!backward || !right) return null;
  const up = cross(backward, right);
  // The rotation with these columns as a quaternion (Shepperd's method).
  const [m, n, o] = [right, up, backward];
  const [xx, yy, zz] = [m[0], n[1], o[2]];
  const squares = [1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz, 1 + xx + yy + zz];
  const most = squares.indexOf(Math.max(...squares));
  const products = [
    [squares[0], m[1] + n[0], o[0] + m[2], n[2] - o[1]],
    [m[1] + n[0], squares[1], n[2] + o[1], o[0] - m[2]],
    [o[0] + m[2], n[2] + o[1], squares[2], m[1] - n[0]],
    [n[2] - o[1], o[0] - m[2], m[1] - n[0], squares[3]],
  ][most];
  const scale = 1 / Math.hypot(...products);
  const turned = Float32Array.from(camera);
  turned.set(
    products.map((part) => part * scale),
    4,
  );
  return turned;
}

/**
 * Triangles with one of these corners.
 * @param {Uint32Array} corners  of all triangles, three each @param {ArrayLike<number>} vertices
 */
export function trianglesAt(corners, vertices) {
  const wanted = new Set(Array.from(vertices));
  /** @type {Set<number>} */
  const found = new Set();
  corners.forEach((v, k) => {
    if (wanted.has(v)) found.add(Math.floor(k / 3));
  });
  return Uint32Array.from(found);
}
