// @ts-check
// Which panes there are, what each does otherwise than the first, and how they go together.

/** @import { Rival } from "../comparison.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { letter, MOST_PANES, optionsOf, timeExponent, timeUnitsAgree } from "../comparison.js";
import { t } from "../language.js";
import { choicesOf, flowOf, isRead, rowOf, usualBoundary } from "../options.js";
import { say } from "../words.js";
import { objection, presets } from "./comparison-presets.js";
import { captions, differences } from "./comparison-words.js";
import { byId, fillSelect, setText } from "./element.js";
import { limit } from "./option-form.js";

/** What a pane may do otherwise, in this order. @type {readonly (keyof Options)[]} */
const controls = [
  "flow",
  "scheme",
  "p",
  "keep",
  "regularise",
  "epsilon",
  "integrator",
  "boundary",
  "prefill",
  "tau",
];

/** All that a select can say of an option. @param {keyof Options} name */
function offered(name) {
  const { kind, ids } = rowOf(name);
  if (kind === "switch") {
    return [
      { id: "false", label: say("option-no") },
      { id: "true", label: say("option-yes") },
    ];
  }
  // Flips change the mesh: nothing can be beside them.
  const single = choicesOf(name).filter(({ id }) => name !== "flow" || flowOf(id).order > 0);
  if (kind !== "set") return single;
  const all = single.map(({ label }) => label).join(", ");
  return [{ id: "none", label: say("option-nothing") }, ...single, { id: ids.join(), label: all }];
}

/** What stands in a control. @param {keyof Options} name @param {Options} options */
function chosenIn(name, options) {
  if (name === "boundary") return options.boundary ?? usualBoundary(options.flow) ?? "";
  const value = options[name];
  if (Array.isArray(value)) return value.length === 0 ? "none" : [...value].sort().join();
  return value === null ? "" : String(value);
}

/**
 * What a control says.
 * @param {HTMLInputElement | HTMLSelectElement} control
 * @param {keyof Options} name
 * @returns {unknown}
 */
function saidBy(control, name) {
  if (control instanceof HTMLInputElement)
    return control.value === "" ? null : control.valueAsNumber;
  const { kind } = rowOf(name);
  if (kind === "switch") return control.value === "true";
  if (kind !== "set") return control.value;
  return control.value === "none" ? [] : control.value.split(",");
}

/** The form of one pane. */
class PaneForm {
  /** @type {Map<HTMLInputElement | HTMLSelectElement, keyof Options>} */
  #controls = new Map();
  /** @type {Rival["change"] | null} */
  #change = null;
  /** @type {Options | null} */
  #main = null;

  /** @param {number} id @param {Controller} controller */
  constructor(id, controller) {
    this.id = id;
    this.root = document.createElement("details");
    this.root.className = "pane-form";
    this.title = document.createElement("summary");
    this.fields = document.createElement("fieldset");
    this.fields.className = "fields";
    this.legend = document.createElement("legend");
    this.legend.className = "visually-hidden";
    this.fields.append(this.legend);
    this.root.append(this.title, this.fields);
    for (const name of controls) this.#add(name, controller);
    this.remove = document.createElement("button");
    this.remove.type = "button";
    this.remove.className = "small";
    this.remove.addEventListener("click", () => controller.removePane(id));
    this.fields.append(this.remove);
  }

  /** @param {keyof Options} name @param {Controller} controller */
  #add(name, controller) {
    const field = document.createElement("div");
    field.className = "field";
    const label = document.createElement("label");
    label.textContent = say(`option-${name}`);
    label.htmlFor = `pane-${this.id}-${name}`;
    const element = document.createElement(rowOf(name).kind === "number" ? "input" : "select");
    element.id = label.htmlFor;
    if (element instanceof HTMLSelectElement) fillSelect(element, offered(name));
    else {
      element.type = "number";
      limit(element, name);
      if (!element.required) element.placeholder = say(`option-${name}.absent`);
    }
    element.addEventListener("change", () => {
      if (!element.reportValidity()) return;
      // A raw step size would override the other.
      const own = name === "tau" ? { dt: null } : {};
      controller.changePane(this.id, { [name]: saidBy(element, name), ...own });
    });
    // A value that was refused must not stay beside the one in force.
    element.addEventListener("focusout", () => this.#fill());
    field.append(label, element);
    this.fields.append(field);
    this.#controls.set(element, name);
  }

