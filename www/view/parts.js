// @ts-check
// Pieces that every view is made of.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { say } from "../words.js";
import { page } from "./page.js";

/** @typedef {() => unknown} View  of the state, as it is */

/** Outlines on a grid of 20; those of `solid` are filled. @type {Record<string, string>} */
const paths = {
  play: "M5.8 3.8v12.4l10-6.2z",
  pause: "M5.6 4h3.2v12H5.6zM11.2 4h3.2v12h-3.2z",
  again: "M4.3 7A6.6 6.6 0 1 1 3.4 10.800M3 3.200V7.700H7.5",
  back: "M14 5l-6 5 6 5zM5.5 5v10",
  next: "M6 5l6 5-6 5zM14.5 5v10",
  start: "M9.5 5l-5 5 5 5zM15.5 5l-5 5 5 5z",
  loop: "M4 9V8a3 3 0 0 1 3-3h8M13 2.500L15.5 5 13 7.500M16 11v1a3 3 0 0 1-3 3H5M7 12.500L4.5 15 7 17.5",
  expand: "M4 12.500V16h3.500M16 7.500V4h-3.500M4 16l4.5-4.500M16 4l-4.5 4.5",
  surface: "M10 2.500l7 3.800v7.400l-7 3.8-7-3.800V6.300zM3 6.300l7 3.9 7-3.900M10 10.200v7.3",
  flow: "M2.5 13c2.5 0 2.5-6 5-6s2.5 6 5 6 2.5-4 5-4",
  measure: "M3 17V9M8 17V4M13 17v-6M18 17H2.5",
  compare: "M3 4h6v12H3zM11 4h6v12h-6z",
  share: "M10 12V3M6.5 6L10 2.7 13.5 6M4 10v6.500h12V10",
  library: "M3 3h6v6H3zM11 3h6v6h-6zM3 11h6v6H3zM11 11h6v6h-6z",
  present: "M3 4h14v9.500H3zM10 13.500V17M6.5 17h7",
  help: "M7.3 7.400a2.7 2.7 0 1 1 4 2.400c-.9.5-1.3 1-1.3 2M10 14.600v.4",
  close: "M5 5l10 10M15 5L5 15",
  down: "M6 8l4 4 4-4",
  search: "M9 3.500a5.5 5.5 0 1 0 0 11 5.5 5.5 0 0 0 0-11zM13 13l4 4",
  lock: "M5 9.500h10V17H5zM7 9.500V7a3 3 0 0 1 6 0v2.5",
  open: "M3 6V4.500h5L9.5 6H17v10H3zM3 6h14",
  paint: "M16.5 3.500L9 11M9 11c-2-.5-4 .5-4 3 0 1.5-1 2-2 2.3 3 1.2 7 .4 7.3-2.6z",
  fill: "M10 4c4 0 7 2.5 7 6s-3 6-7 6-7-2.5-7-6 3-6 7-6zM10 8v4M8 10h4",
  invert:
    "M10 3a7 7 0 1 0 0 14 7 7 0 0 0 0-14zM10 8.800a1.2 1.2 0 1 0 0 2.4 1.2 1.2 0 0 0 0-2.400z",
  remesh: "M3 16l4-8 5 8zM7 8l4-5 4 6-3 7M15 9l2 7h-5",
  subdivide: "M10 3l7 13H3zM6.5 9.500h7L10 16z",
  undo: "M7 4.500L3.5 8 7 11.500M3.5 8H12a4.5 4.5 0 0 1 0 9H8",
};
const solid = ["play", "pause", "back", "next", "start"];

/** @param {string} name */
export const icon = (name) =>
  html`<svg class="icon ${solid.includes(name) ? "solid" : ""}" viewBox="0 0 20 20" aria-hidden="true">${svg`<path d=${paths[name]} />`}</svg>`;

export const mark = html`<svg class="mark" viewBox="0 0 24 24" aria-hidden="true">
  <circle cx="12" cy="12" r="10.5" />
  <path d="M12 12V2.500M12 12l8.2 4.700M12 12l-8.2 4.700M4.5 7.500c3.5.6 6 2.3 7.5 4.5 1.5-2.2 4-3.9 7.5-4.500M12 12c1 3 .8 6-.8 9.3" />
</svg>`;

/** What all buttons may have. @typedef {{ disabled?: boolean, pressed?: boolean }} Pressable */

/**
 * A button of an icon alone.
 * @param {string} name  of the icon @param {string} label @param {View} act
 * @param {Pressable & { key?: string }} [more]
 */
export const iconButton = (name, label, act, { key = "", pressed, disabled = false } = {}) =>
  html`<button type="button" class="icon-button" aria-label=${label}
    title=${key ? `${label} (${key})` : label} aria-pressed=${pressed ?? nothing}
    aria-disabled=${String(disabled)} @click=${() => disabled || act()}>${icon(name)}</button>`;

/**
 * @param {unknown} label @param {View} act @param {string} [kind]  class names
 * @param {Pressable & { icon?: string, title?: string }} [more]
 */
