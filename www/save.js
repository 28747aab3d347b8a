// Files that the browser saves: meshes, numbers, pictures, sequences.

import { extensionOf } from "./mesh-format.js";
import { createMontage } from "./montage.js";
import { fault } from "./words.js";

/** @import { Page } from "./actions.js" */
/** @import { S } from "./store.js" */

/**
 * @param {Pick<S, "mesh" | "options" | "reading">} state @param {string} format
 * @returns {string} e.g. `icosphere-circle-step0012.ply`
 */
export function fileName({ mesh, options, reading }, format) {
  const name = (mesh?.name ?? "surface").replace(/[^\p{L}\p{N}._-]+/gu, "-");
  const step = String(reading?.step ?? 0).padStart(4, "0");
  const ending = format === "recipe" ? "recipe.json" : extensionOf(format);
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

/** All pictures of the stage as one. @param {Page} page */
export function montageOf({ stage }) {
  return createMontage(stage.root, () =>
    [stage.first, ...stage.others.values()]
      .filter(({ figure }) => !figure.classList.contains("away"))
      .map(({ figure, viewer }) => ({ figure, paint: (...place) => viewer?.paint(...place) })),
  );
}

/** The stage as a PNG. @param {Page} page @returns {Promise<Blob>} */
async function picture(page) {
  const { first, others } = page.stage;
  const taken = first.viewer && (others.size > 0 ? montageOf(page) : first.viewer).snapshot();
  const blob = await taken;
  if (!blob) throw fault("NoPicture", "no-picture");
  return blob;
}

/**
 * What a file of a format holds; another format where the solver cannot be asked.
 * @param {Page} page @param {string} format @returns {Promise<{ format: string, blob: Blob }>}
 */
export async function contents(page, format) {
  if (format === "png") return { format, blob: await picture(page) };
  if (format === "recipe") {
    const type = "application/json";
    return { format, blob: new Blob([await page.open.recipe()], { type }) };
  }
  const file = await page.run.export(format);
  const type = format === "csv" ? "text/csv" : "application/octet-stream";
  return { format: file.format, blob: new Blob([file.bytes], { type }) };
}

/** @param {Page} page @param {string} format */
export async function saveFile(page, format) {
  try {
    const { format: kind, blob } = await contents(page, format);
    save(blob, fileName(page.get(), kind));
  } catch (error) {
    page.report(error);
  }
}

/** All steps that are stored. @param {Page} page @param {string} format @param {number} every */
export async function saveSequence(page, format, every) {
  const name = fileName(page.get(), "zip");
  const zip = await page.edit.sequence(format, every);
  if (zip) save(new Blob([zip], { type: "application/zip" }), name);
}
