// @ts-check
// WebKitGTK's MiniBrowser on a display in memory, driven by WebDriver: JSON over HTTP.

import { readdirSync } from "node:fs";
import { createServer } from "node:net";
import path from "node:path";
import { findDisplay, pressing, startDisplay } from "./engine.js";
import { findProgram, installPackages, isExecutable, start } from "./programs.js";

/** @import { Engine } from "./engine.js" */

/** @typedef {{ driver: string, browser: string }} Programs */

/** Where distributions put the program without a window of its own. */
function findBrowser() {
  const libraries = ["/usr/lib", "/usr/libexec", "/usr/lib64"];
  const folders = libraries.flatMap((folder) =>
    list(folder).flatMap((name) => [
      path.join(folder, name),
      ...(name.endsWith("-linux-gnu")
        ? list(path.join(folder, name)).map((inner) => path.join(folder, name, inner))
        : []),
    ]),
  );
  return (
    folders
      .filter((folder) => path.basename(folder).startsWith("webkit2gtk-"))
      .map((folder) => path.join(folder, "MiniBrowser"))
      .find(isExecutable) ?? null
  );
}

/** @param {string} folder */
function list(folder) {
  try {
    return readdirSync(folder);
  } catch {
    return [];
  }
}

/** @returns {Programs | null} */
function find() {
  const driver = findProgram(["WebKitWebDriver"]);
  const browser = findBrowser();
  return driver && browser && findDisplay() ? { driver, browser } : null;
}

/** Its programs; continuous integration installs them. */
export function ensureWebkit() {
  if (process.platform !== "linux") return null;
  if (!find() && process.env.CI) installPackages(["webkit2gtk-driver", "xvfb"]);
  return find();
}

/**
 * @param {Programs} programs
 * @returns {Promise<Engine>}
 */
export async function launchWebkit({ driver, browser }) {
  const display = await startDisplay();
  let stop = async () => {};
  const close = async () => {
    await stop();
    await display?.stop();
  };
  try {
    const port = await freePort();
    ({ stop } = await start(driver, [`--port=${port}`], undefined, display?.env));
    const address = `http://127.0.0.1:${port}`;
    await untilServed(`${address}/status`);
    return await connect(address, browser, close);
  } catch (error) {
    await close();
    throw error;
  }
}

/** The driver does not say which port it took; it can be given one. @returns {Promise<number>} */
function freePort() {
  const server = createServer();
  return new Promise((resolve) => {
    server.listen(0, "127.0.0.1", () => {
      const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}

/** @param {string} url */
async function untilServed(url) {
  const end = Date.now() + 30_000;
  for (;;) {
    const isThere = await fetch(url).then(
      ({ ok }) => ok,
      () => false,
    );
    if (isThere) return;
    if (Date.now() > end) throw new Error("WebKitWebDriver does not answer");
  }
}

/** The name under which WebDriver passes an element. */
const ELEMENT = "element-6066-11e4-a52e-4f735466cecf";

/**
 * @param {string} address
 * @param {string} binary
 * @param {() => Promise<void>} close
 * @returns {Promise<Engine>}
 */
async function connect(address, binary, close) {
  /** @param {string} command @param {object} [body]  none: it is a question */
  const send = async (command, body) => {
    const request = body && { method: "POST", body: JSON.stringify(body) };
    const response = await fetch(`${address}/session${command}`, request);
    const { value } = /** @type {any} */ (await response.json());
    if (!response.ok) throw new Error(`${command}: ${value.error}: ${value.message}`);
    return value;
  };
  const options = { binary, args: ["--automation"] };
  const { sessionId } = await send("", {
    capabilities: { alwaysMatch: { "webkitgtk:browserOptions": options } },
  });
  const session = `/${sessionId}`;
  await send(`${session}/timeouts`, { script: 300_000, pageLoad: 300_000 });
  /** @param {string} code */
  const call = async (code) => {
    const script = `
      const done = arguments[arguments.length - 1];
      Promise.resolve().then(() => (${code})).then(
        (value) => done({ value: value ?? null }),
        (error) => done({ error: String(error) }));`;
    const { value, error } = await send(`${session}/execute/async`, { script, args: [] });
    if (error) throw new Error(error);
    return value;
  };
  return {
    // WebDriver tells of none.
    faults: [],
    resize: async (width, height) => {
      // Of the window; the page is smaller by the bars around it.
      await send(`${session}/window/rect`, { width, height });
      const { w, h } = await call("({ w: innerWidth, h: innerHeight })");
      await send(`${session}/window/rect`, { width: 2 * width - w, height: 2 * height - h });
    },
    open: async (url) => {
      await send(`${session}/url`, { url });
    },
    evaluate: call,
    element: async (code) => {
      const element = await call(code);
      if (!element?.[ELEMENT]) throw new Error(`no element: ${code}`);
      return element;
    },
    click: async (element) => {
      await send(`${session}/actions`, { actions: pressing(element) });
    },
    setFile: async (element, file) => {
      await send(`${session}/element/${element[ELEMENT]}/value`, { text: file });
    },
    picture: async (element) => {
      const png = await send(`${session}/element/${element[ELEMENT]}/screenshot`);
      return Buffer.from(png, "base64");
    },
    close: async () => {
      await fetch(`${address}/session${session}`, { method: "DELETE" }).catch(() => {});
      await close();
    },
  };
}