export const button = (
  label,
  act,
  kind = "",
  { icon: name, disabled = false, pressed, title } = {},
) =>
  html`<button type="button" class="button ${kind}" aria-disabled=${String(disabled)} title=${title ?? nothing}
    aria-pressed=${pressed ?? nothing} @click=${() => disabled || act()}>${name ? icon(name) : nothing}${label}</button>`;

/** Ids that stay what they are while a name does. @type {Map<string, string>} */
const ids = new Map();
/** @param {string} name */
export function idOf(name) {
  const id = ids.get(name) ?? `f${ids.size + 1}`;
  ids.set(name, id);
  return id;
}

/** Puts what is chosen into a signal. @template T @param {{ value: T }} signal @returns {(value: T) => void} */
export const into = (signal) => (value) => {
  signal.value = value;
};

/** @template {string} Id @typedef {{ id: Id, label: string, group?: string }} Choice */

/**
 * One of a few, side by side.
 * @template {string} Id
 * @param {string} label @param {readonly Choice<Id>[]} choices @param {Id} chosen
 * @param {(id: Id) => unknown} choose
 */
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

/**
 * One of many, in groups where they have some.
 * @template {string} Id
 * @param {string} label @param {readonly Choice<Id>[]} choices @param {Id} chosen
 * @param {(id: Id) => unknown} choose @param {string} [hint]
 */
export function select(label, choices, chosen, choose, hint) {
  const groups = new Set(choices.map(({ group }) => group));
  const options = [...groups].map((group) => {
    const some = choices
      .filter((one) => one.group === group)
      .map(
        (one) => html`<option value=${one.id} ?selected=${one.id === chosen}>${one.label}</option>`,
      );
    return group === undefined ? some : html`<optgroup label=${group}>${some}</optgroup>`;
  });
  return labelled(
    label,
    html`<select id=${idOf(label)} .value=${chosen} @change=${(/** @type {any} */ event) => choose(event.target.value)}>
      ${options}</select>`,
    hint,
  );
}

/** @param {string} label @param {boolean} on @param {(on: boolean) => unknown} turn @param {string} [hint] */
export const toggle = (label, on, turn, hint) =>
  labelled(
    label,
    html`<input id=${idOf(label)} type="checkbox" class="switch" .checked=${on}
      @change=${(/** @type {any} */ event) => turn(event.target.checked)} />`,
    hint,
  );

/**
 * What may stand in a field of a number; where it is wrong, the browser says so.
 * @typedef {{ kind?: string, min?: unknown, max?: unknown, step?: unknown, placeholder?: unknown }} Typed
 */

/**
 * @param {string} label  from which its id is made @param {string | number | null} value
 * @param {(value: number | null) => unknown} set  null: the field was emptied @param {Typed} [more]
 */
export const number = (
  label,
  value,
  set,
  { kind = "", min = nothing, max = nothing, step = "any", placeholder = nothing } = {},
) =>
  html`<input id=${idOf(label)} class=${kind} type="number" inputmode="decimal" min=${min} max=${max} step=${step}
    placeholder=${placeholder} .value=${String(value ?? "")} @change=${(
      /** @type {any} */ { target },
    ) => target.reportValidity() && set(target.value === "" ? null : target.valueAsNumber)} />`;

/** The same in a line of text. @type {typeof number} */
export const shortNumber = (label, value, set, more) =>
  html`<label class="inline" for=${idOf(label)}>${label} ${number(label, value, set, { kind: "short", ...more })}</label>`;

/** @param {string} label @param {number} value @param {number} min @param {number} max @param {(value: number) => unknown} set */
export const slider = (label, value, min, max, set) =>
  html`<label class="inline">${label} <input type="range" min=${min} max=${max} .value=${String(value)}
    @input=${(/** @type {any} */ { target }) => set(target.valueAsNumber)} /></label>`;

/**
 * A part that is opened by its heading; its contents are made only then.
 * @param {string} name @param {string} heading @param {View} contents @param {string} [aside]
 */
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

/**
 * A table of numbers that may be long.
 * @param {string} name @param {readonly string[]} heads @param {readonly (readonly unknown[])[]} rows
 */
export const grid = (name, heads, rows) =>
  html`<div class="scroll" tabindex="0" role="group" aria-label=${name}><table class="grid" aria-label=${name}>
    <thead><tr>${heads.map((head) => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody>${rows.map((row) => html`<tr>${row.map((cell) => html`<td>${cell}</td>`)}</tr>`)}</tbody>
  </table></div>`;

/** What of the program stands in words. @param {string} key */
export const keycap = (key) => html`<kbd>${key}</kbd>`;

/** Closes the part at hand. @param {View} act */
export const close = (act) => iconButton("close", say("close"), act);

/**
 * A view that is fetched when it is first shown, or before by `fetch`: the first picture does not
 * wait for it.
 * @param {() => Promise<View>} load
 */
export function lazy(load) {
  const view = signal(/** @type {View | null} */ (null));
  /** @type {Promise<void> | null} */
  let asked = null;
  const fetch = () => {
    asked ??= load().then(into(view));
    return asked;
  };
  const show = () => {
    if (!view.value) fetch().catch(page.report);
    return view.value?.() ?? nothing;
  };
  return Object.assign(show, { fetch, isThere: () => view.value !== null });
}
