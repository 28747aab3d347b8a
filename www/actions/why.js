// @ts-check
// Why the flow stands as it does, and what helps.

/** @import { Remedy } from "../generated/types.js" */
/** @import { Core } from "./core.js" */

import { t } from "../language.js";
import { stepsOf } from "./edits.js";

/**
 * @param {Core} core
 * @param {ReturnType<typeof import("./edits.js").createEdits>} edits
 * @param {(until: number | null) => Promise<void>} run
 */
export function createWhyActions(core, edits, run) {
  const { store, solver, enqueue, rest, configure } = core;
  const goOn = () => run(null);

  /** Other options, from the start or from the surface as it is. @param {Remedy} remedy */
  async function change(remedy) {
    const { options, reading } = store.get();
    const wanted = { ...options, ...remedy.change };
    if (remedy.fromStart || !reading || reading.step === 0) await configure(wanted);
    else await edits.adopt(wanted, stepsOf(reading.step));
  }

  /** All flips that gain anything, and back to the flow. */
  async function flip() {
    const { options, reading, arrangement } = store.get();
    const flips = /** @type {const} */ ({ flow: "flips", criterion: "localised" });
    await edits.adopt({ ...options, ...flips }, stepsOf(reading?.step ?? 0));
    await solver.arrange({ ...arrangement, flipsPerStep: null });
    await solver.step();
    await solver.arrange(arrangement);
    await edits.adopt(options, t("the edge flips"));
  }

  /** @param {number} steps */
  async function back(steps) {
    for (let n = 0; n < steps && store.get().reading?.canStepBack; n += 1) await solver.back();
  }

  return {
    why: () => solver.why(),

    /**
     * Carries a remedy out, and goes on with the flow. A study is the page's own.
     * @param {Remedy} remedy
     */
    async remedy(remedy) {
      if (remedy.id === "regularise") {
        if (remedy.fromStart) await enqueue(() => rest().then(() => change(remedy)));
        await edits.actions.regularise();
      }
      if (remedy.id === "subdivide") await edits.actions.subdivide("loop");
      return enqueue(async () => {
        await rest();
        if (!store.get().reading) return;
        if (remedy.id === "back") return back(remedy.steps);
        if (remedy.id === "keepAndFlips") await flip();
        else if (Object.keys(remedy.change).length > 0) await change(remedy);
        await goOn();
      });
    },

    /**
     * The surface to be studied, as a file: a study has a solver of its own, and the flow goes on.
     * @returns {Promise<{ name: string, bytes: ArrayBuffer }>}
     */
    async presentSurface() {
      const { bytes } = await solver.export("ply");
      return { name: "surface.ply", bytes: bytes.buffer };
    },
  };
}
