// @ts-check
// Looking around in a run: stored steps, branches, playing them, recipes.

/** @import { Core } from "./core.js" */
/** @import { RecipeCard, ScriptText } from "../generated/types.js" */
/** @import { Scene } from "../link.js" */
/** @import { Options } from "../options.js" */
/** @import { Loaded } from "../generated/types.js" */
/** @import { Origin, Source } from "../state.js" */

import { sha256 } from "../digest.js";
import { t } from "../language.js";
import { defaults } from "../options.js";
import { transitions as to } from "../state.js";

/**
 * How a mesh is loaded.
 * @typedef {object} Loading
 * @property {string} name  for the status line
 * @property {Source} source
 * @property {Origin} [origin]  where that is not the source
 * @property {() => Promise<Loaded>} ask
 * @property {Options} options
 * @property {Options} fallback  for a mesh that the options do not suit
 * @property {Partial<Scene>} [scene]
 * @property {import("../library.js").Sample["fill"]} [fill]  of what is loaded, before it is shown
 */

/**
 * What a recipe or a link begins with, and what it is called.
 * @typedef {object} Made
 * @property {Origin} origin
 * @property {string} name
 * @property {boolean} isPlain  whether that is what is shown at first
 */

/** A recipe that was read. @typedef {{ text: string, card: RecipeCard }} Recipe */

/**
 * @param {Core & { load: (loading: Loading) => Promise<void>,
 *   replayed: <T>(ask: () => Promise<T>) => Promise<T> }} core
 */
