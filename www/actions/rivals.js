// @ts-check
// The solvers of the flows beside the page's own, a worker each: made, put at the start,
// replaced when they are lost, and ended with their panes.

/** @import { Field, Frame } from "../state.js" */
/** @import { FieldName } from "../state.js" */
/** @import { Options } from "../options.js" */
/** @import { Solver } from "../solver.js" */

import { LOST } from "../channel.js";
import { optionsOf, paneOf } from "../comparison.js";
import { comparisonTransitions as on } from "../comparison-state.js";
import { t } from "../language.js";
import { createSolver, withSelection } from "../solver.js";
import { transitions as to } from "../state.js";
import { say } from "../words.js";

/**
 * @param {object} page
 * @param {import("../state.js").Store} page.store
 * @param {Solver} page.solver  the page's own, which has the mesh
 * @param {import("../controller.js").Voice} page.voice
 * @param {(error: unknown) => void} page.report
 * @param {(id: number, frame: Frame) => void} page.onFrame
 */
export function createRivals({ store, solver, voice, report, onFrame }) {
  /** @type {Map<number, { solver: Solver, mesh: unknown }>} */
  const rivals = new Map();
  /** Fields as the solvers gave them, before they share a scale. @type {Map<number, Field | null>} */
  const fields = new Map();
  /** Whose answer is waited for. @type {Set<number>} */
  const busy = new Set();
  /** Whose solver was lost in this run: it would be lost again. @type {Set<number>} */
  const out = new Set();

  /** @param {number} id */
  const nameOf = (id) => paneOf(store.get().comparison, id);

  /** A new worker, with all that the old one had. @param {number} id @param {string} reason  why that is no more */
  async function revive(id, reason) {
    out.add(id);
    store.update(on.rivalLost, id, t("Its solver stopped: {reason}", { reason }));
    const own = rivals.get(id)?.solver;
    if (!own) return;
    const pane = nameOf(id);
    try {
      const reading = await own.revive();
      if (!reading) throw new Error("There was no mesh yet.");
      store.update(on.rivalRevived, id, reading);
      voice.error({
        message: t(
          "The solver of pane {pane} stopped ({reason}); a new one stands at step {step}. The other panes go on.",
          { pane, reason, step: reading.step },
        ),
        hint: t("Play or Step takes the pane along again; Remove closes it."),
      });
    } catch (error) {
      // Unless its pane was closed or its solver ended meanwhile.
      if (!rivals.has(id) || /** @type {any} */ (error)?.kind === LOST) return;
      voice.error({
        message: t("The solver of pane {pane} could not be started again ({reason}).", {
          pane,
          reason,
        }),
        hint: t("Reset tries once more; the other panes go on without it."),
      });
    }
  }

  /** @param {number} id */
  function employ(id) {
    const made = createSolver({
      onReady() {},
      onStopped() {},
      onProgress({ stage, fraction }) {
        if (busy.has(id)) store.update(to.progress, { stage, fraction, pane: nameOf(id) });
      },
      onSilent(isSilent) {
        const told = isSilent
          ? { stage: say("solver-silent"), fraction: 0, pane: nameOf(id) }
          : null;
        if (busy.has(id)) store.update(to.progress, told);
      },
      onCrashed: (reason) => revive(id, reason),
      onFrame(frame) {
        fields.set(id, frame.field);
        onFrame(id, frame);
      },
    });
    const rival = { solver: made, mesh: /** @type {unknown} */ (null) };
    rivals.set(id, rival);
    return rival;
  }

  /** @param {Partial<Options>} change */
  function wanted(change) {
    const { options, mesh } = store.get();
    // A mesh that was edited goes over as a file.
    return withSelection(optionsOf(options, change), mesh);
  }

  return {
    fields,
    busy,
    out,

    /** @param {number} id */
    solverOf: (id) => rivals.get(id)?.solver,

    /**
     * Puts a rival at the start, with a mesh if it has none.
     * @param {number} id @param {Partial<Options>} change
     */
    async begin(id, change) {
      const { mesh, colour, comparison } = store.get();
      const isLost = comparison.rivals.find((one) => one.id === id)?.phase === "lost";
      const rival = rivals.get(id) ?? employ(id);
      out.delete(id);
      busy.add(id);
      try {
        if (rival.mesh !== mesh || isLost) {
          const origin = solver.origin();
          if (!origin) return;
          store.update(on.rivalLoading, id);
          await rival.solver.same(origin);
        }
        const configured = await rival.solver.configure(wanted(change));
        if (rival.mesh !== mesh || isLost) {
          // There is no field to colour by before there is a flow.
          fields.set(id, await rival.solver.colour(colour));
          rival.mesh = mesh;
        }
        store.update(on.rivalConfigured, id, change, configured);
      } finally {
        busy.delete(id);
      }
    },

    /** What could not begin stays in its pane, saying why. @param {number} id @param {any} error */
    unfit(id, error) {
      if (error?.kind === LOST) return;
      if (!error?.kind) report(error);
      const reason = String(error?.message ?? error);
      store.update(on.rivalLost, id, reason);
      const message = t("Pane {pane}: {reason}", { pane: nameOf(id), reason });
      voice.error({ message, hint: error?.hint ?? "" });
    },

    /** Ends the solvers of panes that are no more. */
    dismiss() {
      const ids = store.get().comparison.rivals.map(({ id }) => id);
      for (const [id, rival] of [...rivals]) {
        if (ids.includes(id)) continue;
        rivals.delete(id);
        fields.delete(id);
        rival.solver.dismiss();
      }
    },

    /** @param {FieldName} name */
    colour: (name) =>
      Promise.all(
        [...rivals].map(async ([id, rival]) => {
          if (rival.mesh) fields.set(id, await rival.solver.colour(name).catch(() => null));
        }),
      ),

    /** Ends a step that takes too long. @param {number} id */
    halt(id) {
      rivals.get(id)?.solver.dismiss();
      revive(id, t("it was ended"));
    },
  };
}
