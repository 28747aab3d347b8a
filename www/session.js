// The solver's wasm `Session` by commands: what may be asked, and what is answered, is said in
// generated/types.d.ts.

import { numberAs } from "./numbers.js";

/** @import { RunAnswer, RunCommand, Status, ToolAnswer, ToolCommand } from "./generated/types.js" */
/** @import { Session } from "./pkg/solver/solver.js" */

/** @template T @typedef {T extends unknown ? keyof T : never} KeyOf */
/** @typedef {RunCommand | ToolCommand} Command */
/** @typedef {KeyOf<Command>} CommandName */
/** @template {CommandName} N @typedef {Extract<Command, Record<N, any>>[N]} FieldsOf */
/**
 * Of what is asked for, what is left out has its default.
 * @template T
 * @typedef {T extends ArrayBufferView ? T : T extends (infer E)[] ? E[] : T extends object ? { [K in keyof T]?: Loose<T[K]> } : T} Loose
 */
/** @template {CommandName} N @typedef {Extract<RunAnswer | ToolAnswer, Record<N, any>>[N]} AnswerOf */

/**
 * @template {CommandName} N @param {Session} session @param {N} name
 * @param {Loose<FieldsOf<N>>} [fields] @returns {AnswerOf<N>}
 * @throws {import("./generated/types.js").Fault}
 */
export function perform(session, name, fields) {
  const answer = session.perform({ [name]: fields ?? {} })[name];
  if (answer?.numbers) numberAs(answer.numbers);
  return answer;
}

/** Whether a run came to its end, of its own accord or at a limit. @param {Status} status */
export const isOver = (status) => status !== "ready";
