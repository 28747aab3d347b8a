// What the page shows, as one frozen object in a signal: views are functions of it. How far the
// clip is played changes at every picture and stands beside it (player.js).

import { signal } from "@preact/signals-core";
import { numberAs } from "./numbers.js";
import { defaults, plainArrangement } from "./options.js";

/** @import { Arrangement, Configured, Curves, CurvatureJump, Diagnosis, Inverted, LinkView, Loaded, Look, LookOptions, State as Reading, Timeline } from "./generated/types.js" */
/** @import { Options } from "./options.js" */
/** @import { Figure } from "./library.js" */

/** @typedef {'empty' | 'loading' | 'ready' | 'failed'} Phase */
export const tabs = /** @type {const} */ (["surface", "flow", "measure", "compare", "share"]);
/** @typedef {typeof tabs[number]} Tab */
export const tools = /** @type {const} */ (["paint", "fill", "subdivide", "remesh", "invert"]);
/** @typedef {typeof tools[number] | "pick"} Mode */

/** Whether a tool is at work on the surface, which stays as it is meanwhile. @param {{ mode: Mode | null }} s */
export const isEditing = ({ mode }) => mode !== null && mode !== "pick";

/** What a surface is coloured by. @typedef {import("./generated/types.js").FieldName | "none"} FieldName */
/** @typedef {import("./generated/types.js").Field} Field */
/** Triangles that are seen to be. @typedef {Uint32Array} Marked */

/**
 * @typedef {{ kind: 'sample', id: string } |
 *           { kind: 'file', name: string, file?: string, sha256?: string, bytes?: number }} Source
 *   a file's own name and fingerprint, where it was opened here; the fingerprint is empty where
 *   the browser keeps it from pages
 */
/** @typedef {Source | { kind: 'shape', shape: string, parameters: Record<string, number> }} Origin */

/**
 * Of a figure of two halves: the one that is shown backwards is computed; the film is shown; some of
 * it was lost with its solver.
 * @typedef {"back" | "whole" | "cut" | null} Film
 */

/** What an edit was made of. @typedef {{ source: Source, origin: Origin | null, options: Options, figure: Figure | null, film: Film, what: string }} Earlier */

/**
 * What undoing brings back of what is shown: nothing where nothing is.
 * @param {Pick<Earlier, "origin" | "options" | "figure" | "film"> & { source: Source | null }} shown
 * @param {string} what  is undone then @returns {Earlier[]}
 */
export const earlierOf = ({ source, origin, options, figure, film }, what) =>
  source ? [{ source, origin, options, figure, film, what }] : [];

/** Edges, two ends each, and triangles to be seen; those that are turned to. @typedef {{ edges: Uint32Array, triangles: Uint32Array, near?: Uint32Array }} Marks */

/**
 * How the surface is drawn: with what a link says of it, in colours, where `contrast`, that are told
 * apart from afar and by everyone; `systemDark` is what the theme `auto` means now.
 * @typedef {Required<LinkView> & { theme: "auto" | "light" | "dark", systemDark: boolean, contrast: boolean }} View
 */

/** What a frame has beside the surface. @typedef {{ curves: Curves | null, jump: CurvatureJump | null, look: Look | null }} Extras */

/**
 * What goes on beside the flow of the page, in a worker of its own: a clip, and what of it is known.
 * @typedef {object} Beside
 * @property {number} id
 * @property {Partial<Options>} change  what it does otherwise than the first
 * @property {"loading" | "ready" | "lost"} phase
 * @property {string} reason   why it is lost
 * @property {boolean} running
 * @property {Reading | null} reading
 * @property {Uint8Array | null} held
 * @property {unknown} mesh     that its solver has
 * @property {import("./solver.js").Solver} solver
 */
/** @typedef {Beside & import("./player.js").Track} Rival */

/**
 * @typedef {object} Note  a line for the status line
 * @property {number} id
 * @property {"note" | "answer" | "error"} kind  errors stay until they are dismissed
 * @property {string} text
 * @property {string} hint
 * @property {readonly { label: string, act: () => unknown }[]} offers
 */

