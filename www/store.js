// @ts-check
// What the page shows, as one frozen object in a signal: views are functions of it. How far the
// clip is played changes at every picture and stands beside it (player.js).

import { computed, signal } from "@preact/signals-core";
import { numberAs } from "./numbers.js";
import { defaults, plainArrangement } from "./options.js";

/** @import { Configured, Curves, CurvatureJump, Inverted, Loaded, Look, State as Reading, Timeline, LookOptions } from "./generated/types.js" */
/** @import { Options } from "./options.js" */

/** @typedef {'empty' | 'loading' | 'ready' | 'failed'} Phase */
export const tabs = /** @type {const} */ (["surface", "flow", "measure", "compare", "share"]);
/** @typedef {typeof tabs[number]} Tab */
export const tools = /** @type {const} */ (["paint", "fill", "subdivide", "remesh", "invert"]);
/** @typedef {typeof tools[number] | "pick"} Mode */

/** What a surface is coloured by.
 * @typedef {import("./generated/types.js").FieldName | "none"} FieldName
 */
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
 * What an edit was made of.
 * @typedef {{ source: Source, options: Options, what: string }} Earlier
 */

/** Edges, two ends each, and triangles to be seen; those that are turned to. @typedef {{ edges: Uint32Array, triangles: Uint32Array, near?: Uint32Array }} Marks */

/**
 * @typedef {object} View
 * @property {'smooth' | 'flat'} shading
 * @property {boolean} wireframe
 * @property {boolean} boundary
 * @property {number} cut           percent of its depth that are cut away in front
 * @property {'auto' | 'light' | 'dark'} theme
 * @property {boolean} systemDark   what `auto` means now
 * @property {'auto' | 'log' | 'linear'} scale  of the energy axis
 * @property {boolean} contrast     colours that are told apart from afar and by everyone
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
 * @typedef {object} Comparison
 * @property {readonly Rival[]} rivals
 * @property {"progress" | "step" | "time"} lockstep
 * @property {"side" | number} shown   all side by side, or one in the place of all
 * @property {number | null} difference  the pane that distances are measured to, and colours show
 * @property {boolean} withStart  whether the start stands beside
 */

/**
 * @typedef {object} Note  a line for the status line
 * @property {number} id
 * @property {"note" | "answer" | "error"} kind  errors stay until they are dismissed
 * @property {string} text
 * @property {string} hint
 * @property {readonly { label: string, act: () => unknown }[]} offers
 */

/**
 * @typedef {object} PageState
 * @property {Phase} phase
 * @property {string | null} loadingName  of the mesh that is being loaded
 * @property {Source | null} source
 * @property {Origin | null} origin  what was loaded before all edits; null where that is not known
 * @property {Loaded | null} mesh
 * @property {Extras | null} extras
 * @property {Reading | null} reading   where the solver stands
 * @property {Timeline | null} timeline
 * @property {boolean} running      whether the solver takes steps
 * @property {"start" | "here"} applies  where a change of the flow begins
 * @property {Options} options
 * @property {Configured | null} configured
 * @property {Readonly<Required<import("./generated/types.js").Arrangement>>} arrangement  of edge flips
 * @property {readonly Earlier[]} earlier  what `undo` brings back, oldest first
 * @property {Marks | null} marks
 * @property {Readonly<LookOptions>} lookOptions  what is looked at more closely
 * @property {Inverted | null} preview
 * @property {import("./library.js").Figure | null} figure
 * @property {"back" | "whole" | null} film  of a figure of two halves: the one that is shown
 *   backwards is computed; the film is shown
 * @property {Readonly<Comparison>} comparison
 * @property {FieldName} colour
 * @property {readonly [number, number] | null} range  of colours, held for the run
 * @property {number | null} goal         the step a link asks for, while running to it
 * @property {{ stage: string, fraction: number } | null} progress
 * @property {boolean} isSilent           the solver owes an answer and gives no sign of life
 * @property {Float32Array | null} camera
 * @property {View} view
 * @property {boolean} presenting
 * @property {string} version             of the solver; empty until it is up
 * @property {Tab | null} tab
 * @property {Mode | null} mode
 * @property {"library" | "help" | "commands" | "plot" | null} dialog
 * @property {{ diagnosis: import("./generated/types.js").Diagnosis | null, isShown: boolean } | null} why  the card that says it
 * @property {string | null} section     of the drawer, that is open
 * @property {boolean} welcome
 * @property {boolean} isNew             whether a mesh was opened that nothing has been done to
 * @property {boolean} legend            whether its options are open
 * @property {readonly Note[]} notes
 * @property {number} noteShown          the last that has been in the status line
 * @property {boolean} isNoteFresh       whether it stands there
 * @property {{ text: string, answer: (yes: boolean) => void } | null} question
 */

/** @typedef {Readonly<PageState>} S */

/** @type {Readonly<Comparison>} */
export const alone = Object.freeze({
  rivals: [],
  lockstep: "progress",
  shown: "side",
  difference: null,
  withStart: false,
});

/** @type {S} */
export const initial = Object.freeze({
  phase: "empty",
  loadingName: null,
  source: null,
  origin: null,
  mesh: null,
  extras: null,
  reading: null,
  timeline: null,
  running: false,
  applies: "start",
  options: defaults,
  configured: null,
  arrangement: plainArrangement,
  earlier: [],
  marks: null,
  lookOptions: Object.freeze({ probe: null, circles: false, directions: false, crossings: false }),
  preview: null,
  figure: null,
  film: null,
  comparison: alone,
  colour: "none",
  range: null,
  goal: null,
  progress: null,
  isSilent: false,
  camera: null,
  view: Object.freeze({
    shading: "smooth",
    wireframe: false,
    boundary: true,
    cut: 0,
    theme: "auto",
    systemDark: false,
    scale: "auto",
    contrast: false,
  }),
  presenting: false,
  version: "",
  tab: null,
  mode: null,
  dialog: null,
  why: null,
  section: null,
  welcome: false,
  isNew: false,
  legend: false,
  notes: [],
  noteShown: 0,
  isNoteFresh: false,
  question: null,
});

/** @param {S} first */
export function createStore(first = initial) {
  const state = signal(first);
  return {
    state,
    get: () => state.peek(),
    /** @param {Partial<PageState>} change */
    patch(change) {
      if (change.mesh) numberAs(change.mesh.numbers);
      state.value = Object.freeze({ ...state.peek(), ...change });
    },
    /**
     * A part of the state, of which views learn only when it changes.
     * @template T
     * @param {(state: S) => T} part
     */
    select: (part) => computed(() => part(state.value)),
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */

/** @param {S} s whether the surface is shown on a dark ground */
export const isDark = ({ view }) =>
  view.theme === "dark" || (view.theme === "auto" && view.systemDark);
