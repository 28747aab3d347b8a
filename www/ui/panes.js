// @ts-check
// Pictures beside the surface: edge flips from the same start by other criteria, or the
// start itself; flows that are compared. One camera for all.

/** @import { Pane } from "../generated/types.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Shown } from "./extra-pane.js" */

import { t } from "../language.js";
import { byCurvature, choiceLabel, flowLabel } from "../options.js";
import { say } from "../words.js";
import { captionParts, rivalPictures } from "./comparison-words.js";
import { jumpText } from "./curvature-form.js";
import { byId } from "./element.js";
import { ExtraPane, setCaption } from "./extra-pane.js";
import { createMontage } from "./montage.js";
import { formatNumber } from "./number.js";
import { ownPane } from "./picture.js";

const order = ["start", "area", ...byCurvature, "localised"];

/** What stands under a pane. @param {Pane["name"]} name @param {Readonly<PageState>} state */
function captionOf(name, { reading, frame }) {
  const pane = frame?.panes.find((pane) => pane.name === name);
  if (pane?.state) {
    const { step } = pane.state;
    const values = { flow: flowLabel(name), step, jump: jumpText(pane.jump) };
    return pane.jump
      ? t("{flow}: step {step}, jump of H {jump}", values)
      : t("{flow}: step {step}", values);
  }
  const named = name === "localised" ? t("Localised") : choiceLabel("criterion", name);
  const label = name === "start" ? t("Start") : named;
  const run = reading?.flips?.find(({ criterion }) => criterion === name);
  const first = frame?.curves?.runs[0];
  const values = {
    label,
    area: formatNumber(run ? run.area : first?.area[0], 6),
    circle: formatNumber(run ? run.circle : first?.circle[0], 5),
  };
  if (!run) return t("{label}: area {area}, W {circle}", values);
  const flips = say("count-flips", { count: run.flips });
  return t("{label}: {flips}, area {area}, W {circle}", { ...values, flips });
}

/** @param {Readonly<PageState>} state @returns {{ own: readonly string[], ownOrder: number, others: Shown[] }} */
function picturesOf(state) {
  if (state.comparison.rivals.length > 0) {
    return { own: captionParts(state)[0], ownOrder: 0, others: rivalPictures(state) };
  }
  const own = ownPane(state);
  const others = (state.frame?.panes ?? [])
    .filter(({ name }) => name !== own?.name)
    .map((pane) => ({
      key: pane.name,
      order: order.indexOf(pane.name),
      caption: [captionOf(pane.name, state)],
      drawable: pane,
      ...pane,
    }));
  return {
    own: own && others.length > 0 ? [captionOf(own.name, state)] : [],
    ownOrder: order.indexOf(own?.name ?? ""),
    others,
  };
}

/**
 * @param {Controller} controller
 * @param {Pick<ReturnType<typeof import("./picture.js").createPicture>, "isMoved" | "paint" | "snapshot">} picture
 * @param {1 | 4} samples  of the pictures' smoothing
 */
export function createPanes(controller, picture, samples) {
  const root = byId("panes", HTMLElement);
  const own = byId("own-pane", HTMLElement);
  const ownCaption = byId("own-caption", HTMLElement);
  /** @type {ExtraPane[]} */
  let extra = [];

  /** One in the place of all, or side by side. @param {PageState["comparison"]["shown"]} shown */
  function arrange(shown) {
    const word = String(shown);
    if ((root.dataset.shown ?? "side") === word) return;
    root.dataset.shown = word;
    const figures = [own, ...extra.map(({ figure }) => figure)];
    const held = figures.some((figure) => figure.contains(document.activeElement));
    figures.forEach((figure, n) => {
      figure.classList.toggle("in-place", n === shown);
    });
    // What is not seen cannot keep the focus.
    const next = figures[shown === "side" ? 0 : shown]?.querySelector("[role=img]");
    if (held) /** @type {HTMLElement | null | undefined} */ (next)?.focus();
  }

  const montage = createMontage(root, () =>
    [{ figure: own, paint: picture.paint }, ...extra.map((one) => one.tile())].filter(
      ({ figure }) => getComputedStyle(figure).visibility === "visible",
    ),
  );

  return {
    /** For all that is on the stage, where that is more than the surface's own canvas. */
    sheet: () => (extra.length > 0 || picture.isMoved() ? montage.canvas() : null),
    compose: montage.paint,
    /** @returns {Promise<Blob | null>} */
    snapshot: () => (extra.length > 0 ? montage.snapshot() : picture.snapshot()),

    /** @param {Readonly<PageState>} state */
    update(state) {
      const { own: caption, ownOrder, others } = picturesOf(state);
      const keys = others.map(({ key }) => key);
      if (keys.join() !== extra.map(({ key }) => key).join()) {
        for (const one of extra) if (!keys.includes(one.key)) one.close();
        extra = keys.map(
          (key) => extra.find((one) => one.key === key) ?? new ExtraPane(key, controller, samples),
        );
        root.append(...extra.map(({ figure }) => figure));
        root.dataset.count = String(1 + extra.length);
      }
      own.style.order = String(ownOrder);
      ownCaption.hidden = extra.length === 0;
      if (extra.length > 0) setCaption(ownCaption, caption);
      extra.forEach((one, n) => {
        one.update(state, others[n]);
      });
      // Of three in two rows the last stands in the middle.
      const figures = [own, ...extra.map(({ figure }) => figure)];
      const last = Math.max(...figures.map(({ style }) => Number(style.order)));
      for (const figure of figures) {
        figure.classList.toggle("last", Number(figure.style.order) === last);
      }
      arrange(state.comparison.shown);
    },
  };
}
