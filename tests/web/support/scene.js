// @ts-check
// Links read and written by the solver. Needs the wasm build.

import { openSession } from "../../../www/cli/solver.js";
import { linkIn, pageScene, sceneOf } from "../../../www/link.js";
import { perform } from "../../../www/session.js";

const reader = await openSession();

/**
 * The scene of a link.
 * @param {{ search: string, hash: string }} address
 * @throws {import("../../../www/generated/types.js").Fault} of an option that cannot be
 */
export const readScene = (address) => sceneOf(perform(reader, "readLink", linkIn(address)));

/**
 * A page's scene as a link.
 * @param {import("../../../www/pkg/solver/solver.js").Session} session  that stands where it does
 * @param {any} state  of the page
 * @param {boolean} [shared]
 */
export const writeScene = (session, state, shared = false) =>
  perform(session, "writeLink", { scene: pageScene(state, shared) });
