// @ts-check
// The history under the buttons: a slider over the stored steps, played forwards and
// backwards, and the branches.

/** @import { Timeline } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { byId, setText } from "./element.js";
import { formatNumber } from "./number.js";

/** @param {Controller} controller */
export function createScrubber(controller) {
  const root = byId("scrubber", HTMLElement);
  const slider = byId("scrub", HTMLInputElement);
  const value = byId("scrub-value", HTMLElement);
  const rate = byId("history-rate", HTMLSelectElement);
  const branches = byId("branches", HTMLSelectElement);
  const players = [
    { button: byId("history-back", HTMLButtonElement), direction: /** @type {const} */ (-1) },
    { button: byId("history-forth", HTMLButtonElement), direction: /** @type {const} */ (1) },
  ];

  /** Whether the thumb is held: then it stays where it is. */
  let isHeld = false;
  /** @type {Timeline | null} */
  let timeline = null;
  let playing = 0;

  /** @param {number} step */
  function tell(step) {
    const text = t("Step {step} of {last}", { step, last: timeline?.last ?? step });
    setText(value, text);
    if (slider.ariaValueText !== text) slider.ariaValueText = text;
  }

  slider.addEventListener("input", () => {
    isHeld = true;
    tell(slider.valueAsNumber);
    controller.seek(slider.valueAsNumber);
  });
  slider.addEventListener("change", async () => {
    await controller.seek(slider.valueAsNumber);
    isHeld = false;
    // Between stored steps it comes to rest on one.
    if (timeline) show(timeline);
  });
  for (const { button, direction } of players) {
    button.addEventListener("click", () => {
      if (playing === direction) controller.stopHistory();
      else if (button.ariaDisabled !== "true") {
        controller.playHistory(direction, () => Number(rate.value));
      }
    });
  }
  branches.addEventListener("change", () => {
    if (branches.value) controller.branch(Number(branches.value));
  });

  /** @param {Timeline} now */
  function showBranches({ branches: known }) {
    const options = known.map(({ id, from, last, energy }) => {
      const values = { from, steps: last - from, energy: formatNumber(energy, 4) };
      return new Option(
        t("Branch from step {from} ({steps} steps, energy {energy})", values),
        `${id}`,
      );
    });
    const heading = new Option(
      known.length === 1 ? t("1 branch") : t("{count} branches", { count: known.length }),
      "",
    );
    branches.replaceChildren(heading, ...options);
    branches.hidden = known.length === 0;
  }

  /** @param {Timeline} now */
  function show(now) {
    const { start, last, at } = now;
    if (slider.min !== String(start)) slider.min = String(start);
    if (slider.max !== String(last)) slider.max = String(last);
    if (isHeld) return;
    if (slider.valueAsNumber !== at) slider.value = String(at);
    tell(at);
  }

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      root.hidden =
        !state.timeline ||
        (state.timeline.stored < 2 && state.timeline.branches.length === 0) ||
        !state.reading;
      if (state.timeline && state.timeline !== timeline) {
        const before = JSON.stringify(timeline?.branches);
        timeline = state.timeline;
        if (before !== JSON.stringify(timeline.branches)) showBranches(timeline);
        show(timeline);
      }
      playing = state.playing;
      for (const { button, direction } of players) {
        button.ariaPressed = String(playing === direction);
        const end = direction > 0 ? timeline?.next : timeline?.previous;
        button.ariaDisabled = String(playing !== direction && (end ?? null) === null);
      }
    },
  };
}
