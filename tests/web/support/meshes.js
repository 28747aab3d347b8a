// @ts-check
// Meshes written by the tests themselves, of known counts.

/**
 * A torus with a wave on it, so that there is something to smooth: R = 2, r = 0.8.
 * Closed, genus 1, `around · along` vertices and twice as many triangles.
 * @param {number} [along]
 * @param {number} [around]
 * @returns {{ positions: number[][], triangles: number[][] }}
 */
export function wavyTorus(along = 48, around = 24) {
  const positions = [];
  const triangles = [];
  const index = (/** @type {number} */ i, /** @type {number} */ j) =>
    (i % along) * around + (j % around);
  for (let i = 0; i < along; i += 1) {
    for (let j = 0; j < around; j += 1) {
      const [u, v] = [(2 * Math.PI * i) / along, (2 * Math.PI * j) / around];
      const r = 0.8 + 0.08 * Math.sin(5 * u) * Math.cos(2 * v);
      const ring = 2 + r * Math.cos(v);
      positions.push([ring * Math.cos(u), ring * Math.sin(u), r * Math.sin(v)]);
      triangles.push([index(i, j), index(i + 1, j), index(i + 1, j + 1)]);
      triangles.push([index(i, j), index(i + 1, j + 1), index(i, j + 1)]);
    }
  }
  return { positions, triangles };
}

/** @param {ReturnType<typeof wavyTorus>} mesh */
export function obj({ positions, triangles }) {
  const vertices = positions.map((p) => `v ${p.join(" ")}\n`);
  const faces = triangles.map((t) => `f ${t.map((i) => i + 1).join(" ")}\n`);
  return [...vertices, ...faces].join("");
}

/** @param {ReturnType<typeof wavyTorus>} mesh */
export function ply({ positions, triangles }) {
  return [
    "ply\nformat ascii 1.0\n",
    `element vertex ${positions.length}\n`,
    "property double x\nproperty double y\nproperty double z\n",
    `element face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header\n`,
    ...positions.map((p) => `${p.join(" ")}\n`),
    ...triangles.map((t) => `3 ${t.join(" ")}\n`),
  ].join("");
}

/** Binary PLY, as scanners write it. @param {ReturnType<typeof wavyTorus>} mesh */
export function binaryPly({ positions, triangles }) {
  const head = [
    "ply\nformat binary_little_endian 1.0\n",
    `element vertex ${positions.length}\nproperty float x\nproperty float y\nproperty float z\n`,
    `element face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header\n`,
  ].join("");
  const faces = Buffer.alloc(13 * triangles.length);
  for (const [n, triangle] of triangles.entries()) {
    faces[13 * n] = 3;
    for (const [k, vertex] of triangle.entries()) faces.writeInt32LE(vertex, 13 * n + 1 + 4 * k);
  }
  const points = Buffer.from(Float32Array.from(positions.flat()).buffer);
  return Buffer.concat([Buffer.from(head), points, faces]);
}
