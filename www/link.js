// The scene in the address, after `#`, which a browser never sends to the server. The solver
// reads and writes its words; here is what it needs of the page.

/** @import { Arrangement, Comparison, LinkScene, PageScene, ScriptText } from "./generated/types.js" */
/** @import { Options } from "./options.js" */
/** @import { FieldName, S, View } from "./store.js" */

import { plainArrangement } from "./options.js";

/**
 * A scene to be shown: that of a link, or of a recipe.
 * @typedef {object} Made
 * @property {ScriptText} [prepares] makes the mesh, where it was edited
 * @property {ScriptText} [follows]  leads to the step, where that takes more than steps
 * @property {Partial<Options>} options
 * @property {Partial<Arrangement>} arrangement
 * @property {FieldName} colour
 * @property {Omit<Comparison, "shown"> & { shown: "side" | number } | null} comparison
 * @property {Partial<View>} view
 * @property {number} manySteps       as many as one would rather be asked about; else 0
 */
/** @typedef {Made & Pick<LinkScene, "sample" | "mesh" | "hash" | "figure" | "step" | "camera" | "check" | "version">} Scene */

/** @typedef {{ search: string, hash: string }} Address */

/** A link in an address; a query too, as one writes by hand. @param {Address} address */
export const linkIn = ({ search, hash }) =>
  hash.length > 1 ? { text: hash.slice(1), isOwn: true } : { text: search.slice(1), isOwn: false };

/** What is shown without a link. @type {Readonly<Scene>} */
export const plainScene = Object.freeze({
  sample: "bumpy-sphere",
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
 * @param {S} state  with a mesh
 * @param {boolean} shared  whether it is sent to somebody @returns {PageScene}
 */
export function pageScene({ source, origin, figure, comparison, view, camera, goal }, shared) {
  const { rivals, lockstep, shown, difference } = comparison;
  const panes = rivals.map(({ change, reading }) => ({ change, step: reading?.step ?? 0 }));
  const { shading, wireframe, boundary, cut, scale } = view;
  return /** @type {any} */ ({
    ...{ source, origin, camera, goal, shared },
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

/**
 * Keeps an address in step with the state: at most twice a second, because browsers refuse more
 * than about three changes a second.
 * @param {() => S} get @param {() => Promise<{ text: string }>} write  the words of the scene
 * @param {(hash: string) => void} show
 * @returns {() => void} to be called where the scene may be another
 */
export function createLinkWriter(get, write, show) {
  let isWaiting = false;
  const isThere = () => get().phase === "ready" && get().reading !== null;
  return () => {
    if (isWaiting) return;
    isWaiting = true;
    setTimeout(async () => {
      isWaiting = false;
      if (!isThere()) return;
      const { mesh } = get();
      // A solver that is gone writes none; the next state asks the next one.
      const link = await write().catch(() => null);
      if (link && isThere() && get().mesh === mesh) show(`#${link.text}`);
    }, 500);
  };
}
