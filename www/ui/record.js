// @ts-check
// Films of the picture, and the stored steps as a ZIP of meshes.

/** @import { PageState } from "../state.js" */
/** @import { Controller } from "../controller.js" */

import { t } from "../language.js";
import { choices } from "../options.js";
import { fileName, save } from "./download.js";
import { byId, fillSelect, setText } from "./element.js";

/** Frames a second. */
const RATE = 30;
/** Bits a second: fine lines stay fine. */
const QUALITY = 12_000_000;

/** What a browser records, the best first. */
const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

/** @param {number} seconds */
const clock = (seconds) =>
  `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;

/** @param {number} bytes */
const size = (bytes) => {
  if (bytes < 1e6) return `${Math.ceil(bytes / 1e3)} kB`;
  return bytes < 1e9 ? `${(bytes / 1e6).toPrecision(3)} MB` : `${(bytes / 1e9).toPrecision(3)} GB`;
};

/**
 * What is recorded.
 * @typedef {object} Stage
 * @property {() => Promise<Blob | null>} snapshot  draws the picture anew
 * @property {() => HTMLCanvasElement | null} sheet  for all of several pictures; null where there is one
 * @property {(sheet: HTMLCanvasElement) => void} compose  draws all of them
 */

/**
 * @param {Controller} controller
 * @param {() => Readonly<PageState>} state
 * @param {Stage} stage
 */
export function createRecord(controller, state, stage) {
  const section = byId("record", HTMLDetailsElement);
  const film = createFilm(controller, state, stage);

  const format = byId("sequence-format", HTMLSelectElement);
  const every = byId("sequence-every", HTMLInputElement);
  const told = byId("sequence-size", HTMLElement);
  const button = byId("sequence", HTMLButtonElement);
  const pictures = ["csv", "recipe", "png"];
  fillSelect(
    format,
    choices.format.filter(({ id }) => !pictures.includes(id)),
  );

  let asked = 0;
  /** Says beforehand how large it will be. */
  async function measure() {
    asked += 1;
    const mine = asked;
    if (!section.open || !state().reading || !every.checkValidity()) return;
    try {
      const { meshes, bytes } = await controller.sequenceSize(format.value, every.valueAsNumber);
      if (mine !== asked) return;
      const values = { meshes, size: size(bytes) };
      setText(
        told,
        meshes === 1
          ? t("1 mesh, about {size} before compression; 1 GB at most.", values)
          : t("{meshes} meshes, about {size} before compression; 1 GB at most.", values),
      );
    } catch {
      // Saving says what is wrong.
    }
  }
  format.addEventListener("change", measure);
  every.addEventListener("input", measure);
  section.addEventListener("toggle", measure);

  button.addEventListener("click", async () => {
    if (button.ariaDisabled === "true" || !every.reportValidity()) return;
    const name = fileName(state(), "zip");
    const zip = await controller.sequence(format.value, every.valueAsNumber);
    if (zip) save(new Blob([zip], { type: "application/zip" }), name);
  });

  /** @type {PageState["timeline"]} */
  let measured = null;
  return {
    /** @param {Readonly<PageState>} now */
    update(now) {
      film.update();
      const usable = now.reading !== null && now.phase !== "loading" && now.phase !== "failed";
      button.ariaDisabled = String(!usable);
      if (!section.open || now.phase === "running" || now.playing !== 0) return;
      const { timeline } = now;
      if (timeline?.stored === measured?.stored && timeline?.last === measured?.last) return;
      measured = timeline;
      measure();
    },
  };
}

/**
 * @param {Controller} controller
 * @param {() => Readonly<PageState>} state
 * @param {Stage} stage
 * @returns {{ update: () => void }}
 */
function createFilm(controller, state, stage) {
  const button = byId("film", HTMLButtonElement);
  const elapsed = byId("film-time", HTMLElement);
  const note = byId("film-note", HTMLElement);
  const canvas = byId("surface", HTMLCanvasElement);
  /** @type {MediaRecorder | null} */
  let recorder = null;

  const type =
    typeof MediaRecorder === "undefined" || !("captureStream" in canvas)
      ? undefined
      : types.find((one) => MediaRecorder.isTypeSupported(one));
  if (!type) {
    button.ariaDisabled = "true";
    setText(
      note,
      t("This browser cannot record films. “Picture, PNG” and the steps can be saved."),
    );
    note.hidden = false;
    return { update() {} };
  }

  /** What is recorded where that is not the picture itself. @type {HTMLCanvasElement | null} */
  let whole = null;
  let isDue = false;

  /** A canvas gives a frame when it is drawn. */
  function draw() {
    if (!whole) return void stage.snapshot().catch(() => {});
    if (isDue) return;
    isDue = true;
    requestAnimationFrame(() => {
      isDue = false;
      // Those that stood beside the surface may be gone.
      if (whole) stage.compose(whole);
    });
  }

  function start() {
    whole = stage.sheet();
    // Not with an empty one.
    if (whole) stage.compose(whole);
    /** @type {Blob[]} */
    const parts = [];
    const name = fileName(state(), type?.startsWith("video/webm") ? "webm" : "mp4");
    const film = new MediaRecorder((whole ?? canvas).captureStream(RATE), {
      mimeType: type,
      videoBitsPerSecond: QUALITY,
    });
    recorder = film;
    const begun = performance.now();
    const show = () => setText(elapsed, clock((performance.now() - begun) / 1000));
    const timer = setInterval(show, 500);
    film.addEventListener("dataavailable", ({ data }) => data.size > 0 && parts.push(data));
    film.addEventListener("error", () =>
      controller.report({
        kind: "FilmFailed",
        message: t("The browser stopped recording."),
        hint: t("What was recorded until then is saved."),
      }),
    );
    film.addEventListener("stop", () => {
      clearInterval(timer);
      for (const track of film.stream.getTracks()) track.stop();
      recorder = null;
      whole = null;
      showState();
      if (parts.length > 0) save(new Blob(parts, { type: film.mimeType }), name);
    });
    // In parts, so that little is lost if the page is.
    film.start(1000);
    show();
    // It begins with what is there.
    draw();
  }

  function showState() {
    button.ariaPressed = String(recorder !== null);
    setText(button, recorder ? t("Stop and save") : t("Record film"));
    if (!recorder) setText(elapsed, "");
  }

  button.addEventListener("click", async () => {
    if (recorder) {
      // Ends with the picture as it is now, however long it has stood still.
      if (whole) stage.compose(whole);
      else await stage.snapshot().catch(() => {});
      recorder?.stop();
    } else {
      try {
        start();
      } catch (error) {
        whole = null;
        controller.report(error);
      }
    }
    showState();
  });

  return {
    /** What changes on the page may change the pictures. */
    update() {
      if (whole) draw();
    },
  };
}
