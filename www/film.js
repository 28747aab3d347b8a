// Films of the stage, as it is drawn.

import { signal } from "@preact/signals-core";
import { fileName, montageOf, save } from "./save.js";
import { say } from "./words.js";

/** @import { Page } from "./actions.js" */

/** Frames a second of a film. */
const RATE = 30;
/** Bits a second: fine lines stay fine. */
const QUALITY = 12_000_000;
/** What a browser records, the best first. */
const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** @param {Page} page */
export function createFilm(page) {
  const recorder = signal(/** @type {MediaRecorder | null} */ (null));
  const time = signal("");
  const { stage } = page;
  const type =
    typeof MediaRecorder === "undefined" || !("captureStream" in stage.canvas)
      ? undefined
      : types.find((one) => MediaRecorder.isTypeSupported(one));

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
    const begun = performance.now();
    const show = () => {
      const seconds = Math.floor((performance.now() - begun) / 1000);
      time.value = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
    };
    const timer = setInterval(show, 500);
    // A canvas gives a frame when it is drawn.
    const end = stage.pictures.subscribe(() => whole && montage.paint(whole));
    film.addEventListener("dataavailable", ({ data }) => data.size > 0 && parts.push(data));
    film.addEventListener("error", () =>
      page.notes.error({ message: say("film-failed"), hint: say("film-failed.hint") }),
    );
    film.addEventListener("stop", () => {
      clearInterval(timer);
      end();
      for (const track of film.stream.getTracks()) track.stop();
      recorder.value = null;
      time.value = "";
      if (parts.length > 0) save(new Blob(parts, { type: film.mimeType }), name);
    });
    // In parts, so that little is lost if the page is.
    film.start(1000);
    recorder.value = film;
    show();
    // It begins with what is there.
    stage.first.viewer?.snapshot().catch(() => {});
  }

  return {
    recorder,
    time,
    isAble: type !== undefined,
    /** Begins one, or ends it and saves it. */
    async turn() {
      if (!recorder.peek()) return start();
      // Ends with the picture as it is now, however long it has stood still.
      await stage.first.viewer?.snapshot().catch(() => {});
      recorder.peek()?.stop();
    },
  };
}
