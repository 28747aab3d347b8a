// @ts-check
// What follows the opening of a link: waiting until its scene is there, and telling whether it
// is the scene that was sent.

/** @import { Scene } from "./link.js" */
/** @import { PageState } from "./state.js" */
/** @import { Controller, Voice } from "./controller.js" */

import { sha256 } from "./digest.js";
import { figures } from "./generated/library.js";
import { t } from "./language.js";
import { verdict } from "./link-check.js";
import { symbol } from "./ui/status.js";

/**
 * The scene of a link that names a figure and no sample: what the link leaves out is the
 * figure's.
 * @param {Scene} scene
 * @returns {Scene & { sample: string }}
 */
export function sceneOfFigure(scene) {
  const figure = figures.find(({ id }) => id === scene.figure);
  if (!figure) {
    throw {
      kind: "UnknownFigure",
      message: t("There is no figure “{id}”.", { id: scene.figure ?? "" }),
      hint: t("The button Figures shows those there are."),
    };
  }
  return {
    ...scene,
    sample: figure.sample,
    options: /** @type {Scene["options"]} */ ({ ...figure.options, ...scene.options }),
    arrangement: { ...figure.arrangement, ...scene.arrangement },
    colour: scene.colour === "none" ? figure.colour : scene.colour,
  };
}

/** @param {Pick<Controller, "open">} controller @param {() => Readonly<PageState>} get @param {Pick<Voice, "error" | "answer" | "note">} voice */
export function createArrival(controller, get, voice) {
  /** @type {((state: Readonly<PageState>) => void)[]} */
  let waiting = [];
  /** @param {Readonly<PageState>} state */
  const isStill = ({ phase }) => phase !== "running" && phase !== "loading";

  /** The state once nothing runs or loads. @returns {Promise<Readonly<PageState>>} */
  const still = () =>
    isStill(get()) ? Promise.resolve(get()) : new Promise((resolve) => waiting.push(resolve));

  /**
   * Whether a file is the one a link was made with.
   * @param {Scene} scene
   * @param {File} file
   * @returns {Promise<boolean | null>} null where the link does not say
   */
  async function recognise({ mesh, hash }, file) {
    if (mesh === null || hash === null) return null;
    const digest = await sha256(await file.arrayBuffer());
    return digest === "" ? null : digest.startsWith(hash);
  }

  /**
   * After a scene was asked for: compares what came of it with what the link says.
   * @param {Scene} scene
   * @param {boolean | null} isFile  whether the mesh is that of the link
   */
  async function check(scene, isFile = true) {
    const asked = get().mesh;
    const state = await still();
    const { origin, mesh } = state;
    const isSample = origin !== null && "kind" in origin && origin.kind === "sample";
    const isScene = isSample ? origin.id === scene.sample : scene.mesh !== null;
    // Refused, or overtaken by another mesh.
    if (!isScene || mesh !== asked) return;
    const said = verdict(scene, state, symbol(state), isFile);
    if (!said) return;
    if (!said.isGood) voice.error(said);
    else voice.answer(said.hint ? `${said.message} ${said.hint}` : said.message);
  }

  return {
    still,
    check,

    /**
     * Opens a file for a link that waits for one: with the scene of the link, if it is that
     * file or is called like it; told in words where it is another.
     * @param {Scene} scene
     * @param {File} file
     */
    async open(scene, file) {
      const isFile = await recognise(scene, file);
      const isNamed = scene.mesh !== null && file.name.replace(/\.[^.]+$/, "") === scene.mesh;
      // What was done to another mesh means nothing on this one.
      const own = isFile === false ? { ...scene, edits: null, path: null } : scene;
      await controller.open(file, isFile || isNamed ? own : {});
      // Said now: what was said before a mesh was loaded is cleared with the mesh before.
      if (isFile === false) {
        voice.note(
          t(
            "“{name}” is not the file of the link, which shows “{mesh}”; it is opened all the same.",
            { name: file.name, mesh: scene.mesh ?? "" },
          ),
        );
      }
      if (isFile || isNamed) await check(scene, isFile);
    },

    /** @param {Readonly<PageState>} state */
    update(state) {
      if (waiting.length === 0 || !isStill(state)) return;
      const told = waiting;
      waiting = [];
      for (const resolve of told) resolve(state);
    },
  };
}
