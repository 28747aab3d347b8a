// @ts-check
// The tab that sets flows side by side, and their curves in the dock.

import { html, nothing } from "lit-html";
import { letter, MOST_PANES, optionsOf, timeUnitsAgree } from "../comparison.js";
import { flows } from "../generated/schema.js";
import { flowLabel, rowOf } from "../options.js";
import { say } from "../words.js";
import { field, fieldsOf } from "./flow.js";
import { button, iconButton, keycap, segmented, select } from "./parts.js";

/** @import { Page } from "../actions.js" */
/** @import { Options } from "../options.js" */

const contrasts = /** @type {const} */ (["flow", "p", "regularise", "scheme", "then"]);

/** @param {Page} page */
export function compare(page) {
  const s = page.state.value;
  const { comparison, options, mesh, colour } = s;
  const { rivals, lockstep, shown, difference, withStart } = comparison;
  if (!mesh) return nothing;
  const isOpen = rivals.length > 0 || withStart;
  const all = [options, ...rivals.map(({ change }) => optionsOf(options, change))];
  const agree = timeUnitsAgree(all);
  const steps = [
    { id: "progress", label: say("lockstep-progress") },
    ...(agree ? [{ id: "time", label: say("lockstep-time") }] : []),
    { id: "step", label: say("lockstep-step") },
  ];
  const flowChoices = flows
    .filter(({ id }) => id !== "flips")
    .map(({ id }) => ({ id, label: flowLabel(id) }));
  return html`
    <p class="hint">${say("compare-hint")}</p>
    <div class="row">${contrasts.map((what) => button(say(`contrast-${what}`), () => page.compare.contrast(what), { kind: "chip" }))}</div>
    ${rivals.length > 0 ? html`<p class="pane-name"><b class="pane-0">A</b> ${flowLabel(options.flow)}</p>` : nothing}
    ${rivals.map(({ id, change, phase, reason }, n) => {
      const own = optionsOf(options, change);
      const name = letter(n + 1);
      return html`<fieldset class="pane-form"><legend><b class="pane-${n + 1}">${name}</b></legend>
        ${select(say("pane-flow", { name }), flowChoices, own.flow, (flow) => page.compare.change(id, { flow: /** @type {Options["flow"]} */ (flow) }))}
        ${fieldsOf(page, own, true)
          .concat(rowOf("tau"))
          .map((row) => field(page, row, own, (edit) => page.compare.change(id, edit)))}
        ${phase === "lost" ? html`<p class="hint danger">${reason}</p>` : nothing}
        ${iconButton("close", say("remove-pane", { name }), () => page.compare.remove(id))}</fieldset>`;
    })}
    ${rivals.length > 0 && rivals.length < MOST_PANES - 1 ? button(say("add-pane", { name: letter(rivals.length + 1) }), page.compare.add, { kind: "small" }) : nothing}
    ${
      isOpen
        ? html`<hr />
        ${rivals.length > 0 ? segmented(say("lockstep"), steps, lockstep, (id) => page.compare.show({ lockstep: /** @type {any} */ (id) })) : nothing}
        ${agree ? nothing : html`<p class="hint">${say("times-differ")}</p>`}
        ${segmented(
          say("show-panes"),
          [
            { id: "side", label: say("side-by-side") },
            { id: "place", label: say("in-place") },
          ],
          shown === "side" ? "side" : "place",
          (id) => page.compare.show({ shown: id === "side" ? "side" : 0 }),
        )}
        <p class="hint">${say("in-place-hint")} ${keycap("B")}</p>
        ${select(
          say("pane-colours"),
          [
            { id: "", label: say(`colour-${colour}`) },
            ...[options, ...rivals].map((_, n) => ({
              id: String(n),
              label: say("distance-to", { name: letter(n) }),
            })),
          ],
          difference === null ? "" : String(difference),
          (id) => page.compare.show({ difference: id === "" ? null : Number(id) }),
        )}
        ${button(say("close-comparison"), page.compare.close, { kind: "small" })}`
        : nothing
    }`;
}
