// The scene in the address, after `#`, which a browser never sends to the server. The solver
// reads and writes its words; here is what it needs of the page.

/** @import { LinkScene, PageScene, ScriptText } from "./generated/types.js" */
/** @import { FieldName, PageState } from "./store.js" */

import { plainArrangement } from "./options.js";

/**
 * A scene to be shown: that of a link, or of a recipe.
 * @typedef {object} Scene
 * @property {string | null} sample  id of a sample; null when the mesh came from a file
 * @property {string | null} mesh    name of that file's mesh
 * @property {string | null} hash    the first 16 digits of its SHA-256
 * @property {string | null} figure
 * @property {ScriptText} [prepares] makes the mesh, where it was edited
 * @property {ScriptText} [follows]  leads to the step, where that takes more than steps
 * @property {Partial<import("./options.js").Options>} options
 * @property {Partial<import("./generated/types.js").Arrangement>} arrangement
 * @property {FieldName} colour
 * @property {{ panes: readonly { change: Partial<import("./options.js").Options>, step: number | null }[], lockstep: "step" | "time", shown: "side" | number, difference: number | null } | null} comparison  step: null, as the first
 * @property {number} step
 * @property {Float32Array | null} camera
 * @property {Partial<import("./store.js").View>} view
 * @property {string | null} check    the energy at `step`, as it was when the link was written
 * @property {string | null} version  of the solver that computed it
 * @property {number} manySteps       as many as one would rather be asked about; else 0
 */

/** @typedef {{ search: string, hash: string }} Address */

/**
 * A link in an address. A query is understood too, for whoever writes one by hand.
 * @param {Address} address
 */
export const linkIn = ({ search, hash }) =>
  hash.length > 1 ? { text: hash.slice(1), isOwn: true } : { text: search.slice(1), isOwn: false };

/** What is shown at first. */
const first = "bumpy-sphere";

/** Without a link. @type {Readonly<Scene>} */
export const plainScene = Object.freeze({
  sample: first,
  mesh: null,
  hash: null,
  figure: null,
  options: {},
  arrangement: plainArrangement,
  colour: "none",
  comparison: null,
  step: 0,
  camera: null,
  view: {},
  check: null,
  version: null,
  manySteps: 0,
});

/** Words that say which surface it is. */
const ofSurfaces = ["sample", "mesh", "figure", "edits"];

/** The scene of a link; where it names no surface, on the one that is shown at first. @param {LinkScene} link @returns {Scene} */
export function sceneOf({ text, edited, hasPath, colour, comparison, estimate, ...link }) {
  const script = { link: text };
  const words = new URLSearchParams(text);
  const isBare = !ofSurfaces.some((word) => words.has(word));
  return /** @type {Scene} */ ({
    ...link,
    ...(isBare && { sample: plainScene.sample }),
    colour: colour ?? "none",
    comparison: comparison && { ...comparison, shown: comparison.shown ?? "side" },
    manySteps: estimate.isLong ? estimate.steps : 0,
    ...(edited && { prepares: script }),
    ...(hasPath && { follows: script }),
  });
}

/**
 * What the solver does not know of a scene.
 * @param {Readonly<PageState>} state  with a mesh
 * @param {boolean} shared  whether it is sent to somebody @returns {PageScene}
 */
export function pageScene(
  { source, origin, figure, film, comparison, view, camera, goal },
  shared,
) {
  const { rivals, lockstep, shown, difference } = comparison;
  const panes = rivals.map(({ change, reading }) => ({ change, step: reading?.step ?? 0 }));
  const { shading, wireframe, boundary, cut, scale } = view;
  return /** @type {any} */ ({
    // A film is made anew, of both its halves.
    ...{ source, origin, camera, goal: film ? 0 : goal, shared },
    figure: figure?.id ?? null,
    comparison: {
      panes,
      lockstep: lockstep === "time" ? "time" : "step",
      shown: shown === "side" ? null : shown,
      difference,
    },
    view: { shading, wireframe, boundary, cut, scale },
  });
}

/** Whether there is a scene. @param {Readonly<PageState> | null} state @returns {state is Readonly<PageState>} */
const isThere = (state) => state !== null && state.phase === "ready" && state.reading !== null;

/**
 * Keeps an address in step with the state: at most twice a second, because browsers refuse more
 * than about three changes a second.
 * @param {() => Promise<string>} write  the words of the scene @param {(hash: string) => void} show
 * @param {number} pause milliseconds between changes
 */
export function createLinkWriter(write, show, pause = 500) {
  let isWaiting = false;
  /** @type {Readonly<PageState> | null} */
  let latest = null;
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      latest = state;
      if (isWaiting) return;
      isWaiting = true;
      setTimeout(async () => {
        isWaiting = false;
        if (!isThere(latest)) return;
        const { mesh } = latest;
        // A solver that is gone writes none; the next state asks the next one.
        const text = await write().catch(() => null);
        if (text !== null && isThere(latest) && latest.mesh === mesh) show(`#${text}`);
      }, pause);
    },
  };
}
