// What is opened: samples, figures, files, links and recipes.

import { LOST } from "../channel.js";
import { sha256 } from "../digest.js";
import { sampleName } from "../library.js";
import { linkIn, pageScene, plainScene, sceneOf } from "../link.js";
import { defaults } from "../options.js";
import { alone, earlierOf } from "../store.js";
import { say } from "../words.js";

/** @import { Loaded, RecipeCard, RepairOptions, ScriptText } from "../generated/types.js" */
/** @import { Figure, Sample } from "../library.js" */
/** @import { Address, Scene } from "../link.js" */
/** @import { Options } from "../options.js" */
/** @import { Origin, Source } from "../store.js" */
/** @import { Fault } from "../words.js" */
/** @import { Core } from "./core.js" */

/**
 * How a mesh is loaded: under a name, with options or, where they do not suit it, others; what is to
 * be filled is so before it is shown; what undoing goes back from, where it can.
 * @typedef {{ name: string, source: Source, origin: Origin, ask: () => Promise<Loaded>, options: Options,
 *   fallback: Options, scene: Partial<Scene>, fill?: Sample["fill"], undoes?: string }} Loading
 */

/** A file that something begins with. @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Bytes */
/** A recipe that was read. @typedef {{ text: string, card: RecipeCard }} Recipe */

/** Samples and figures: they can be opened once there is a solver, which is fetched meanwhile. */
const library = () => import("../generated/library.js");

/** Faces of a file from which it is taken for a scan. */
const SCANNED = 2000;

/** The name of a file's mesh. @param {string} file */
const stem = (file) => file.replace(/\.[^.]+$/, "");

/** No sample, and no file that could be named by its content. @param {string} name @returns {Source} */
const edited = (name) => ({ kind: "file", name });