  /** @param {Options} main @param {Rival} rival @param {number} index @param {string} words  what it does */
  update(main, rival, index, words) {
    const pane = letter(index);
    setText(this.title, `${pane}: ${words}`);
    setText(this.legend, t("Pane {pane}", { pane }));
    setText(this.remove, t("Remove pane {pane}", { pane }));
    this.root.dataset.curve = String(index);
    if (main === this.#main && rival.change === this.#change) return;
    this.#main = main;
    this.#change = rival.change;
    this.#fill();
  }

  #fill() {
    if (!this.#main || !this.#change) return;
    const options = optionsOf(this.#main, this.#change);
    for (const [element, name] of this.#controls) {
      element.value = chosenIn(name, options);
      const field = /** @type {HTMLElement} */ (element.parentElement);
      field.hidden = !isRead(name, options);
      field.classList.toggle("differs", name in this.#change);
    }
  }
}

/** @param {Options} options */
function unitOf(options) {
  const k = timeExponent(options);
  const raised = Number.isInteger(k)
    ? [...String(k)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(digit)]).join("")
    : `^${k}`;
  return t("length{power}", { power: raised });
}

/** @param {Options[]} all  of all panes */
function lockstepNote(all) {
  if (timeUnitsAgree(all)) {
    return t("By step all step at once; by time the one that is behind goes next.");
  }
  const units = all.map((options, n) => `${letter(n)}: ${unitOf(options)}`).join(", ");
  return t("By time is for flows whose times have one unit; these have {units}.", { units });
}

/** @param {Controller} controller */
export function createComparisonForm(controller) {
  const section = byId("comparison", HTMLDetailsElement);
  const add = byId("pane-add", HTMLButtonElement);
  const preset = byId("preset", HTMLSelectElement);
  const root = byId("pane-forms", HTMLElement);
  const box = byId("comparison-controls", HTMLElement);
  const flip = byId("flip-panes", HTMLButtonElement);
  const side = byId("side-by-side", HTMLButtonElement);
  const lockstep = byId("lockstep", HTMLSelectElement);
  const note = byId("lockstep-note", HTMLElement);
  const difference = byId("difference", HTMLSelectElement);
  const said = byId("comparison-said", HTMLElement);
  const ready = presets();
  fillSelect(preset, [{ id: "", label: t("Ready-made…") }, ...ready]);

  add.addEventListener("click", () => {
    if (add.ariaDisabled !== "true") controller.addPane();
  });
  preset.addEventListener("change", () => {
    const chosen = ready.find(({ id }) => id === preset.value);
    if (chosen) controller.preset(chosen);
    preset.value = "";
  });
  flip.addEventListener("click", () => controller.flip());
  side.addEventListener("click", () => {
    controller.sideBySide();
    flip.focus();
  });
  byId("comparison-close", HTMLButtonElement).addEventListener("click", () => {
    controller.closeComparison();
    add.focus();
  });
  lockstep.addEventListener("change", () =>
    controller.lockstep({ lockstep: lockstep.value === "time" ? "time" : "step" }),
  );
  difference.addEventListener("change", () =>
    controller.difference(difference.value === "" ? null : Number(difference.value)),
  );

  /** @type {PaneForm[]} */
  let forms = [];
  /** @type {PageState["comparison"] | null} */
  let shown = null;
  /** @type {Options | null} */
  let main = null;

  /** @type {PageState["mesh"]} */
  let mesh = null;
  /** What makes no sense on this mesh says why not. @param {Options} options */
  function judge(options) {
    for (const [n, one] of ready.entries()) {
      const why = objection(one, mesh, options);
      const option = preset.options[n + 1];
      option.disabled = why !== "";
      setText(option, why === "" ? one.label : t("{label} ({why})", { label: one.label, why }));
    }
  }

  /** @param {PageState["comparison"]} comparison @param {Options} options */
  function fill({ rivals }, options) {
    const ids = rivals.map(({ id }) => id);
    if (ids.join() !== forms.map(({ id }) => id).join()) {
      // A form that goes takes the focus with it.
      const held = root.contains(document.activeElement);
      const one = forms.length + 1 === ids.length;
      forms = ids.map((id) => forms.find((form) => form.id === id) ?? new PaneForm(id, controller));
      // Of one that was added, what it does is asked next.
      forms.at(-1)?.root.toggleAttribute("open", one || ids.length === 1);
      root.replaceChildren(...forms.map((form) => form.root));
      if (held && !root.contains(document.activeElement)) add.focus();
      if (ids.length > 0) section.open = true;
      const to = [0, ...ids].map((_, n) => ({
        id: String(n),
        label: t("Distance to {pane}", { pane: letter(n) }),
      }));
      fillSelect(difference, [{ id: "", label: t("As chosen above") }, ...to]);
    }
    const words = differences(
      options,
      rivals.map(({ change }) => change),
    );
    forms.forEach((form, n) => {
      form.update(options, rivals[n], n + 1, words[n + 1]);
    });
    const all = [options, ...rivals.map(({ change }) => optionsOf(options, change))];
    setText(note, lockstepNote(all));
    lockstep.options[1].disabled = !timeUnitsAgree(all);
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const { comparison, options } = state;
      const usable = state.reading !== null && comparison.rivals.length < MOST_PANES - 1;
      if (add.ariaDisabled !== String(!usable)) add.ariaDisabled = String(!usable);
      if (state.mesh !== mesh || options !== main) {
        mesh = state.mesh;
        judge(options);
      }
      if (comparison === shown && options === main) return;
      const before = shown?.shown ?? "side";
      if (comparison.rivals !== shown?.rivals || options !== main) fill(comparison, options);
      shown = comparison;
      main = options;
      document.body.classList.toggle("comparing", comparison.rivals.length > 0);
      box.hidden = comparison.rivals.length === 0;
      const inPlace = comparison.shown !== "side";
      side.hidden = !inPlace;
      lockstep.value = comparison.lockstep;
      difference.value = comparison.difference === null ? "" : String(comparison.difference);
      if (comparison.shown === before) return;
      setText(
        said,
        comparison.shown === "side"
          ? t("All panes side by side.")
          : t("In place: {caption}", { caption: captions(state)[comparison.shown] }),
      );
    },
  };
}
