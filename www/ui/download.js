// @ts-check
// Saves the mesh, the history or the picture.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { choices } from "../options.js";
import { byId, fillSelect } from "./element.js";

/**
 * @param {Readonly<PageState>} state
 * @param {string} format
 * @returns {string} e.g. `icosphere-circle-step0012.ply`
 */
export function fileName({ mesh, options, reading }, format) {
  const name = (mesh?.name ?? "surface").replace(/[^\p{L}\p{N}._-]+/gu, "-");
  const step = String(reading?.step ?? 0).padStart(4, "0");
  const ending = format === "recipe" ? "recipe.json" : format.replace("-ascii", "");
  return `${name}-${options.flow}-step${step}.${ending}`;
}

/** @param {Blob} blob @param {string} name */
export function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has the address by then; large files are still being written.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/**
 * @param {Controller} controller
 * @param {() => Readonly<PageState>} state
 * @param {() => Promise<Blob | null>} snapshot
 */
export function createDownload(controller, state, snapshot) {
  const format = byId("format", HTMLSelectElement);
  const button = byId("download", HTMLButtonElement);
  fillSelect(format, choices.format);

  /** @param {string} kind @returns {Promise<{ format: string, blob: Blob }>} */
  async function contents(kind) {
    if (kind === "recipe") {
      const blob = new Blob([await controller.recipe()], { type: "application/json" });
      return { format: kind, blob };
    }
    if (kind !== "png") {
      const { format, bytes } = await controller.export(kind);
      const type = format === "csv" ? "text/csv" : "application/octet-stream";
      return { format, blob: new Blob([bytes], { type }) };
    }
    const picture = await snapshot();
    if (picture) return { format: kind, blob: picture };
    throw {
      kind: "NoPicture",
      message: t("There is no picture to save."),
      hint: t("Save the mesh."),
    };
  }

  button.addEventListener("click", async () => {
    if (!state().mesh) return;
    try {
      // Named after the step it shows: a run may go on while it is written.
      const shown = state();
      const { format: kind, blob } = await contents(format.value);
      save(blob, fileName(shown, kind));
    } catch (error) {
      controller.report(error);
    }
  });
}
