// @ts-check
// The selects Sample, Flow, Boundary and Colour by.

/** @import { FieldName } from "../state.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Options } from "../options.js" */

import { samples } from "../generated/library.js";
import { sampleName } from "../library.js";
import { choices, choicesOf, isRead, toFlow, usualBoundary } from "../options.js";
import { say } from "../words.js";
import { byId, fillSelect, setText } from "./element.js";

/** @param {Controller} controller */
export function createChoices(controller) {
  const sample = byId("sample", HTMLSelectElement);
  const note = byId("sample-note", HTMLElement);
  const flow = byId("flow", HTMLSelectElement);
  const boundary = byId("boundary", HTMLSelectElement);
  const colour = byId("colour", HTMLSelectElement);

  for (const shelf of new Set(samples.map(({ group }) => group))) {
    const group = document.createElement("optgroup");
    group.label = say(`group-${shelf}`);
    const own = samples.filter((one) => one.group === shelf);
    group.append(...own.map(({ id }) => new Option(sampleName(id), id)));
    sample.append(group);
  }
  fillSelect(flow, choicesOf("flow"));
  fillSelect(boundary, choicesOf("boundary"));
  fillSelect(colour, choices.colour);
  // Stands for a mesh from a file; it cannot be picked again.
  const own = new Option("", "");
  own.hidden = true;
  sample.prepend(own);

  sample.addEventListener("change", () => controller.sample(sample.value));
  flow.addEventListener("change", () =>
    controller.configure(toFlow(/** @type {Options["flow"]} */ (flow.value))),
  );
  boundary.addEventListener("change", () =>
    controller.configure({ boundary: /** @type {Options["boundary"]} */ (boundary.value) }),
  );
  colour.addEventListener("change", () =>
    controller.colour(/** @type {FieldName} */ (colour.value)),
  );

  /** @type {PageState["source"]} */
  let shown = null;
  /** @type {Options | null} */
  let options = null;
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.source !== shown && state.source) {
        shown = state.source;
        own.textContent = shown.kind === "file" ? shown.name : "";
        sample.value = shown.kind === "sample" ? shown.id : "";
        setText(note, shown.kind === "sample" ? say(`sample-${shown.id}.shows`) : "");
      } else if (state.phase !== "loading" && shown?.kind === "sample") {
        // A sample that was refused leaves the one before in place.
        if (sample.value !== shown.id) sample.value = shown.id;
      }
      if (state.options !== options) {
        options = state.options;
        flow.value = options.flow;
        boundary.value = options.boundary ?? usualBoundary(options.flow) ?? "";
        byId("boundary-field", HTMLElement).hidden = !isRead("boundary", options);
      }
      if (colour.value !== state.colour && state.phase !== "loading") colour.value = state.colour;
    },
  };
}
