// @ts-check
// The mesh among files, out of archives that zlib and fflate made; damaged archives, and archives
// that would be too large, are refused.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { strToU8, zipSync } from "fflate";
import { meshAmong } from "../../www/unpack.js";
import { entriesOf } from "../../www/zip.js";

const mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/** @param {string | Uint8Array} content */
const bytesOf = (content) =>
  Uint8Array.from(typeof content === "string" ? strToU8(content) : content);

/** @param {Record<string, string | Uint8Array>} files @param {0 | 9} [level] */
const zip = (files, level = 9) =>
  zipSync(Object.fromEntries(Object.entries(files).map(([name, one]) => [name, bytesOf(one)])), {
    level,
  });

/** @param {Record<string, string | Uint8Array>} files */
const among = (files) =>
  meshAmong(Object.entries(files).map(([name, one]) => ({ name, bytes: bytesOf(one) })));

/** @param {{ bytes: Uint8Array }} found */
const text = ({ bytes }) => new TextDecoder().decode(bytes);

/** @param {Promise<unknown>} promise @param {string} kind */
const refuses = (promise, kind) =>
  assert.rejects(promise, (/** @type {any} */ error) => {
    assert.equal(error.kind, kind);
    assert.match(error.message.id, /^unpack-/);
    return true;
  });

test("a mesh is found in gzip, in ZIP, in both, and among several files", async () => {
  /** @type {Record<string, string | Uint8Array>[]} */
  const packed = [
    { "a.obj": mesh },
    { "a.obj.gz": gzipSync(mesh) },
    { "b.zip": zip({ "a.obj": mesh }) },
    { "b.zip": zip({ "a.obj": mesh }, 0) },
    { "b.zip": zip({ "deep/er/a.obj": mesh, "deep/a.mtl": "x", "deep/a.png": "y" }) },
    { "b.zip": zip({ "a.OBJ.gz": gzipSync(mesh), "read.txt": "x" }) },
    { "b.zip.gz": gzipSync(zip({ "a.obj": mesh })) },
    { "b.zip": zip({ "__MACOSX/._a.obj": "x".repeat(999), "a.obj": mesh, ".c.obj": "y" }) },
    { "a.mtl": "x", "a.obj": mesh, "a.png": "y" },
    { "a.mtl": "x", "a.zip": zip({ "a.obj": mesh }) },
  ];
  for (const files of packed) {
    const found = await among(files);
    assert.equal(text(found), mesh);
    assert.deepEqual([found.name.toLowerCase(), found.others], ["a.obj", []]);
  }
  // What has no ending that says so is left to whoever reads it.
  assert.equal((await among({ "some.txt": mesh })).name, "some.txt");
  assert.equal(text(await among({ "b.zip": zip({ "some.txt": mesh }) })), mesh);
  const several = await among({
    "b.zip": zip({ "x/a.obj": mesh, "b.ply": "ply", "c.off": "OFF" }),
  });
  assert.deepEqual([several.name, several.others], ["a.obj", ["b.ply", "c.off"]]);
});

test("the models of a 3MF package are put after each other, the first in front", async () => {
  const one = await among({
    "a.3mf": zip({ "[Content_Types].xml": "x", "3D/3dmodel.model": "<m/>" }),
  });
  assert.deepEqual([one.name, text(one)], ["a.3mf", "<m/>"]);
  const two = await among({
    "a.3mf": zip({ "3D/Objects/o_1.model": "<o/>", "3D/3dmodel.model": "<m/>" }),
  });
  const expected = "<?model /3D/3dmodel.model?>\n<m/>\n<?model /3D/Objects/o_1.model?>\n<o/>\n";
  assert.equal(text(two), expected);
  // Wherever the package says that its model is.
  const relations = `<Relationships><Relationship Target="/a.png" Type="x/thumbnail"/>
    <Relationship Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'
    Target='/Models/Main.model'/></Relationships>`;
  const parts = { "parts/o.model": "<o/>", "models/main.model": "<m/>", "_rels/.rels": relations };
  const elsewhere = await among({ "b.zip": zip(parts) });
  const both = "<?model /models/main.model?>\n<m/>\n<?model /parts/o.model?>\n<o/>\n";
  assert.deepEqual([elsewhere.name, text(elsewhere)], ["b.3mf", both]);
});

