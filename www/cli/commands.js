// The commands there are.

import { numberOf } from "../numbers.js";
import { say } from "../words.js";
import { bench } from "./bench.js";
import { orExit } from "./failure.js";
import { readHelp } from "./files.js";
import { fill, flow } from "./flow.js";
import { replay } from "./replay.js";
import { shape } from "./shape.js";
import { inWords, repairInWords, table } from "./text.js";

/**
 * What a file is before a repair; null where it is no surface.
 * @param {import("./run.js").Perform} perform @param {import("./run.js").Mesh} mesh
 */
function infoOf(perform, mesh) {
  try {
    return inWords(perform("load", mesh).info);
  } catch (/** @type {any} */ error) {
    // What a repair does not help against it will refuse itself.
    if (error?.kind) return null;
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

/** @type {Record<string, import("./run.js").Spec>} */
export const commands = {
  info: {
    run({ perform }) {
      const info = perform("info");
      const loops = info.boundaryLoops > 0 && perform("loops").map(loopOf);
      return { result: { ...inWords(info), ...(loops && { loops }) } };
    },
  },
  repair: {
    own: { out: "FILE" },
    load({ perform, asked }, mesh) {
      const before = infoOf(perform, mesh);
      const { repaired } = perform("load", { ...mesh, repair: asked });
      return { before, repaired };
    },
    run({ perform, loaded: { before, repaired } }) {
      const after = inWords(perform("info"));
      return { result: { changes: repaired.map(repairInWords), before, after } };
    },
  },
  energy: { run: ({ perform, asked }) => ({ result: perform("energy", asked) }) },
  flow,
  flips: {
    own: { out: "FILE", history: "FILE.csv" },
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
    own: { out: "FILE" },
    run({ perform, asked }) {
      // Without steps: the flow's checks of the mesh are those of the regularisation.
      perform("configure", { options: { flow: "p-willmore" } });
      const start = performance.now();
      const outcome = orExit(4, () => perform("regularise", { options: asked }));
      return { result: { ...outcome, milliseconds: performance.now() - start } };
    },
  },
  remesh: {
    own: { out: "FILE" },
    run: ({ perform, asked }) => ({ result: perform("remesh", { options: asked }) }),
  },
  fill,
  replay,
  shape,
  bench,
};

/** @returns {string} */
export function overview() {
  const rows = Object.entries(commands).map(([name, { operands = ["MESH"] }]) => [
    `  ${[name, ...operands].join(" ")}`,
    say(`summary-${name}`),
  ]);
  return `${say("overview", { commands: table(rows, 2), formats: readHelp })}\n`;
}
