// @ts-check
// The handle of a drawer, which is a sheet on a phone: dragged up it takes the place of the
// surface, dragged down it is as before, and then closed. A tap does the same without dragging.

import { signal } from "@preact/signals-core";
import { html } from "lit-html";
import { say } from "../words.js";

/** Whether sheets have their full height. */
export const isTall = signal(false);

/** So far, in CSS pixels, a finger may slip on a tap. */
const SLIP = 6;

/** @param {() => void} shut */
export function handle(shut) {
  return html`<button type="button" class="grip" aria-label=${say("full-height")} aria-pressed=${String(isTall.value)}
    @pointerdown=${(/** @type {PointerEvent} */ event) => drag(event, shut)}
    @click=${(/** @type {MouseEvent} */ event) => {
      // By a pointer it was dragged or tapped before.
      if (event.detail === 0) isTall.value = !isTall.value;
    }}></button>`;
}

/** @param {PointerEvent} down @param {() => void} shut */
function drag(down, shut) {
  const button = /** @type {HTMLElement} */ (down.currentTarget);
  const panel = /** @type {HTMLElement} */ (button.closest(".panel"));
  const start = panel.getBoundingClientRect().height;
  const most = start + (document.getElementById("stage")?.clientHeight ?? 0);
  const ending = new AbortController();
  const { signal } = ending;
  let by = 0;
  button.setPointerCapture(down.pointerId);
  const move = (/** @type {PointerEvent} */ event) => {
    by = down.clientY - event.clientY;
    if (Math.abs(by) <= SLIP) return;
    panel.classList.add("dragged");
    panel.style.height = `${Math.max(0, Math.min(most, start + by))}px`;
  };
  const end = (/** @type {boolean} */ isDone) => {
    ending.abort();
    panel.style.height = "";
    panel.classList.remove("dragged");
    if (!isDone) return;
    if (Math.abs(by) <= SLIP) isTall.value = !isTall.value;
    else if (by > 0) isTall.value = true;
    else if (isTall.value && start + by > start / 3) isTall.value = false;
    else shut();
  };
  button.addEventListener("pointermove", move, { signal });
  button.addEventListener("pointerup", () => end(true), { signal });
  button.addEventListener("pointercancel", () => end(false), { signal });
}
