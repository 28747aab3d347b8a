// @ts-check
// A static web server as plain as the plainest host: files, their types, 404.

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { typeOf } from "../../../www/vite-plugin.js";

/** The built site. */
export const site = fileURLToPath(new URL("../../../dist", import.meta.url));

/**
 * Serves a folder on a free port of this machine, by default below a sub-path:
 * a site that works there has no absolute addresses in it.
 * @param {string} [folder]
 * @param {string} [base]  begins and ends with a slash
 * @param {number} [wanted]  port of a server that was closed, to take its place
 * @returns {Promise<{ url: string, close: () => Promise<void> }>}
 */
export async function serve(folder = site, base = "/some/folder/", wanted = 0) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const inside = pathname.startsWith(base) ? pathname.slice(base.length) || "index.html" : null;
    const file = inside === null ? null : path.join(folder, decodeURIComponent(inside));
    try {
      if (file === null || !file.startsWith(folder + path.sep)) throw new Error("outside");
      const bytes = await readFile(file);
      // As hosts of static sites do: a script module may be used by other pages only so.
      const headers = { "content-type": typeOf(file), "access-control-allow-origin": "*" };
      response.writeHead(200, headers).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(wanted, "127.0.0.1", () => resolve(undefined)));
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  return {
    url: `http://127.0.0.1:${port}${base}`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
