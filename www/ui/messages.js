// @ts-check
// Warnings and errors, each shown once. Errors stay until they are dismissed.

import { t } from "../language.js";
import { byId } from "./element.js";

/** Milliseconds a warning stays. */
const NOTE_STAYS = 12_000;

export function createMessages() {
  const errors = byId("errors", HTMLElement);
  const notes = byId("notes", HTMLElement);
  const template = byId("message-template", HTMLTemplateElement);
  /** Keys of what was noted. @type {Set<string>} */
  const told = new Set();

  /** @param {HTMLElement} list @param {string} what @param {string} hint */
  function add(list, what, hint) {
    const copy = /** @type {DocumentFragment} */ (template.content.cloneNode(true));
    const message = /** @type {HTMLElement} */ (copy.querySelector(".message"));
    const lines = message.querySelectorAll("p");
    lines[0].textContent = what;
    lines[1].textContent = hint;
    lines[1].hidden = hint === "";
    message.querySelector("button")?.addEventListener("click", () => message.remove());
    list.append(message);
    // A lecture hall needs the latest ones, not a wall of them.
    while (list.children.length > 3) list.firstElementChild?.remove();
    return message;
  }

  /** @type {HTMLElement | null} */
  let answered = null;
  /** What helps against a fault. @type {(fault: any) => { label: string, act: () => unknown }[]} */
  let offers = () => [];

  /** A message that goes by itself. @param {string} text */
  function stay(text) {
    const message = add(notes, text, "");
    const leave = () =>
      message.matches(":hover, :focus-within") ? setTimeout(leave, NOTE_STAYS) : message.remove();
    setTimeout(leave, NOTE_STAYS);
    return message;
  }

  /** @param {string} label @param {string} value */
  function choice(label, value) {
    const button = document.createElement("button");
    button.value = value;
    button.textContent = label;
    return button;
  }

  return {
    /**
     * Whether to do what takes long.
     * @param {string} text
     * @returns {Promise<boolean>}
     */
    ask(text) {
      const dialog = document.createElement("dialog");
      const form = document.createElement("form");
      form.method = "dialog";
      form.className = "row";
      form.append(choice(t("Run them"), "run"), choice(t("Leave it"), ""));
      const said = document.createElement("p");
      said.textContent = text;
      said.id = "question";
      dialog.setAttribute("aria-labelledby", said.id);
      dialog.append(said, form);
      document.body.append(dialog);
      dialog.showModal();
      return new Promise((resolve) => {
        dialog.addEventListener("close", () => {
          dialog.remove();
          resolve(dialog.returnValue === "run");
        });
      });
    },
    /** @param {typeof offers} found  remedies to be offered beside an error */
    offer(found) {
      offers = found;
    },
    /** @param {{ message: string, hint: string }} fault */
    error(fault) {
      const { message, hint } = fault;
      const shown = [...errors.querySelectorAll(".what")].some(
        (what) => what.textContent === message,
      );
      if (shown) return;
      const said = add(errors, message, hint);
      const row = document.createElement("div");
      row.className = "row";
      for (const { label, act } of offers(fault)) {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = label;
        button.addEventListener("click", act);
        row.append(button);
      }
      if (row.childElementCount > 0) said.append(row);
    },
    /** @param {string} text @param {string} [key] */
    note(text, key = text) {
      if (told.has(key)) return;
      told.add(key);
      stay(text);
    },
    /** @param {string} text */
    answer(text) {
      // The answer before is of no use any more.
      answered?.remove();
      answered = stay(text);
    },
    clear() {
      told.clear();
      errors.replaceChildren();
      notes.replaceChildren();
    },
  };
}
