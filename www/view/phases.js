// The phase diagram of vesicles: energy over reduced volume, of three branches of shapes. Every
// point is a surface that a click opens.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { formatNumber } from "../number.js";
import { say } from "../words.js";
import { pathOf } from "./curve.js";
import { page } from "./page.js";
import { grid } from "./parts.js";
import { axesOf } from "./plot.js";
import { workAside } from "./study.js";

/** @import { Phase } from "../generated/types.js" */

/** @typedef {Phase & { bytes: Uint8Array<ArrayBuffer> }} Shape */

const branches = ["prolate", "oblate", "stomatocyte"];
/** Reduced volumes, and energies. */
const { x, y, drawing } = axesOf({ size: [420, 320], left: 40, x: [0.48, 0.97], y: [1, 2.15] });

const found = signal(/** @type {readonly Shape[]} */ ([]));

const { said, turn } = workAside(async (own, isWanted) => {
  found.value = [];
  const next = () => own.ask("phase", { number: found.peek().length });
  for (let phase = await next(); phase; phase = await next()) {
    const { bytes } = await own.export("ply");
    if (!isWanted()) return;
    found.value = [...found.peek(), { ...phase, bytes }];
  }
});

/** @param {string} branch @param {number} n */
function curve(branch, n) {
  const shapes = found.value.filter((one) => one.branch === branch);
  const path = pathOf(shapes.map((one) => [x(one.reducedVolume), y(one.energy)]));
  const points = shapes.map(({ reducedVolume, energy, bytes, options }) => {
    const volume = reducedVolume.toFixed(3);
    const label = say("phase-point", { branch, volume, energy: energy.toFixed(4) });
    const open = () => page.open.open([new File([bytes], `${branch}-${volume}.ply`)], { options });
    return svg`<circle class="pane-${n}" r="6" cx=${x(reducedVolume)} cy=${y(energy)} role="button" tabindex="0" aria-label=${label}
      @click=${open} @keydown=${(/** @type {KeyboardEvent} */ { key }) => key === "Enter" && open()} />`;
  });
  return svg`${shapes.length > 1 ? svg`<path class="pane-${n}" d=${path} />` : nothing}${points}`;
}

function diagram() {
  const rows = found.value.map(({ branch, reducedVolume, energy, expected }) => [
    say("phase-branch", { branch }),
    formatNumber(reducedVolume, 4),
    formatNumber(energy, 5),
    formatNumber(expected, 5),
  ]);
  const heads = [say("phase-of"), "v", "∫H²/4π", say("phase-expected")];
  return html`${drawing(say("phases"), "group", branches.map(curve), ["v", "∫H²/4π"])}${grid(say("phases"), heads, rows)}`;
}

export function phases() {
  const { length: count, 0: first } = found.value;
  return html`<p class="hint">${say("phases-hint")}</p>${turn(say("phases-run"))}
    ${said.value ? html`<p class="hint" role="status">${said.value}</p>` : nothing}
    ${first ? html`<p class="hint" role="status">${say("phases-count", { count, of: first.of })}</p>${diagram()}` : nothing}`;
}
