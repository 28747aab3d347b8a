// @ts-check
// Random quadrilaterals by the angle between their faces, and how many of them speak against
// the conjecture: counts that grow as long as one looks.

/** @import { LabReport as Lab } from "../generated/types.js" */
/** @import { Controller } from "../controller.js" */

import { currentLanguage, t } from "../language.js";
import { byId, setText } from "./element.js";
import { showQuadrilateral } from "./quadrilateral.js";

/** Tetrahedra, and as many flattened ones, between two pictures. */
const BATCH = 10_000;

// A point between thousands would be read as a decimal point: German takes a thin space.
const whole = {
  format: (/** @type {number} */ count) => {
    const text = count.toLocaleString("en");
    return currentLanguage() === "en" ? text : text.replaceAll(",", "\u202f");
  },
};

/** @param {number} part @param {number} of */
const percent = (part, of) => (of === 0 ? "–" : `${((100 * part) / of).toPrecision(3)} %`);

/** @param {Controller} controller */
export function createLab(controller) {
  const section = byId("lab", HTMLDetailsElement);
  const button = byId("lab-run", HTMLButtonElement);
  const summary = byId("lab-summary", HTMLElement);
  const rows = byId("lab-rows", HTMLTableSectionElement);
  const strongest = byId("lab-strongest", HTMLElement);
  let running = false;

  /** @param {Lab} lab */
  function show(lab) {
    const [areaOnly, localisedOnly] = lab.counterexamples;
    const against = areaOnly + localisedOnly;
    setText(
      summary,
      t(
        "{total} random tetrahedra, {against} against: {share} ({areaOnly} lower only the area, {localisedOnly} only the localised energy).",
        {
          total: whole.format(lab.tetrahedra),
          against: whole.format(against),
          share: percent(against, lab.tetrahedra),
          areaOnly: whole.format(areaOnly),
          localisedOnly: whole.format(localisedOnly),
        },
      ),
    );
    const most = Math.max(
      ...lab.classes.map((c) => c.counterexamples / Math.max(c.total, 1)),
      1e-9,
    );
    rows.replaceChildren(
      ...lab.classes.map(({ below, total, counterexamples }, n) => {
        const row = document.createElement("tr");
        const head = document.createElement("th");
        head.scope = "row";
        head.textContent = `${n === 0 ? 0 : lab.classes[n - 1].below}–${below}°`;
        const share = document.createElement("td");
        const bar = document.createElement("span");
        bar.className = "bar";
        bar.style.width = `${(100 * counterexamples) / Math.max(total, 1) / most}%`;
        share.append(percent(counterexamples, total), bar);
        row.append(head);
        for (const count of [total, counterexamples]) {
          row.insertCell().textContent = whole.format(count);
        }
        row.append(share);
        return row;
      }),
    );
    showQuadrilateral(strongest, lab.strongest);
  }

  async function run() {
    try {
      while (running && section.open) {
        show(await controller.lab(BATCH));
        await new Promise(requestAnimationFrame);
      }
    } catch (error) {
      controller.report(error);
    }
    stop();
  }

  function stop() {
    running = false;
    setText(button, t("Draw quadrilaterals"));
  }

  button.addEventListener("click", () => {
    if (running) return stop();
    running = true;
    setText(button, t("Stop"));
    run();
  });
}
