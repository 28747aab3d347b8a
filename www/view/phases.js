// @ts-check
// The phase diagram of vesicles: energy over reduced volume, of three branches of shapes. Every
// point is a surface that a click opens.

import { signal } from "@preact/signals-core";
import { html, nothing, svg } from "lit-html";
import { LOST } from "../channel.js";
import { formatNumber, formatShort } from "../number.js";
import { say } from "../words.js";
import { button, grid } from "./parts.js";
import { ticksOf } from "./plot.js";
import { solverAside } from "./study.js";

/** @import { Phase } from "../generated/types.js" */
/** @import { Page } from "../actions.js" */

/** @typedef {Phase & { bytes: Uint8Array<ArrayBuffer> }} Shape */

const branches = ["prolate", "oblate", "stomatocyte"];
/** What the axes reach over: reduced volumes, energies. */
const [VOLUMES, ENERGIES] = [
  [0.48, 0.97],
  [1, 2.15],
];
const [WIDTH, HEIGHT, LEFT, BOTTOM, GAP] = [420, 320, 40, 280, 12];

/** @type {import("@preact/signals-core").Signal<readonly Shape[]>} */
const found = signal([]);
/** @type {import("@preact/signals-core").Signal<import("../solver.js").Solver | null>} */
const solver = signal(null);

/** What went wrong. */
const said = signal("");

function end() {
  solver.peek()?.dismiss();
  solver.value = null;
}

/** @param {Page} page */
async function run(page) {
  const own = solverAside((reason) => {
    said.value = say("study-crashed", { reason });
    end();
  });
  solver.value = own;
  found.value = [];
  said.value = "";
  try {
    for (let phase = await own.phase(0); phase; phase = await own.phase(found.peek().length)) {
      const { bytes } = await own.export("ply");
      if (solver.peek() !== own) return;
      found.value = [...found.peek(), { ...phase, bytes: /** @type {any} */ (bytes) }];
    }
  } catch (error) {
    if (/** @type {import("../words.js").Fault} */ (error).kind !== LOST) page.report(error);
  }
  if (solver.peek() === own) end();
}

/** @param {Page} page @param {Shape} shape */
function open(page, { branch, reducedVolume, bytes, options }) {
  const name = `${branch}-${reducedVolume.toFixed(3)}.ply`;
  page.open.open([new File([bytes], name)], { options });
}

/** @param {number} value @param {number[]} range */
const share = (value, [low, high]) => (value - low) / (high - low);
/** @param {number} volume */
const x = (volume) => LEFT + (WIDTH - LEFT - GAP) * share(volume, VOLUMES);
/** @param {number} energy */
const y = (energy) => BOTTOM - (BOTTOM - GAP) * share(energy, ENERGIES);

/** @param {Page} page @param {string} branch @param {number} n */
function curve(page, branch, n) {
  const shapes = found.value.filter((one) => one.branch === branch);
  const path = shapes.map(
    (one) => `${x(one.reducedVolume).toFixed(1)} ${y(one.energy).toFixed(1)}`,
  );
  const point = (/** @type {Shape} */ shape) => {
    const { reducedVolume, energy } = shape;
    const values = { branch, volume: reducedVolume.toFixed(3), energy: energy.toFixed(4) };
    const act = () => open(page, shape);
    return svg`<circle class="pane-${n}" r="6" cx=${x(reducedVolume)} cy=${y(energy)} role="button" tabindex="0" aria-label=${say("phase-point", values)}
      @click=${act} @keydown=${(/** @type {KeyboardEvent} */ { key }) => key === "Enter" && act()} />`;
  };
  return svg`${path.length > 1 ? svg`<path class="pane-${n}" d="M${path.join("L")}" />` : nothing}${shapes.map(point)}`;
}

/** @param {Page} page */
function diagram(page) {
  const rows = found.value.map(({ branch, reducedVolume, energy, expected }) => [
    say("phase-branch", { branch }),
    formatNumber(reducedVolume, 4),
    formatNumber(energy, 5),
    expected === null ? "–" : formatNumber(expected, 5),
  ]);
  const heads = [say("phase-of"), "v", "∫H²/4π", say("phase-expected")];
  return html`<svg class="large-plot" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="group" aria-label=${say("phases")}>
      ${ticksOf(ENERGIES[0], ENERGIES[1], false).map((tick) => svg`<line class="grid" x1=${LEFT} x2=${WIDTH - GAP} y1=${y(tick)} y2=${y(tick)} /><text x=${LEFT - 6} y=${y(tick) + 4} text-anchor="end">${formatShort(tick)}</text>`)}
      ${ticksOf(VOLUMES[0], VOLUMES[1], false).map((tick) => svg`<text x=${x(tick)} y=${BOTTOM + 20} text-anchor="middle">${formatShort(tick)}</text>`)}
      <line class="axis" x1=${LEFT} x2=${WIDTH - GAP} y1=${BOTTOM} y2=${BOTTOM} />
      ${branches.map((branch, n) => curve(page, branch, n))}
    </svg>
    ${grid(say("phases"), heads, rows)}`;
}

/** @param {Page} page */
export function phases(page) {
  const shapes = found.value;
  const count = { count: shapes.length, of: shapes[0]?.of ?? 0 };
  return html`<p class="hint">${say("phases-hint")}</p>
    ${solver.value ? button(say("study-cancel"), end, { kind: "small" }) : button(say("phases-run"), () => run(page), { kind: "small primary" })}
    ${said.value ? html`<p class="hint" role="status">${said.value}</p>` : nothing}
    ${shapes.length > 0 ? html`<p class="hint" role="status">${say("phases-count", count)}</p>${diagram(page)}` : nothing}`;
}
