// @ts-check
// Pictures beside the surface: edge flips from the same start by other criteria, or the
// start itself. One camera for all.

/** @import { Pane } from "../protocol.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Viewer } from "./picture.js" */

import { t } from "../language.js";
import { byCurvature } from "../options.js";
import { flowLabel, jumpText } from "./curvature-form.js";
import { byId, setText } from "./element.js";
import { criterionLabel } from "./flips-form.js";
import { formatCount, formatNumber } from "./number.js";
import { ownPane, styleOf } from "./picture.js";

const order = ["start", "area", ...byCurvature, "localised"];

/** What stands under a pane. @param {Pane["name"]} name @param {Readonly<PageState>} state */
function captionOf(name, { reading, frame }) {
  const standing = frame?.panes.find((pane) => pane.name === name)?.standing;
  if (standing) {
    const { step } = standing;
    const values = { flow: flowLabel(name), step, jump: jumpText(standing.jump) };
    return standing.jump
      ? t("{flow}: step {step}, jump of H {jump}", values)
      : t("{flow}: step {step}", values);
  }
  const named = name === "localised" ? t("Localised") : criterionLabel(name);
  const label = name === "start" ? t("Start") : named;
  const run = reading?.flips?.find(({ criterion }) => criterion === name);
  const first = frame?.curves?.runs[0];
  const values = {
    label,
    area: formatNumber(run ? run.area : first?.area[0], 6),
    circle: formatNumber(run ? run.circle : first?.circle[0], 5),
  };
  if (!run) return t("{label}: area {area}, W {circle}", values);
  const flips = formatCount(run.flips, { one: "# flip", other: "# flips" });
  return t("{label}: {flips}, area {area}, W {circle}", { ...values, flips });
}

/** A picture of its own. */
class ExtraPane {
  /** @type {Viewer | null} */
  #viewer = null;
  #isGone = false;
  /** @type {Pane | null} */
  #shown = null;
  /** @type {PageState["mesh"]} */
  #mesh = null;
  /** @type {PageState["camera"]} */
  #camera = null;
  /** @type {Readonly<PageState>["view"] | null} */
  #view = null;
  /** @type {Readonly<PageState> | null} */
  #state = null;

  /** @param {Pane["name"]} name @param {Controller} controller @param {1 | 4} samples */
  constructor(name, controller, samples) {
    this.name = name;
    this.figure = document.createElement("figure");
    this.figure.className = "pane";
    this.figure.style.order = String(order.indexOf(name));
    this.canvas = document.createElement("canvas");
    this.canvas.role = "img";
    this.canvas.tabIndex = 0;
    this.caption = document.createElement("figcaption");
    this.figure.append(this.canvas, this.caption);
    this.#open(controller, samples);
  }

  /** @param {Controller} controller @param {1 | 4} samples */
  async #open(controller, samples) {
    try {
      const { createViewer } = await import("../viewer.js");
      // Laid out first, so that the picture has a size.
      await new Promise(requestAnimationFrame);
      const viewer = await createViewer(this.canvas, {
        samples,
        onFault: controller.report,
        onCamera: (camera) => {
          this.#camera = camera;
          controller.look(camera);
        },
      });
      if (this.#isGone) viewer.destroy();
      else this.#viewer = viewer;
      if (this.#state) this.update(this.#state);
    } catch (error) {
      controller.report(error);
    }
  }

  /** @param {Readonly<PageState>} state */
  update(state) {
    this.#state = state;
    const pane = state.frame?.panes.find(({ name }) => name === this.name);
    const caption = captionOf(this.name, state);
    setText(this.caption, caption);
    const label = t("Surface: {name}, {caption}", { name: state.mesh?.name ?? "–", caption });
    if (this.canvas.ariaLabel !== label) this.canvas.ariaLabel = label;
    const viewer = this.#viewer;
    if (!viewer || !pane) return;
    if (state.view !== this.#view) {
      this.#view = state.view;
      viewer.setStyle(styleOf(state));
    }
    if (pane !== this.#shown) {
      if (state.mesh !== this.#mesh) {
        viewer.setMesh(pane);
        this.#mesh = state.mesh;
        this.#camera = null;
      } else viewer.replaceMesh(pane);
      viewer.setFrame(pane.positions, pane.field);
      viewer.setHighlight(pane.highlight);
      this.#shown = pane;
    }
    if (state.camera !== this.#camera && state.camera) {
      this.#camera = state.camera;
      viewer.setCamera(state.camera);
    }
  }

  close() {
    this.#isGone = true;
    this.#viewer?.destroy();
    this.figure.remove();
  }
}

/**
 * @param {Controller} controller
 * @param {1 | 4} samples  of the pictures' smoothing
 */
export function createPanes(controller, samples) {
  const root = byId("panes", HTMLElement);
  const own = byId("own-pane", HTMLElement);
  const ownCaption = byId("own-caption", HTMLElement);
  /** @type {ExtraPane[]} */
  let extra = [];

  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      const pane = ownPane(state);
      const names = (state.frame?.panes ?? [])
        .map(({ name }) => name)
        .filter((n) => n !== pane?.name);
      if (names.join() !== extra.map(({ name }) => name).join()) {
        for (const one of extra) if (!names.includes(one.name)) one.close();
        extra = names.map(
          (name) =>
            extra.find((one) => one.name === name) ?? new ExtraPane(name, controller, samples),
        );
        root.append(...extra.map(({ figure }) => figure));
        root.dataset.count = String(1 + extra.length);
      }
      own.style.order = String(order.indexOf(pane?.name ?? ""));
      ownCaption.hidden = extra.length === 0;
      if (pane && extra.length > 0) setText(ownCaption, captionOf(pane.name, state));
      for (const one of extra) one.update(state);
    },
  };
}