/** The flow of the page without any beside it. */
export const alone = Object.freeze({
  rivals: /** @type {readonly Rival[]} */ ([]),
  lockstep: /** @type {"progress" | "step" | "time"} */ ("progress"),
  shown: /** @type {"side" | number} */ ("side"), // all side by side, or one in the place of all
  /** The pane that distances are measured to, and colours show. */
  difference: /** @type {number | null} */ (null),
  withStart: /** @type {boolean} */ (false), // whether the start stands beside
});
/** @typedef {typeof alone} Comparison */

/** What the page shows. */
export const initial = Object.freeze({
  phase: /** @type {Phase} */ ("empty"),
  loadingName: /** @type {string | null} */ (null), // of the mesh that is being loaded
  source: /** @type {Source | null} */ (null),
  /** What was loaded before all edits; null where that is not known. */
  origin: /** @type {Origin | null} */ (null),
  mesh: /** @type {Loaded | null} */ (null),
  extras: /** @type {Extras | null} */ (null),
  reading: /** @type {Reading | null} */ (null), // where the solver stands
  timeline: /** @type {Timeline | null} */ (null),
  running: /** @type {boolean} */ (false), // whether the solver takes steps
  applies: /** @type {"start" | "here"} */ ("start"), // where a change of the flow begins
  options: defaults,
  configured: /** @type {Configured | null} */ (null),
  arrangement: /** @type {Readonly<Required<Arrangement>>} */ (plainArrangement), // of edge flips
  earlier: /** @type {readonly Earlier[]} */ ([]), // what `undo` brings back, oldest first
  marks: /** @type {Marks | null} */ (null),
  /** What is looked at more closely. */
  lookOptions: /** @type {Readonly<LookOptions>} */ (
    Object.freeze({ probe: null, circles: false, directions: false, crossings: false })
  ),
  preview: /** @type {Inverted | null} */ (null),
  figure: /** @type {Figure | null} */ (null),
  film: /** @type {Film} */ (null),
  comparison: alone,
  colour: /** @type {FieldName} */ ("none"),
  range: /** @type {readonly [number, number] | null} */ (null), // of colours, held for the run
  goal: /** @type {number | null} */ (null), // the step a link asks for, while running to it
  progress: /** @type {{ stage: string, fraction: number } | null} */ (null),
  isSilent: /** @type {boolean} */ (false), // the solver owes an answer and gives no sign of life
  camera: /** @type {Float32Array | null} */ (null),
  view: /** @type {View} */ (
    Object.freeze({
      shading: "smooth",
      wireframe: false,
      boundary: true,
      cut: 0,
      theme: "auto",
      systemDark: false,
      scale: "auto",
      contrast: false,
    })
  ),
  presenting: /** @type {boolean} */ (false),
  version: /** @type {string} */ (""), // of the solver; empty until it is up
  tab: /** @type {Tab | null} */ (null),
  mode: /** @type {Mode | null} */ (null),
  dialog: /** @type {"library" | "help" | "commands" | "plot" | null} */ (null),
  /** The card that says it. */
  why: /** @type {{ diagnosis: Diagnosis | null, isShown: boolean } | null} */ (null),
  section: /** @type {string | null} */ (null), // of the drawer, that is open
  welcome: /** @type {boolean} */ (false),
  isNew: /** @type {boolean} */ (false), // whether a mesh was opened that nothing has been done to
  legend: /** @type {boolean} */ (false), // whether its options are open
  notes: /** @type {readonly Note[]} */ ([]),
  noteShown: /** @type {number} */ (0), // the last that has been in the status line
  isNoteFresh: /** @type {boolean} */ (false), // whether it stands there
  question: /** @type {{ text: string, answer: (yes: boolean) => void } | null} */ (null),
});

/** @typedef {typeof initial} S */

export function createStore() {
  const state = signal(initial);
  return {
    state,
    get: () => state.peek(),
    /** @param {Partial<S>} change */
    patch(change) {
      if (change.mesh) numberAs(change.mesh.numbers);
      state.value = Object.freeze({ ...state.peek(), ...change });
    },
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */

/** @param {S} s whether the surface is shown on a dark ground */
export const isDark = ({ view }) =>
  view.theme === "dark" || (view.theme === "auto" && view.systemDark);
