// @ts-check
// A picture beside that of the surface, under the same camera.

/** @import { Field } from "../state.js" */
/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */
/** @import { Drawable } from "../viewer.js" */
/** @import { Viewer } from "./picture.js" */

import { t } from "../language.js";
import { styleOf } from "./picture.js";

/**
 * What a pane shows.
 * @typedef {object} Shown
 * @property {string} key           of the pane it belongs to
 * @property {number} order         among the panes
 * @property {readonly string[]} caption  in parts, see `setCaption`
 * @property {Drawable} drawable    connectivity, and the positions that the camera is set for
 * @property {Float32Array} positions
 * @property {Field | null} field
 * @property {Uint32Array} [highlight]  two ends an edge
 * @property {Uint32Array} [marked]     triangles
 * @property {Uint8Array} [held]        1 where a vertex is held
 */

/**
 * One sentence in one part or three, of which a narrow pane leaves the middle one out.
 * @param {HTMLElement} element @param {readonly string[]} parts
 */
export function setCaption(element, parts) {
  if (element.textContent === parts.join("") && element.childElementCount === parts.length) return;
  element.replaceChildren(
    ...parts.map((text, n) => {
      const span = document.createElement("span");
      if (n === 1) span.className = "what";
      span.textContent = text;
      return span;
    }),
  );
}

export class ExtraPane {
  /** @type {Viewer | null} */
  #viewer = null;
  #isGone = false;
  /** @type {Shown | null} what the viewer has */
  #drawn = null;
  /** @type {PageState["mesh"]} */
  #mesh = null;
  /** @type {PageState["camera"]} */
  #camera = null;
  /** @type {Readonly<PageState>["view"] | null} */
  #view = null;
  /** @type {[Readonly<PageState>, Shown] | null} */
  #last = null;

  /** @param {string} key @param {Controller} controller @param {1 | 4} samples */
  constructor(key, controller, samples) {
    this.key = key;
    this.figure = document.createElement("figure");
    this.figure.className = "pane";
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
      if (this.#last) this.update(...this.#last);
    } catch (error) {
      controller.report(error);
    }
  }

  /** @param {Readonly<PageState>} state @param {Shown} shown */
  update(state, shown) {
    this.#last = [state, shown];
    this.figure.style.order = String(shown.order);
    setCaption(this.caption, shown.caption);
    const name = state.mesh?.name ?? "–";
    const label = t("Surface: {name}, {caption}", { name, caption: shown.caption.join("") });
    if (this.canvas.ariaLabel !== label) this.canvas.ariaLabel = label;
    const viewer = this.#viewer;
    if (!viewer) return;
    if (state.view !== this.#view) {
      this.#view = state.view;
      viewer.setStyle(styleOf(state));
    }
    this.#draw(viewer, state.mesh, shown);
    if (state.camera !== this.#camera && state.camera) {
      this.#camera = state.camera;
      viewer.setCamera(state.camera);
    }
  }

  /** @param {Viewer} viewer @param {PageState["mesh"]} mesh @param {Shown} shown */
  #draw(viewer, mesh, shown) {
    const { drawable, positions, field, highlight, marked, held } = shown;
    let before = this.#drawn;
    if (mesh !== this.#mesh) {
      viewer.setMesh(drawable);
      this.#mesh = mesh;
      this.#camera = null;
      before = null;
    } else if (drawable !== before?.drawable) {
      viewer.replaceMesh(drawable);
      before = null;
    }
    if (positions !== before?.positions || field !== before.field) {
      viewer.setFrame(positions, field, marked);
    }
    if (highlight && highlight !== before?.highlight) viewer.setHighlight(highlight);
    if (held && held !== before?.held) viewer.setFixed(held);
    this.#drawn = shown;
  }

  /** @returns {import("./montage.js").Tile} */
  tile() {
    return { figure: this.figure, paint: (...place) => this.#viewer?.paint(...place) };
  }

  close() {
    this.#isGone = true;
    this.#viewer?.destroy();
    this.figure.remove();
  }
}
