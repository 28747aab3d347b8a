// @ts-check
// What follows the opening of a link: waiting until its scene is there, and telling whether it
// is the scene that was sent.

/** @import { Scene } from "./link.js" */
/** @import { PageState } from "./state.js" */
/** @import { Controller, Voice } from "./controller.js" */

import { sha256 } from "./digest.js";
import { t } from "./language.js";
import { formatNumber } from "./ui/number.js";
import { symbol } from "./ui/status.js";

/**
 * Why a scene may have come out otherwise.
 * @param {string | null} theirs  version of the solver @param {string} ours
 * @param {boolean | null} isFile  whether the mesh is the file of the link; null: not known
 */
function reason(theirs, ours, isFile) {
  if (isFile === false) return t("The mesh is not the file of the link.");
  if (theirs !== null && theirs !== ours) {
    return t("The link was made by version {theirs} of the solver; this is version {ours}.", {
      theirs,
      ours,
    });
  }
  if (isFile === null) return t("Perhaps the file is not the one the link was made with.");
  return t("The same version should give the same numbers; please report this, with the link.");
}

/**
 * What is to be said of a scene that was restored.
 * @param {Scene} scene
 * @param {import("./generated/types.js").LinkCheck} check
 * @param {Readonly<PageState>} state
 * @param {boolean | null} isFile
 * @returns {{ isGood: boolean, message: string, hint: string }}
 */
export function checked({ step, version }, { outcome, sent, ...here }, state, isFile) {
  const hint = reason(version, state.version, isFile);
  const values = {
    symbol: symbol(state),
    here: formatNumber(here.energy, 6),
    sent: formatNumber(sent, 6),
    apart: formatNumber(Math.abs(here.energy - sent), 2),
    step,
  };
  switch (outcome) {
    case "same":
      return {
        isGood: true,
        message: t("The scene is as it was sent: {symbol} = {here}.", values),
        hint: "",
      };
    case "near":
      return {
        isGood: true,
        message: t(
          "The scene is as it was sent to six digits: {symbol} = {here}, {apart} from the {sent} of the link.",
          values,
        ),
        hint,
      };
    case "endsEarly":
      return {
        isGood: false,
        message: t("The link shows step {step}; here the flow ends at step {here}.", {
          step,
          here: here.step,
        }),
        hint,
      };
    default:
      return {
        isGood: false,
        message: t(
          "The scene is not as it was sent: {symbol} = {here} at step {step}, where the link says {sent}; that is {apart} off.",
          values,
        ),
        hint,
      };
  }
}

/** @param {Pick<Controller, "open" | "checkLink">} controller @param {() => Readonly<PageState>} get @param {Pick<Voice, "error" | "answer" | "note">} voice */
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
    if (!isScene || mesh !== asked || scene.check === null) return;
    const found = await controller.checkLink(scene.check, scene.step).catch(() => null);
    if (!found || get().mesh !== asked) return;
    const said = checked(scene, found, state, isFile);
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
      const { prepares: _, follows: __, ...bare } = scene;
      const own = isFile === false ? bare : scene;
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
