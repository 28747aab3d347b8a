// @ts-check
// What is opened: samples, figures, files, links and recipes.

import { LOST } from "../channel.js";
import { sha256 } from "../digest.js";
import { figures, samples } from "../generated/library.js";
import { sampleName } from "../library.js";
import { linkIn, pageScene, sceneOf } from "../link.js";
import { defaults } from "../options.js";
import { alone } from "../store.js";
import { say } from "../words.js";

/** @import { Loaded, RecipeCard, RepairOptions, ScriptText } from "../generated/types.js" */
/** @import { Figure, Sample } from "../library.js" */
/** @import { Scene } from "../link.js" */
/** @import { Options } from "../options.js" */
/** @import { Origin, Source } from "../store.js" */
/** @import { Core } from "./core.js" */

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
 * @property {Sample["fill"]} [fill]  of what is loaded, before it is shown
 */

/** A file that something begins with. @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Bytes */

/** Faces of a file from which it is taken for a scan. */
const SCANNED = 2000;

/** The name of a file's mesh. @param {string} file */
const stem = (file) => file.replace(/\.[^.]+$/, "");

/**
 * @param {Core} core
 * @param {ReturnType<typeof import("./run.js").createRun>} run
 * @param {ReturnType<typeof import("./compare.js").createCompare>} compare
 */