test("a glTF file gets the buffers beside it", async () => {
  const scene = JSON.stringify({ buffers: [{ uri: "the%20mesh.bin" }, { uri: "data:x" }, {}] });
  const bin = Uint8Array.from({ length: 100_001 }, (_, k) => k % 251);
  for (const files of /** @type {Record<string, string | Uint8Array>[]} */ ([
    { "a.gltf": scene, "the mesh.bin": bin },
    { "a.zip": zip({ "x/a.gltf": scene, "x/the mesh.bin": bin, "the mesh.bin": "no" }) },
  ])) {
    const { name, bytes } = await among(files);
    const { buffers } = JSON.parse(new TextDecoder().decode(bytes));
    assert.equal(name, "a.gltf");
    const [head, body] = buffers[0].uri.split(",");
    assert.equal(head, "data:application/octet-stream;base64");
    assert.deepEqual(new Uint8Array(Buffer.from(body, "base64")), bin);
    assert.deepEqual(buffers.slice(1), [{ uri: "data:x" }, {}]);
  }
  assert.equal(text(await among({ "a.gltf": "{" })), "{");
});

/** An archive whose first file's head in the list is changed. */
function changed(/** @type {(view: DataView, at: number) => void} */ change, content = mesh) {
  const bytes = zip({ "a.obj": content });
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const at = view.getUint32(bytes.length - 6, true);
  change(view, at);
  return among({ "b.zip": bytes });
}

test("damaged archives are refused, wherever the damage is", async () => {
  await refuses(among({ "a.gz": gzipSync(mesh).subarray(0, 20) }), "Damaged");
  const whole = zip({ "a.obj": mesh.repeat(20) });
  for (let end = 4; end < whole.length; end += 1) {
    await refuses(among({ "b.zip": whole.subarray(0, end) }), "Damaged");
  }
  let refused = 0;
  for (let at = 4; at < whole.length; at += 1) {
    const bytes = Uint8Array.from(whole);
    bytes[at] ^= 0x10;
    const outcome = await among({ "b.zip": bytes }).catch((error) => error);
    if (outcome.kind) refused += 1;
    // A name, a date or a comment may be another; what is in the file may not.
    else assert.equal(text(outcome), mesh.repeat(20), `byte ${at}`);
  }
  assert.ok(refused > whole.length / 4, `${refused} of ${whole.length}`);
  await refuses(
    changed((view, at) => view.setUint16(at + 8, 1, true)),
    "Encrypted",
  );
  await refuses(
    changed((view, at) => view.setUint16(at + 10, 14, true)),
    "Unsupported",
  );
  await refuses(
    changed((view, at) => view.setUint32(at + 16, 7, true)),
    "Damaged",
  );
  await refuses(
    changed((view, at) => view.setUint32(at + 24, 7, true)),
    "TooLarge",
  );
  await refuses(
    changed((view, at) => view.setUint32(at + 42, 1 << 30, true)),
    "Damaged",
  );
  await refuses(among({ "b.zip": zip({ "a.txt": "x", "b.txt": "y" }) }), "NoMesh");
  await refuses(among({ "b.zip": zip({}) }), "NoMesh");
});

test("what would be too large is refused before it is there", async () => {
  // 40 MB of blanks in 40 kB.
  const bomb = new Uint8Array(40_000_000).fill(32);
  await refuses(among({ "a.obj.gz": gzipSync(bomb) }), "TooLarge");
  await refuses(among({ "b.zip": zip({ "a.obj": bomb }) }), "TooLarge");
  // The same that says it were small: no more than that is unpacked.
  await refuses(
    changed((view, at) => view.setUint32(at + 24, 1000, true), " ".repeat(40_000_000)),
    "TooLarge",
  );
});

test("sizes of 64 bits are read", async () => {
  const bytes = zip({ "a.obj": mesh }, 0);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const at = view.getUint32(bytes.length - 6, true);
  const list = bytes.subarray(at, bytes.length - 22);
  // Its list again, with the sizes and the place in an extra field.
  const wide = new Uint8Array(list.length + 28);
  wide.set(list);
  const own = new DataView(wide.buffer);
  for (const k of [20, 24, 42]) own.setUint32(k, 0xffffffff, true);
  own.setUint16(30, 28, true);
  own.setUint16(list.length, 1, true);
  own.setUint16(list.length + 2, 24, true);
  [mesh.length, mesh.length, 0].forEach((n, k) => {
    own.setBigUint64(list.length + 4 + 8 * k, BigInt(n), true);
  });
  const end = new DataView(new ArrayBuffer(56 + 20 + 22));
  end.setUint32(0, 0x06064b50, true);
  end.setBigUint64(32, 1n, true);
  end.setBigUint64(48, BigInt(at), true);
  end.setUint32(56, 0x07064b50, true);
  end.setBigUint64(64, BigInt(at + wide.length), true);
  end.setUint32(76, 0x06054b50, true);
  end.setUint16(76 + 10, 0xffff, true);
  end.setUint32(76 + 16, 0xffffffff, true);
  const whole = new Uint8Array([...bytes.subarray(0, at), ...wide, ...new Uint8Array(end.buffer)]);
  const [entry] = entriesOf(whole);
  assert.equal(entry.size, mesh.length);
  assert.equal(new TextDecoder().decode(await entry.read()), mesh);
});
