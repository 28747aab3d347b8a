// Sets of vertices as a byte each.

/**
 * Gives a value to the vertices within a ball.
 * @param {Uint8Array} set       changed in place @param {Float32Array} positions
 * @param {number[]} centre @param {number} radius @param {0 | 1} value
 */
export function painted(set, positions, [x, y, z], radius, value) {
  const most = radius * radius;
  for (let v = 0; v < set.length; v += 1) {
    const dx = positions[3 * v] - x;
    const dy = positions[3 * v + 1] - y;
    const dz = positions[3 * v + 2] - z;
    if (dx * dx + dy * dy + dz * dz <= most) set[v] = value;
  }
}

/**
 * Spreads a value by one ring of neighbours.
 * @param {Uint8Array} set @param {Uint32Array} triangles @param {0 | 1} value
 */
export function grown(set, triangles, value) {
  const next = Uint8Array.from(set);
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = triangles.subarray(t, t + 3);
    if (corners.some((v) => set[v] === value)) for (const v of corners) next[v] = value;
  }
  return next;
}

/** The edges out of a set. @param {Uint8Array} set @param {Uint32Array} edges  two ends each */
export function rim(set, edges) {
  /** @type {number[]} */
  const found = [];
  for (let e = 0; e < edges.length; e += 2) {
    if (set[edges[e]] !== set[edges[e + 1]]) found.push(edges[e], edges[e + 1]);
  }
  return Uint32Array.from(found);
}