export function createOpen(core, run, compare) {
  const { get, patch, notes, solver, enqueue, rest, anew } = core;

  /** @param {Loading} loading */
  async function load(loading) {
    const { name, source, origin = source, ask, options, fallback, scene = {}, fill } = loading;
    await rest();
    const { mesh: before, phase } = get();
    patch({ phase: "loading", loadingName: name, mode: null, preview: null });
    try {
      const shape = await ask();
      const mesh = fill ? (await solver.fill(fill)).loaded : shape;
      notes.clear();
      patch({
        ...{ source, origin, mesh, reading: null, timeline: null, configured: null, earlier: [] },
        ...{
          figure: null,
          goal: null,
          isNew: false,
          camera: scene.camera ?? null,
          applies: "start",
        },
      });
      anew();
      for (const warning of mesh.info.warnings) notes.note(say(warning), warning.id);
      compare.prepare(scene.comparison ?? null);
      // A new solver knows of none.
      await run.arranged(scene.arrangement ?? {});
      if (scene.colour && scene.colour !== get().colour) patch({ colour: scene.colour });
      const suits = await core.configure(options).then(
        () => true,
        async (error) => {
          if (error?.kind === LOST) throw error;
          // A mesh without a flow would be a dead end: said, and another flow in its place.
          core.report(error);
          await core.configure(fallback);
          return false;
        },
      );
      patch({ phase: "ready" });
      if (get().colour !== "none") await core.colour(get().colour);
      if (!suits) return;
    } catch (error) {
      // The mesh of before stays.
      patch({ phase: before ? "ready" : phase === "loading" ? "empty" : phase, progress: null });
      throw error;
    }
    const figure = figures.find(({ id }) => id === scene.figure);
    if (figure && source.kind === "sample" && figure.sample === source.id) patch({ figure });
    if (scene.follows) await followed(scene.follows);
    else if (scene.step) {
      patch({ running: true, goal: scene.step });
      await solver.run(scene.step);
    }
    const steps = scene.comparison?.panes.map(({ step }) => step) ?? [];
    await compare.runTo(steps, scene.step ?? 0);
  }

  /** @param {ScriptText} script  whose flow is configured */
  async function followed(script) {
    await replayed(() => solver.follow(script));
    await core.refill();
  }

  /** What is being done again, and may be given up. */
  let isReplaying = false;
  /** @template T @param {() => Promise<T>} ask @returns {Promise<T>} */
  async function replayed(ask) {
    isReplaying = true;
    patch({ progress: { stage: "replay", fraction: 0 } });
    return ask().finally(() => {
      isReplaying = false;
      patch({ progress: null });
    });
  }

  /**
   * Makes the mesh that a recipe or a link begins with, and of it what its edits made.
   * @param {ScriptText} script
   * @param {{ origin: Origin, name: string, isPlain: boolean }} made
   * @param {Bytes | null} file  that it begins with
   * @param {Pick<Loading, "options" | "fallback" | "scene">} shown
   */
  function remade(script, { origin, name, isPlain }, file, shown) {
    const source = isPlain && origin.kind !== "shape" ? origin : { kind: "file", name };
    const ask = () => replayed(() => solver.prepare(script, file));
    return load({ name, source: /** @type {Source} */ (source), origin, ask, ...shown });
  }

  /** @param {string} id @param {Partial<Scene>} scene */
  function loadSample(id, scene) {
    const sample = samples.find((one) => one.id === id) ?? samples[0];
    const suggested = { ...defaults, ...sample.options };
    const options = { ...suggested, ...scene.options };
    const source = /** @type {const} */ ({ kind: "sample", id: sample.id });
    if (scene.prepares) {
      const made = { origin: source, name: sample.shape, isPlain: false };
      return remade(scene.prepares, made, null, { options, fallback: suggested, scene });
    }
    const ask = () => solver.sample(sample.shape, sample.parameters);
    const name = sampleName(sample.id);
    return load({ name, source, ask, options, fallback: suggested, scene, fill: sample.fill });
  }

  /**
   * @param {Bytes} file @param {Partial<Scene>} scene
   * @param {Partial<RepairOptions> | null} [repair]  how it is repaired, where it is
   */
  async function loadFile(file, scene, repair = null) {
    const { name: whole, bytes } = file;
    const name = stem(whole);
    // Of what an earlier mesh was shown with, the choice of flow is the user's; the rest
    // says nothing about this one.
    const { flow, boundary, p, keep, regularise } = get().options;
    const plain = { ...defaults, boundary };
    const options = { ...plain, flow, p, keep, regularise, ...scene.options };
    const own = { name, file: whole, sha256: await sha256(bytes), bytes: bytes.byteLength };
    const source = /** @type {const} */ ({ kind: "file", ...own });
    if (scene.prepares) {
      const made = { origin: source, name, isPlain: false };
      const given = { name: whole, bytes };
      return remade(scene.prepares, made, given, { options, fallback: plain, scene });
    }
    const ask = () => solver.load(whole, bytes, repair);
    try {
      await load({ name: whole, source, ask, options, fallback: plain, scene });
    } catch (error) {
      const { message, hint, repairs } = /** @type {import("../words.js").Fault} */ (error);
      if (!repairs?.length) throw error;
      // No surface: with one press it is opened as the one that a repair makes of it.
      const again = () => enqueue(() => loadFile(file, scene, {}));
      const what = repairs.map((item) => say(item.message));
      const offers = [{ label: say("repair-and-open"), act: again }];
      notes.error({ message, hint: [hint, say("repair-would"), ...what].join(" ") }, offers);
      return;
    }
    const { mesh } = get();
    if (repair && mesh) core.showRepairs(mesh);
    // What a finely meshed file is for decides what is to be done with it.
    const isPlainly = Object.keys(scene).length === 0;
    patch({ isNew: isPlainly && (mesh?.info.faces ?? 0) >= SCANNED });
  }

  /** A recipe that was read. @typedef {{ text: string, card: RecipeCard }} Recipe */
  /** What the next file is waited for: a recipe's mesh, or that of a link. @type {Recipe | null} */
  let awaited = null;
  /** @type {Scene | null} */
  let linked = null;

  /** @param {Recipe} recipe @param {Bytes | null} file */
  async function followRecipe({ text, card }, file) {
    const options = { ...defaults, ...card.flow };
    const { arrangement, mesh } = card;
    const origin = /** @type {Origin} */ (card.origin);
    const name = "shape" in mesh ? mesh.shape : stem(mesh.name);
    const scene = { arrangement, follows: { recipe: text } };
    const made = { origin, name, isPlain: card.plain };
    await remade({ recipe: text }, made, file, { options, fallback: options, scene });
    const { reading } = get();
    if (!reading) return;
    const values = { expected: card.energy, got: reading.energy };
    notes.answer(
      say("recipe-compared", { same: String(reading.energy === card.energy), ...values }),
    );
  }

  /** @param {Uint8Array<ArrayBuffer>} bytes */
  async function readRecipe(bytes) {
    const text = new TextDecoder().decode(bytes);
    const recipe = { text, card: await solver.readRecipe(text) };
    const { estimate, mesh } = recipe.card;
    const { steps } = estimate;
    if (estimate.isLong && !(await notes.ask(say("recipe-is-long", { steps })))) return;
    if (!("sha256" in mesh)) return followRecipe(recipe, null);
    const { origin, source } = get();
    const isOpen = origin === source && source?.kind === "file";
    const known = isOpen && source.sha256 === mesh.sha256 ? solver.file() : null;
    if (known) return followRecipe(recipe, { name: mesh.name, bytes: known });
    awaited = recipe;
    notes.answer(say("recipe-wants-mesh", { name: mesh.name }));
  }

  /**
   * Whether a file is the one a link was made with.
   * @param {Scene} scene @param {Uint8Array<ArrayBuffer>} bytes
   * @returns {Promise<boolean | null>} null where the link does not say
   */
  async function isLinked({ mesh, hash }, bytes) {
    if (mesh === null || hash === null) return null;
    const digest = await sha256(bytes);
    return digest === "" ? null : digest.startsWith(hash);
  }

  /** Files that were chosen: a link that is still being read does not take their place. */
  let chosen = 0;

  /** Settled once nothing runs or loads. */
  const still = async () => {
    for (;;) {
      await enqueue(async () => {});
      const { running, phase } = get();
      if (!running && phase !== "loading") return;
      await new Promise((resolve) => {
        const end = core.store.state.subscribe((s) => {
          if (!s.running && s.phase !== "loading")
            queueMicrotask(() => {
              end();
              resolve(null);
            });
        });
      });
    }
  };

  /** Says whether what came of a link is what was sent. @param {Scene} scene @param {boolean | null} isFile */
  async function check(scene, isFile = true) {
    const asked = get().mesh;
    await still();
    const { origin, mesh, reading, version } = get();
    const isScene = origin?.kind === "sample" ? origin.id === scene.sample : scene.mesh !== null;
    // Refused, or overtaken by another mesh.
    if (!isScene || mesh !== asked || scene.check === null || !reading) return;
    const found = await solver.checkLink(scene.check, scene.step).catch(() => null);
    if (!found || get().mesh !== asked) return;
    const why =
      isFile === false
        ? "file"
        : scene.version !== null && scene.version !== version
          ? "version"
          : isFile === null
            ? "unknown"
            : "same";
    const values = { ...found, wanted: scene.step, theirs: scene.version ?? "", ours: version };
    const message = say("link-checked", values);
    const hint = found.outcome === "same" ? "" : say("link-differs", { why, ...values });
    if (found.outcome === "same" || found.outcome === "near")
      notes.answer(`${message} ${hint}`.trim());
    else notes.error({ message, hint });
  }

  /**
   * A mesh, perhaps the one that a recipe or a link waits for.
   * @param {Bytes} file @param {Partial<Scene>} [given]
   */
  async function loadAwaited(file, given) {
    if (given) return loadFile(file, given);
    const [recipe, scene] = [awaited, linked];
    [awaited, linked] = [null, null];
    if (recipe && "sha256" in recipe.card.mesh) {
      const { name, sha256: digest } = recipe.card.mesh;
      if ((await sha256(file.bytes)) === digest) {
        return followRecipe(recipe, { name, bytes: file.bytes });
      }
      await loadFile(file, {});
      notes.answer(say("recipe-other-mesh", { name }));
    } else if (scene) {
      const isFile = await isLinked(scene, file.bytes);
      const { prepares: _, follows: __, ...bare } = scene;
      const isNamed = stem(file.name) === scene.mesh;
      // What was done to another mesh means nothing on this one.
      await loadFile(file, isFile || isNamed ? (isFile === false ? bare : scene) : {});
      if (isFile === false)
        notes.note(say("link-other-file", { name: file.name, mesh: scene.mesh }));
      if (isFile || isNamed) check(scene, isFile);
    } else await loadFile(file, {});
  }

  const open = {
    load,
    loadSample,
    still,
    /** @param {string} id @param {Partial<Scene>} [scene] */
    sample: (id, scene = {}) => enqueue(() => loadSample(id, { comparison: null, ...scene })),
    /** A figure of a paper: its sample, flow and parameters. @param {Figure} figure */
    figure: (figure) =>
      enqueue(() => {
        const { options, arrangement, colour } = figure;
        const scene = { options, arrangement, colour, comparison: null, figure: figure.id };
        return loadSample(figure.sample, scene);
      }),
    /**
     * A mesh, a recipe, or the mesh that a recipe or a link waits for; of several files the recipe
     * first, then the mesh among them.
     * @param {File[]} files @param {Partial<Scene>} [given]
     */
    open(files, given) {
      chosen += 1;
      return enqueue(async () => {
        const bytesOf = async (/** @type {File} */ one) => new Uint8Array(await one.arrayBuffer());
        patch({ dialog: null, welcome: false });
        const recipeFile = given ? undefined : files.find(({ name }) => /\.json$/i.test(name));
        if (recipeFile) await readRecipe(await bytesOf(recipeFile));
        const rest = files.filter((one) => one !== recipeFile);
        if (rest.length === 0) return;
        const { meshAmong } = await import("../unpack.js");
        const read = rest.map(async (one) => ({ name: one.name, bytes: await bytesOf(one) }));
        const { name, bytes, others } = await meshAmong(await Promise.all(read));
        await loadAwaited({ name, bytes }, given);
        if (others.length > 0) notes.note(say("unpack-others", { name, others }), "unpack-others");
      });
    },

    /**
     * The scene of an address; where a word in it cannot be, there is none.
     * @param {import("../link.js").Address} address
     * @returns {Promise<Scene | null>} null where its length was not wanted
     */
    async readLink(address) {
      const scene = sceneOf(await solver.readLink(linkIn(address)));
      const steps = scene.manySteps;
      return steps === 0 || (await notes.ask(say("link-is-long", { steps }))) ? scene : null;
    },
    /** @param {import("../link.js").Address} address @param {Scene} plain  what is shown without one */
    async openLink(address, plain) {
      /** @type {unknown} */
      let refusal = null;
      const before = chosen;
      const read = await open.readLink(address).catch((error) => {
        refusal = error;
        return null;
      });
      if (chosen !== before) return;
      // Where nothing is shown yet, that would be a dead end.
      const scene = read ?? (get().mesh ? null : plain);
      if (scene) {
        run.view(scene.view);
        if (scene.sample) await open.sample(scene.sample, scene);
        else {
          linked = scene;
          const hint = say("link-wants-file.hint");
          notes.error({ message: say("link-wants-file", { mesh: scene.mesh }), hint });
        }
      }
      // Said now: a mesh that is loaded clears what was said before.
      if (refusal) core.report(refusal);
      if (scene?.sample) await check(scene);
    },
    /** @param {boolean} [shared]  sent to somebody, so that there is always an energy to compare */
    writeLink: (shared = false) => solver.writeLink(pageScene(get(), shared)),
    /** How the present surface came about, as a file. @returns {Promise<string>} */
    recipe() {
      const { origin, figure, reading } = get();
      const sample = samples.find(({ id }) => id === figure?.sample);
      // The half of a film that is shown backwards begins with a surface of its own.
      const isBack = sample && figure?.back && (reading?.step ?? 0) < 0;
      const parameters = { ...sample?.parameters, ...figure?.back };
      const own = isBack ? { kind: "shape", shape: sample.shape, parameters } : origin;
      return solver.writeRecipe(/** @type {any} */ (own));
    },
    /** Gives up what is being done again. @returns {Promise<boolean>} whether there was something */
    async giveUp() {
      if (!isReplaying) return false;
      await solver.cancel().catch(core.report);
      return true;
    },
    /** Nothing is compared any more. */
    plain: () => patch({ comparison: alone }),
  };
  return open;
}
