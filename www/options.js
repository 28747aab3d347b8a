// Options of a flow as the tables of `generated/schema.js` have them: defaults, what is read by
// what, and how they are called. Reading and checking is the solver's.

/** @import { Flow, FlowName, FlowOptions, Row } from "./generated/schema.js" */
/** @import { Arrangement } from "./generated/types.js" */

import * as schema from "./generated/schema.js";
import { written } from "./mesh-format.js";
import { say } from "./words.js";

/** @typedef {Readonly<Required<FlowOptions>>} Options */

/** @param {readonly Row[]} rows @returns {any} */
const usual = (rows) => Object.fromEntries(rows.map(({ name, default: value }) => [name, value]));

/** @type {Options} */
export const defaults = Object.freeze(usual(schema.options));

/** @type {Readonly<Required<Arrangement>>} */
export const plainArrangement = Object.freeze(usual(schema.arrangement));

/** @type {ReadonlyMap<string, Row>} */
const rows = new Map([...schema.options, ...schema.arrangement].map((row) => [row.name, row]));

/** @param {string} name @returns {Row} */
export function rowOf(name) {
  const row = rows.get(name);
  if (!row) throw new Error(`there is no option ${name}`);
  return row;
}

/** @param {string} id @returns {Flow} */
export function flowOf(id) {
  const flow = schema.flows.find((one) => one.id === id);
  if (!flow) throw new Error(`there is no flow ${id}`);
  return flow;
}

/** Flows by mean curvature and its derivatives, by their order. */
export const byCurvature = schema.flows
  .filter(({ family }) => family === "curvature")
  .map(({ id }) => /** @type {string} */ (id));

/**
 * The change to another flow: what means nothing to it goes back to its default.
 * @param {FlowName} flow @returns {Partial<Options>}
 */
export const toFlow = (flow) => ({
  ...usual(schema.options.filter(({ ofOneFlow }) => ofOneFlow)),
  flow,
});

/**
 * Whether what runs reads an option.
 * @param {string} name @param {Options} options  of what runs @returns {boolean}
 */
export function isRead(name, options) {
  const { flows, ...only } = rowOf(name);
  return (
    flows.includes(options.flow) &&
    (only.scheme === null || only.scheme === options.scheme) &&
    (only.goal === null || only.goal === options.goal) &&
    (only.remesh === null || only.remesh === options.remesh || !isRead("remesh", options))
  );
}

/**
 * What the system of the flow runs with: what the flow does not read is as usual, or as its row
 * sets it.
 * @param {Options} options @returns {Options}
 */
export const settled = (options) => ({
  ...options,
  ...usual(schema.options.filter(({ flows }) => !flows.includes(options.flow))),
  ...flowOf(options.flow).sets,
});
/** What is asked about a flow first; the rest is under *Advanced*. */
const basic = [
  ...["boundary", "goal", "detail", "smoothSteps"],
  ...["p", "keep", "reducedVolume", "criterion"],
];

/** @param {string} name  of an option */
export const isBasic = (name) => basic.includes(name);

/** An option as text, which the solver reads. @param {unknown} value @param {string} [name] */
export const asText = (value, name) =>
  Array.isArray(value) && value.length === 0
    ? "none"
    : String(value ?? rows.get(name ?? "")?.absent ?? "auto");

/** @param {string} id  of a flow */
export const flowLabel = (id) => say(`flow-${id}`);

/** @param {string} name  of an option @param {string} id  one of its choices */
export const choiceLabel = (name, id) =>
  name === "flow" ? flowLabel(id) : say(`option-${name}.${id}`);

/** What a select shows. @param {string} name  of an option */
export const choicesOf = (name) =>
  rowOf(name).ids.map((id) => ({ id, label: choiceLabel(name, id) }));

/** What a surface can be coloured by. */
export const colours = /** @type {const} */ (["none", ...schema.fields]);

/** Formats of meshes. */
export const savedMeshes = /** @type {import("./element.js").MeshFormat[]} */ (
  written.map(({ name }) => name)
);

/** All that can be saved. @type {readonly import("./element.js").ExportFormat[]} */
export const formats = [...savedMeshes, "csv", "recipe", "png"];

/** What is chosen from, in words. @template {string} const Id @param {readonly Id[]} ids @param {string} kind */
export const named = (ids, kind) => ids.map((id) => ({ id, label: say(`${kind}-${id}`) }));