export function createTime({ store, solver, voice, enqueue, rest, load, replayed }) {
  /** @type {number | null} the latest step asked for, not sought yet */
  let wanted = null;
  let isSeeking = false;

  /** At most one seek is under way; of those asked for meanwhile the latest is next. @param {number} step */
  async function go(step) {
    wanted = step;
    if (isSeeking) return;
    isSeeking = true;
    while (wanted !== null) {
      let next = wanted;
      wanted = null;
      await enqueue(async () => {
        await rest();
        if (!store.get().reading) return;
        // What was asked for while this one waited.
        next = wanted ?? next;
        wanted = null;
        await solver.seek(next);
      });
    }
    isSeeking = false;
  }

  /** Which playing this is; an older one stops. */
  let playing = 0;

  function stop() {
    playing += 1;
    if (store.get().playing !== 0) store.update(to.playing, 0);
  }

  /**
   * Plays the stored steps, as many a second as asked for.
   * @param {-1 | 1} direction
   * @param {() => number} rate  steps a second
   */
  async function playHistory(direction, rate) {
    stop();
    const mine = playing;
    store.update(to.playing, direction);
    let due = performance.now();
    while (mine === playing) {
      const { timeline, phase, mesh } = store.get();
      const next = direction > 0 ? timeline?.next : timeline?.previous;
      if (next === null || next === undefined || phase === "loading") break;
      await go(next);
      const now = store.get();
      // Something else has moved the surface, or nothing can.
      if (mine !== playing || now.mesh !== mesh || now.timeline === timeline) break;
      due = Math.max(due + 1000 / rate(), performance.now());
      await new Promise((resolve) => setTimeout(resolve, due - performance.now()));
    }
    if (mine === playing) stop();
  }

  /** @type {Recipe | null} one that waits for its mesh */
  let awaited = null;

  /**
   * Loads the mesh that a recipe or a link begins with, and makes of it what its edits made.
   * @param {ScriptText} script
   * @param {Made} made
   * @param {{ name: string, bytes: Uint8Array<ArrayBuffer> } | null} file  that it begins with
   * @param {Pick<Loading, "options" | "fallback" | "scene">} shown
   */
  function replay(script, { origin, name, isPlain }, file, shown) {
    const source = isPlain && origin.kind !== "shape" ? origin : { kind: "file", name };
    const ask = () => replayed(() => solver.prepare(script, file));
    return load({ name, source: /** @type {Source} */ (source), origin, ask, ...shown });
  }

  /**
   * @param {Recipe} recipe
   * @param {{ name: string, bytes: Uint8Array<ArrayBuffer> } | null} file  of its mesh
   */
  async function followRecipe({ text, card }, file) {
    const options = { ...defaults, ...card.flow };
    const { arrangement, mesh } = card;
    const origin = /** @type {Origin} */ (card.origin);
    const name = "shape" in mesh ? mesh.shape : mesh.name.replace(/\.[^.]+$/, "");
    const scene = { arrangement, follows: { recipe: text } };
    const made = { origin, name, isPlain: card.plain };
    await replay({ recipe: text }, made, file, { options, fallback: options, scene });
    const { reading } = store.get();
    if (!reading) return;
    voice.answer(
      reading.energy === card.energy
        ? t("The recipe gives the energy that it promised, to the last bit.")
        : t("The recipe promised the energy {expected}; here it is {got}.", {
            expected: card.energy,
            got: reading.energy ?? "–",
          }),
    );
  }

  /** Whether to go on, where it takes long. @param {Recipe} recipe */
  async function mayRun({ card: { estimate } }) {
    if (!estimate.isLong) return true;
    const steps = estimate.steps.toLocaleString("en");
    return voice.ask(t("This recipe runs about {steps} steps.", { steps }));
  }

  const actions = {
    /** Shows a stored step; a run is paused for it. @param {number} step */
    seek(step) {
      stop();
      return go(step);
    },
    /** @param {number} id */
    branch(id) {
      stop();
      return enqueue(async () => {
        await rest();
        if (store.get().reading) await solver.branch(id);
      });
    },
    playHistory,
    stopHistory: stop,

    /** @param {string} format @param {number} every */
    sequenceSize: (format, every) => solver.sequenceSize(format, every),
    /**
     * The stored steps as a ZIP of meshes; null where it came to nothing, which has been said.
     * @param {string} format @param {number} every
     * @returns {Promise<Uint8Array<ArrayBuffer> | null>}
     */
    async sequence(format, every) {
      stop();
      /** @type {Uint8Array<ArrayBuffer> | null} */
      let zip = null;
      await enqueue(async () => {
        await rest();
        store.update(to.progress, { stage: "sequence", fraction: 0 });
        zip = await solver.sequence(format, every).finally(() => store.update(to.progress, null));
      });
      return zip;
    },

    /** How the present surface came about, as a file. @returns {Promise<string>} */
    recipe: () => solver.writeRecipe(/** @type {any} */ (store.get().origin)),

    /**
     * Whether a file is a recipe, or the mesh that one waits for; then it is followed.
     * @param {File} file
     * @param {() => Promise<void>} open  opens it as a mesh like any other
     * @returns {Promise<boolean>}
     */
    async takes(file, open) {
      const isRecipe = /\.json$/i.test(file.name);
      if (!isRecipe && !awaited) return false;
      const bytes = new Uint8Array(await file.arrayBuffer());
      if (isRecipe) {
        await enqueue(async () => {
          const text = new TextDecoder().decode(bytes);
          const recipe = { text, card: await solver.readRecipe(text) };
          if (!(await mayRun(recipe))) return;
          const { mesh } = recipe.card;
          if (!("sha256" in mesh)) return followRecipe(recipe, null);
          const { name } = mesh;
          const { origin, source } = store.get();
          const isOpen = origin === source && source?.kind === "file";
          const known = isOpen && source.sha256 === mesh.sha256 ? solver.file() : null;
          if (known) return followRecipe(recipe, { name, bytes: known });
          awaited = recipe;
          voice.answer(
            t("This recipe is for the mesh “{name}”. Open that file now; the recipe follows.", {
              name,
            }),
          );
        });
        return true;
      }
      const recipe = awaited;
      awaited = null;
      if (!recipe || !("sha256" in recipe.card.mesh)) return false;
      const { name, sha256: digest } = recipe.card.mesh;
      if ((await sha256(bytes)) !== digest) {
        await open();
        voice.answer(
          t("This is not the mesh “{name}” of the recipe: its contents differ.", { name }),
        );
        return true;
      }
      await enqueue(() => followRecipe(recipe, { name, bytes }));
      return true;
    },
  };
  return { stop, replay, actions };
}
