// @ts-check
// `umbilic regularise`: conformal regularisation of a mesh at rest.

import { perform } from "../session.js";
import { orExit } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeOutput } from "./files.js";
import { number, parse } from "./options.js";
import { entries, format, table } from "./text.js";

/** @typedef {import("../generated/types.js").Regularised} Regularised */

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "slides vertices along a closed surface towards a conformal mesh, or refuses",
  operands: ["MESH"],
  options: {
    mode: {
      value: "MODE",
      choices: ["linear", "nonlinear"],
      help: "nonlinear (default) keeps the volume better",
    },
    epsilon: { value: "VALUE", help: "1e-3 is faithful, 1e-1 aggressive (default 0.01)" },
    iterations: { value: "N", help: "passes at most (default 5)" },
    features: {
      value: "VALUE",
      help: "how strongly features stay (default 0.3; 0: creases slide too)",
    },
    out: { value: "FILE", help: "the mesh at the end: .obj, .off, .ply, .stl or .glb" },
  },
};

/** @type {import("./commands.js").Command} */
export const regularise = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const given = {
      mode: values.mode,
      epsilon: number(values, "epsilon", { low: Number.MIN_VALUE }),
      iterations: number(values, "iterations", { low: 0, integer: true }),
      features: number(values, "features", { low: 0 }),
    };
    checkOutputs([values.out]);
    const outFormat = values.out && formatOf(values.out);
    const { bytes, name } = readMesh(operands[0], io);
    const session = await open();
    orExit(3, () => perform(session, "load", { bytes, name }));
    // Without steps: the flow's checks of the mesh are those of the regularisation.
    orExit(3, () => perform(session, "configure", { options: { flow: "p-willmore" } }));
    const options = Object.fromEntries(Object.entries(given).filter(([, v]) => v !== undefined));
    const start = performance.now();
    /** @type {Regularised} */
    const outcome = orExit(4, () => perform(session, "regularise", { options }));
    const milliseconds = performance.now() - start;
    if (values.out) writeOutput(values.out, perform(session, "export", { format: outFormat }));
    if (values.json) io.write(`${JSON.stringify({ ...outcome, milliseconds })}\n`);
    else io.write(summary(outcome));
    return 0;
  },
};

/** @param {Regularised} outcome */
function summary({ passes, before, after, distance, pinned }) {
  const last = new Map(entries(after));
  const rows = entries(before).map(([key, value]) => [key, format(value), format(last.get(key))]);
  const creases = pinned > 0 ? `${pinned} vertices on creases stay` : "no vertex is on a crease";
  const said =
    passes > 0
      ? `surfaces before and after within ${format(100 * distance)} % of the size, ${creases}`
      : `as regular as it gets, ${creases}${pinned > 0 ? "; a finer mesh has more to move" : ""}`;
  return `${passes} passes, ${said}\n\n${table([["", "before", "after"], ...rows])}`;
}
