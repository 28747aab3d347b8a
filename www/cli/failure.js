// How a command ends when it does not end well: one shape, three exit codes.

/** @typedef {import("../generated/types.js").Fault} Fault */
import { sayFault } from "../words.js";
import { repairInWords } from "./text.js";

/** @typedef {import("../generated/types.js").Fault} Refusal */

/** Bad usage, refused input or numerical failure, in words. */
export class Failure extends Error {
  /**
   * @param {2 | 3 | 4} exit @param {string} kind @param {string} message @param {string} hint
   * @param {readonly { kind: string, count: number, message: string }[]} [repairs]  what would help
   */
  constructor(exit, kind, message, hint, repairs = []) {
    super(message);
    this.exit = exit;
    this.kind = kind;
    this.hint = hint;
    this.repairs = repairs;
  }
}

/** @param {string} message @param {string} [hint] */
export function usage(message, hint = "") {
  return new Failure(2, "Usage", message, hint);
}

/**
 * Calls the solver and says which exit code its refusal would mean.
 * @template T @param {2 | 3 | 4} exit @param {() => T} call @returns {T}
 */
export function orExit(exit, call) {
  try {
    return call();
  } catch (error) {
    if (!isRefusal(error)) throw error;
    const { kind, message, hint } = sayFault(error);
    const repairs = (error.repairs ?? []).map(repairInWords);
    const way = "`umbilic repair MESH --out FILE` writes such a surface.";
    throw new Failure(exit, kind, message, repairs.length > 0 ? `${hint} ${way}` : hint, repairs);
  }
}

/**
 * What a command ends with after `error`. Anything but a refusal in words is a defect
 * of ours and is thrown on, stack and all.
 * @param {unknown} error @returns {Failure}
 */
export function failureOf(error) {
  if (error instanceof Failure) return error;
  if (error instanceof WebAssembly.RuntimeError) {
    const hint = "This is a defect of the solver; the mesh and the options will reproduce it.";
    return new Failure(4, "Crashed", `The solver crashed: ${error.message}.`, hint);
  }
  throw error;
}

/** @param {unknown} error @returns {error is Refusal} */
export function isRefusal(error) {
  return typeof error === "object" && error !== null && "kind" in error && "hint" in error;
}
