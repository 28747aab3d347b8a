// The mesh among files that were opened together, for the page and the command line: out of gzip
// and ZIP, and with what a glTF file or a 3MF package keeps elsewhere put into it.

import { isMeshName } from "./mesh-format.js";
import { refusal } from "./refusal.js";
import { entriesOf, gunzip, isGzip, isZip } from "./zip.js";

/** @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Bytes */
/** A file that is read when it is asked for. @typedef {import("./zip.js").Entry} Part */

const base = (/** @type {string} */ name) => name.slice(name.lastIndexOf("/") + 1);
const folder = (/** @type {string} */ name) => name.slice(0, name.lastIndexOf("/") + 1);
const withoutGzip = (/** @type {string} */ name) => name.replace(/\.gz$/i, "");

/** What a file system adds of its own. @param {string} name */
const isHidden = (name) => name.startsWith("__MACOSX/") || base(name).startsWith(".");

/** What is in a file, but for gzip in gzip. @param {Bytes} file @returns {Promise<Part[]>} */
async function partsOf(file) {
  const isPacked = isGzip(file.bytes);
  const bytes = isPacked ? await gunzip(file.bytes) : file.bytes;
  const name = isPacked ? withoutGzip(file.name) : file.name;
  if (!isZip(bytes)) return [{ name, size: bytes.length, read: async () => bytes }];
  const all = entriesOf(bytes);
  const relations = all.find((entry) => entry.name === "_rels/.rels");
  const entries = all.filter((entry) => !isHidden(entry.name));
  const isModel = relations ? /\.model$/i : /^3D\/.*\.model$/i;
  const models = entries.filter((entry) => isModel.test(entry.name));
  return models.length > 0 ? [packageOf(name, models, relations)] : entries;
}

/** Where a package says that its model is, in small letters. @param {Part} [relations] */
async function firstModel(relations) {
  const text = relations ? new TextDecoder().decode(await relations.read()) : "";
  const tags = text.match(/<[^<>]*\/3dmodel["'][^<>]*>/g) ?? [];
  const target = /\bTarget\s*=\s*["']\/?([^"']+)/.exec(tags[0] ?? "");
  return (target?.[1] ?? "3D/3dmodel.model").toLowerCase();
}

/**
 * The model files of a 3MF package as one, the first of them in front; each after an instruction
 * that says its path, by which they name each other.
 * @param {string} name @param {Part[]} models @param {Part} [relations] @returns {Part}
 */
function packageOf(name, models, relations) {
  return {
    name: /\.3mf$/i.test(name) ? name : name.replace(/\.[^.]*$|$/, ".3mf"),
    size: models.reduce((sum, { size }) => sum + size, 0),
    async read() {
      if (models.length === 1) return models[0].read();
      const first = await firstModel(relations);
      const isFirst = (/** @type {Part} */ part) => part.name.toLowerCase() === first;
      const sorted = [...models].sort((a, b) => Number(isFirst(b)) - Number(isFirst(a)));
      /** @type {BlobPart[]} */
      const whole = [];
      for (const part of sorted) whole.push(`<?model /${part.name}?>\n`, await part.read(), "\n");
      return new Uint8Array(await new Blob(whole).arrayBuffer());
    },
  };
}

/** @param {Uint8Array} bytes */
function base64(bytes) {
  let text = "";
  // So many arguments of a call are sure to be allowed.
  for (let at = 0; at < bytes.length; at += 0x6000) {
    text += btoa(String.fromCharCode(...bytes.subarray(at, at + 0x6000)));
  }
  return text;
}

/**
 * A glTF file with the buffers that are in files of their own.
 * @param {Uint8Array<ArrayBuffer>} bytes @param {string} name @param {Part[]} parts
 */
async function withBuffers(bytes, name, parts) {
  /** @type {any} */
  let scene;
  try {
    scene = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    // Whoever reads it says where it breaks off.
    return bytes;
  }
  let isChanged = false;
  for (const buffer of Array.isArray(scene?.buffers) ? scene.buffers : []) {
    if (typeof buffer?.uri !== "string" || buffer.uri.startsWith("data:")) continue;
    let uri = buffer.uri;
    try {
      uri = decodeURIComponent(uri);
    } catch {
      // Taken as it stands.
    }
    const known =
      parts.find((part) => part.name === folder(name) + uri) ??
      parts.find((part) => base(part.name) === base(uri));
    if (!known) continue;
    buffer.uri = `data:application/octet-stream;base64,${base64(await known.read())}`;
    isChanged = true;
  }
  return isChanged ? new TextEncoder().encode(JSON.stringify(scene)) : bytes;
}

/**
 * @param {readonly Bytes[]} files  at least one
 * @returns the mesh itself, named without `.gz`, and further ones that were not taken
 * @throws {import("./generated/types.js").Fault}
 */
export async function meshAmong(files) {
  const parts = (await Promise.all(files.map(partsOf))).flat();
  const named = parts.filter(({ name }) => isMeshName(withoutGzip(name)));
  // One alone is read as what it is, whatever it is called.
  const meshes = named.length === 0 && parts.length === 1 ? parts : named;
  if (meshes.length === 0) {
    throw refusal("NoMesh", "unpack-no-mesh", { names: parts.map(({ name }) => name) });
  }
  // Of several the finest.
  const mesh = meshes.reduce((best, one) => (one.size > best.size ? one : best));
  const read = await mesh.read();
  const plain = isGzip(read) ? await gunzip(read) : read;
  const name = base(withoutGzip(mesh.name));
  return {
    name,
    bytes: /\.gltf$/i.test(name) ? await withBuffers(plain, mesh.name, parts) : plain,
    others: meshes.filter((one) => one !== mesh).map((one) => one.name),
  };
}
