// @ts-check
// Presenting: the surface, the number, a title and the curve, large enough for the last row, and
// the keys of a presenter's clicker.

import { signal } from "@preact/signals-core";
import { html, nothing } from "lit-html";
import { takesKeys } from "../commands.js";
import { figures } from "../generated/library.js";
import { sayFigure } from "../library.js";
import { formatBeside } from "../number.js";
import { isTrouble, sceneTitle, symbol } from "../status.js";
import { say } from "../words.js";
import { starters } from "./cards.js";
import { energyOf, pathOf, thinned, topOf } from "./curve.js";

/** @import { Page } from "../actions.js" */

/** Milliseconds without a movement after which the pointer goes. */
const QUIET = 2000;

const details = signal(false);

/** What comes after, and before: figures of the papers, else what one begins with. @param {Page} page @param {1 | -1} way */
function turnTo(page, way) {
  const { figure, source } = page.get();
  if (figure) {
    const next = figures[figures.indexOf(figure) + way];
    return next && page.open.figure(next);
  }
  const all = ["bumpy-sphere", ...starters];
  const at = all.indexOf(source?.kind === "sample" ? source.id : "");
  return page.open.sample(all[(at + way + all.length) % all.length]);
}

/** @param {Page} page */
function forward(page) {
  const { running, phase } = page.get();
  if (phase === "loading") return;
  const isMoving = running || page.player.motion.peek() !== "still";
  const { lead } = page;
  const isAtEnd = page.isOver() && lead.u >= lead.clip.total * (1 - 1e-9);
  if (!isMoving && isAtEnd) turnTo(page, 1);
  else page.run.toggle();
}

/** @param {Page} page */
function backward(page) {
  const { phase } = page.get();
  if (phase === "loading") return;
  if (page.lead.u > 0) page.run.reset();
  else turnTo(page, -1);
}

/** @type {Record<string, (page: Page) => unknown>} */
const keys = {
  PageDown: forward,
  ArrowRight: forward,
  PageUp: backward,
  ArrowLeft: backward,
  i: () => {
    details.value = !details.peek();
  },
};

/** Keys of a clicker, full screen, and the pointer that goes when it rests. @param {Page} page */
export function listenToClicker(page) {
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
    act(page);
  });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let quiet;
  addEventListener(
    "pointermove",
    () => {
      root.classList.remove("idle");
      clearTimeout(quiet);
      quiet = setTimeout(() => root.classList.toggle("idle", page.get().presenting), QUIET);
    },
    { passive: true },
  );
  // Leaving full screen with the browser's own key ends the presentation too.
  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) page.present(false);
  });
  let was = false;
  page.state.subscribe(({ presenting }) => {
    if (presenting === was) return;
    was = presenting;
    root.classList.toggle("presenting", presenting);
    if (presenting && document.activeElement instanceof HTMLElement) document.activeElement.blur();
    // Refused where the page is embedded; presenting works without.
    if (presenting) root.requestFullscreen?.().catch(() => {});
    else if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
  });
}

/** @param {Page} page */
function line(page) {
  const { points, total } = page.lead.clip;
  if (points.length < 2) return nothing;
  const most = topOf(points);
  const list = thinned(points).map((point) => [
    (600 * point.sum) / (total || 1),
    140 - (128 * Math.max(energyOf(point), 0)) / most,
  ]);
  const x = (600 * page.lead.u) / (total || 1);
  const { index, share } = page.lead.clip.at(page.lead.u);
  const [a, b] = [points[index], points[index + 1] ?? points[index]];
  const y = 140 - (128 * Math.max(energyOf(a) + share * (energyOf(b) - energyOf(a)), 0)) / most;
  return html`<svg class="present-line" viewBox="0 0 600 150" aria-hidden="true">
    <line x1="0" x2="600" y1="140" y2="140" /><path class="computed" d=${pathOf(list)} />
    <path class="played" d=${pathOf([...list.filter(([left]) => left < x), [x, y]])} /><circle cx=${x} cy=${y} r="9" /></svg>`;
}

/** @param {Page} page */
export function present(page) {
  const s = page.state.value;
  if (!s.presenting) return nothing;
  page.player.tick.value;
  const shown = page.shown();
  const first = page.lead.clip.points[0]?.state.energy ?? 0;
  const title = s.figure ? sayFigure(s.figure, "title") : sceneTitle(s.source);
  const clause = s.figure
    ? `${say(`paper-${s.figure.paper}.authors`)}, ${sayFigure(s.figure)}`
    : say(`flow-${s.options.flow}`);
  return html`<div class="present-number"><b>${formatBeside(shown?.energy, first)}</b><span>${symbol(s)}</span></div>
    <div class="present-caption"><h2 id="presented">${title}</h2><p>${clause}</p></div>${line(page)}
    ${isTrouble(shown) ? html`<i class="present-trouble"></i>` : nothing}
    ${details.value && shown ? html`<p class="present-details">${say("clause-step", { step: shown.step })}. ${shown.message ? say(shown.message) : ""}</p>` : nothing}`;
}
