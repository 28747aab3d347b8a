// @ts-check
// Files that the browser saves: meshes, numbers, pictures, films, sequences.

import { signal } from "@preact/signals-core";
import { extensionOf } from "./mesh-format.js";
import { createMontage } from "./montage.js";
import { say } from "./words.js";

/** @import { Page } from "./actions.js" */
/** @import { S } from "./store.js" */

/** Frames a second of a film. */
const RATE = 30;
/** Bits a second: fine lines stay fine. */
const QUALITY = 12_000_000;
/** What a browser records, the best first. */
const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/**
 * @param {Pick<S, "mesh" | "options" | "reading">} state
 * @param {string} format
 * @returns {string} e.g. `icosphere-circle-step0012.ply`
 */
export function fileName({ mesh, options, reading }, format) {
  const name = (mesh?.name ?? "surface").replace(/[^\p{L}\p{N}._-]+/gu, "-");
  const step = String(reading?.step ?? 0).padStart(4, "0");
  const ending = format === "recipe" ? "recipe.json" : extensionOf(format);
  return `${name}-${options.flow}-step${step}.${ending}`;
}

/** @param {Blob} blob @param {string} name */
function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // The browser has the address by then; large files are still being written.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** All pictures of the stage as one. @param {Page} page */
function montageOf({ stage }) {
  return createMontage(stage.root, () =>
    [stage.first, ...stage.others.values()]
      .filter(({ figure }) => !figure.classList.contains("away"))
      .map(({ figure, viewer }) => ({ figure, paint: (...place) => viewer?.paint(...place) })),
  );
}

/** @param {Page} page */
export function createSave(page) {
  /** @returns {Promise<Blob | null>} */
  async function picture() {
    const { stage } = page;
    if (!stage.first.viewer) return null;
    return stage.others.size > 0 ? montageOf(page).snapshot() : stage.first.viewer.snapshot();
  }

  /** @param {string} kind @returns {Promise<{ format: string, blob: Blob }>} */
  async function contents(kind) {
    if (kind === "recipe") {
      return {
        format: kind,
        blob: new Blob([await page.open.recipe()], { type: "application/json" }),
      };
    }
    if (kind !== "png") {
      const { format, bytes } = await page.run.export(kind);
      const type = format === "csv" ? "text/csv" : "application/octet-stream";
      return { format, blob: new Blob([bytes], { type }) };
    }
    const blob = await picture();
    if (blob) return { format: kind, blob };
    const [message, hint] = [say("no-picture"), say("no-picture.hint")];
    throw { kind: "NoPicture", message, hint, detail: {} };
  }

  return {
    picture,
    /** @param {string} format */
    async file(format) {
      try {
        const { format: kind, blob } = await contents(format);
        save(blob, fileName(page.get(), kind));
      } catch (error) {
        page.report(error);
      }
    },
    /** @param {string} format @param {number} every */
    async sequence(format, every) {
      const name = fileName(page.get(), "zip");
      const zip = await page.edit.sequence(format, every);
      if (zip) save(new Blob([zip], { type: "application/zip" }), name);
    },
  };
}

/** Films of the stage. @param {Page} page */
export function createFilm(page) {
  const isOn = signal(false);
  const time = signal("");
  const { stage } = page;
  const type =
    typeof MediaRecorder === "undefined" || !("captureStream" in stage.canvas)
      ? undefined
      : types.find((one) => MediaRecorder.isTypeSupported(one));
  /** @type {MediaRecorder | null} */
  let recorder = null;

  function start() {
    const montage = montageOf(page);
    const whole = stage.others.size > 0 ? montage.canvas() : null;
    if (whole) montage.paint(whole);
    /** @type {Blob[]} */
    const parts = [];
    const name = fileName(page.get(), type?.startsWith("video/webm") ? "webm" : "mp4");
    const film = new MediaRecorder((whole ?? stage.canvas).captureStream(RATE), {
      mimeType: type,
      videoBitsPerSecond: QUALITY,
    });
    recorder = film;
    const begun = performance.now();
    const show = () => {
      const seconds = Math.floor((performance.now() - begun) / 1000);
      time.value = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
    };
    const timer = setInterval(show, 500);
    // A canvas gives a frame when it is drawn.
    const end = stage.onDrawn(() => whole && montage.paint(whole));
    film.addEventListener("dataavailable", ({ data }) => data.size > 0 && parts.push(data));
    film.addEventListener("error", () =>
      page.notes.error({ message: say("film-failed"), hint: say("film-failed.hint") }),
    );
    film.addEventListener("stop", () => {
      clearInterval(timer);
      end();
      for (const track of film.stream.getTracks()) track.stop();
      recorder = null;
      isOn.value = false;
      time.value = "";
      if (parts.length > 0) save(new Blob(parts, { type: film.mimeType }), name);
    });
    // In parts, so that little is lost if the page is.
    film.start(1000);
    isOn.value = true;
    show();
    // It begins with what is there.
    stage.first.viewer?.snapshot().catch(() => {});
  }

  return {
    isOn,
    time,
    isAble: type !== undefined,
    /** Begins one, or ends it and saves it. */
    async turn() {
      try {
        if (!recorder) return start();
        // Ends with the picture as it is now, however long it has stood still.
        await stage.first.viewer?.snapshot().catch(() => {});
        recorder?.stop();
      } catch (error) {
        page.report(error);
      }
    },
  };
}
