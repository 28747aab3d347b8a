// Every action by name, with its keys. What a key does is said here and nowhere else.

/** @import { Page } from "./actions.js" */

import { colours } from "./options.js";
import { speeds } from "./player.js";
import { tabs, tools } from "./store.js";
import { say } from "./words.js";

/** Keys that are not called as what they write. */
const named = ["space", "home", "end", "ctrl-z", "ctrl-k"];

/** What is printed on a key. @param {string} key */
export const keyName = (key) => (named.includes(key) ? say(`key-${key}`) : key.toUpperCase());

/** @typedef {{ id: string, keys: readonly string[], act: (page: Page) => unknown, repeats?: boolean }} Command */

/** @param {Page} page @param {number} by */
function faster(page, by) {
  const at = speeds.indexOf(page.player.speed.peek()) + by;
  page.player.speed.value = speeds[Math.min(Math.max(at, 0), speeds.length - 1)];
}

/** While presenting, the legend is shown and taken away. @param {Page} page */
function nextColour(page) {
  const { presenting, legend, colour } = page.get();
  if (presenting) page.patch({ legend: !legend });
  if (presenting && colour !== "none") return;
  const at = colours.indexOf(page.get().colour);
  return page.run.colour(colours[(at + 1) % colours.length]);
}

const toStart = (/** @type {Page} */ page) =>
  page.run.seek(page.lead.clip.points[0]?.state.step ?? 0);
const toEnd = (/** @type {Page} */ page) => page.run.seek(page.lead.clip.last?.state.step ?? 0);

/** @param {keyof import("./store.js").View} name @returns {(page: Page) => unknown} */
const flip = (name) => (page) => page.run.view({ [name]: !page.get().view[name] });

/** @param {string} format @returns {(page: Page) => Promise<void>} */
const saved = (format) => async (page) => (await import("./save.js")).saveFile(page, format);

/** @type {readonly Command[]} */
export const commands = [
  { id: "play", keys: ["space"], act: (page) => page.run.toggle() },
  { id: "step", keys: ["."], act: (page) => page.run.step(), repeats: true },
  { id: "back", keys: [","], act: (page) => page.run.back(), repeats: true },
  { id: "reset", keys: ["r"], act: (page) => page.run.reset() },
  { id: "start", keys: ["home"], act: toStart },
  { id: "end", keys: ["end"], act: toEnd },
  { id: "slower", keys: ["["], act: (page) => faster(page, -1) },
  { id: "faster", keys: ["]"], act: (page) => faster(page, 1) },
  { id: "loop", keys: ["l"], act: (page) => page.run.loop() },
  { id: "plot", keys: ["e"], act: (page) => page.patch({ dialog: "plot" }) },
  { id: "library", keys: ["/"], act: (page) => page.patch({ dialog: "library" }) },
  { id: "open", keys: ["o"], act: (page) => page.chooseFile() },
  ...tabs.map((id, n) => ({
    id,
    keys: [`${n + 1}`],
    act: (/** @type {Page} */ page) => page.turn(id),
  })),
  { id: "colour", keys: ["c"], act: nextColour },
  { id: "wireframe", keys: ["m"], act: flip("wireframe") },
  { id: "fit", keys: ["v"], act: (page) => page.stage.fit() },
  { id: "flip-panes", keys: ["b"], act: (page) => page.compare.flip() },
  { id: "present", keys: ["f"], act: (page) => page.present() },
  { id: "undo", keys: ["ctrl-z"], act: (page) => page.edit.undo() },
  { id: "commands", keys: ["ctrl-k"], act: (page) => page.patch({ dialog: "commands" }) },
  { id: "help", keys: ["?"], act: (page) => page.patch({ dialog: "help" }) },
  ...tools.map((id) => ({ id, keys: [], act: (/** @type {Page} */ page) => page.tool(id) })),
  { id: "repair", keys: [], act: (page) => page.edit.repair() },
  { id: "regularise", keys: [], act: (page) => page.edit.regularise() },
  { id: "adopt", keys: [], act: (page) => page.edit.adopt() },
  { id: "download", keys: [], act: saved("ply") },
  { id: "picture", keys: [], act: saved("png") },
  { id: "boundary-lines", keys: [], act: flip("boundary") },
  { id: "contrast", keys: [], act: flip("contrast") },
];

/** @param {EventTarget | null} target whether a key belongs to a control that takes text or choices */
export function takesKeys(target) {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target.matches("select, textarea")) return true;
  return target instanceof HTMLInputElement && !["checkbox", "radio"].includes(target.type);
}

/** @param {EventTarget | null} target whether Space presses it already */
const takesSpace = (target) =>
  target instanceof Element && target.matches("button, summary, a[href], input, .scroll");

/** Single keys. They rest while something is typed or a dialog is open. @param {Page} page */
export function listenForKeys(page) {
  addEventListener("keydown", (event) => {
    const { dialog, question, mode, why, legend, tab, welcome, presenting, comparison } =
      page.get();
    if (event.key === "Escape" && !dialog && !question) {
      if (mode) page.edit.mode(null);
      else if (why) page.why.close();
      else if (legend) page.patch({ legend: false });
      else if (presenting) page.present(false);
      else if (comparison.shown !== "side") page.compare.show({ shown: "side" });
      else if (tab) page.turn(tab);
      else if (welcome) page.patch({ welcome: false });
      return;
    }
    const name = event.key === " " ? "space" : event.key.toLowerCase();
    const key = event.ctrlKey || event.metaKey ? `ctrl-${name}` : name;
    const command = commands.find(({ keys }) => keys.includes(key));
    if (!command || !page.keysOn.peek() || event.defaultPrevented) return;
    if (event.altKey || event.isComposing || dialog || question) return;
    if (takesKeys(event.target) || (key === "space" && takesSpace(event.target))) return;
    event.preventDefault();
    if (!event.repeat || command.repeats) command.act(page);
  });
}
