// Pieces that every view is made of.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { fetchRest, say } from "../words.js";
import { page } from "./page.js";

/** @typedef {() => unknown} View  of the state, as it is */

/** An outline of those in `index.html`. @param {string} name */
export const icon = (name) =>
  html`<svg class="icon" aria-hidden="true"><use href="#icon-${name}" /></svg>`;

/** What all buttons may have. @typedef {{ disabled?: boolean, pressed?: boolean }} Pressable */

/** A button of an icon alone. @param {string} name @param {string} label @param {View} act @param {Pressable & { key?: string }} [more] */
export const iconButton = (name, label, act, { key, pressed, disabled = false } = {}) =>
  html`<button type="button" class="icon-button" aria-label=${label}
    title=${key ? `${label} (${key})` : label} aria-pressed=${pressed ?? nothing}
    aria-disabled=${String(disabled)} @click=${() => disabled || act()}>${icon(name)}</button>`;

/** @param {unknown} label @param {View} act @param {string} [kind]  class names @param {Pressable & { icon?: string, title?: string }} [more] */
export const button = (label, act, kind = "", { disabled = false, ...more } = {}) =>
  html`<button type="button" class="button ${kind}" aria-disabled=${String(disabled)} title=${more.title ?? nothing}
    aria-pressed=${more.pressed ?? nothing} @click=${() => disabled || act()}>${more.icon ? icon(more.icon) : nothing}${label}</button>`;

/** The id of a control, which its label points at: no id has spaces. @param {string} name */
export const idOf = (name) => `field-${name.replace(/\s+/g, "-")}`;

/** Puts what is chosen into a signal. @template T @param {{ value: T }} signal @returns {(value: T) => void} */
export const into = (signal) => (value) => {
  signal.value = value;
};

/** @template {string} Id @typedef {{ id: Id, label: string, group?: string }} Choice */
/** @typedef {<Id extends string>(label: string, choices: readonly Choice<Id>[], chosen: Id, choose: (id: Id) => unknown, hint?: string) => unknown} Choosing */

/** One of a few, side by side. @type {Choosing} */
export const segmented = (label, choices, chosen, choose) =>
  html`<fieldset class="field"><legend>${label}</legend><span class="segments">${choices.map(
    ({ id, label: text }) =>
      html`<label><input type="radio" name=${idOf(label)} .checked=${id === chosen}
        @change=${() => choose(id)} /><span>${text}</span></label>`,
  )}</span></fieldset>`;

/** A control under its name. @param {string} label @param {unknown} control  whose id is of the name @param {unknown} [hint] */
export const labelled = (label, control, hint = "") =>
  html`<div class="field"><label for=${idOf(label)}>${label}</label>
    ${control}${hint ? html`<p class="hint">${hint}</p>` : nothing}</div>`;

/** One of many, in groups where they have some. @type {Choosing} */
export const select = (label, choices, chosen, choose, hint) => {
  /** @param {Choice<string>} choice */
  const option = ({ id, label: text }) =>
    html`<option value=${id} ?selected=${id === chosen}>${text}</option>`;
  const groups = [...new Set(choices.map(({ group }) => group))].map((group) => {
    const options = choices.filter((one) => one.group === group).map(option);
    return group === undefined ? options : html`<optgroup label=${group}>${options}</optgroup>`;
  });
  const change = (/** @type {any} */ { target }) => choose(target.value);
  const list = html`<select id=${idOf(label)} .value=${chosen} @change=${change}>${groups}</select>`;
  return labelled(label, list, hint);
};

/** @param {string} label @param {boolean} on @param {(on: boolean) => unknown} turn @param {string} [hint] */
export const toggle = (label, on, turn, hint) => {
  const input = html`<input id=${idOf(label)} type="checkbox" class="switch" .checked=${on}
    @change=${(/** @type {any} */ { target }) => turn(target.checked)} />`;
  return labelled(label, input, hint);
};

/**
 * A field of a number; where what is typed is none or out of bounds, the browser says so.
 * @param {string} label  from which its id is made @param {string | number | null} value
 * @param {(value: number | null) => unknown} set  null: the field was emptied
 * @param {{ kind?: string, min?: unknown, max?: unknown, step?: unknown, placeholder?: unknown }} [more]
 */
