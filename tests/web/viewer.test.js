// @ts-check
// The viewer alone, without the page, on both renderers: a surface between two steps, and
// what the pixels of a picture say of light, lines and effects.

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, openPage } from "./support/browser.js";
import { wavyTorus } from "./support/meshes.js";
import { serve } from "./support/server.js";

const packages = fileURLToPath(new URL("../../www/pkg", import.meta.url));

for (const name of /** @type {const} */ (["viewer", "viewer-webgl"])) {
  describe(`the package ${name}`, () => {
    /** @type {Awaited<ReturnType<typeof serve>>} */
    let server;
    /** @type {import("playwright-core").Browser} */
    let browser;
    before(async () => {
      server = await serve(packages);
      browser = await launch({ webgpu: name === "viewer" });
    });
    after(async () => {
      await browser?.close();
      await server?.close();
    });

    /**
     * A page with a viewer of a wavy torus on it, and pictures of it.
     * @param {object} style  of the viewer
     * @param {1 | 4} [samples]  a pixel
     */
    async function open(style, samples = 4) {
      const opened = await openPage(browser);
      const { page } = opened;
      // Any answer of the server gives the page its origin.
      await page.route("**/blank", (route) =>
        route.fulfill({ contentType: "text/html", body: "<canvas width=240 height=180></canvas>" }),
      );
      await page.goto(`${server.url}blank`);
      await page.evaluate(
        async ([url, mesh, style, samples]) => {
          const { default: load, Viewer } = await import(url);
          await load();
          const canvas = document.querySelector("canvas");
          const viewer = await Viewer.create(canvas, { samples });
          const positions = Float32Array.from(mesh.positions);
          const triangles = Uint32Array.from(mesh.triangles);
          viewer.setStyle(style);
          viewer.setMesh(positions, triangles, Uint32Array.from(mesh.edges), new Uint32Array());
          viewer.orbit(0, 15);
          const camera = viewer.camera();
          /** The surface after so many steps. @param {number} step */
          const after = (step) =>
            positions.map((x, n) => x * (1 - 0.07 * step * (n % 3)) + 0.02 * step * Math.sin(n));
          /** @param {number} step */
          const values = (step) => positions.map((x) => x + step).filter((_, n) => n % 3 === 0);
          /** What is on the picture, from the same place. */
          const picture = async () => {
            viewer.setCamera(camera);
            const { data } = await viewer.readPixels();
            let hash = 0;
            const colours = new Set();
            for (let n = 0; n < data.length; n += 4) {
              const pixel = (data[n] << 16) | (data[n + 1] << 8) | data[n + 2];
              hash = (Math.imul(hash, 31) + pixel) | 0;
              colours.add(pixel);
            }
            return { hash, colours: colours.size };
          };
          /** @param {object} style */
          const pixels = async (style) => {
            viewer.setStyle(style);
            return [...(await viewer.readPixels()).data];
          };
          Object.assign(globalThis, { viewer, after, values, picture, pixels, positions });
        },
        /** @type {[string, ReturnType<typeof torus>, object, number]} */ ([
          `${server.url}${name}/${name}.js`,
          torus(),
          style,
          samples,
        ]),
      );
      return opened;
    }

    for (const style of [
      { effects: "always", wireframe: true },
      { effects: "never", shading: "flat" },
    ]) {
      test(`draws steps exactly, and others between them: ${Object.values(style)}`, async () => {
        const { page, faults, close } = await open(style);
        const found = await page.evaluate(async () => {
          const { viewer, after, values, picture } = /** @type {any} */ (globalThis);
          const times = [0, 1, 1.5, 3, 3.25, 4];
          const alone = [];
          for (const step of times.keys()) {
            viewer.setPositions(after(step));
            viewer.setField(values(step), -2, 6, true);
            alone.push(await picture());
          }
          // Longer than what is held, so that the oldest make room.
          viewer.setPositions(after(0));
          viewer.setField(values(0), -2, 6, true);
          const moving = [];
          const between = [];
          for (const step of times.keys()) {
            if (step > 0) {
              viewer.addStep(after(step), times[step], step === 3);
              viewer.setField(values(step), -2, 6, true);
              viewer.setTime(0.5 * (times[step - 1] + times[step]));
              between.push(await picture());
            }
            viewer.setTime(times[step]);
            moving.push(await picture());
          }
          viewer.setTime(times[3]);
          return { alone, moving, between, again: await picture() };
        });
        assert.deepEqual(found.moving, found.alone);
        assert.deepEqual(found.again, found.alone[3]);
        const all = [...found.alone, ...found.between];
        assert.equal(new Set(all.map(({ hash }) => hash)).size, all.length, "two look alike");
        for (const { colours } of all) assert.ok(colours > 200, `only ${colours} colours`);
        assert.deepEqual(faults, []);
        await close();
      });
    }

    test("effects darken corners and floor, and software draws corners only at rest", async () => {
      const { page, faults, close } = await open({ theme: "light" });
      const [chosen, without, withAll] = await page.evaluate(async () => {
        const { viewer, positions, pixels } = /** @type {any} */ (globalThis);
        // Both walls of the hole close to each other.
        const squeezed = Float32Array.from(positions, (x, n) => (n % 3 === 0 ? 0.3 * x : x));
        viewer.setPositions(squeezed);
        const chosen = [viewer.effects(), viewer.settle(), viewer.effects()];
        const isDrawn = viewer.draw();
        chosen.push(isDrawn && viewer.effects());
        // One of a film is none at rest.
        viewer.settle();
        viewer.invalidate();
        chosen.push(viewer.effects());
        const without = await pixels({ effects: "never" });
        return [chosen, without, await pixels({ effects: "always" })];
      });
      if (process.platform === "linux")
        assert.deepEqual(chosen, ["shadow", true, "occlusion", "shadow", "shadow"]);
      const darker = { surface: 0, floor: 0 };
      for (let n = 0; n < without.length; n += 4) {
        const by = without[n] - withAll[n];
        // Multisampled edges of the surface show a little of the floor.
        assert.ok(by >= -1, `brighter by ${-by}`);
        // The surface is green, what is around it grey.
        const part = without[n + 1] - without[n] > 15 ? "surface" : "floor";
        if (by >= 8) darker[part] += 1;
      }
      assert.ok(darker.floor > 1000, `${darker.floor} pixels of the floor`);
      assert.ok(darker.surface > 100, `${darker.surface} pixels of the surface`);
      assert.deepEqual(faults, []);
      await close();
    });

    test("edges are drawn from near, and vanish before they make patterns", async () => {
      const { page, faults, close } = await open({ theme: "light", effects: "never" }, 1);
      /** Share of pixels that the wireframe changes. @param {number} zoom */
      const changed = async (zoom) => {
        /** @type {number[][]} */
        const [without, withEdges] = await page.evaluate(async (zoom) => {
          const { viewer, pixels } = /** @type {any} */ (globalThis);
          viewer.fit();
          viewer.zoom(zoom, 120, 90);
          return [await pixels({ wireframe: false }), await pixels({ wireframe: true })];
        }, zoom);
        const pixels = without.map((x, n) => Math.abs(x - withEdges[n]));
        return pixels.filter((by, n) => n % 4 === 0 && by > 2).length / (without.length / 4);
      };
      const [near, far] = [await changed(6), await changed(0.5)];
      assert.ok(near > 0.1, `${near} of the picture from near`);
      assert.ok(far < 0.001, `${far} of the picture from afar`);
      assert.deepEqual(faults, []);
      await close();
    });

    test("a cut opens the surface from the front, and is undone to the last bit", async () => {
      const { page, faults, close } = await open({ theme: "light", effects: "never" }, 1);
      const found = await page.evaluate(async () => {
        const { viewer, pixels } = /** @type {any} */ (globalThis);
        viewer.fit();
        const pictures = [];
        for (const cut of [0, 0.5, 1, 0]) pictures.push(await pixels({ cut }));
        /** Depth of what is picked in the middle of the ring’s near side. */
        const seen = [];
        for (const cut of [0, 0.5]) {
          viewer.setStyle({ cut });
          for (let y = 10; y < 180; y += 10) {
            const hit = viewer.pick(120, y);
            if (hit) seen.push([cut, viewer.project(...hit.slice(0, 3))[2]]);
          }
        }
        return { pictures, seen };
      });
      const [whole, half, none, again] = found.pictures;
      assert.deepEqual(again, whole);
      /** @param {number[]} a @param {number[]} b */
      const apart = (a, b) =>
        a.filter((x, n) => n % 4 === 0 && Math.abs(x - b[n]) > 8).length / (a.length / 4);
      assert.ok(apart(whole, half) > 0.05, `${apart(whole, half)}`);
      assert.ok(apart(half, none) > 0.05, `${apart(half, none)}`);
      /** @param {number} wanted */
      const depths = (wanted) => found.seen.filter(([cut]) => cut === wanted).map(([, z]) => z);
      const nearest = Math.min(...depths(0));
      assert.ok(Math.min(...depths(0.5)) > nearest * 1.02, "what is cut away is not picked");
      assert.deepEqual(faults, []);
      await close();
    });

    test("light changes the colour of a value within narrow bounds only", async () => {
      const { page, faults, close } = await open({ theme: "dark", effects: "always" }, 1);
      const data = await page.evaluate(async () => {
        const { viewer, positions, pixels } = /** @type {any} */ (globalThis);
        viewer.setField(new Float32Array(positions.length / 3).fill(1), -1, 1, true);
        return pixels({});
      });
      const light = (/** @type {number} */ byte) =>
        byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;
      const own = [0xa8, 0x56, 0x0f].map(light);
      let seen = 0;
      for (let n = 0; n < data.length; n += 4) {
        if (data[n] < 2 * data[n + 2]) continue;
        seen += 1;
        for (const channel of [0, 1]) {
          const ratio = light(data[n + channel]) / own[channel];
          assert.ok(ratio > 0.68 && ratio < 1.07, `${ratio} of the colour's light`);
        }
      }
      assert.ok(seen > 5000, `only ${seen} pixels of the surface`);
      assert.deepEqual(faults, []);
      await close();
    });
  });
}

/** A torus as arrays; more vertices than a row of the texture that carries them. */
function torus() {
  const { positions, triangles } = wavyTorus(60, 40);
  const edges = triangles.flatMap(([a, b, c]) => [a, b, b, c, c, a]);
  return { positions: positions.flat(), triangles: triangles.flat(), edges };
}
