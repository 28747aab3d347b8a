// A triangle mesh as a file, of what the page itself has. The solver writes every format; this is
// for when it cannot be asked.

/**
 * Binary PLY with `double` positions, so that no digit is lost.
 * @param {ArrayLike<number>} positions  three coordinates a vertex
 * @param {ArrayLike<number>} shift      added to each
 * @param {Uint32Array} triangles        three corners each
 * @param {ArrayLike<number> | null} colours  of four parts each, from 0 to 1
 */
export function plyOf(positions, shift, triangles, colours) {
  const [vertices, faces] = [positions.length / 3, triangles.length / 3];
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${vertices}\n` +
      "property double x\nproperty double y\nproperty double z\n" +
      (colours ? ["red", "green", "blue", "alpha"] : [])
        .map((part) => `property uchar ${part}\n`)
        .join("") +
      `element face ${faces}\nproperty list uchar int vertex_indices\nend_header\n`,
  );
  const row = colours ? 28 : 24;
  const bytes = new Uint8Array(header.length + row * vertices + 13 * faces);
  bytes.set(header);
  const view = new DataView(bytes.buffer);
  let at = header.length;
  for (let v = 0; v < vertices; v += 1, at += row) {
    for (let k = 0; k < 3; k += 1) {
      view.setFloat64(at + 8 * k, positions[3 * v + k] + shift[k], true);
    }
    for (let k = 0; colours && k < 4; k += 1) {
      view.setUint8(at + 24 + k, Math.round(255 * colours[4 * v + k]));
    }
  }
  for (let n = 0; n < triangles.length; n += 3, at += 13) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; k += 1) view.setInt32(at + 1 + 4 * k, triangles[n + k], true);
  }
  return bytes;
}
