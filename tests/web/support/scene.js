// @ts-check
// The scene of a link, its options read by the solver. Needs the wasm build.

import { loadSolver } from "../../../www/cli/solver.js";
import { readLink, sceneOf } from "../../../www/link.js";

const { readOptions } = await loadSolver();

/**
 * @param {{ search: string, hash: string }} address
 * @throws {import("../../../www/generated/types.js").Fault} of an option that cannot be
 */
export function readScene(address) {
  const link = readLink(address);
  return sceneOf(link, readOptions(link.asked));
}
