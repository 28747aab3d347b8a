// @ts-check
// A visitor brings files of other programs: a GLB, an OBJ with its material in a ZIP, a glTF with
// its numbers in a file of their own.

import assert from "node:assert/strict";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { strToU8, zipSync } from "fflate";
import { reading, surface, until, useSite } from "./support/app.js";
import { glb, gltf } from "./support/formats.js";
import { obj, wavyTorus } from "./support/meshes.js";

const site = useSite();

/**
 * Drops files on the page.
 * @param {import("playwright-core").Page} page
 * @param {Record<string, Uint8Array>} files
 */
async function drop(page, files) {
  const listed = Object.entries(files).map(([name, bytes]) => ({ name, bytes: [...bytes] }));
  await page.evaluate((all) => {
    const dataTransfer = new DataTransfer();
    for (const { name, bytes } of all) {
      dataTransfer.items.add(new File([new Uint8Array(bytes)], name));
    }
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }));
  }, listed);
}

/** A text in gzip of two members. @param {string} text */
const halves = (text) =>
  new Uint8Array(
    Buffer.concat([
      gzipSync(text.slice(0, text.length / 2)),
      gzipSync(text.slice(text.length / 2)),
    ]),
  );

test("files of other programs that are dropped are shown", async () => {
  const { page, faults, close } = await site.open();
  /** @type {{ title: string, along: number, files: Record<string, Uint8Array> }[]} */
  const dropped = [
    { title: "wave", along: 24, files: { "wave.glb": glb(wavyTorus(24, 12)) } },
    {
      title: "packed",
      along: 30,
      files: {
        "all.zip": zipSync({
          "in/packed.obj": strToU8(obj(wavyTorus(30, 12))),
          "in/packed.mtl": strToU8("newmtl a\n"),
        }),
      },
    },
    { title: "mesh", along: 36, files: gltf(wavyTorus(36, 12)) },
    // As `cat` puts two packed files together.
    { title: "joined", along: 27, files: { "joined.obj.gz": halves(obj(wavyTorus(27, 12))) } },
  ];
  for (const { title, along, files } of dropped) {
    await drop(page, files);
    await page.getByRole("img", { name: new RegExp(`^Surface: ${title}`) }).waitFor();
    await until(page, "Ready");
    assert.match(await surface(page), new RegExp(`^Surface: ${title}, step 0`));
    assert.equal(await reading(page, "Vertices"), String(12 * along));
    assert.equal(await reading(page, "Faces"), String(24 * along));
  }
  await drop(page, { "none.zip": zipSync({ "a.txt": strToU8("x"), "b.txt": strToU8("y") }) });
  await page.getByRole("alert").filter({ hasText: "There is no mesh" }).waitFor();
  assert.deepEqual(faults, []);
  await close();
});
