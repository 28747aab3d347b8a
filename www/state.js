// @ts-check
// What the page shows, as one frozen object, and the only functions that change it.
// Transitions are pure: (state, …) → state. Parts read; the controller writes.

/** @import { FlowOptions } from "./generated/schema.js" */
/** @import { Arrangement } from "./generated/types.js" */
/** @import { Configured, CurvatureJump, Curves, Inverted, Loaded, Look, Pane, PlotPoint, State as Reading, Timeline, Wanted } from "./generated/types.js" */

import { alone, begunAnew, rebased } from "./comparison.js";
import { byCurvature, defaults, plainArrangement } from "./options.js";

/** @typedef {'empty' | 'loading' | 'ready' | 'running' | 'paused' | 'failed'} Phase */

/** A point of the plot. @typedef {Omit<PlotPoint, "warnings">} Sample */

/** What a surface is coloured by; `distance`, from one pane to another, is the page's own.
 * @typedef {import("./generated/types.js").FieldName | "none" | "distance"} FieldName
 */
/**
 * A field; `label` is of one that is the page's own.
 * @typedef {Omit<import("./generated/types.js").Field, "name"> & { name: FieldName, label?: string }} Field
 */
/** A frame as the page takes it in: of several panes it makes some itself.
 * @typedef {Omit<import("./generated/types.js").Frame, "exact" | "timeline" | "field"> & { timeline: Timeline | null, field: Field | null }} Frame
 */

/**
 * @typedef {{ kind: 'sample', id: string } |
 *           { kind: 'file', name: string, file?: string, sha256?: string, bytes?: number }} Source
 *   a file's own name and fingerprint, where it was opened here; the fingerprint is empty where
 *   the browser keeps it from pages
 */

/** @typedef {Source | { kind: 'shape', shape: string, parameters: Record<string, number> }} Origin */

/**
 * What an edit was made of.
 * @typedef {object} Earlier
 * @property {Source} source
 * @property {Readonly<Required<FlowOptions>>} options
 * @property {readonly Sample[]} history
 * @property {string} what  for people
 */

/**
 * Edges, two ends each, and triangles to be seen.
 * @typedef {{ edges: Uint32Array, triangles: Uint32Array }} Marks
 */

/**
 * @typedef {object} View
 * @property {'smooth' | 'flat'} shading
 * @property {boolean} wireframe
 * @property {boolean} boundary
 * @property {'auto' | 'light' | 'dark'} theme
 * @property {boolean} systemDark   what `auto` means now
 * @property {'auto' | 'log' | 'linear'} scale  of the energy axis
 * @property {boolean} contrast     colours that are told apart from afar and by everyone
 */

/**
 * @typedef {object} PageState
 * @property {Phase} phase
 * @property {string | null} loadingName  of the mesh that is being loaded; null while the
 *   surface is brought back
 * @property {Source | null} source
 * @property {Origin | null} origin  what was loaded before all edits; null where that is not known
 * @property {Loaded | null} mesh
 * @property {{ positions: Float32Array, field: Field | null, flippedTriangles: Uint32Array, panes: readonly Pane[], curves: Curves | null, jump: CurvatureJump | null, look: Look | null } | null} frame
 * @property {Reading | null} reading
 * @property {readonly Sample[]} history  from the start to the present step
 * @property {Timeline | null} timeline
 * @property {boolean | null} goingOn  as chosen for this run; see `goesOn`
 * @property {-1 | 0 | 1} playing         which way stored steps are played, 0 for not
 * @property {Readonly<Required<FlowOptions>>} options
 * @property {Configured | null} configured
 * @property {Readonly<Arrangement>} arrangement  of edge flips
 * @property {readonly Earlier[]} earlier  what `undo` brings back, oldest first
 * @property {Marks | null} marks         drawn over the surface
 * @property {Readonly<Wanted>} wanted    what is looked at more closely
 * @property {Inverted | null} preview    shown in place of the frame: the surface inverted
 * @property {import("./library.js").Figure | null} figure  of a paper, that is being shown
 * @property {Readonly<import("./comparison.js").Comparison>} comparison  flows beside this one
 * @property {FieldName} colour
 * @property {number | null} goal         the step a link asks for, while running to it
 * @property {boolean} pausing            asked to pause; the step in hand is not done
 * @property {{ stage: string, fraction: number, pane?: string } | null} progress
 * @property {boolean} isSilent           the solver owes an answer and gives no sign of life
 * @property {Float32Array | null} camera
 * @property {View} view
 * @property {boolean} presenting
 * @property {string} version             of the solver; empty until it is up
 */

/** @type {Readonly<PageState>} */
export const initial = Object.freeze({
  phase: "empty",
  loadingName: null,
  source: null,
  origin: null,
  mesh: null,
  frame: null,
  reading: null,
  history: [],
  timeline: null,
  goingOn: null,
  playing: 0,
  options: defaults,
  configured: null,
  arrangement: plainArrangement,
  earlier: [],
  marks: null,
  wanted: Object.freeze({ probe: null, circles: false, directions: false }),
  preview: null,
  figure: null,
  comparison: alone,
  colour: "none",
  goal: null,
  pausing: false,
  progress: null,
  isSilent: false,
  camera: null,
  view: Object.freeze({
    shading: "smooth",
    wireframe: false,
    boundary: true,
    theme: "auto",
    systemDark: false,
    scale: "auto",
    contrast: false,
  }),
  presenting: false,
  version: "",
});

