// The tab that sets flows side by side.

import { html, nothing } from "lit-html";
import { letter, MOST_PANES, optionsOf, timeUnitsAgree } from "../comparison.js";
import { flows } from "../generated/schema.js";
import { flowLabel, named, rowOf } from "../options.js";
import { say } from "../words.js";
import { field, fieldsOf } from "./flow.js";
import { page } from "./page.js";
import { button, iconButton, keycap, segmented, select } from "./parts.js";

/** @import { Comparison, Rival } from "../store.js" */

const contrasts = /** @type {const} */ (["flow", "p", "regularise", "scheme", "then"]);

/** A pane, and what it does otherwise. @param {Rival} rival @param {number} n */
function form(rival, n) {
  const { change, phase, reason } = rival;
  const own = optionsOf(page.state.value.options, change);
  const name = letter(n + 1);
  const set = (/** @type {Rival["change"]} */ edit) => page.compare.change(rival, edit);
  const others = flows.map(({ id }) => id).filter((id) => id !== "flips");
  return html`<fieldset class="pane-form"><legend><b class="pane-${n + 1}">${name}</b></legend>
    ${select(say("pane-flow", { name }), named(others, "flow"), own.flow, (flow) => set({ flow }))}
    ${[...fieldsOf(own, true), rowOf("tau")].map((row) => field(row, own, set))}
    ${phase === "lost" ? html`<p class="hint danger">${reason}</p>` : nothing}
    ${iconButton("close", say("remove-pane", { name }), () => page.compare.remove(rival))}</fieldset>`;
}

/** How the panes are shown. @param {boolean} agree  whether their times can be compared */
function display(agree) {
  const { comparison, colour, options } = page.state.value;
  const { rivals, lockstep, shown, difference } = comparison;
  const { show } = page.compare;
  /** @type {Comparison["lockstep"][]} */
  const steps = agree ? ["progress", "time", "step"] : ["progress", "step"];
  const places = named(["side", "place"], "show-panes");
  const distances = [options, ...rivals].map((_, n) => ({
    id: String(n),
    label: say("distance-to", { name: letter(n) }),
  }));
  const colours = [{ id: "", label: say(`colour-${colour}`) }, ...distances];
  return html`<hr />
    ${rivals.length > 0 ? segmented(say("lockstep"), named(steps, "lockstep"), lockstep, (id) => show({ lockstep: id })) : nothing}
    ${agree ? nothing : html`<p class="hint">${say("times-differ")}</p>`}
    ${segmented(say("show-panes"), places, shown === "side" ? "side" : "place", (id) => show({ shown: id === "side" ? "side" : 0 }))}
    <p class="hint">${say("in-place-hint")} ${keycap("B")}</p>
    ${select(say("pane-colours"), colours, String(difference ?? ""), (id) => show({ difference: id === "" ? null : Number(id) }))}
    ${button(say("close-comparison"), page.compare.close, "small")}`;
}

export function compare() {
  const { comparison, options, mesh } = page.state.value;
  const { rivals, withStart } = comparison;
  if (!mesh) return nothing;
  const isOpen = rivals.length > 0;
  const agree = timeUnitsAgree([options, ...rivals.map((one) => optionsOf(options, one.change))]);
  // The last of these that the second pane does otherwise: an exponent changes the flow too.
  const differs = contrasts.findLast((what) => what in (rivals[0]?.change ?? {}));
  const chosen = withStart ? "then" : differs;
  const more = say("add-pane", { name: letter(rivals.length + 1) });
  return html`<p class="hint">${say("compare-hint")}</p>
    <div class="row">${contrasts.map((what) => button(say(`contrast-${what}`), () => page.compare.contrast(what), "chip", { pressed: what === chosen }))}</div>
    ${isOpen ? html`<p class="pane-name"><b class="pane-0">A</b> ${flowLabel(options.flow)}</p>` : nothing}
    ${rivals.map(form)}
    ${isOpen && rivals.length < MOST_PANES - 1 ? button(more, page.compare.add, "small") : nothing}
    ${isOpen || withStart ? display(agree) : nothing}`;
}