export const number = (label, value, set, { kind = "", min, max, step, placeholder } = {}) =>
  html`<input id=${idOf(label)} class=${kind} type="number" inputmode="decimal" min=${min ?? nothing} max=${max ?? nothing}
    step=${step ?? "any"} placeholder=${placeholder ?? nothing} .value=${String(value ?? "")} @change=${(
      /** @type {any} */ { target },
    ) => target.reportValidity() && set(target.value === "" ? null : target.valueAsNumber)} />`;

/** The same in a line of text. @type {typeof number} */
export const shortNumber = (label, value, set, more) =>
  html`<label class="inline" for=${idOf(label)}>${label} ${number(label, value, set, { kind: "short", ...more })}</label>`;

/** @param {string} label @param {number} value @param {number} min @param {number} max @param {(value: number) => unknown} set */
export const slider = (label, value, min, max, set) =>
  html`<label class="inline">${label} <input type="range" min=${min} max=${max} .value=${String(value)}
    @input=${(/** @type {any} */ { target }) => set(target.valueAsNumber)} /></label>`;

/** A part that is opened by its heading; its contents are made only then. @param {string} name @param {string} heading @param {View} contents @param {string} [aside] */
export function section(name, heading, contents, aside = "") {
  const isOpen = page.state.value.section === name;
  const turn = () => page.patch({ section: isOpen ? null : name });
  return html`<section class="more">
    <h3><button type="button" aria-expanded=${String(isOpen)} @click=${turn}>${icon("down")}${heading}
      ${aside ? html`<small>${aside}</small>` : nothing}</button></h3>
    ${isOpen ? html`<div class="inner">${contents()}</div>` : nothing}
  </section>`;
}

/** A name and a value, and how the value is found by others; what is none is left out. @typedef {readonly [string, unknown, string?] | false | null | undefined} Reading */

/** Rows of names and values. @param {string} name  of the table @param {readonly Reading[]} rows */
export const table = (name, rows) =>
  html`<table class="rows" aria-label=${name}><tbody>${rows.map((row) =>
    row
      ? html`<tr><th scope="row">${row[0]}</th><td data-reading=${row[2] ?? nothing}>${row[1]}</td></tr>`
      : nothing,
  )}</tbody></table>`;

/** A table of numbers that may be long. @param {string} name @param {readonly string[]} heads @param {readonly (readonly unknown[])[]} rows */
export const grid = (name, heads, rows) =>
  html`<div class="scroll" tabindex="0" role="group" aria-label=${name}><table class="grid" aria-label=${name}>
    <thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody>${rows.map((row) => html`<tr>${row.map((cell) => html`<td>${cell}</td>`)}</tr>`)}</tbody>
  </table></div>`;

/** Moves the focus along a row of elements, by keys. @param {KeyboardEvent} event @param {string} elements @returns {boolean} whether it was such a key */
export function rove(event, elements) {
  const row = /** @type {HTMLElement} */ (event.currentTarget);
  const all = /** @type {HTMLElement[]} */ ([...row.querySelectorAll(elements)]);
  const at = all.indexOf(/** @type {HTMLElement} */ (event.target));
  const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[event.key];
  if (by === undefined || at < 0) return false;
  event.preventDefault();
  all[(at + by + all.length) % all.length].focus();
  return true;
}

/** What of the program stands in words. @param {string} key */
export const keycap = (key) => html`<kbd>${key}</kbd>`;

/** Closes the part at hand. @param {View} act */
export const close = (act) => iconButton("close", say("close"), act);

/** @type {(() => Promise<void>)[]} */
const later = [];

/** Fetches the views that are known by now, so that they open at once. */
export const fetchViews = () => Promise.all(later.map((fetch) => fetch()));

/** A view that is fetched when it is first shown, or before by `fetchViews`, with all words: the first picture does not wait for it. @param {() => Promise<View>} load */
export function lazy(load) {
  const view = signal(/** @type {View | null} */ (null));
  // Asked for twice, it is fetched once, by the browser; without a connection now, there may be
  // one when it is asked for again.
  const fetch = async () => {
    if (view.peek()) return;
    const [loaded] = await Promise.all([load(), fetchRest()]);
    view.value = loaded;
  };
  later.push(fetch);
  const show = () => {
    if (!view.value) fetch().catch(page.report);
    return view.value?.() ?? nothing;
  };
  return Object.assign(show, { isThere: () => view.value !== null });
}
