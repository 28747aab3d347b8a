// @ts-check
// `umbilic info`: the diagnosis card of a mesh.

import { perform } from "../session.js";
import { orExit } from "./failure.js";
import { readMesh } from "./files.js";
import { parse } from "./options.js";
import { entries, format, inWords, table } from "./text.js";

/** @type {import("./options.js").Syntax} */
const syntax = {
  summary: "what a mesh is and what is odd about it",
  operands: ["MESH"],
  options: {},
};

/** @type {import("./commands.js").Command} */
export const info = {
  syntax,
  async run({ parameters, io, open }) {
    const { operands, values } = await parse(parameters, syntax);
    const { bytes, name } = readMesh(operands[0], io);
    const session = await open();
    const info = inWords(orExit(3, () => perform(session, "load", { bytes, name })).info);
    if (values.json) {
      io.write(`${JSON.stringify(info)}\n`);
    } else {
      io.write(table(entries(info).map(([key, value]) => [key, format(value)])));
      for (const warning of info.warnings) io.write(`warning: ${warning}\n`);
    }
    return 0;
  },
};