/** @param {Core} core @param {ReturnType<typeof import("./run.js").createRun>} run @param {import("../actions.js").Compare} compare */
export function createOpen(core, run, compare) {
  const { get, patch, notes, solver, enqueue, rest, anew } = core;

  /** @param {Loading} loading */
  async function load({ name, source, origin, ask, options, fallback, scene, fill, undoes }) {
    await rest();
    const { mesh: before, phase } = get();
    const earlier = undoes ? earlierOf(get(), undoes) : [];
    patch({ phase: "loading", loadingName: name, mode: null, preview: null });
    try {
      const shape = await ask();
      const mesh = fill ? (await solver.edit("fill", { options: fill })).loaded : shape;
      const camera = scene.camera ?? null;
      notes.clear();
      patch({ source, origin, mesh, reading: null, timeline: null, configured: null, earlier });
      patch({ figure: null, goal: null, isNew: false, camera, applies: "start" });
      anew();
      for (const warning of mesh.info.warnings) notes.note(say(warning), warning.id);
      if (scene.comparison || get().comparison !== alone)
        await compare.prepare(scene.comparison ?? null);
      // A new solver knows of none.
      await run.arranged(scene.arrangement ?? {});
      if (scene.colour && scene.colour !== get().colour) patch({ colour: scene.colour });
      let suits = true;
      await core.configure(options).catch((error) => {
        if (error?.kind === LOST) throw error;
        // A mesh without a flow would be a dead end: said, and another flow in its place.
        core.report(error);
        suits = false;
        return core.configure(fallback);
      });
      patch({ phase: "ready" });
      if (get().colour !== "none") await core.colour(get().colour);
      if (!suits) return;
    } catch (error) {
      // The mesh of before stays.
      patch({ phase: before ? "ready" : phase === "loading" ? "empty" : phase, progress: null });
      throw error;
    }
    const figure = (await library()).figures.find(({ id }) => id === scene.figure);
    if (figure && source.kind === "sample" && figure.sample === source.id) patch({ figure });
    const { follows, step = 0 } = scene;
    if (follows) {
      await replayed(() => solver.follow(follows));
      await core.refill();
    } else if (step) {
      if (step < 0 && figure) {
        patch({ film: "back" });
        await solver.turn(figure.id, true);
      }
      patch({ running: true, goal: step });
      await solver.run(step);
    }
    if (scene.comparison) {
      const steps = scene.comparison.panes.map((pane) => pane.step);
      await compare.runTo(steps, step);
    }
  }

  /** What is being done again, and may be given up. */
  let isReplaying = false;
  /** @template T @param {() => Promise<T>} ask */
  function replayed(ask) {
    isReplaying = true;
    return core.during("replay", ask).finally(() => {
      isReplaying = false;
    });
  }
  /** The mesh that a recipe or a link begins with, and of it what its edits made. @param {ScriptText} script @param {Bytes | null} file */
  const prepared = (script, file) => () => replayed(() => solver.prepare(script, file));

  /** @param {string} id @param {Partial<Scene>} scene */
  async function loadSample(id, scene) {
    const { samples } = await library();
    const sample = samples.find((one) => one.id === id) ?? samples[0];
    const { shape, parameters, fill } = sample;
    const fallback = { ...defaults, ...sample.options };
    const options = { ...fallback, ...scene.options };
    const origin = /** @type {const} */ ({ kind: "sample", id: sample.id });
    const ask = () => solver.sample(shape, parameters);
    const made = scene.prepares
      ? { name: shape, source: edited(shape), ask: prepared(scene.prepares, null) }
      : { name: sampleName(sample.id), source: origin, ask, fill };
    await load({ ...made, origin, options, fallback, scene });
  }

  /**
   * @param {Bytes} file @param {Partial<Scene>} scene
   * @param {Partial<RepairOptions> | null} [repair]  how it is repaired, where it is
   * @returns {Promise<void>}
   */
  async function loadFile(file, scene, repair = null) {
    const { name: whole, bytes } = file;
    const name = stem(whole);
    // Of what an earlier mesh was shown with, the choice of flow is the user's; the rest
    // says nothing about this one.
    const { flow, boundary, p, keep, regularise } = get().options;
    const fallback = { ...defaults, boundary };
    const options = { ...fallback, flow, p, keep, regularise, ...scene.options };
    const own = { name, file: whole, sha256: await sha256(bytes), bytes: bytes.byteLength };
    const origin = /** @type {const} */ ({ kind: "file", ...own });
    const made = scene.prepares
      ? { name, source: edited(name), ask: prepared(scene.prepares, file) }
      : { name: whole, source: origin, ask: () => solver.load(whole, bytes, repair) };
    const undoes = repair ? say("edit-repair") : undefined;
    try {
      await load({ ...made, origin, options, fallback, scene, undoes });
    } catch (error) {
      const { message, hint, repairs } = /** @type {Fault} */ (error);
      if (!repairs?.length || scene.prepares) throw error;
      // No surface: with one press it is opened as the one that a repair makes of it.
      const act = () => enqueue(() => loadFile(file, scene, {}));
      const what = repairs.map((item) => say(item.message));
      const offers = [{ label: say("repair-and-open"), act }];
      return notes.error({ message, hint: [hint, say("repair-would"), ...what].join(" ") }, offers);
    }
    const { mesh } = get();
    if (repair && mesh) core.showRepairs(mesh);
    // What a finely meshed file is for decides what is to be done with it.
    const isPlainly = Object.keys(scene).length === 0;
    patch({ isNew: isPlainly && (mesh?.info.faces ?? 0) >= SCANNED });
  }

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
    const source = card.plain && origin.kind !== "shape" ? origin : edited(name);
    const ask = prepared({ recipe: text }, file);
    await load({ name, source, origin, ask, options, fallback: options, scene });
    const { reading } = get();
    if (!reading) return;
    const [expected, got] = [card.energy, reading.energy];
    notes.answer(say("recipe-compared", { same: String(got === expected), expected, got }));
  }

  /** @param {Uint8Array<ArrayBuffer>} bytes */
  async function readRecipe(bytes) {
    const text = new TextDecoder().decode(bytes);
    const recipe = { text, card: await solver.ask("readRecipe", { text }) };
    const { estimate, mesh } = recipe.card;
    const { steps } = estimate;
    if (estimate.isLong && !(await notes.ask(say("recipe-is-long", { steps })))) return;
    if (!("sha256" in mesh)) return followRecipe(recipe, null);
    const { origin, source } = get();
    const isOpen = origin === source && source?.kind === "file" && source.sha256 === mesh.sha256;
    const known = isOpen ? solver.file() : null;
    if (known) return followRecipe(recipe, { name: mesh.name, bytes: known });
    awaited = recipe;
    notes.answer(say("recipe-wants-mesh", { name: mesh.name }));
  }

  /** Files that were chosen: a link that is still being read does not take their place. */
  let chosen = 0;

  /** Settled once nothing runs or loads. */
  async function still() {
    const isBusy = () => get().running || get().phase === "loading";
    await enqueue(() => {});
    while (isBusy()) {
      await new Promise((resolve) => {
        const end = core.state.subscribe(() => {
          if (!isBusy()) queueMicrotask(() => resolve(end()));
        });
      });
      await enqueue(() => {});
    }
  }

  /** Says whether what came of a link is what was sent. @param {Scene} scene @param {boolean | null} isFile */
  async function check(scene, isFile = true) {
    const asked = get().mesh;
    await still();
    const { origin, mesh, reading, version } = get();
    const isScene = origin?.kind === "sample" ? origin.id === scene.sample : scene.mesh !== null;
    // Refused, or overtaken by another mesh.
    if (!isScene || mesh !== asked || scene.check === null || !reading) return;
    const found = await solver
      .ask("checkLink", { sent: scene.check, step: scene.step })
      .catch(() => null);
    if (!found || get().mesh !== asked) return;
    const isOther = scene.version !== null && scene.version !== version;
    const known = isOther ? "version" : isFile === null ? "unknown" : "same";
    const why = isFile === false ? "file" : known;
    const values = { ...found, wanted: scene.step, theirs: scene.version ?? "", ours: version };
    const message = say("link-checked", values);
    const hint = found.outcome === "same" ? "" : say("link-differs", { why, ...values });
    if (["same", "near"].includes(found.outcome)) notes.answer(`${message} ${hint}`.trim());
    else notes.error({ message, hint });
  }

  /** A mesh, perhaps the one that a recipe or a link waits for. @param {Bytes} file @param {Partial<Scene>} [given] */
  async function loadAwaited(file, given) {
    if (given) return loadFile(file, given);
    const [recipe, scene] = [awaited, linked];
    [awaited, linked] = [null, null];
    if (recipe && "sha256" in recipe.card.mesh) {
      const { name, sha256: digest } = recipe.card.mesh;
      if ((await sha256(file.bytes)) === digest)
        return followRecipe(recipe, { name, bytes: file.bytes });
      await loadFile(file, {});
      return notes.answer(say("recipe-other-mesh", { name }));
    }
    if (!scene) return loadFile(file, {});
    // Whether it is the file that the link was made with; null where that cannot be told.
    const digest = scene.hash && (await sha256(file.bytes));
    const isFile = digest ? digest.startsWith(scene.hash ?? "") : null;
    const isMeant = isFile || stem(file.name) === scene.mesh;
    const { prepares: _, follows: __, ...bare } = scene;
    // What was done to another mesh means nothing on this one.
    await loadFile(file, isMeant ? (isFile === false ? bare : scene) : {});
    if (isFile === false) notes.note(say("link-other-file", { name: file.name, mesh: scene.mesh }));
    if (isMeant) check(scene, isFile);
  }

  const open = {
    still,
    /** @param {string} id @param {Partial<Scene>} [scene] */
    sample: (id, scene = {}) => enqueue(() => loadSample(id, { comparison: null, ...scene })),
    /** A figure of a paper: its sample, flow and parameters. @param {Figure} figure */
    figure: ({ id: figure, sample, options, arrangement, colour }) =>
      open.sample(sample, { options, arrangement, colour, figure }),
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
        const read = rest.map(async (one) => ({ name: one.name, bytes: await bytesOf(one) }));
        const unpacked = await solver.ask("unpack", { files: await Promise.all(read) });
        const { name, bytes, others } = unpacked;
        await loadAwaited({ name, bytes }, given);
        if (others.length > 0) notes.note(say("unpack-others", { name, others }), "unpack-others");
      });
    },

    /**
     * The scene of an address; where a word in it cannot be, there is none.
     * @param {Address} address
     * @returns {Promise<Scene | null>} null where its length was not wanted
     */
    async readLink(address) {
      const link = linkIn(address);
      // Reading needs a part of the solver that the first picture is not to wait for.
      if (link.text === "") return plainScene;
      const scene = sceneOf(await solver.ask("readLink", link));
      const steps = scene.manySteps;
      return steps === 0 || (await notes.ask(say("link-is-long", { steps }))) ? scene : null;
    },
    /** @param {Address} address */
    async openLink(address) {
      const before = chosen;
      const [read] = await Promise.allSettled([open.readLink(address)]);
      if (chosen !== before) return;
      // Where nothing is shown yet, that would be a dead end.
      const none = get().mesh ? null : plainScene;
      const scene = (read.status === "fulfilled" ? read.value : null) ?? none;
      if (scene) run.view(scene.view);
      if (scene?.sample) await open.sample(scene.sample, scene);
      else if (scene) {
        linked = scene;
        const hint = say("link-wants-file.hint");
        notes.error({ message: say("link-wants-file", { mesh: scene.mesh }), hint });
      }
      // Said now: a mesh that is loaded clears what was said before.
      if (read.status === "rejected") core.report(read.reason);
      if (scene?.sample) await check(scene);
    },
    /** @param {boolean} [shared]  sent to somebody, so that there is always an energy to compare */
    writeLink: (shared = false) => solver.ask("writeLink", { scene: pageScene(get(), shared) }),
    /** How the present surface came about, as a file. @returns {Promise<string>} */
    async recipe() {
      const { samples } = await library();
      const { origin, figure, reading } = get();
      const sample = samples.find(({ id }) => id === figure?.sample);
      // The half of a film that is shown backwards begins with a surface of its own.
      const isBack = sample && figure?.back && (reading?.step ?? 0) < 0;
      const parameters = { ...sample?.parameters, ...figure?.back };
      const own = isBack ? { kind: "shape", shape: sample.shape, parameters } : origin;
      return solver.ask("writeRecipe", { origin: /** @type {any} */ (own) });
    },
    /** Gives up what is being done again. @returns {Promise<boolean>} whether there was something */
    async giveUp() {
      if (!isReplaying) return false;
      await solver.ask("cancelReplay").catch(core.report);
      return true;
    },
  };
  return open;
}
