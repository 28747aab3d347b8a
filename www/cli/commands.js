// The commands there are.

import * as schema from "../generated/schema.js";
import { numberOf } from "../numbers.js";
import { bench } from "./bench.js";
import { out } from "./command.js";
import { isRefusal, orExit } from "./failure.js";
import { readHelp } from "./files.js";
import { fill, flow } from "./flow.js";
import { replay } from "./replay.js";
import { shape } from "./shape.js";
import { inWords, repairInWords, table } from "./text.js";

/**
 * What a file is before a repair; null where it is no surface.
 * @param {import("./command.js").Perform} perform @param {{ bytes: Uint8Array<ArrayBuffer>, name: string }} mesh
 */
function infoOf(perform, mesh) {
  try {
    return inWords(perform("load", mesh).info);
  } catch (error) {
    // What a repair does not help against it will refuse itself.
    if (isRefusal(error)) return null;
    throw error;
  }
}

/**
 * A boundary loop by its number, with one of its vertices as the file counts.
 * @param {import("../generated/types.js").LoopInfo} loop @param {number} number
 */
const loopOf = ({ edges, length, small, vertices }, number) => ({
  ...{ number, edges, length, small },
  vertex: numberOf("vertices", vertices[0]),
});

/** @type {Record<string, import("./command.js").Spec>} */
export const commands = {
  info: {
    summary: "what a mesh is and what is odd about it",
    run({ perform }) {
      const info = perform("info");
      const loops = info.boundaryLoops > 0 && perform("loops").map(loopOf);
      return { result: { ...inWords(info), ...(loops && { loops }) } };
    },
  },
  repair: {
    summary: "makes a whole surface of a broken file, and lists what it changed",
    rows: schema.repair,
    options: out,
    load(perform, mesh, asked) {
      const before = infoOf(perform, mesh);
      const { repaired } = perform("load", { ...mesh, repair: asked });
      return { before, repaired };
    },
    run({ perform, loaded: { before, repaired } }) {
      const after = inWords(perform("info"));
      return { result: { changes: repaired.map(repairInWords), before, after } };
    },
  },
  energy: {
    summary: "all energies and integrals",
    rows: schema.energy,
    run: ({ perform, asked }) => ({ result: perform("energy", asked) }),
  },
  flow,
  flips: {
    summary: "flips edges as long as that lowers area or Willmore energy",
    rows: schema.flips,
    options: {
      ...out,
      history: { value: "FILE.csv", isWritten: true, help: "every flip: edge, reduction, area, W" },
    },
    run({ perform, asked, values, loaded }) {
      const options = { ...asked, history: values.history !== undefined };
      const { history, warnings: own, ...result } = perform("flip", { options });
      const warnings = [...loaded.info.warnings, ...own];
      // Those who read the result rely on its keys.
      const told = warnings.length > 0 ? inWords({ ...result, warnings }) : result;
      return { result: told, files: { history: () => history ?? "" } };
    },
  },
  regularise: {
    summary: "slides vertices along a closed surface towards a conformal mesh, or refuses",
    rows: schema.regularise,
    options: out,
    run({ perform, asked }) {
      // Without steps: the flow's checks of the mesh are those of the regularisation.
      perform("configure", { options: { flow: "p-willmore" } });
      const start = performance.now();
      const outcome = orExit(4, () => perform("regularise", { options: asked }));
      return { result: { ...outcome, milliseconds: performance.now() - start } };
    },
  },
  remesh: {
    summary: "gives a surface other triangles, of one size or as small as it bends",
    rows: schema.remesh,
    options: out,
    run: ({ perform, asked }) => ({ result: perform("remesh", { options: asked }) }),
  },
  fill,
  replay,
  shape,
  bench,
};

/** @returns {string} */
export function overview() {
  const rows = Object.entries(commands).map(([name, { operands = ["MESH"], summary }]) => [
    `  ${[name, ...operands].join(" ")}`,
    summary,
  ]);
  return `umbilic <command> [options]

Willmore-type geometric flows on triangle meshes.

${table(rows, 2)}
MESH is a file that ends in
${readHelp},
or - for standard input.
umbilic <command> --help lists a command's options; --version tells the version.
Exit codes: 0 done, 2 bad usage, 3 refused input, 4 the surface could not be kept good: a failure,
a singularity or a collapse.
`;
}
