// @ts-check
// The scene in the address: read from it, and written into it. After `#`, which a
// browser never sends to the server. Only what differs from the defaults is named.

/** @import { FieldName } from "./state.js" */
/** @import { PageState, View } from "./state.js" */

import { optionsOf, rebased, timeUnitsAgree } from "./comparison.js";
import { samples } from "./generated/library.js";
import { isReading } from "./link-check.js";
import { readComparison, writeComparison } from "./link-comparison.js";
import { beginning, decodeEdits, decodePath, encodePath, firstOptions } from "./link-edits.js";
import { decodeRegion, encodeRegion } from "./link-region.js";
import {
  asText,
  byCurvature,
  choices,
  defaults,
  isOption,
  plainArrangement,
  rowOf,
  wordOptions,
} from "./options.js";
import { flowsIn } from "./recipe-schema.js";

/**
 * @typedef {object} Scene
 * @property {string | null} sample  id of a sample; null when the mesh came from a file
 * @property {string | null} mesh    name of that file's mesh
 * @property {string | null} hash    the first 16 digits of its SHA-256
 * @property {string | null} figure  its id; without a sample, all of that figure
 * @property {import("./generated/types.js").Chapter[] | null} edits  of that mesh, by hand
 * @property {Partial<import("./options.js").Options>} options
 * @property {Partial<import("./generated/types.js").Arrangement>} arrangement
 * @property {FieldName} colour
 * @property {import("./actions/compare.js").Linked | null} comparison
 * @property {number} step
 * @property {import("./generated/types.js").Leg[] | null} path  to it, where it is more than steps
 * @property {Float32Array | null} camera
 * @property {Partial<View>} view
 * @property {string | null} check    the energy at `step`, as it was when the link was written
 * @property {string | null} version  of the solver that computed it
 */

/**
 * What the solver is asked to read: words as text, and options of flows with their types.
 * @typedef {object} Asked
 * @property {Record<string, string | number[]>} [words]  of the flow and of the arrangement
 * @property {Record<string, string>[]} [panes]           of each further pane
 * @property {object[]} [flows]
 * @property {object} [arrangement]
 */

/**
 * What it answers: the same with their types, once all of them can be.
 * @typedef {object} Given
 * @property {Partial<import("./options.js").Options>} options
 * @property {Partial<import("./generated/types.js").Arrangement>} arrangement
 * @property {Partial<import("./options.js").Options>[]} panes
 */

/**
 * A link as it is written, its options not read yet.
 * @typedef {Omit<Scene, "options" | "arrangement" | "comparison"> & {
 *   asked: Asked, compared: import("./link-comparison.js").Written | null }} Link
 */

/** @type {Readonly<Given>} */
const nothing = Object.freeze({ options: {}, arrangement: {}, panes: [] });

/** Words of a link that are no options. */
export const otherWords = [
  ...["sample", "mesh", "hash", "figure", "edits", "path", "step", "check", "version", "colour"],
  ...["camera", "shading", "wireframe", "border", "scale"],
  ...["panes", "lockstep", "shown", "difference"],
];

/** @param {string | null} id the options a sample comes with */
const suggested = (id) => ({ ...defaults, ...samples.find((sample) => sample.id === id)?.options });

/**
 * Options are for the solver to read; other values that make no sense are passed over, so an old
 * or mistyped link still opens.
 * @param {{ search: string, hash: string }} address
 * @returns {Link}
 */
export function readLink({ search, hash }) {
  // A query is understood too, for whoever writes a link by hand; the page itself writes the other.
  const isOwn = hash.length > 1;
  const words = new URLSearchParams(isOwn ? hash.slice(1) : search);
  const asked = words.get("sample");
  const mesh = words.get("mesh");
  const known = samples.some(({ id }) => id === asked);
  /** @type {Record<string, string | number[]>} */
  const options = {};
  for (const [word, text] of words) {
    // In a query there may be words of others.
    if (isOption(word) || (isOwn && !otherWords.includes(word))) options[word] = text;
  }
  for (const key of ["free", "fixed"]) {
    const text = words.get(key);
    if (text !== null) options[key] = decodeRegion(text) ?? text;
  }
  const camera = (words.get("camera") ?? "").split(",").map(Number);
  const shading = words.get("shading");
  const scale = words.get("scale");
  const digest = /^[\da-f]{16,64}$/.exec(words.get("hash") ?? "")?.[0].slice(0, 16) ?? null;
  const figure = /^[\w.-]{1,60}$/.exec(words.get("figure") ?? "")?.[0] ?? null;
  const check = words.get("check");
  const step = Number(/^\d{1,7}$/.exec(words.get("step") ?? "")?.[0] ?? 0);
  const colour = choices.colour.find(({ id }) => id === words.get("colour"))?.id ?? "none";
  // Made of a sample that there is no more, they mean nothing.
  const edits = known || asked === null ? decodeEdits(words.get("edits")) : null;
  const path = decodePath(words.get("path"), step);
  const compared = readComparison(words);
  return {
    sample: known ? asked : mesh || figure ? null : samples[0].id,
    mesh: known ? null : mesh,
    hash: known || !mesh ? null : digest,
    figure,
    edits,
    asked: {
      ...(Object.keys(options).length > 0 && { words: options }),
      ...(compared && { panes: compared.panes.map((pane) => pane.words) }),
      ...((edits || path) && { flows: flowsIn({ edits, path }) }),
    },
    compared,
    colour: /** @type {FieldName} */ (colour),
    step,
    path,
    camera: camera.length > 1 && camera.every(Number.isFinite) ? new Float32Array(camera) : null,
    view: {
      ...(shading === "flat" || shading === "smooth" ? { shading } : {}),
      ...(words.has("wireframe") ? { wireframe: words.get("wireframe") === "true" } : {}),
      ...(words.has("border") ? { boundary: words.get("border") !== "false" } : {}),
      ...(scale === "log" || scale === "linear" ? { scale } : {}),
    },
    check: isReading(check) ? check : null,
    version: /^[\w.+-]{1,40}$/.exec(words.get("version") ?? "")?.[0] ?? null,
  };
}