/**
 * That stood at a moment which was gone back to; panes beside it do what they did.
 * @param {S} s @param {NonNullable<Frame["flow"]>} flow
 */
function anotherFlow(s, { options: told, configured }) {
  const options = { ...defaults, ...told };
  return { options, configured, comparison: rebased(s.comparison, s.options, options) };
}

/** @param {Reading | null} reading @returns {Phase} where a session that is not running stands */
const still = (reading) => {
  if (!reading) return "empty";
  return reading.step === 0 && reading.status === "ready" ? "ready" : "paused";
};

/** @param {Sample} of @returns {Sample} */
const sample = ({ step, time, dt, energy, objective, area, volume, minAngleDegrees }) => ({
  ...{ step, time, dt, energy, objective },
  ...{ area, volume, minAngleDegrees },
});

/**
 * @param {readonly Sample[]} history
 * @param {Reading} reading
 * @param {readonly Sample[]} added  oldest first
 */
export function extended(history, reading, added) {
  const first = added.length > 0 ? added[0].step : reading.step;
  const kept = history.filter((point) => point.step < first);
  return added.length > 0 ? [...kept, ...added.map(sample)] : [...kept, sample(reading)];
}

/** @param {Loaded} mesh */
const firstFrame = (mesh) => ({
  positions: mesh.positions,
  field: null,
  flippedTriangles: new Uint32Array(0),
  panes: [],
  curves: null,
  jump: null,
  look: null,
});

/** Edits that the session keeps to be undone. */
const MOST_EDITS = 8;

/** @typedef {Readonly<PageState>} S */

