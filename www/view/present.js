// Presenting: the surface, the number, a title and the curve, large enough for the last row, and
// the keys of a presenter's clicker.

import "../style/present.css";
import { computed, signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { takesKeys } from "../commands.js";
import { figures } from "../generated/library.js";
import { sayFigure } from "../library.js";
import { formatBeside } from "../number.js";
import { isTrouble, sceneTitle, symbol } from "../status.js";
import { say } from "../words.js";
import { starters } from "./cards.js";
import { courseOf, pathOf, topOf } from "./curve.js";
import { page } from "./page.js";

/** Milliseconds without a movement after which the pointer goes. */
const QUIET = 2000;

const details = signal(false);

/** What is on its way: a press before it is there counts from it. @type {{ figure: typeof figures[number] | null, id: string } | null} */
let asked = null;

/** What comes after, and before: figures of the papers, else what one begins with. @param {1 | -1} way */
async function turnTo(way) {
  const { figure, source } = page.get();
  const from = asked ?? { figure, id: source?.kind === "sample" ? source.id : "" };
  const all = ["bumpy-sphere", ...starters];
  const next = from.figure
    ? { figure: figures[figures.indexOf(from.figure) + way], id: "" }
    : { figure: null, id: all[(all.indexOf(from.id) + way + all.length) % all.length] };
  if (next.figure === undefined) return;
  asked = next;
  try {
    await (next.figure ? page.open.figure(next.figure) : page.open.sample(next.id));
  } finally {
    if (asked === next) asked = null;
  }
}

function forward() {
  const isMoving = page.get().running || page.player.motion.peek() !== "still";
  const { clip, u } = page.lead;
  const isAtEnd = !isMoving && page.isOver() && u >= clip.total * (1 - 1e-9);
  return asked || isAtEnd ? turnTo(1) : page.run.toggle();
}

const backward = () => (page.lead.u > 0 && !asked ? page.run.reset() : turnTo(-1));

/** @type {Record<string, () => unknown>} */
const keys = {
  ...{ PageDown: forward, ArrowRight: forward, PageUp: backward, ArrowLeft: backward },
  i() {
    details.value = !details.peek();
  },
};

// Keys of a clicker, full screen, and the pointer that goes when it rests.
const root = document.documentElement;
addEventListener("keydown", (event) => {
  const { presenting, dialog } = page.get();
  const act = Object.hasOwn(keys, event.key) ? keys[event.key] : null;
  if (!act || !presenting || dialog || event.defaultPrevented || event.repeat) return;
  if (event.ctrlKey || event.metaKey || event.altKey || event.shiftKey || takesKeys(event.target))
    return;
  // Arrow keys belong to what has the focus: they turn the surface.
  if (event.key.startsWith("Arrow") && document.activeElement !== document.body) return;
  event.preventDefault();
  act();
});
/** @type {ReturnType<typeof setTimeout> | undefined} */
let quiet;
const wake = () => {
  root.classList.remove("idle");
  clearTimeout(quiet);
  quiet = setTimeout(() => root.classList.toggle("idle", page.get().presenting), QUIET);
};
addEventListener("pointermove", wake, { passive: true });
// Leaving full screen with the browser's own key ends the presentation too.
document.addEventListener("fullscreenchange", () => {
  if (!document.fullscreenElement) page.present(false);
});
computed(() => page.state.value.presenting).subscribe((presenting) => {
  root.classList.toggle("presenting", presenting);
  if (presenting && document.activeElement instanceof HTMLElement) document.activeElement.blur();
  // Refused where the page is embedded; presenting works without.
  if (presenting) root.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
});

function line() {
  const { clip } = page.lead;
  if (clip.points.length < 2) return nothing;
  const [total, most] = [clip.total || 1, topOf(clip.points)];
  const { whole, played, here } = courseOf(({ sum, state }) => [
    (600 * sum) / total,
    140 - (128 * Math.max(state.energy, 0)) / most,
  ]);
  return html`<svg class="present-line" viewBox="0 0 600 150" aria-hidden="true">
    <line x1="0" x2="600" y1="140" y2="140" /><path class="computed" d=${pathOf(whole)} />
    <path class="played" d=${pathOf(played)} /><circle cx=${here[0]} cy=${here[1]} r="9" /></svg>`;
}

export function present() {
  const s = page.state.value;
  page.player.tick.value;
  const { figure } = s;
  const shown = page.shown();
  const first = page.lead.clip.points[0]?.state.energy ?? 0;
  const title = figure ? sayFigure(figure, "title") : sceneTitle(s.source);
  const clause = figure
    ? `${say(`paper-${figure.paper}.authors`)}, ${sayFigure(figure)}`
    : say(`flow-${s.options.flow}`);
  const more = html`<p class="present-details">${say("reading-step")} ${shown?.step ?? 0}${shown?.message ? `. ${say(shown.message)}` : ""}</p>`;
  return html`<div class="present-number"><b>${formatBeside(shown?.energy, first)}</b><span>${symbol(s)}</span></div>
    <div class="present-caption"><h2 id="presented">${title}</h2><p>${clause}</p></div>${line()}
    ${isTrouble(shown) ? html`<i class="present-trouble"></i>` : nothing}${details.value && shown ? more : nothing}`;
}
