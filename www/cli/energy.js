// @ts-check
// `umbilic energy`: the energies and integrals of a mesh.

import { rowOf } from "../options.js";
import { perform } from "../session.js";
import { orExit, usage } from "./failure.js";
import { readMesh } from "./files.js";
import { parse } from "./options.js";
import { entries, format, table } from "./text.js";

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "all energies and integrals",
  operands: ["MESH"],
  options: {
    p: { value: "P", many: true, help: "a further exponent of ∫|H|^p dA, beside 0 to 4" },
    boundary: {
      value: "CONDITION",
      choices: [...rowOf("boundary").ids],
      help: "of open meshes: which terms count and which vertices move",
    },
  },
};

/** @type {import("./commands.js").Command} */
export const energy = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const p = (values.p ?? []).map(exponent);
    const { bytes, name } = readMesh(operands[0], io);
    const session = await open();
    orExit(3, () => perform(session, "load", { bytes, name }));
    const options = { p, ...(values.boundary && { boundary: values.boundary }) };
    const energies = orExit(3, () => perform(session, "energy", options));
    if (values.json) io.write(`${JSON.stringify(energies)}\n`);
    else io.write(table(entries(energies).map(([key, value]) => [key, format(value)])));
    return 0;
  },
};

/** @param {string} text */
function exponent(text) {
  const value = Number(text);
  if (text.trim() !== "" && Number.isFinite(value) && value >= 0) return value;
  throw usage(`--p is \`${text}\`, not an exponent from 0.`);
}
