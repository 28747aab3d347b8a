// How every command runs: what was typed is read and checked, places to write to are tried, the
// mesh is loaded, the solver is asked, and what it answers is written.

import { perform as performIn } from "../session.js";
import { say } from "../words.js";
import { orExit } from "./failure.js";
import { checkOutput, formatOf, readMesh, writeOutput } from "./files.js";
import { help, optionsOf, ownOptions, parse, readFlags, typed } from "./options.js";
import { print, wanting } from "./text.js";

/** @import { Option, Values } from "./options.js" */
/** @import { Session } from "./solver.js" */
/** @import { AnswerOf, CommandName, FieldsOf, Loose } from "../session.js" */
/** @import { Terminal } from "../cli.js" */

/**
 * Asks the solver.
 * @typedef {<N extends CommandName>(name: N, fields?: Loose<FieldsOf<N>>) => AnswerOf<N>} Perform
 */
/** A mesh file, unpacked. @typedef {{ bytes: Uint8Array<ArrayBuffer>, name: string }} Mesh */
/**
 * What a command has at hand: what is asked of the solver, what was typed, and what loading gave.
 * @typedef {{ perform: Perform, asked: any, values: Values, operands: string[], io: Terminal, loaded: any }} Call
 */
/**
 * What a command comes to: the JSON; a text for people, the result in lines unless given; what
 * `--history` and its like ask for; the exit code.
 * @typedef {{ result: any, text?: string, files?: Record<string, () => string>, exit?: number }} Done
 */
/**
 * A command. Its summary is `summary-` and its name in the words, its options those of the table of
 * its name.
 * @typedef {object} Spec
 * @property {string[]} [operands]  a mesh unless given
 * @property {string[]} [tables]  of options, where there are others
 * @property {Record<string, string | null>} [own]  options of the command line's own, with what follows
 * @property {(parameters: string[]) => Option[]} [more]  options that depend on what was typed
 * @property {(values: Values, operands: string[], io: Terminal) => any} [ask]  what is asked of the
 *   solver; the options of the table unless given
 * @property {(call: Call, mesh: Mesh) => any} [load]  how the mesh is loaded, where that takes more
 * @property {2 | 4} [refusal]  the exit code where the solver refuses to run, 3 unless given
 * @property {(call: Call) => Done} run
 */

/**
 * @param {string} name @param {Spec} spec
 * @param {{ parameters: string[], io: Terminal, open: () => Session | Promise<Session> }} call
 * @returns {Promise<number>} the exit code
 */
export async function execute(name, spec, { parameters, io, open }) {
  const { operands = ["MESH"], tables = [name], own = {}, load, run } = spec;
  const isHelp = ["--help", "-h"].some((flag) => parameters.includes(flag));
  const options = [
    ...tables.flatMap(optionsOf),
    ...ownOptions(name, own),
    ...(spec.more?.(isHelp ? [] : parameters) ?? []),
    ...ownOptions(name, { json: null, help: null }),
  ];
  if (isHelp) {
    io.write(help(name, operands, options));
    return 0;
  }
  const { asked, ...given } = orExit(2, () => {
    const line = parse(parameters, operands, options);
    const { values, operands: given } = line;
    return {
      ...line,
      asked: spec.ask?.(values, given, io) ?? readFlags(name, typed(name, values)),
    };
  });
  const { values } = given;
  const format = values.out && formatOf(values.out);
  for (const { flag, isWritten } of options) {
    if (isWritten && values[flag] !== undefined) checkOutput(values[flag]);
  }
  const session = await open();
  /** @type {Perform} */
  const perform = (command, fields) => performIn(session, command, fields);
  /** @type {Call} */
  const call = { perform, asked, ...given, io, loaded: null };
  const mesh = operands[0] === "MESH" && readMesh(perform, given.operands[0], io);
  if (mesh) call.loaded = load ? load(call, mesh) : perform("load", mesh);
  const { result, text, files = {}, exit = 0 } = orExit(spec.refusal ?? 3, () => run(call));
  // What works on a broken surface as it is says so; `info` lists that itself.
  const repairs = name === "info" ? [] : wanting(call.loaded?.info?.repairs);
  if (repairs.length > 0) io.log(repairs.join("\n"));
  if (format) {
    const losses = perform("losses", { format });
    writeOutput(values.out, perform("export", { format }));
    for (const loss of losses) io.log(say(loss));
  }
  for (const [flag, content] of Object.entries(files)) {
    if (values[flag] !== undefined) writeOutput(values[flag], content());
  }
  io.write(values.json ? `${JSON.stringify(result)}\n` : (text ?? print(result)));
  return exit;
}
