// How a command ends when it does not end well: one shape, three exit codes.

import { sayFault } from "../words.js";
import { repairInWords } from "./text.js";

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

/** A refusal with its exit code; another error as it is. @param {2 | 3 | 4} exit @param {unknown} error */
export function failed(exit, error) {
  if (!isRefusal(error)) return error;
  const { kind, message, hint } = sayFault(error);
  const repairs = (error.repairs ?? []).map(repairInWords);
  const way = "`umbilic repair MESH --out FILE` writes such a surface.";
  return new Failure(exit, kind, message, repairs.length > 0 ? `${hint} ${way}` : hint, repairs);
}

/**
 * Calls the solver and says which exit code its refusal would mean.
 * @template T @param {2 | 3 | 4} exit @param {() => T} call @returns {T}
 */
export function orExit(exit, call) {
  try {
    return call();
  } catch (error) {
    throw failed(exit, error);
  }
}

/** @param {unknown} error @returns {error is Refusal} */
export const isRefusal = (error) =>
  typeof error === "object" && error !== null && "kind" in error && "hint" in error;
