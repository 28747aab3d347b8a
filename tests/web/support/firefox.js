// @ts-check
// Firefox, driven by WebDriver BiDi: JSON over a WebSocket.

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { findDisplay, pressing, startDisplay } from "./engine.js";
import { findProgram, installPackages, start } from "./programs.js";

/** @import { Engine } from "./engine.js" */

const places = [
  "/Applications/Firefox.app/Contents/MacOS/firefox",
  "C:\\Program Files\\Mozilla Firefox\\firefox.exe",
];

/** Without a display it has no WebGL on Linux. */
const find = () =>
  process.platform !== "linux" || findDisplay()
    ? findProgram(["firefox-esr", "firefox"], places, "FIREFOX_PATH")
    : null;

/** Its program; continuous integration installs it. @returns {string | null} */
export function ensureFirefox() {
  if (!find() && process.env.CI) installPackages(["firefox-esr", "xvfb"]);
  return find();
}

/** It asks nobody anything, and does not look for a graphics card. */
const preferences = {
  "app.normandy.enabled": false,
  "browser.shell.checkDefaultBrowser": false,
  "browser.startup.page": 0,
  "datareporting.policy.dataSubmissionEnabled": false,
  "network.captive-portal-service.enabled": false,
  "network.connectivity-service.enabled": false,
  "services.settings.server": "data:,",
  "toolkit.telemetry.reportingpolicy.firstRun": false,
  "webgl.force-enabled": true,
};

/**
 * @param {string} program
 * @returns {Promise<Engine>}
 */
export async function launchFirefox(program) {
  const profile = mkdtempSync(path.join(tmpdir(), "umbilic-firefox-"));
  const lines = Object.entries(preferences).map(
    ([name, value]) => `user_pref("${name}", ${JSON.stringify(value)});\n`,
  );
  writeFileSync(path.join(profile, "user.js"), lines.join(""));
  const display = await startDisplay();
  const close = async () => {
    await display?.stop();
    rmSync(profile, { recursive: true, force: true });
  };
  try {
    const parameters = [
      ...(display ? [] : ["--headless"]),
      ...["--no-remote", "--remote-debugging-port=0", "--profile", profile, "about:blank"],
    ];
    const env = { HOME: profile, ...display?.env };
    const { sign, stop } = await start(program, parameters, /BiDi listening on (ws:\S+)/, env);
    return await connect(`${sign}/session`, async () => {
      await stop();
      await close();
    });
  } catch (error) {
    await close();
    throw error;
  }
}

/** @param {string} address @param {() => Promise<void>} close @returns {Promise<Engine>} */
async function connect(address, close) {
  /** @type {string[]} */
  const faults = [];
  const send = await talk(address, ({ method, params }) => {
    if (method === "log.entryAdded" && params.level === "error") faults.push(params.text);
  });
  await send("session.new", { capabilities: {} });
  await send("session.subscribe", { events: ["log.entryAdded"] });
  const { contexts } = await send("browsingContext.getTree", {});
  const { context } = contexts[0];
  /** @param {string} functionDeclaration @param {unknown[]} [elements] */
  const call = async (functionDeclaration, elements = []) => {
    const answer = await send("script.callFunction", {
      functionDeclaration,
      arguments: elements,
      awaitPromise: true,
      target: { context },
      userActivation: true,
    });
    if (answer.type === "exception") throw new Error(answer.exceptionDetails.text);
    return answer.result;
  };
  return {
    faults,
    resize: async (width, height) => {
      await send("browsingContext.setViewport", { context, viewport: { width, height } });
    },
    open: async (url) => {
      await send("browsingContext.navigate", { context, url, wait: "complete" });
    },
    evaluate: async (code) => {
      const { value } = await call(`async () => JSON.stringify((await (${code})) ?? null)`);
      return JSON.parse(value);
    },
    element: async (code) => {
      const { type, sharedId } = await call(`async () => await (${code})`);
      if (type !== "node") throw new Error(`no element: ${code}`);
      return { sharedId };
    },
    click: async (element) => {
      const actions = pressing({ type: "element", element });
      await send("input.performActions", { context, actions });
    },
    setFile: async (element, file) => {
      await send("input.setFiles", { context, element, files: [file] });
    },
    picture: async (element) => {
      const clip = { type: "element", element };
      const { data } = await send("browsingContext.captureScreenshot", { context, clip });
      return Buffer.from(data, "base64");
    },
    close,
  };
}

/**
 * @param {string} address
 * @param {(event: { method: string, params: any }) => void} hear
 * @returns {Promise<(method: string, params: object) => Promise<any>>} sends a command
 */
async function talk(address, hear) {
  // Here and not above: whoever only looks for the program may have no packages yet.
  const { WebSocket } = await import("ws");
  const socket = new WebSocket(address);
  /** @type {Map<number, { resolve: (value: any) => void, reject: (error: Error) => void }>} */
  const waiting = new Map();
  let last = 0;
  socket.on("message", (text) => {
    const message = JSON.parse(String(text));
    if (message.type === "event") return hear(message);
    const { resolve, reject } = waiting.get(message.id) ?? {};
    waiting.delete(message.id);
    if (message.type === "success") resolve?.(message.result);
    else reject?.(new Error(`${message.error}: ${message.message}`));
  });
  socket.on("close", () => {
    for (const { reject } of waiting.values()) reject(new Error("Firefox is gone"));
  });
  await new Promise((resolve, reject) => {
    socket.once("open", resolve);
    socket.once("error", reject);
  });
  return (method, params) =>
    new Promise((resolve, reject) => {
      last += 1;
      waiting.set(last, { resolve, reject });
      socket.send(JSON.stringify({ id: last, method, params }));
    });
}
