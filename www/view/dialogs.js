// @ts-check
// What opens over everything: help with its keys, the list of commands, the larger plot.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { commands, keyName } from "../commands.js";
import { remember } from "../language.js";
import { say } from "../words.js";
import { button, close, idOf, keycap, toggle } from "./parts.js";
import { plot } from "./plot.js";

/** @import { Page } from "../actions.js" */

/** @param {Page} page */
const shut = (page) => page.patch({ dialog: null });

/** Pages of the guide. */
const guide = ["first-look", "lecture", "mesh"];

/** @param {Page} page */
export function help(page) {
  const { version } = page.state.value;
  return html`<header><h2>${say("help")}</h2>${close(() => shut(page))}</header>
    <p>${say("help-what")}</p><p>${say("help-how")}</p><p>${say("help-private")}</p>
    <p>${say("guide")} ${guide.map(
      (name, n) =>
        html`${n > 0 ? " · " : ""}<a href="./www/guide/${name}.html">${say(`guide-${name}`)}</a>`,
    )}</p>
    <h3>${say("keys")}</h3>
    ${toggle(say("keys-on"), page.keysOn.value, (on) => {
      page.keysOn.value = on;
      remember("keys", on ? "on" : "off");
    })}
    <dl class="keys">${commands
      .filter(({ keys }) => keys.length > 0)
      .map(
        ({ id, keys }) =>
          html`<dt>${keys.map((key) => keycap(keyName(key)))}</dt><dd>${say(`command-${id}`)}</dd>`,
      )}<dt>${keycap("← ↑ → ↓")}</dt><dd>${say("keys-turn")}</dd><dt>${keycap("Page ↓ ↑")}</dt><dd>${say("keys-clicker")}</dd></dl>
    <h3>${say("surface-gestures")}</h3><p>${say("gestures")}</p>
    <div class="row">${button(say("welcome-again"), () => page.patch({ dialog: null, welcome: true, tab: null }))}</div>
    <p class="hint">${say("version", { version })}</p><p class="hint">${page.stage.renderer.value}</p>`;
}

const wanted = signal("");
const chosen = signal(0);

/** @param {Page} page */
export function palette(page) {
  const text = wanted.value.trim().toLowerCase();
  const found = commands.filter(({ id }) => say(`command-${id}`).toLowerCase().includes(text));
  const at = Math.min(chosen.value, found.length - 1);
  /** @param {(typeof commands)[number] | undefined} command */
  function perform(command) {
    if (!command) return;
    shut(page);
    wanted.value = "";
    chosen.value = 0;
    command.act(page);
  }
  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.key === "Enter") perform(found[at]);
    else if (event.key === "ArrowDown") chosen.value = Math.min(at + 1, found.length - 1);
    else if (event.key === "ArrowUp") chosen.value = Math.max(at - 1, 0);
    else return;
    event.preventDefault();
  }
  const id = idOf("command");
  return html`<header><h2 class="visually-hidden">${say("commands")}</h2>
      <input id=${id} class="wide" role="combobox" aria-expanded="true" aria-controls="commands" aria-label=${say("commands")}
        aria-activedescendant=${found[at] ? `command-${found[at].id}` : nothing} placeholder=${say("commands-hint")} .value=${wanted.value}
        @keydown=${key} @input=${(/** @type {any} */ { target }) => {
          wanted.value = target.value;
          chosen.value = 0;
        }} />${close(() => shut(page))}</header>
    <ul id="commands" class="commands" role="listbox" aria-label=${say("commands")}>${found.map(
      (
        command,
        n,
      ) => html`<li id="command-${command.id}" role="option" aria-selected=${String(n === at)} @click=${() => perform(command)}>
        <span>${say(`command-${command.id}`)}</span>${command.keys.map((one) => keycap(keyName(one)))}</li>`,
    )}</ul>`;
}

/** @param {Page} page */
export function largePlot(page) {
  return html`<header><h2>${say("larger-plot")}</h2>${close(() => shut(page))}</header>${plot(page)}`;
}
