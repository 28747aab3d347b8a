// @ts-check
// The energy and the equation of the flow in force, with the values of their symbols.

/** @import { PageState } from "../state.js" */
/** @import { Part } from "./mathml.js" */
/** @import { Statement } from "./statements.js" */

import { t } from "../language.js";
import { byId } from "./element.js";
import { math } from "./mathml.js";
import { statementOf } from "./statements.js";

/** Of a formula that is too wide, by its usual size. */
const SMALLEST = 0.75;

export function createEquations() {
  const section = byId("equation", HTMLDetailsElement);
  const parts = byId("equation-parts", HTMLElement);

  /** @type {Readonly<PageState> | null} */
  let state = null;
  /** @type {unknown[]} what is told of */
  let told = [];
  /** @type {HTMLElement[]} */
  let values = [];
  /** @type {unknown} */
  let laidOut = null;

  /** @param {string} heading @param {Part[]} formulae */
  function formulas(heading, formulae) {
    const title = document.createElement("h3");
    title.textContent = heading;
    // A long formula scrolls in a region of its own.
    const scroll = document.createElement("div");
    scroll.className = "formulae";
    scroll.tabIndex = 0;
    scroll.role = "group";
    scroll.ariaLabel = heading;
    scroll.append(...formulae.map((formula) => math(formula, true)));
    return [title, scroll];
  }

  /** @param {Statement} statement */
  function lay({ energy, equation, source, symbols }) {
    const table = document.createElement("table");
    const caption = table.createCaption();
    caption.textContent = t("Symbols, as they are now");
    values = symbols.map(([symbol, meaning, value]) => {
      const line = table.insertRow();
      const head = document.createElement("th");
      head.scope = "row";
      head.append(math(symbol));
      line.append(head);
      line.insertCell().textContent = meaning;
      const cell = line.insertCell();
      cell.textContent = value;
      return cell;
    });
    const note = document.createElement("p");
    note.className = "note";
    note.textContent = source;
    parts.replaceChildren(
      ...formulas(t("Energy"), energy),
      ...formulas(t("Equation"), equation),
      table,
      note,
    );
    fit();
  }

  /** A formula that is a little too wide is set smaller, one that is far too wide scrolls. */
  function fit() {
    for (const scroll of parts.querySelectorAll(".formulae")) {
      const region = /** @type {HTMLElement} */ (scroll);
      region.style.fontSize = "";
      const share = region.clientWidth / region.scrollWidth;
      if (share < 1) region.style.fontSize = `${Math.max(share, SMALLEST)}em`;
    }
  }

  function show() {
    if (!section.open || !state) return;
    const about = [state.options, state.mesh, state.reading, state.configured];
    if (about.every((value, n) => value === told[n])) return;
    const isSame = state.options === laidOut && state.mesh === told[1];
    told = about;
    const statement = statementOf(state);
    if (!isSame || statement.symbols.length !== values.length) {
      laidOut = state.options;
      lay(statement);
      return;
    }
    // While it runs only values change.
    for (const [n, [, , value]] of statement.symbols.entries()) {
      if (values[n].textContent !== value) values[n].textContent = value;
    }
  }

  section.addEventListener("toggle", show);
  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      state = now;
      show();
    },
  };
}
