// @ts-check
// Files of other programs, written by the tests themselves: the mesh of `meshes.js` as each.

import { strToU8, zipSync } from "fflate";

/** @typedef {{ positions: number[][], triangles: number[][] }} Mesh */

/** @param {Mesh} mesh @returns {{ json: any, binary: Uint8Array<ArrayBuffer> }} */
function scene({ positions, triangles }) {
  const indices = new Uint32Array(triangles.flat());
  const vectors = new Float32Array(positions.flat());
  const binary = new Uint8Array(indices.byteLength + vectors.byteLength);
  binary.set(new Uint8Array(indices.buffer));
  binary.set(new Uint8Array(vectors.buffer), indices.byteLength);
  const json = {
    asset: { version: "2.0" },
    nodes: [{ mesh: 0, scale: [2, 2, 2] }],
    scenes: [{ nodes: [0] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 1 }, indices: 0 }] }],
    accessors: [
      { bufferView: 0, componentType: 5125, count: indices.length, type: "SCALAR" },
      { bufferView: 1, componentType: 5126, count: positions.length, type: "VEC3" },
    ],
    bufferViews: [
      { buffer: 0, byteLength: indices.byteLength },
      { buffer: 0, byteOffset: indices.byteLength, byteLength: vectors.byteLength },
    ],
    buffers: [{ byteLength: binary.length }],
  };
  return { json, binary };
}

/** @param {Mesh} mesh */
export function glb(mesh) {
  const { json, binary } = scene(mesh);
  const text = JSON.stringify(json);
  const head = strToU8(text.padEnd(Math.ceil(text.length / 4) * 4));
  const numbers = (/** @type {number[]} */ ...list) => new Uint8Array(new Uint32Array(list).buffer);
  return Buffer.concat([
    strToU8("glTF"),
    numbers(2, 28 + head.length + binary.length, head.length),
    strToU8("JSON"),
    head,
    numbers(binary.length),
    strToU8("BIN\0"),
    binary,
  ]);
}

/** A scene with its numbers in `mesh.bin`. @param {Mesh} mesh */
export function gltf(mesh) {
  const { json, binary } = scene(mesh);
  json.buffers[0].uri = "mesh.bin";
  return { "mesh.gltf": Buffer.from(JSON.stringify(json)), "mesh.bin": Buffer.from(binary) };
}

/** @param {Mesh} mesh */
export function threeMf({ positions, triangles }) {
  const vertices = positions.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`);
  const faces = triangles.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`);
  const model = `<?xml version="1.0"?><model><resources><object id="1"><mesh><vertices>${vertices.join("")}</vertices><triangles>${faces.join("")}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>`;
  return Buffer.from(zipSync({ "3D/3dmodel.model": strToU8(model) }));
}

/** @param {Mesh} mesh */
export function vtk({ positions, triangles }) {
  const faces = triangles.map((t) => `3 ${t.join(" ")}`);
  return Buffer.from(
    `# vtk DataFile Version 3.0\na mesh\nASCII\nDATASET POLYDATA\nPOINTS ${positions.length} double\n${positions
      .map((p) => p.join(" "))
      .join("\n")}\nPOLYGONS ${faces.length} ${4 * faces.length}\n${faces.join("\n")}\n`,
  );
}

/** @param {Mesh} mesh */
export function msh({ positions, triangles }) {
  const nodes = positions.map((p, k) => `${k + 1} ${p.join(" ")}`);
  const elements = triangles.map((t, k) => `${k + 1} 2 0 ${t.map((v) => v + 1).join(" ")}`);
  return Buffer.from(
    `$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n${nodes.length}\n${nodes.join("\n")}\n$EndNodes\n$Elements\n${elements.length}\n${elements.join("\n")}\n$EndElements\n`,
  );
}
