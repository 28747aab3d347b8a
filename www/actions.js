// What a user can ask for. Nothing here touches the document.

import { createCore } from "./actions/core.js";
import { createEdit } from "./actions/edit.js";
import { createOpen } from "./actions/open.js";
import { createRun } from "./actions/run.js";
import { createWhy } from "./actions/why.js";
import { createNotes } from "./notes.js";

/** @import { Mode, Store, Tab } from "./store.js" */

/**
 * Actions that are fetched when the first of them is asked for.
 * @template {Record<string, (...given: any[]) => unknown>} T @param {() => Promise<T>} load
 * @returns {{ [K in keyof T]: (...given: Parameters<T[K]>) => Promise<Awaited<ReturnType<T[K]>>> }}
 */
function deferred(load) {
  /** @type {Promise<T> | undefined} */
  let made;
  /** @param {unknown} _ @param {string} name @returns {(...given: any[]) => Promise<any>} */
  const get =
    (_, name) =>
    async (...given) => {
      // Without a connection now, there may be one when it is asked for again.
      made ??= load().catch((error) => {
        made = undefined;
        throw error;
      });
      return (await made)[name](...given);
    };
  return new Proxy(/** @type {any} */ ({}), { get });
}

/** @param {Store} store @param {Parameters<typeof createCore>[2]} environment */
export function createPage(store, environment) {
  const notes = createNotes(store);
  const core = createCore(store, notes, environment);
  const edits = createEdit(core);
  const run = createRun(core, edits.adopt);
  const compare = deferred(() =>
    import("./actions/compare.js").then(({ createCompare }) => createCompare(core)),
  );
  const open = createOpen(core, run, compare);
  const why = createWhy(core, edits, run);
  return { ...core, run, open, compare, why, edit: edits.edit };
}

/**
 * What the views have beside that; see main.js.
 * @typedef {object} Views
 * @property {import("./view/stage.js").Stage} stage
 * @property {import("@preact/signals-core").Signal<boolean>} keysOn
 * @property {import("@preact/signals-core").Signal<({ id: string } & import("./library.js").Finding) | null>} finding
 *   of the figure that was last judged
 * @property {() => void} chooseFile
 * @property {(tab: Tab) => void} turn
 * @property {(mode: Mode) => void} tool
 * @property {(on?: boolean) => void} present
 */

/** @typedef {ReturnType<typeof createPage> & Views} Page */
/** @typedef {Page["compare"]} Compare */
