// @ts-check
// The tab of the flow. Its fields come from the rows of options: no flow is known by name.

import { html, nothing } from "lit-html";
import * as schema from "../generated/schema.js";
import { formatNumber, formatShort } from "../number.js";
import { asText, choiceLabel, choicesOf, isBasic, isRead } from "../options.js";
import { say } from "../words.js";
import { button, idOf, section, segmented, select, toggle } from "./parts.js";

/** @import { Page } from "../actions.js" */
/** @import { Row } from "../generated/schema.js" */
/** @import { Options } from "../options.js" */

/** More choices, or more letters in all, stand in a list and not side by side. */
const [SIDE_BY_SIDE, LETTERS] = [3, 36];

/** Whether a mesh can be given to a flow. @param {Page} page @param {import("../generated/schema.js").Flow} flow */
function suits(page, { meshes }) {
  const info = page.state.value.mesh?.info;
  return !info || ((meshes.open || info.closed) && (meshes.oneSided || info.oriented));
}

/** @param {Page} page */
function flows(page) {
  const { options } = page.state.value;
  /** @param {KeyboardEvent} event */
  function move(event) {
    const all = [
      .../** @type {HTMLElement} */ (event.currentTarget).querySelectorAll("[role=option]"),
    ];
    const at = all.indexOf(/** @type {HTMLElement} */ (event.target));
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Enter" || event.key === " ")
      /** @type {HTMLElement} */ (event.target).click();
    else if (by !== undefined)
      /** @type {HTMLElement} */ (all[(at + by + all.length) % all.length]).focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
  return html`<div class="list" role="listbox" aria-label=${say("option-flow")} @keydown=${move}>${schema.flows.map(
    (flow) => {
      const isOn = flow.id === options.flow;
      const fits = suits(page, flow);
      return html`<div role="option" class="option" tabindex=${isOn ? 0 : -1} aria-selected=${String(isOn)}
        aria-disabled=${String(!fits)} @click=${() => fits && !isOn && page.run.configure({ flow: flow.id })}>
        <i class="radio"></i><b>${say(`flow-${flow.id}`)}</b>
        <small>${fits ? say(`flow-${flow.id}.plain`) : say("flow-unsuitable")}</small></div>`;
    },
  )}</div>`;
}

/**
 * What stands in the field of a number that is chosen automatically.
 * @param {Page} page @param {string} name
 */
function automatic(page, name) {
  const { configured } = page.state.value;
  const known = /** @type {any} */ ({ dt: configured?.dt, tau: configured?.tau })[name];
  return known === undefined ? say("automatic") : formatNumber(known, 3);
}

/**
 * A slider over the decades about what is usual, which says in the field where it is.
 * @param {Row} row @param {string} label @param {number} value @param {(now: number) => unknown} set
 */
function slider({ default: usual, range }, label, value, set) {
  if (typeof usual !== "number" || usual <= 0 || !range || (range.low <= 0 && !range.lowOpen))
    return nothing;
  const [low, high] = [Math.max(range.low, usual / 100), Math.min(range.high, usual * 100)];
  if (high < 100 * low) return nothing;
  /** @param {any} event */
  const at = ({ target }) => {
    const number = 10 ** target.valueAsNumber;
    return range.whole ? Math.round(number) : Number(number.toPrecision(2));
  };
  return html`<input type="range" class="decades" aria-label=${label} aria-valuetext=${formatShort(value)}
    min=${Math.log10(low)} max=${Math.log10(high)} step="0.01" .value=${String(Math.log10(value))}
    @input=${(/** @type {any} */ event) => {
      event.target.closest(".field").querySelector("[type=number]").value = at(event);
    }} @change=${(/** @type {any} */ event) => set(at(event))} />`;
}

/**
 * @param {Page} page @param {Row} row @param {Options} options
 * @param {(change: any) => unknown} change  of options, or of how edge flips are shown
 */
export function field(page, row, options, change) {
  const { name, kind, absent, unit, range } = row;
  const label = say(`option-${name}`);
  const value = /** @type {any} */ (options)[name];
  const set = (/** @type {unknown} */ now) => change({ [name]: now });
  const hint = say(`option-${name}-help`);
  if (kind === "switch") return toggle(label, value, set, hint);
  if (kind === "choice") {
    const auto = absent ? [{ id: absent, label: say("automatic") }] : [];
    const choices = [...auto, ...choicesOf(name)];
    const choose = (/** @type {string} */ id) => set(id === absent ? null : id);
    const letters = choices.reduce((sum, one) => sum + one.label.length, 0);
    return choices.length <= SIDE_BY_SIDE && letters <= LETTERS && absent === null
      ? segmented(label, choices, asText(value, name), choose)
      : select(label, choices, asText(value, name), choose, hint);
  }
  if (kind === "set") {
    return html`<fieldset class="field"><legend>${label}</legend><span class="checks">${row.ids.map(
      (id) => html`<label><input type="checkbox" .checked=${value.includes(id)}
        @change=${(/** @type {any} */ event) =>
          set(
            row.ids.filter((one) => (one === id ? event.target.checked : value.includes(one))),
          )} />
        ${choiceLabel(name, id)}</label>`,
    )}</span></fieldset>`;
  }
  if (kind === "vertices") return nothing;
  const id = idOf(label);
  /** @param {any} event */
  function type({ target }) {
    if (target.value === "" && absent !== null) return set(null);
    if (target.reportValidity() && target.value !== "") set(target.valueAsNumber);
  }
  return html`<div class="field"><label for=${id}>${label}</label>
    <span class="number"><input id=${id} type="number" inputmode="decimal" step="any"
      min=${range?.also === null ? range.low : nothing} max=${range?.high ?? nothing}
      placeholder=${absent === null ? nothing : automatic(page, name)}
      .value=${value === null ? "" : formatShort(value, 6)} @change=${type} />
      ${unit ? html`<span class="unit">${say("unit", { unit, kind: unit.split(" ")[0] })}</span>` : nothing}</span>
    ${value === null ? nothing : slider(row, label, value, set)}<p class="hint">${hint}</p></div>`;
}

/** The fields that what runs reads. @param {Page} page @param {Options} options @param {boolean} basic */
export function fieldsOf(page, options, basic) {
  const { mesh } = page.state.value;
  return schema.options.filter(
    ({ name, kind }) =>
      name !== "flow" &&
      kind !== "vertices" &&
      isBasic(name) === basic &&
      isRead(name, options) &&
      (name !== "boundary" || (mesh?.info.boundaryLoops ?? 0) > 0),
  );
}

/** How edge flips, and what else is arranged, are shown. @param {Page} page */
function display(page) {
  const { arrangement, options, comparison } = page.state.value;
  const rows = schema.arrangement.filter(({ flows: some }) => some.includes(options.flow));
  if (rows.length === 0 || comparison.rivals.length > 0) return nothing;
  return rows.map((row) =>
    row.range && row.absent === null
      ? select(
          say(`option-${row.name}`),
          [...Array(row.range.high + 1).keys()].map((n) => ({ id: String(n), label: String(n) })),
          String(/** @type {any} */ (arrangement)[row.name]),
          (id) => page.run.arrange({ [row.name]: Number(id) }),
        )
      : field(page, row, /** @type {any} */ (arrangement), page.run.arrange),
  );
}

/** @param {Page} page */
export function flow(page) {
  const { options, applies, reading, mesh, configured } = page.state.value;
  const change = (/** @type {Partial<Options>} */ edit) => page.run.configure(edit);
  const advanced = fieldsOf(page, options, false);
  const moved = (reading?.step ?? 0) > 0;
  const isPart = options.free !== null || options.fixed !== null;
  const all = mesh ? mesh.positions.length / 3 : 0;
  return html`${flows(page)}<hr />
    ${fieldsOf(page, options, true).map((row) => field(page, row, options, change))}
    ${display(page)}
    ${
      isPart && configured
        ? html`<p class="hint">${say("region-count", { free: configured.freeVertices, all })}
          ${button(say("clear-paint"), () => page.edit.select(null), { kind: "small" })}</p>`
        : nothing
    }
    ${
      moved && mesh
        ? segmented(
            say("applies"),
            [
              { id: "start", label: say("start-word") },
              { id: "here", label: say("this-step") },
            ],
            applies,
            (id) => page.run.applies(id === "here" ? "here" : "start"),
          )
        : nothing
    }
    ${reading?.flips ? button(say("flip-all"), page.edit.finish, { kind: "small" }) : nothing}
    ${
      advanced.length > 0
        ? section(
            page,
            "advanced",
            say("advanced"),
            () => html`${advanced.map((row) => field(page, row, options, change))}
          ${button(say("recommended"), page.run.recommend, { kind: "small" })}`,
            say("advanced-what"),
          )
        : nothing
    }`;
}
