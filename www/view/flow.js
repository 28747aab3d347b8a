// The tab of the flow. Its fields come from the rows of options: no flow is known by name.

import { html, nothing } from "lit-html";
import * as schema from "../generated/schema.js";
import { formatNumber, formatShort } from "../number.js";
import { asText, choiceLabel, choicesOf, isBasic, isRead, named } from "../options.js";
import { say } from "../words.js";
import { page } from "./page.js";
import { button, labelled, number, rove, section, segmented, select, toggle } from "./parts.js";

/** @import { Flow, Row } from "../generated/schema.js" */
/** @import { Options } from "../options.js" */

/** More choices, or more letters in all, stand in a list and not side by side. */
const [SIDE_BY_SIDE, LETTERS] = [3, 36];

/** Whether the mesh can be given to a flow. @param {Flow} flow */
function suits({ meshes }) {
  const info = page.state.value.mesh?.info;
  return !info || ((meshes.open || info.closed) && (meshes.oneSided || info.oriented));
}

/** Keys of the list of flows, of which one has the focus. @param {KeyboardEvent} event */
function move(event) {
  const isChoice = event.key === "Enter" || event.key === " ";
  if (isChoice) /** @type {HTMLElement} */ (event.target).click();
  else if (!rove(event, "[role=option]")) return;
  event.preventDefault();
  event.stopPropagation();
}

function flows() {
  const all = schema.flows.map((flow) => {
    const { id } = flow;
    const isOn = id === page.state.value.options.flow;
    const fits = suits(flow);
    return html`<div role="option" class="option" tabindex=${isOn ? 0 : -1} aria-selected=${String(isOn)}
      aria-disabled=${String(!fits)} @click=${() => fits && !isOn && page.run.configure({ flow: id })}>
      <i class="radio"></i><b>${say(`flow-${id}`)}</b>
      <small>${say(fits ? `flow-${id}.plain` : "flow-unsuitable")}</small></div>`;
  });
  return html`<div class="list" role="listbox" aria-label=${say("option-flow")} @keydown=${move}>${all}</div>`;
}

/** What stands in the field of a number that is chosen automatically. @param {string} name */
function automatic(name) {
  const { dt, tau } = page.state.value.configured ?? {};
  const known = /** @type {Record<string, number | undefined>} */ ({ dt, tau })[name];
  return known === undefined ? say("automatic") : formatNumber(known, 3);
}

/**
 * A slider over the decades about what is usual, which says in the field where it is.
 * @param {Row} row @param {string} label @param {number} value @param {(now: number) => unknown} set
 */
function decades({ default: usual, range }, label, value, set) {
  if (typeof usual !== "number" || usual <= 0 || !range || (range.low <= 0 && !range.lowOpen))
    return nothing;
  const [low, high] = [Math.max(range.low, usual / 100), Math.min(range.high, usual * 100)];
  if (high < 100 * low) return nothing;
  /** @param {any} event */
  const at = ({ target }) => {
    const exact = 10 ** target.valueAsNumber;
    return range.whole ? Math.round(exact) : Number(exact.toPrecision(2));
  };
  const show = (/** @type {any} */ event) => {
    event.target.closest(".field").querySelector("[type=number]").value = at(event);
  };
  return html`<input type="range" class="decades" aria-label=${label} aria-valuetext=${formatShort(value)}
    min=${Math.log10(low)} max=${Math.log10(high)} step="0.01" .value=${String(Math.log10(value))}
    @input=${show} @change=${(/** @type {any} */ event) => set(at(event))} />`;
}

/** Leads from a step size to the same in the other unit, as the flow of the page has it. @param {string} name @param {any} of @param {(change: any) => unknown} change */
function twin(name, of, change) {
  const other = { tau: "dt", dt: "tau" }[name];
  const { configured, options } = page.state.value;
  if (!other || !configured || of !== options) return nothing;
  const swap = () => change({ [name]: null, [other]: /** @type {any} */ (configured)[other] });
  return html`<button type="button" class="link" @click=${swap}>${say("step-size-as", { other })}</button>`;
}

