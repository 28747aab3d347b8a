// @ts-check
// A mesh from the user: the button, or a file dropped anywhere.

import { byId } from "./element.js";

/** @param {(file: File) => void} open */
export function createMeshInput(open) {
  const input = byId("file", HTMLInputElement);
  byId("open", HTMLButtonElement).addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    // Emptied, so that the same file can be opened again after it was edited.
    if (file) open(file);
    input.value = "";
  });

  const target = byId("drop", HTMLElement);
  // `dragleave` also comes when the pointer moves from one element to the next.
  let depth = 0;
  /** @param {DragEvent} event */
  const hasFile = (event) => event.dataTransfer?.types.includes("Files") ?? false;
  /** @param {number} now */
  function setDepth(now) {
    depth = Math.max(0, now);
    target.hidden = depth === 0;
  }
  window.addEventListener("dragenter", (event) => {
    if (hasFile(event)) setDepth(depth + 1);
  });
  window.addEventListener("dragleave", (event) => {
    if (hasFile(event)) setDepth(depth - 1);
  });
  window.addEventListener("dragover", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  });
  window.addEventListener("drop", (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    setDepth(0);
    const file = event.dataTransfer?.files[0];
    if (file) open(file);
  });
}
