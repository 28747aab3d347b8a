// @ts-check
// What was done to a surface, as words of a link: `edits`, the runs and edits that made its mesh of
// the one that was loaded, and `path`, where its run is more than so many steps. As in a recipe, but
// of a flow's options only those that are not the default; base64 that an address may hold.

/** @import { FlowOptions } from "./generated/schema.js" */
/** @import { Chapter as RecipeChapter, Leg as RecipeLeg } from "./generated/types.js" */
/** @import { PageState, Source } from "./state.js" */

import { asBase64, decodeRegion, encodeRegion, fromBase64, LONGEST } from "./link-region.js";
import { asText, defaults } from "./options.js";
import { checkEdits, checkPath, isPlain, stepsIn } from "./recipe-schema.js";

const regions = ["free", "fixed"];

/** @param {unknown} value @returns {string | null} null where it would be longer than a link may be */
function encode(value) {
  const text = asBase64(new TextEncoder().encode(JSON.stringify(value)));
  return text.length <= LONGEST ? text : null;
}

/**
 * @template T
 * @param {string | null} text
 * @param {(value: any) => T} read  throws where it makes no sense
 * @returns {T | null}
 */
function decode(text, read) {
  if (!text || text.length > LONGEST) return null;
  try {
    return read(JSON.parse(new TextDecoder().decode(fromBase64(text))));
  } catch {
    return null;
  }
}

/** @param {FlowOptions} flow @returns {Record<string, unknown> | null} null where a region fits no link */
function compact(flow) {
  /** @type {Record<string, unknown>} */
  const told = {};
  for (const [key, value] of Object.entries(flow)) {
    const usual = /** @type {Record<string, unknown>} */ (defaults)[key];
    if (asText(value) === asText(usual)) continue;
    told[key] = value;
    if (!regions.includes(key)) continue;
    const region = encodeRegion(/** @type {number[]} */ (value));
    if (region === null) return null;
    told[key] = region;
  }
  return told;
}

/** @param {any} flow */
function whole(flow) {
  const all = { ...defaults, ...flow };
  // What is none is left as it is, for the solver to refuse.
  for (const key of regions) all[key] = decodeRegion(String(all[key])) ?? all[key];
  return all;
}

/** @param {any} leg @returns {leg is { flow: FlowOptions }} */
const isFlow = (leg) => typeof leg === "object" && "flow" in leg;

/** @param {RecipeLeg} leg */
function compactLeg(leg) {
  if (!isFlow(leg)) return leg;
  const flow = compact(leg.flow);
  return flow && { flow };
}

/** @param {readonly RecipeLeg[]} path @returns {unknown[] | null} null where a region fits no link */
function compactPath(path) {
  const told = path.map(compactLeg);
  return told.includes(null) ? null : told;
}

/** @param {any} path  as it is in a link */
const wholePath = (path) =>
  path.map((/** @type {any} */ leg) => (isFlow(leg) ? { flow: whole(leg.flow) } : leg));

/** @type {WeakMap<readonly RecipeChapter[], string | null>} the address is written at every frame */
const known = new WeakMap();

/** @param {readonly RecipeChapter[]} chapters @returns {string | null} null where they fit no link */
function encodeEdits(chapters) {
  const before = known.get(chapters);
  if (before !== undefined) return before;
  const told = chapters.map(({ flow, path, ...rest }) => ({
    flow: flow && compact(flow),
    path: compactPath(path),
    ...rest,
  }));
  const fits = told.every(
    ({ flow, path }, n) => path !== null && (flow !== null || chapters[n].flow === null),
  );
  const text = fits ? encode(told) : null;
  known.set(chapters, text);
  return text;
}

/** @param {string | null} text @returns {RecipeChapter[] | null} */
export const decodeEdits = (text) =>
  decode(text, (chapters) => {
    for (const chapter of chapters) {
      if (chapter.flow !== null) chapter.flow = whole(chapter.flow);
      chapter.path = wholePath(chapter.path);
    }
    checkEdits(chapters);
    return chapters;
  });

/**
 * The options that a path began with, where others followed on the way.
 * @param {import("./generated/types.js").Recipe} story
 * @returns {import("./options.js").Options | null}
 */
export const firstOptions = ({ flow, path }) =>
  flow && path.some(isFlow) ? { ...defaults, ...flow } : null;

/**
 * @param {readonly RecipeLeg[]} path  as it was when the flow last stood still
 * @param {number} step  where it has come to since, or will
 */
export function encodePath(path, step) {
  const more = step - stepsIn(path);
  if (isPlain(path) || more < 0) return null;
  const told = compactPath(path);
  return told && encode(more > 0 ? [...told, { steps: more }] : told);
}

/** @param {string | null} text @param {number} step @returns {RecipeLeg[] | null} */
export const decodePath = (text, step) =>
  decode(text, (told) => {
    const path = wholePath(told);
    checkPath(path);
    return stepsIn(path) === step ? path : null;
  });

/**
 * What a link to a surface begins with: the mesh that was loaded, with what was done to it, or only
 * the name of what came of it, where that is not known or fits no link.
 * @param {Pick<PageState, "source" | "origin" | "story">} state
 * @returns {{ from: Source | null, edits: string | null }}
 */
export function beginning({ source, origin, story }) {
  if (!story || !origin || origin === source || !("kind" in origin)) {
    return { from: source, edits: null };
  }
  const edits = encodeEdits(story.edits);
  return { from: edits === null ? source : origin, edits };
}
