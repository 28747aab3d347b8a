// How every command runs: what was typed is read and checked, places to write to are tried, the
// mesh is loaded, the solver is asked, and what it answers is written.

import { perform } from "../session.js";
import { orExit } from "./failure.js";
import { checkOutputs, formatOf, readMesh, writeMesh, writeOutput, writtenHelp } from "./files.js";
import { flagsOf, parse, readFlags, typed } from "./options.js";
import { print } from "./text.js";

/** @import { Row } from "../generated/schema.js" */
/** @import { Options, Syntax, Values } from "./options.js" */
/** @import { Session } from "./solver.js" */
/** @import { Terminal } from "./terminal.js" */

/**
 * What a command is given.
 * @typedef {object} Call
 * @property {string[]} parameters  what follows the command's name
 * @property {Terminal} io
 * @property {() => Promise<Session>} open
 */
/**
 * @typedef {object} Command
 * @property {Syntax} syntax
 * @property {(call: Call) => Promise<number>} run  answers the exit code
 */
/**
 * What a command came to.
 * @typedef {object} Done
 * @property {Record<string, any>} result  the JSON
 * @property {string} [text]  for people; the result in lines unless given
 * @property {Record<string, () => string>} [files]  what `--history` and its like ask for
 * @property {number} [exit]
 */
/**
 * A row of the table of commands.
 * @typedef {object} Spec
 * @property {string} name
 * @property {string} summary
 * @property {string[]} [operands]  a mesh unless given
 * @property {readonly Row[]} [rows]  options that the solver reads
 * @property {string} [words]  what the names of their words begin with
 * @property {Options} [options]  others
 * @property {(values: Values, operands: string[], io: Terminal) => Promise<any>} [ask]  what is asked of the
 *   solver; the options of the rows unless given
 * @property {(session: Session, mesh: { bytes: Uint8Array, name: string }, asked: any) => any} [load]
 *   how the mesh is loaded, where that takes more; what it answers is `loaded`
 * @property {(done: { session: Session, asked: any, values: Values, operands: string[],
 *   io: Terminal, loaded: any }) => Done} run
 */

/** @type {Options} */
export const out = {
  out: { value: "FILE", help: `the mesh at the end: ${writtenHelp}` },
};

/** @param {Spec} spec @returns {Command} */
export function command({
  name,
  summary,
  operands = ["MESH"],
  rows = [],
  words,
  options,
  ...spec
}) {
  const syntax = { summary, operands, options: { ...flagsOf(rows, words ?? name), ...options } };
  const load = spec.load ?? ((session, mesh) => perform(session, "load", mesh));
  const ask = spec.ask ?? ((values) => readFlags(name, typed(rows, values)));
  return {
    syntax,
    async run({ parameters, io, open }) {
      const { operands: given, values } = await parse(parameters, syntax);
      const asked = await ask(values, given, io);
      const format = values.out && formatOf(values.out);
      const written = Object.keys(syntax.options).filter((key) => syntax.options[key].written);
      checkOutputs(["out", ...written].map((key) => values[key]));
      const mesh = operands[0] === "MESH" ? await readMesh(given[0], io) : null;
      const session = await open();
      const loaded = mesh && orExit(3, () => load(session, mesh, asked));
      const done = spec.run({ session, asked, values, operands: given, io, loaded });
      if (format) writeMesh(session, values.out, io);
      for (const [key, content] of Object.entries(done.files ?? {})) {
        if (values[key] !== undefined) writeOutput(values[key], content());
      }
      const { result, text, exit = 0 } = done;
      io.write(values.json ? `${JSON.stringify(result)}\n` : (text ?? print(result)));
      return exit;
    },
  };
}
