// How a command ends when it does not end well: one shape, three exit codes.

import { sayFault } from "../words.js";
import { repairInWords, repairWay } from "./text.js";

/** @typedef {import("../generated/types.js").Fault} Refusal */

/** Bad usage, refused input or numerical failure, in words. */
export class Failure extends Error {
  /**
   * @param {2 | 3 | 4} exit @param {string} kind @param {string} message @param {string} [hint]
   * @param {readonly ReturnType<typeof repairInWords>[]} [repairs]  what would help
   */
  constructor(exit, kind, message, hint = "", repairs = []) {
    super(message);
    this.exit = exit;
    this.kind = kind;
    this.hint = hint;
    this.repairs = repairs;
  }
}

/** @param {string} message @param {string} [hint] */
export const usage = (message, hint) => new Failure(2, "Usage", message, hint);

/** @param {unknown} error @returns {error is Refusal} */
export const isRefusal = (error) =>
  typeof error === "object" && error !== null && "kind" in error && "hint" in error;

/**
 * What a command ends with. Anything but a refusal in words is a defect of ours and is thrown on,
 * stack and all.
 * @param {2 | 3 | 4} exit  where the solver refuses @param {unknown} error
 */
export function failed(exit, error) {
  if (error instanceof Failure) return error;
  if (error instanceof WebAssembly.RuntimeError) {
    const hint = "This is a defect of the solver; the mesh and the options will reproduce it.";
    return new Failure(4, "Crashed", `The solver crashed: ${error.message}.`, hint);
  }
  if (!isRefusal(error)) throw error;
  const { kind, message, hint } = sayFault(error);
  const repairs = (error.repairs ?? []).map(repairInWords);
  const way = repairs.length > 0 ? `${hint} ${repairWay}` : hint;
  return new Failure(exit, kind, message, way, repairs);
}

/**
 * Does what may fail, and says in words that it did.
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
 * @template T @param {2 | 4} exit @param {() => T} call @returns {T}
 */
export const orExit = (exit, call) => attempt(call, (error) => failed(exit, error));
