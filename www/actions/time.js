// @ts-check
// Looking around in a run: stored steps, branches, playing them, recipes.

/** @import { Core } from "./core.js" */
/** @import { Recipe } from "../recipe.js" */
/** @import { Scene } from "../link.js" */
/** @import { Options } from "../options.js" */
/** @import { Loaded } from "../generated/types.js" */
/** @import { PageState, Source } from "../state.js" */

import { sha256 } from "../digest.js";
import { samples } from "../generated/library.js";
import { t } from "../language.js";
import { defaults, plainArrangement } from "../options.js";
import { askedBy, isOwn, makeRecipe, pathOf, readRecipe } from "../recipe.js";
import { transitions as to } from "../state.js";

/**
 * How a mesh is loaded.
 * @typedef {object} Loading
 * @property {string} name  for the status line
 * @property {Source} source
 * @property {NonNullable<PageState["origin"]>} [origin]  where that is not the source
 * @property {() => Promise<Loaded>} ask
 * @property {Options} options
 * @property {Options} fallback  for a mesh that the options do not suit
 * @property {Partial<Scene>} [scene]
 * @property {import("../library.js").Sample["fill"]} [fill]  of what is loaded, before it is shown
 */

/** @param {unknown} value */
const asKey = (value) => JSON.stringify(value);

/** The page's sample that a recipe begins with. @param {Recipe["mesh"]} mesh */
const sampleOf = (mesh) =>
  isOwn(mesh)
    ? undefined
    : samples.find(
        ({ id, shape, parameters }) =>
          id === mesh.sample &&
          shape === mesh.shape &&
          asKey(parameters) === asKey(mesh.parameters),
      );

/** @param {Core & { load: (loading: Loading) => Promise<void> }} core */
export function createTime({ store, solver, voice, enqueue, rest, load }) {
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
   * @param {Pick<Recipe, "mesh" | "edits">} told
   * @param {Uint8Array<ArrayBuffer> | null} bytes  of the mesh
   * @param {Pick<Loading, "options" | "fallback" | "scene">} shown
   */
  function replay({ mesh, edits = [] }, bytes, shown) {
    const sample = sampleOf(mesh);
    const name = isOwn(mesh) ? mesh.name.replace(/\.[^.]+$/, "") : mesh.shape;
    /** @type {NonNullable<PageState["origin"]>} */
    const origin = isOwn(mesh)
      ? { kind: "file", ...mesh, name, file: mesh.name }
      : sample
        ? { kind: "sample", id: sample.id }
        : mesh;
    // The page shows some samples filled.
    const isWhole = edits.length === 0 && "kind" in origin && !sample?.fill;
    /** @type {Source} */
    const source = isWhole ? origin : { kind: "file", name };
    const ask = () => solver.prepare({ mesh, edits }, bytes);
    return load({ name, source, origin, ask, ...shown });
  }

  /**
   * @param {Recipe} recipe
   * @param {Uint8Array<ArrayBuffer> | null} bytes  of its mesh
   */
  async function followRecipe(recipe, bytes) {
    const options = { ...defaults, ...recipe.flow };
    const arrangement = { ...plainArrangement, ...recipe.arrangement };
    const scene = { arrangement, path: pathOf(recipe) };
    await replay(recipe, bytes, { options, fallback: options, scene });
    const { reading } = store.get();
    if (!reading) return;
    const same = reading?.energy === recipe.result.energy;
    voice.answer(
      same
        ? t("The recipe gives the energy that it promised, to the last bit.")
        : t("The recipe promised the energy {expected}; here it is {got}.", {
            expected: recipe.result.energy,
            got: reading?.energy ?? "–",
          }),
    );
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
    async recipe() {
      const { origin, version, options, arrangement } = store.get();
      const mesh = origin && "kind" in origin ? meshOf(origin) : origin;
      if (!mesh) {
        throw {
          kind: "NoRecipe",
          message: t(
            "A recipe of this surface cannot be made: where its mesh came from is not known any more.",
          ),
          hint: t(
            "Open the mesh or choose the sample again; what is done from then on can be told.",
          ),
        };
      }
      const { story, state, positions } = await solver.story();
      /** @type {Record<string, unknown>} */
      const arranged = {};
      for (const [key, value] of Object.entries(arrangement)) {
        const usual = /** @type {Record<string, unknown>} */ (plainArrangement)[key];
        const matters = options.flow === "flips" || (key === "compare" && value === "flows");
        if (matters && value !== usual) arranged[key] = value;
      }
      const recipe = makeRecipe({
        ...{ version, mesh, story, state, arrangement: arranged },
        positions: await sha256(positions),
      });
      return `${JSON.stringify(recipe, null, 1)}\n`;
    },

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
          const recipe = readRecipe(new TextDecoder().decode(bytes));
          await solver.readOptions(askedBy(recipe));
          if (!isOwn(recipe.mesh)) return followRecipe(recipe, null);
          const { origin, source } = store.get();
          const isOpen = origin === source && source?.kind === "file";
          const known = isOpen && source.sha256 === recipe.mesh.sha256 ? solver.file() : null;
          if (known) return followRecipe(recipe, known);
          awaited = recipe;
          voice.answer(
            t("This recipe is for the mesh “{name}”. Open that file now; the recipe follows.", {
              name: recipe.mesh.name,
            }),
          );
        });
        return true;
      }
      const recipe = awaited;
      awaited = null;
      if (!recipe || !isOwn(recipe.mesh)) return false;
      if ((await sha256(bytes)) !== recipe.mesh.sha256) {
        await open();
        voice.answer(
          t("This is not the mesh “{name}” of the recipe: its contents differ.", {
            name: recipe.mesh.name,
          }),
        );
        return true;
      }
      await enqueue(() => followRecipe(recipe, bytes));
      return true;
    },
  };
  return { stop, replay, actions };
}

/** What was loaded, as a recipe tells it. @param {Source} source @returns {Recipe["mesh"] | null} */
export function meshOf(source) {
  if (source.kind === "sample") {
    const sample = samples.find(({ id }) => id === source.id);
    if (!sample) return null;
    return { sample: sample.id, shape: sample.shape, parameters: sample.parameters };
  }
  const { file, sha256: hash, bytes } = source;
  return file && hash && bytes !== undefined ? { name: file, sha256: hash, bytes } : null;
}