/** Whether there is nothing for the solver to read. @param {Link} link */
export const isPlainLink = ({ asked }) => Object.keys(asked).length === 0;

/**
 * The scene of a link whose options were read.
 * @param {Link} link
 * @param {Readonly<Given>} [given]
 * @returns {Scene}
 */
export function sceneOf({ asked, compared, ...link }, { options, arrangement, panes } = nothing) {
  const first = { ...suggested(link.sample), ...options };
  const all = [first, ...panes.map((change) => optionsOf(first, change))];
  /** @type {Scene["comparison"] | false | null} */
  const comparison = compared &&
    first.flow !== "flips" && {
      panes: compared.panes.map(({ step }, n) => ({ change: panes[n], step })),
      lockstep: compared.byTime && timeUnitsAgree(all) ? "time" : "step",
      shown: compared.shown ?? "side",
      difference: compared.difference,
    };
  return { ...link, options, arrangement, comparison: comparison || null };
}

/**
 * @param {Readonly<PageState>} state
 * @returns {string} the address's part from `#` on
 */
export function writeLink(state) {
  const { arrangement, colour, camera, reading, view, goal, figure, comparison, story } = state;
  const step = goal ?? reading?.step ?? 0;
  const path = story && encodePath(story.path, step);
  const options = (path && firstOptions(story)) || state.options;
  const { from, edits } = beginning(state);
  if (!from) return "";
  const words = new URLSearchParams();
  if (from.kind === "sample") words.set("sample", from.id);
  else words.set("mesh", from.name);
  if (from.kind === "file" && from.sha256) words.set("hash", from.sha256.slice(0, 16));
  if (edits !== null) words.set("edits", edits);
  else if (from.kind === "sample" && from.id === figure?.sample) words.set("figure", figure.id);
  words.set("flow", options.flow);
  const base = suggested(from.kind === "sample" ? from.id : null);
  for (const { name } of wordOptions) {
    const key = /** @type {keyof typeof options} */ (name);
    if (key !== "flow" && asText(options[key]) !== asText(base[key]))
      words.set(key, asText(options[key], key));
  }
  for (const key of /** @type {const} */ (["free", "fixed"])) {
    const region = options[key] && encodeRegion(options[key]);
    if (region) words.set(key, region);
  }
  const { compare } = arrangement;
  const own = byCurvature.includes(options.flow)
    ? ["flows"]
    : options.flow === "flips"
      ? ["start", "criteria"]
      : [];
  if (own.includes(compare)) words.set("compare", compare);
  for (const key of /** @type {const} */ (["subdivide", "flipsPerStep"])) {
    if (rowOf(key).flows.includes(options.flow) && arrangement[key] !== plainArrangement[key])
      words.set(key, asText(arrangement[key], key));
  }
  if (colour !== "none") words.set("colour", colour);
  writeComparison(words, rebased(comparison, state.options, options), options, reading);
  if (view.shading !== "smooth") words.set("shading", view.shading);
  if (view.wireframe) words.set("wireframe", "true");
  if (!view.boundary) words.set("border", "false");
  if (view.scale !== "auto") words.set("scale", view.scale);
  if (camera) words.set("camera", [...camera].map((x) => +x.toPrecision(5)).join(","));
  if (step > 0) words.set("step", String(step));
  if (path) words.set("path", path);
  // On the way to another step the energy there is not known yet. At the start it follows
  // from the rest of the link: `sharedLink` adds it there.
  if (step > 0 && step === reading?.step) addCheck(words, state);
  return asHash(words);
}

/** @param {URLSearchParams} words */
const asHash = (words) => `#${words.toString().replaceAll("%2C", ",")}`;

/** @param {URLSearchParams} words @param {Readonly<PageState>} state */
function addCheck(words, { reading, version }) {
  if (version) words.set("version", version);
  // All of its digits, so that it can be compared to the last bit.
  if (reading && Number.isFinite(reading.energy)) words.set("check", String(reading.energy));
}

/**
 * The link to send: {@link writeLink}, and always something to check the scene by.
 * @param {Readonly<PageState>} state
 */
export function sharedLink(state) {
  const words = new URLSearchParams(writeLink(state).slice(1));
  if (state.goal === null) addCheck(words, state);
  return asHash(words);
}

/**
 * Keeps the address in step with the state: at most twice a second, because browsers
 * refuse more than about three changes a second.
 * @param {number} pause milliseconds between changes
 */
export function createLinkWriter(pause = 500) {
  let waiting = false;
  let next = "";
  return {
    /** @param {Readonly<PageState>} state */
    update(state) {
      if (state.phase === "loading" || !state.reading) return;
      next = writeLink(state);
      if (waiting) return;
      waiting = true;
      setTimeout(() => {
        waiting = false;
        if (next !== location.hash) history.replaceState(null, "", next);
      }, pause);
    },
  };
}
