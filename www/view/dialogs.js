// What opens over everything: help with its keys, the list of commands, the larger plot.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { commands, keyName } from "../commands.js";
import { remember } from "../language.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, close, idOf, keycap, toggle } from "./parts.js";
import { plot } from "./plot.js";

/** @import { Command } from "../commands.js" */

const shut = () => page.patch({ dialog: null });

const nameOf = (/** @type {Command} */ { id }) => say(`command-${id}`);
const keysOf = (/** @type {Command} */ { keys }) => keys.map((key) => keycap(keyName(key)));

/** Pages of the guide. */
const guide = ["first-look", "lecture", "mesh"];

export function help() {
  const pages = guide.map((name, n) => {
    const address = `./www/guide/${name}.html`;
    return html`${n > 0 ? " · " : ""}<a href=${address}>${say(`guide-${name}`)}</a>`;
  });
  const keys = commands
    .filter((command) => command.keys.length > 0)
    .map((command) => html`<dt>${keysOf(command)}</dt><dd>${nameOf(command)}</dd>`);
  const welcome = () => page.patch({ dialog: null, welcome: true, tab: null });
  return html`<header><h2>${say("help")}</h2>${close(shut)}</header>
    <p>${say("help-what")}</p><p>${say("help-how")}</p><p>${say("help-private")}</p>
    <p>${say("guide")} ${pages}</p>
    <h3>${say("keys")}</h3>
    ${toggle(say("keys-on"), page.keysOn.value, (on) => {
      page.keysOn.value = on;
      remember("keys", on ? "on" : "off");
    })}
    <dl class="keys">${keys}<dt>${keycap("← ↑ → ↓")}</dt><dd>${say("keys-turn")}</dd><dt>${keycap("Page ↓ ↑")}</dt><dd>${say("keys-clicker")}</dd></dl>
    <h3>${say("surface-gestures")}</h3><p>${say("gestures")}</p>
    <div class="row">${button(say("welcome-again"), welcome)}</div>
    <p class="hint">${say("version", { version: page.state.value.version })}</p><p class="hint">${page.stage.renderer.value}</p>`;
}

const wanted = signal("");
const chosen = signal(0);

/** @param {string} text */
function search(text) {
  wanted.value = text;
  chosen.value = 0;
}

/** @param {Command | undefined} command */
function perform(command) {
  if (!command) return;
  shut();
  search("");
  command.act(page);
}

export function palette() {
  const text = wanted.value.trim().toLowerCase();
  const found = commands.filter((command) => nameOf(command).toLowerCase().includes(text));
  const at = Math.min(chosen.value, found.length - 1);
  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.key === "Enter") perform(found[at]);
    else if (event.key === "ArrowDown") chosen.value = Math.min(at + 1, found.length - 1);
    else if (event.key === "ArrowUp") chosen.value = Math.max(at - 1, 0);
    else return;
    event.preventDefault();
  }
  const rows = found.map(
    (command, n) =>
      html`<li id="command-${command.id}" role="option" aria-selected=${String(n === at)} @click=${() => perform(command)}>
        <span>${nameOf(command)}</span>${keysOf(command)}</li>`,
  );
  return html`<header><h2 class="visually-hidden">${say("commands")}</h2>
      <input id=${idOf("command")} class="wide" role="combobox" aria-expanded="true" aria-controls="commands" aria-label=${say("commands")}
        aria-activedescendant=${found[at] ? `command-${found[at].id}` : nothing} placeholder=${say("commands-hint")} .value=${wanted.value}
        @keydown=${key} @input=${(/** @type {any} */ { target }) => search(target.value)} />${close(shut)}</header>
    <ul id="commands" class="commands" role="listbox" aria-label=${say("commands")}>${rows}</ul>`;
}

export const largePlot = () =>
  html`<header><h2>${say("larger-plot")}</h2>${close(shut)}</header>${plot()}`;
