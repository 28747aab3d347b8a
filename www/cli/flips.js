// @ts-check
// `umbilic flips`: edge-flip optimisation.

import { rowOf } from "../options.js";
import { perform } from "../session.js";
import { orExit } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeOutput } from "./files.js";
import { readFlags } from "./flow.js";
import { flagsOf, number, parse, typed } from "./options.js";
import { format, table } from "./text.js";

/** @typedef {import("../generated/types.js").FlipOutcome} Flipped */

const rows = [rowOf("criterion"), rowOf("guardFolds")];

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "flips edges as long as that lowers area or Willmore energy",
  operands: ["MESH"],
  options: {
    ...flagsOf(rows),
    max: { value: "N", help: "at most so many flips" },
    out: { value: "FILE", help: "the mesh at the end: .obj, .off, .ply, .stl or .glb" },
    history: { value: "FILE.csv", help: "every flip: edge, reduction, area, W" },
  },
};

/** @type {import("./commands.js").Command} */
export const flips = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const max = number(values, "max", { low: 0, integer: true });
    const { flow, ...chosen } = await readFlags({ flow: "flips", ...typed(rows, values) });
    checkOutputs([values.out, values.history]);
    const outFormat = values.out && formatOf(values.out);
    const { bytes, name } = readMesh(operands[0], io);
    const session = await open();
    orExit(3, () => perform(session, "load", { bytes, name }));
    const options = {
      ...chosen,
      ...(max !== undefined && { max }),
      history: values.history !== undefined,
    };
    /** @type {Flipped} */
    const { history, ...outcome } = orExit(3, () => perform(session, "flip", { options }));
    if (values.out) writeOutput(values.out, perform(session, "export", { format: outFormat }));
    if (values.history) writeOutput(values.history, history ?? "");
    if (values.json) io.write(`${JSON.stringify(outcome)}\n`);
    else io.write(summary(outcome));
    return 0;
  },
};

/** @param {Flipped} outcome */
function summary({ flips, rejected, before, after }) {
  const rows = [
    ["", "before", "after"],
    ["area", format(before.area), format(after.area)],
    ["circle", format(before.circle), format(after.circle)],
  ];
  return `${flips} flips, ${rejected} refused\n\n${table(rows)}`;
}