export const transitions = {
  /** @param {S} s @param {string} version @returns {S} */
  solverReady: (s, version) => ({ ...s, version }),

  /** @param {S} s @param {string} name @returns {S} */
  loading: (s, name) => ({ ...s, phase: "loading", loadingName: name, goal: null }),

  /** The mesh of before stays. @param {S} s @returns {S} */
  refused: (s) => ({
    ...s,
    phase: still(s.reading),
    ...{ pausing: false, progress: null },
  }),

  /** @param {S} s @param {Source} source @param {Loaded} mesh @param {S["origin"]} [origin] @returns {S} */
  loaded: (s, source, mesh, origin = source) => ({
    ...s,
    source,
    origin,
    mesh,
    frame: firstFrame(mesh),
    reading: null,
    history: [],
    timeline: null,
    goingOn: null,
    configured: null,
    earlier: [],
    marks: null,
    preview: null,
    figure: null,
    comparison: begunAnew(s.comparison),
    goal: null,
    progress: null,
    camera: null,
  }),

  /**
   * Another mesh made of the one at hand; the camera stays.
   * @param {S} s @param {Source} source @param {Loaded} mesh @param {readonly Earlier[]} earlier
   * @returns {S}
   */
  edited: (s, source, mesh, earlier) => ({
    ...s,
    source,
    mesh,
    frame: firstFrame(mesh),
    reading: null,
    history: [],
    timeline: null,
    goingOn: null,
    configured: null,
    earlier: earlier.slice(-MOST_EDITS),
    marks: null,
    comparison: begunAnew(s.comparison),
    preview: null,
  }),

  /** A run that was left. @param {S} s @param {S["history"]} history @param {Frame} frame @returns {S} */
  resumed: (s, history, frame) => transitions.frame({ ...s, history }, frame),

  /** @param {S} s @param {S["playing"]} playing @returns {S} */
  playing: (s, playing) => ({ ...s, playing }),

  /** @param {S} s @param {Readonly<Arrangement>} arrangement @returns {S} */
  arranged: (s, arrangement) => ({ ...s, arrangement }),

  /** @param {S} s @param {import("./library.js").Figure} figure @returns {S} */
  figured: (s, figure) => ({ ...s, figure }),

  /** @param {S} s @param {Marks | null} marks @returns {S} */
  marked: (s, marks) => ({ ...s, marks }),

  /** @param {S} s @param {Readonly<Wanted>} wanted @param {Look} look @returns {S} */
  looking: (s, wanted, look) => ({ ...s, wanted, frame: s.frame && { ...s.frame, look } }),

  /** @param {S} s @param {Inverted | null} preview @returns {S} */
  previewed: (s, preview) => ({ ...s, preview }),

  /** @param {S} s @param {S["goingOn"]} goingOn @returns {S} */
  goingOn: (s, goingOn) => ({ ...s, goingOn }),

  /** @param {S} s @param {S["options"]} options @param {Configured} configured @param {Frame} [frame] @returns {S} */
  configured: (s, options, configured, frame) => {
    const state = {
      ...s,
      phase: still(configured.state),
      options,
      configured,
      reading: configured.state,
      history: extended(s.history, configured.state, []),
    };
    return frame ? transitions.frame(state, frame) : state;
  },

  /** @param {S} s @param {number | null} goal @returns {S} */
  started: (s, goal) => ({ ...s, phase: "running", pausing: false, goal }),

  /** @param {S} s @returns {S} */
  pausing: (s) => ({ ...s, pausing: true }),

  /** @param {S} s @param {Frame} frame @returns {S} */
  frame: (
    s,
    { state, reports, positions, field, flippedTriangles, panes, curves, jump, look, ...more },
  ) => ({
    ...s,
    ...(more.flow ? anotherFlow(s, more.flow) : {}),
    timeline: more.timeline,
    // A run that has not begun can be changed as one likes.
    goingOn: (more.timeline?.stored ?? 0) > 1 ? s.goingOn : null,
    phase: s.phase === "running" || s.phase === "loading" ? s.phase : still(state),
    reading: state,
    history: extended(s.history, state, reports),
    // All panes share one scale of colours.
    frame: {
      positions,
      field: panes[0]?.field ?? field,
      flippedTriangles,
      panes,
      curves,
      jump,
      look,
    },
    preview: null,
    progress: null,
  }),

  /** @param {S} s @param {Reading} reading @returns {S} */
  stopped: (s, reading) => ({
    ...s,
    phase: still(reading),
    reading,
    history: extended(s.history, reading, []),
    goal: null,
    pausing: false,
    progress: null,
  }),

  /** @param {S} s @param {S["progress"]} progress @returns {S} */
  progress: (s, progress) => ({ ...s, progress }),

  /** @param {S} s @param {FieldName} colour @param {Field | null} field @returns {S} */
  coloured: (s, colour, field) => ({ ...s, colour, frame: s.frame && { ...s.frame, field } }),

  /** @param {S} s @param {Float32Array} camera @returns {S} */
  looked: (s, camera) => ({ ...s, camera }),

  /** @param {S} s @param {Partial<View>} change @returns {S} */
  viewed: (s, change) => ({ ...s, view: Object.freeze({ ...s.view, ...change }) }),

  /** Lines and colours change too: the view is another. @param {S} s @param {boolean} presenting @returns {S} */
  presenting: (s, presenting) => ({ ...s, presenting, view: Object.freeze({ ...s.view }) }),

  /** @param {S} s @param {boolean} isSilent @returns {S} */
  silent: (s, isSilent) => ({ ...s, isSilent }),

  /**
   * A new solver is on its way; stored steps, and what could be undone, went with the old one.
   * @param {S} s @returns {S}
   */
  reviving: (s) => ({
    ...s,
    phase: "loading",
    loadingName: null,
    pausing: false,
    goal: null,
    progress: null,
    reading: s.reading && { ...s.reading, canStepBack: false },
    timeline: null,
    earlier: [],
    // The new solver has a mesh edited here as a file of its own.
    origin: s.earlier.length === 0 ? s.origin : null,
  }),

  /** No solver any more. @param {S} s @returns {S} */
  failed: (s) => ({ ...s, phase: "failed", pausing: false, goal: null, progress: null }),
};

/** @param {S} s  whether there is a step from which a change of the flow could go on */
export const canGoOn = ({ options, timeline, comparison, arrangement }) =>
  timeline !== null &&
  timeline.stored > 1 &&
  options.flow !== "flips" &&
  comparison.rivals.length === 0 &&
  !(arrangement.compare === "flows" && byCurvature.includes(options.flow));

/**
 * Whether a change of the flow goes on from the step that is shown, and not back to the start:
 * as was chosen, else where somebody has looked back to it.
 * @param {S} s
 * @param {S["options"]["flow"]} [flow]  that is changed to
 */
export const goesOn = (s, flow = s.options.flow) =>
  canGoOn(s) && flow !== "flips" && (s.goingOn ?? (s.timeline?.at ?? 0) < (s.timeline?.last ?? 0));

/** @param {S} s whether the surface is shown on a dark ground */
export const isDark = ({ view }) =>
  view.theme === "dark" || (view.theme === "auto" && view.systemDark);

/** @param {S} s whether colours are of high contrast: a projector washes the others out */
export const hasContrast = ({ view, presenting }) => view.contrast || presenting;

/**
 * @param {S} first
 * @returns the present state, a way to replace it, and a way to be told
 */
export function createStore(first = initial) {
  let state = first;
  /** @type {((state: S) => void)[]} */
  const listeners = [];
  return {
    get: () => state,
    /**
     * @template {unknown[]} A
     * @param {(state: S, ...parameters: A) => S} transition
     * @param {A} parameters
     */
    update(transition, ...parameters) {
      state = Object.freeze(transition(state, ...parameters));
      for (const listener of listeners) listener(state);
    },
    /** @param {(state: S) => void} listener called at once, and after every change */
    subscribe(listener) {
      listeners.push(listener);
      listener(state);
    },
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */
