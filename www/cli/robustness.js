// @ts-check
// The table `robustness` of `umbilic bench`: how flows end on sound and on rough meshes, left to
// themselves.

import { readdirSync } from "node:fs";
import path from "node:path";
import { byCurvature } from "../options.js";
import { perform } from "../session.js";
import { Failure, orExit, usage } from "./failure.js";
import { isMesh, readInput } from "./files.js";
import { runSteps } from "./flow.js";

/** @typedef {import("./solver.js").Session} Session */
/** @typedef {import("./bench.js").Row} Row */
/** @typedef {import("../generated/schema.js").FlowOptions} FlowOptions */

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {string} [shape]        a sample shape, or else
 * @property {Record<string, number>} [parameters]
 * @property {() => Mesh} [make]     a mesh made here
 * @property {number} [noise]        standard deviation of each coordinate, in mean edge lengths
 * @property {FlowOptions[]} flows
 */
/** @typedef {{ points: number[][], faces: number[][] }} Mesh */

/** @type {FlowOptions} */
const kept = { flow: "p-willmore", keep: ["area", "volume"] };

/** @type {readonly Case[]} */
const cases = [
  {
    name: "ellipsoid",
    shape: "ellipsoid",
    parameters: { a: 1.5, b: 1, c: 0.7, level: 3 },
    flows: [{ flow: "willmore" }, { flow: "mmcv" }, { flow: "mean-curvature" }],
  },
  {
    name: "Clifford torus, noise 0.15 h",
    shape: "torus",
    parameters: { major: Math.SQRT2, minor: 1, around: 40, tube: 20 },
    noise: 0.15,
    flows: [{ flow: "circle" }],
  },
  {
    name: "torus of quads, noise 0.04 h",
    make: () => torusOfQuads(1.3, 0.5, 36, 18),
    noise: 0.04,
    flows: [{ flow: "p-willmore" }],
  },
  {
    name: "near-sphere, noise 0.04 h",
    shape: "ellipsoid",
    parameters: { a: 1.1, b: 1, c: 1, level: 4 },
    noise: 0.04,
    flows: [kept],
  },
  {
    name: "spheroid, noise 0.04 h",
    shape: "ellipsoid",
    parameters: { a: 2.2, b: 1, c: 1, level: 4 },
    noise: 0.04,
    flows: [kept],
  },
  {
    name: "ellipsoid, noise 0.12 h",
    shape: "ellipsoid",
    parameters: { a: 1, b: 0.8, c: 0.6, level: 3 },
    noise: 0.12,
    flows: [kept],
  },
  {
    name: "dumbbell",
    shape: "dumbbell",
    parameters: { level: 4, waist: 0.15 },
    flows: [{ flow: "mean-curvature" }],
  },
];

/** Flows that are tried on meshes of one's own. @type {readonly FlowOptions[]} */
const every = [
  { flow: "circle" },
  { flow: "p-willmore" },
  kept,
  ...byCurvature.map((flow) => /** @type {FlowOptions} */ ({ flow })),
];
/** Steps of each on them. */
const STEPS = 100;

export const robustnessColumns = [
  ...["case", "flow", "ending", "steps", "first", "last", "rise", "angle", "seconds"],
];

/**
 * @param {Session} session
 * @param {{ maxVertices: number, meshes?: string }} limits  a folder of meshes to try instead
 * @returns {Generator<Row>}
 */
export function* robustnessRows(session, { maxVertices, meshes }) {
  if (meshes !== undefined) {
    for (const file of meshesIn(meshes)) {
      const name = path.basename(file);
      const load = () => perform(session, "load", { bytes: readInput(file), name });
      const few = every.map((options) => ({ ...options, maxSteps: STEPS }));
      yield* rowsOf(session, name, load, few, maxVertices);
    }
    return;
  }
  for (const { name, shape, parameters = {}, make, noise = 0, flows } of cases) {
    const sample = () => perform(session, "sample", { name: shape ?? "", parameters });
    const mesh = make?.() ?? (noise > 0 ? meshOf(sample()) : null);
    const load = () =>
      mesh
        ? perform(session, "load", { bytes: written(shaken(mesh, noise)), name: "case.obj" })
        : sample();
    yield* rowsOf(session, name, load, flows, maxVertices);
  }
}

/**
 * A row a flow; one that tells why, where the mesh or the flow is refused.
 * @param {Session} session
 * @param {string} name
 * @param {() => { info: { vertices: number } }} load
 * @param {readonly FlowOptions[]} flows
 * @param {number} maxVertices
 * @returns {Generator<Row>}
 */
function* rowsOf(session, name, load, flows, maxVertices) {
  const loaded = orKind(load);
  if (typeof loaded === "string") {
    yield { ...blank, case: name, flow: "", ending: `refused: ${loaded}` };
    return;
  }
  if (loaded.info.vertices > maxVertices) return;
  for (const options of flows) {
    const flow = [options.flow, ...(options.keep ?? [])].join(", ");
    // Each from the file: what one flow has done to the session is nothing to the next.
    load();
    const refused = orKind(() => perform(session, "configure", { options }));
    if (typeof refused === "string") {
      yield { ...blank, case: name, flow, ending: `refused: ${refused}` };
    } else yield { case: name, flow, ...outcome(session) };
  }
}

const blank = { steps: null, first: null, last: null, rise: null, angle: null, seconds: null };

/** Runs what is configured. @param {Session} session */
function outcome(session) {
  const first = perform(session, "state");
  const begun = performance.now();
  const { status, steps, fault } = runSteps(session, () => {});
  const last = perform(session, "state");
  return {
    ending: fault ? `${status}: ${fault.kind}` : status,
    steps: steps.length,
    first: first.energy,
    last: last.energy,
    // Within steps: between them a flow may take up another functional, as that of a smaller ε.
    rise: steps.reduce(
      (most, { objective, objectiveBefore }) =>
        Math.max(most, (objective - objectiveBefore) / Math.abs(objectiveBefore)),
      0,
    ),
    angle: steps.reduce(
      (least, { minAngleDegrees }) => Math.min(least, minAngleDegrees),
      first.minAngleDegrees,
    ),
    seconds: (performance.now() - begun) / 1000,
  };
}

/**
 * What a call answers, or the kind of its refusal.
 * @template T
 * @param {() => T} call
 * @returns {T | string}
 */
function orKind(call) {
  try {
    return orExit(3, call);
  } catch (error) {
    if (error instanceof Failure) return error.kind;
    throw error;
  }
}

/** Mesh files of a folder, by name. @param {string} folder */
function meshesIn(folder) {
  try {
    const names = readdirSync(folder).filter(isMesh).sort();
    if (names.length > 0) return names.map((name) => path.join(folder, name));
  } catch (error) {
    throw usage(`${folder} is not a folder: ${/** @type {Error} */ (error).message}.`);
  }
  throw usage(`${folder} holds no mesh.`, "Meshes are OBJ, OFF, PLY or STL files.");
}

/** @param {import("../generated/types.js").Loaded} loaded @returns {Mesh} */
function meshOf({ positions, triangles }) {
  const triples = (/** @type {ArrayLike<number>} */ list) =>
    Array.from({ length: list.length / 3 }, (_, n) => [0, 1, 2].map((k) => list[3 * n + k]));
  return { points: triples(positions), faces: triples(triangles) };
}

/**
 * A torus about the z axis, its faces quadrilaterals.
 * @param {number} major @param {number} minor @param {number} around @param {number} tube
 * @returns {Mesh}
 */
function torusOfQuads(major, minor, around, tube) {
  const at = (/** @type {number} */ i, /** @type {number} */ j) => (i % around) * tube + (j % tube);
  const cells = Array.from({ length: around * tube }, (_, n) => [Math.floor(n / tube), n % tube]);
  return {
    points: cells.map(([i, j]) => {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / tube];
      const r = major + minor * Math.cos(v);
      return [r * Math.cos(u), r * Math.sin(u), minor * Math.sin(v)];
    }),
    faces: cells.map(([i, j]) => [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]),
  };
}

/**
 * Moves every coordinate by a normally distributed number, the same each time.
 * @param {Mesh} mesh
 * @param {number} noise  its standard deviation, in mean edge lengths
 * @returns {Mesh}
 */
export function shaken({ points, faces }, noise) {
  const lengths = faces.flatMap((face) =>
    face.map((v, k) => {
      const end = points[face[(k + 1) % face.length]];
      return Math.hypot(...points[v].map((x, axis) => x - end[axis]));
    }),
  );
  const h = lengths.reduce((sum, length) => sum + length, 0) / lengths.length;
  const normal = normals(1);
  return { points: points.map((p) => p.map((x) => x + noise * h * normal())), faces };
}

/**
 * Normally distributed numbers, by Box and Muller (1958) from an xorshift generator (Marsaglia
 * 2003).
 * @param {number} seed
 */
function normals(seed) {
  let state = seed;
  const uniform = () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return ((state >>> 0) + 0.5) / 2 ** 32;
  };
  return () => Math.sqrt(-2 * Math.log(uniform())) * Math.cos(2 * Math.PI * uniform());
}

/** As an OBJ file. @param {Mesh} mesh */
const written = ({ points, faces }) =>
  new TextEncoder().encode(
    [
      ...points.map((p) => `v ${p.join(" ")}`),
      ...faces.map((face) => `f ${face.map((v) => v + 1).join(" ")}`),
    ].join("\n"),
  );
