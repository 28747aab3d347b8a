// @ts-check
// A triangle mesh as a file, of what the page itself has. The solver writes every format; this is
// for when it cannot be asked.

/**
 * Binary PLY with `double` positions, so that no digit is lost.
 * @param {ArrayLike<number>} positions  three coordinates a vertex
 * @param {ArrayLike<number>} shift      added to each
 * @param {Uint32Array} triangles        three corners each
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function plyOf(positions, shift, triangles) {
  const [vertices, faces] = [positions.length / 3, triangles.length / 3];
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${vertices}\n` +
      "property double x\nproperty double y\nproperty double z\n" +
      `element face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const bytes = new Uint8Array(header.length + 24 * vertices + 13 * faces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let at = header.length;
  for (let n = 0; n < positions.length; n += 1, at += 8) {
    view.setFloat64(at, positions[n] + shift[n % 3], true);
  }
  for (let n = 0; n < triangles.length; n += 3, at += 13) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; k += 1) view.setInt32(at + 1 + 4 * k, triangles[n + k], true);
  }
  return bytes;
}
