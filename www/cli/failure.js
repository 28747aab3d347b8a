// How a command ends when it does not end well: one shape, three exit codes.

import { say, sayFault } from "../words.js";
import { repairInWords } from "./text.js";

/**
 * Bad usage, refused input or numerical failure, in words; `repairs` is what would help.
 * @typedef {object} Failure
 * @property {2 | 3 | 4} exit
 * @property {string} kind
 * @property {string} message
 * @property {string} hint
 * @property {ReturnType<typeof repairInWords>[]} [repairs]
 */

/** @type {Record<string, 2 | 3 | 4>} */
const exits = { Usage: 2, NotBuilt: 2, Unreadable: 3, BadSelection: 3, Crashed: 4 };

/**
 * What the command line itself refuses; not all of it has a hint.
 * @param {string} id  of the words @param {Record<string, unknown>} [values]
 * @param {string} [kind] @returns {Failure}
 */
export function refused(id, values = {}, kind = "Usage") {
  const hint = say(`${id}.hint`, values);
  const isSaid = hint !== `${id}.hint`;
  return { exit: exits[kind], kind, message: say(id, values), hint: isSaid ? hint : "" };
}

/**
 * What a command ends with. Anything but a refusal is a defect of ours and is thrown on, stack and
 * all.
 * @param {2 | 3 | 4} exit  where the solver refuses @param {any} error @returns {Failure}
 */
export function failed(exit, error) {
  if (error?.exit) return error;
  if (error instanceof WebAssembly.RuntimeError) {
    return refused("failure-crashed", { reason: error.message }, "Crashed");
  }
  if (!error?.kind) throw error;
  const { kind, message, hint } = sayFault(error);
  if (!error.repairs) return { exit, kind, message, hint };
  const repairs = error.repairs.map(repairInWords);
  return { exit, kind, message, hint: `${hint} ${say("repair-way")}`, repairs };
}

/**
 * Does what may fail, and says what it comes to then.
 * @template T @param {() => T} work @param {(error: any) => Failure} told @returns {T}
 */
export function attempt(work, told) {
  try {
    return work();
  } catch (error) {
    throw told(error);
  }
}

/**
 * Calls the solver where its refusal is not one of the input, as it is otherwise.
 * @template T @param {2 | 3 | 4} exit @param {() => T} call @returns {T}
 */
export const orExit = (exit, call) => attempt(call, (error) => failed(exit, error));