/** @param {Row} row @param {any} options @param {(change: any) => unknown} change  of options, or of how edge flips are shown */
export function field(row, options, change) {
  const { name, kind, absent, unit, range } = row;
  const label = say(`option-${name}`);
  const hint = say(`option-${name}-help`);
  const value = options[name];
  const set = (/** @type {unknown} */ now) => change({ [name]: now });
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
    /** @param {string} id @param {boolean} isOn */
    const turn = (id, isOn) =>
      set(row.ids.filter((one) => (one === id ? isOn : value.includes(one))));
    /** @param {string} id */
    const checkbox = (id) => html`<label><input type="checkbox" .checked=${value.includes(id)}
      @change=${(/** @type {any} */ { target }) => turn(id, target.checked)} /> ${choiceLabel(name, id)}</label>`;
    return html`<fieldset class="field"><legend>${label}</legend><span class="checks">${row.ids.map(checkbox)}</span></fieldset>`;
  }
  const isOptional = absent !== null;
  const shown = value === null ? null : formatShort(value, 6);
  const min = range?.also === null ? range.low : undefined;
  const placeholder = isOptional ? automatic(name) : undefined;
  const take = (/** @type {number | null} */ typed) => (typed !== null || isOptional) && set(typed);
  const input = number(label, shown, take, {
    min,
    max: range?.high,
    step: range?.whole ? 1 : undefined,
    placeholder,
  });
  const unitOf = unit ? say("unit", { unit, kind: unit.split(" ")[0] }) : "";
  const control = html`<span class="number">${input}${unit ? html`<span class="unit">${unitOf}</span>` : nothing}${twin(name, options, change)}</span>
    ${value === null ? nothing : decades(row, label, value, set)}`;
  return labelled(label, control, hint);
}

/** Whether the surface has what an option is about: a boundary, or anything that is held. @param {string} name @param {Options} options */
function isPossible(name, { free, fixed, dt }) {
  const isOpen = (page.state.value.mesh?.info.boundaryLoops ?? 0) > 0;
  if (name === "prefill") return isOpen || free !== null || fixed !== null;
  // Two words for one thing.
  if (name === "tau" || name === "dt") return (dt === null) === (name === "tau");
  return name !== "boundary" || isOpen;
}

/** The fields that what runs reads. @param {Options} options @param {boolean} basic */
export const fieldsOf = (options, basic) =>
  schema.options.filter(
    ({ name, kind }) =>
      name !== "flow" &&
      kind !== "vertices" &&
      isBasic(name) === basic &&
      isRead(name, options) &&
      isPossible(name, options),
  );

/** How edge flips, and what else is arranged, are shown. */
function display() {
  const { arrangement, options, comparison } = page.state.value;
  if (comparison.rivals.length > 0) return nothing;
  const rows = schema.arrangement.filter(({ flows: some }) => some.includes(options.flow));
  return rows.map((row) => field(row, arrangement, page.run.arrange));
}

export function flow() {
  const { options, applies, reading, mesh, configured } = page.state.value;
  const fields = (/** @type {boolean} */ basic) =>
    fieldsOf(options, basic).map((row) => field(row, options, (edit) => page.run.configure(edit)));
  const advanced = () =>
    html`${fields(false)}${button(say("recommended"), page.run.recommend, "small")}`;
  const isPart = (options.free !== null || options.fixed !== null) && configured !== null;
  const count = { free: configured?.freeVertices ?? 0, all: (mesh?.positions.length ?? 0) / 3 };
  const part = html`<p class="hint">${say("region-count", count)}
    ${button(say("clear-paint"), () => page.edit.select(null), "small")}</p>`;
  const begins = named(["start", "here"], "applies");
  const isUnderWay = (reading?.step ?? 0) > 0 && mesh;
  return html`${flows()}<hr />${fields(true)}${display()}
    ${isPart ? part : nothing}
    ${isUnderWay ? segmented(say("applies"), begins, applies, (id) => page.patch({ applies: id })) : nothing}
    ${reading?.flips ? button(say("flip-all"), page.edit.finish, "small") : nothing}
    ${fieldsOf(options, false).length > 0 ? section("advanced", say("advanced"), advanced, say("advanced-what")) : nothing}`;
}
