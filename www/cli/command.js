// How every command runs: what was typed is read and checked, places to write to are tried, the
// mesh is loaded, the solver is asked, and what it answers is written.

import { perform as performIn } from "../session.js";
import { say } from "../words.js";
import { checkOutput, formatOf, readMesh, writeOutput, writtenHelp } from "./files.js";
import { flagsOf, help, parse, readFlags, typed } from "./options.js";
import { pending, print, repairInWords, repairWay } from "./text.js";

/** @import { Row } from "../generated/schema.js" */
/** @import { Options, Values } from "./options.js" */
/** @import { Session } from "./solver.js" */
/** @import { AnswerOf, CommandName, FieldsOf, Loose } from "../session.js" */
/** @import { Terminal } from "../cli.js" */

/**
 * Asks the solver.
 * @typedef {<N extends CommandName>(name: N, fields?: Loose<FieldsOf<N>>) => AnswerOf<N>} Perform
 */
/**
 * What a command comes to: the JSON; a text for people, the result in lines unless given; what
 * `--history` and its like ask for; the exit code.
 * @typedef {{ result: any, text?: string, files?: Record<string, () => string>, exit?: number }} Done
 */
/**
 * A command.
 * @typedef {object} Spec
 * @property {string} summary
 * @property {string[]} [operands]  a mesh unless given
 * @property {readonly Row[]} [rows]  options that the solver reads
 * @property {string} [words]  what the names of their words begin with
 * @property {Options | ((parameters: string[]) => Options)} [options]  others
 * @property {(values: Values, operands: string[], io: Terminal) => any} [ask]  what is asked of the
 *   solver; the options of the rows unless given
 * @property {(perform: Perform, mesh: { bytes: Uint8Array<ArrayBuffer>, name: string }, asked: any) => any} [load]
 *   how the mesh is loaded, where that takes more; what it answers is `loaded`
 * @property {(done: { perform: Perform, asked: any, values: Values, operands: string[],
 *   io: Terminal, loaded: any }) => Done} run
 */

/** @type {Options} */
export const out = {
  out: { value: "FILE", isWritten: true, help: `the mesh at the end: ${writtenHelp}` },
};

/**
 * @param {string} name @param {Spec} spec
 * @param {{ parameters: string[], io: Terminal, open: () => Session | Promise<Session> }} call
 * @returns {Promise<number>} the exit code
 */
export async function execute(name, spec, { parameters, io, open }) {
  const { summary, operands = ["MESH"], rows = [], words = name, load, run } = spec;
  const isHelp = ["--help", "-h"].some((flag) => parameters.includes(flag));
  const { options } = spec;
  const others = typeof options === "function" ? options(isHelp ? [] : parameters) : options;
  const syntax = { summary, operands, options: { ...flagsOf(rows, words), ...others } };
  if (isHelp) {
    io.write(help(name, syntax));
    return 0;
  }
  const { operands: given, values } = parse(parameters, syntax);
  const asked = spec.ask?.(values, given, io) ?? readFlags(name, typed(rows, values));
  const format = values.out && formatOf(values.out);
  for (const [key, { isWritten }] of Object.entries(syntax.options)) {
    if (isWritten && values[key] !== undefined) checkOutput(values[key]);
  }
  const session = await open();
  /** @type {Perform} */
  const perform = (command, fields) => performIn(session, command, fields);
  const mesh = operands[0] === "MESH" ? readMesh(perform, given[0], io) : null;
  const loaded = mesh && (load?.(perform, mesh, asked) ?? perform("load", mesh));
  const done = run({ perform, asked, values, operands: given, io, loaded });
  // What works on a broken surface as it is says so; `info` lists that itself.
  if (loaded?.info && name !== "info") {
    const wanting = pending(loaded.info.repairs.map(repairInWords));
    if (wanting.length > 0) io.log([...wanting, repairWay].join("\n"));
  }
  if (format) {
    const losses = perform("losses", { format });
    writeOutput(values.out, perform("export", { format }));
    for (const loss of losses) io.log(say(loss));
  }
  for (const [key, content] of Object.entries(done.files ?? {})) {
    if (values[key] !== undefined) writeOutput(values[key], content());
  }
  const { result, text, exit = 0 } = done;
  io.write(values.json ? `${JSON.stringify(result)}\n` : (text ?? print(result)));
  return exit;
}
