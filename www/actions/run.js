// Playing, stepping, going back; which flow, and with what.

import { optionsOf } from "../comparison.js";
import { defaults } from "../options.js";
import { isEditing } from "../store.js";
import { say } from "../words.js";

/** @import { Arrangement } from "../generated/types.js" */
/** @import { Options } from "../options.js" */
/** @import { FieldName, View } from "../store.js" */
/** @import { Core } from "./core.js" */

/** What going on from a surface takes back when it is undone. @param {number} count */
export const stepsOf = (count) => say("count-steps", { count });

/** @param {Core} core @param {(options: Options, what: string) => Promise<void>} adopt  makes the surface the start */
export function createRun(core, adopt) {
  const { get, patch, notes, solver, player, lead, enqueue, atRest, settle } = core;

  const isUsable = () => get().reading !== null && get().phase === "ready";
  const isMoving = () => get().running || !core.isStill();
  const isAtEnd = () => lead.u >= lead.clip.total * (1 - 1e-9);
  /** Whether anybody has steps to take. */
  const maySolve = () =>
    !core.isOver() || (lead.clip.last?.state.status === "stepLimit" && isAtEnd());
  /** The solvers of all panes. */
  const all = () => [solver, ...get().comparison.rivals.map((rival) => rival.solver)];
  async function play() {
    if (!isUsable() || isMoving()) return;
    patch({ welcome: false, isNew: false, mode: null, preview: null });
    await core.mend();
    const { figure, film, comparison } = get();
    const isNewFilm = figure?.back && film === null && comparison.rivals.length === 0;
    if (isNewFilm) patch({ film: "back" });
    if (isNewFilm || film === "back") {
      await core.run();
      await core.beside.run();
    } else if (!maySolve() && isAtEnd()) player.begin(true);
    else {
      if (maySolve()) await core.run();
      await core.beside.run();
      player.begin();
    }
  }

  const moves = {
    /** Each press is a step. */
    async step() {
      const next = lead.clip.points[core.shownIndex() + 1];
      if (next) return solver.seek(next.state.step);
      const { film, figure } = get();
      // Behind the half that is shown backwards comes the other one.
      if (film && figure) await solver.turn(figure.id, false);
      return core.stoppable(() => Promise.all(all().map((one) => one.ask("step"))), all());
    },
    async back() {
      const before = lead.clip.points[core.shownIndex() - 1];
      if (before) await solver.seek(before.state.step);
      else if (get().film === null && get().reading?.canStepBack) await solver.ask("back");
    },
    async reset() {
      await core.mend();
      if (get().film) return void (await solver.seek(lead.clip.points[0].state.step));
      core.anew(true);
      for (const rival of get().comparison.rivals) {
        rival.clip.clear();
        rival.u = 0;
      }
      await Promise.all(all().map((one) => one.ask("reset")));
    },
    /** Shows a stored step. @param {number} step */
    seek: (step) => solver.seek(step),
    /** Starts, and pauses by itself there; the display follows at once. @param {number} step */
    runTo(step) {
      patch({ running: true, goal: step });
      return solver.run(step);
    },
    /** @param {number} id */
    async branch(id) {
      core.anew(true);
      await solver.ask("branch", { branch: id });
      await core.refill();
    },
  };

  const { configure } = atRest({
    /** @param {Partial<Options>} change @param {{ fromStart?: boolean }} [how] */
    async configure(change, { fromStart = false } = {}) {
      const { options: before, reading, applies, comparison } = get();
      const options = optionsOf(before, change);
      const isUnderWay = reading !== null && reading.step > 0;
      if (before.flow === "flips" && options.flow !== "flips" && isUnderWay) {
        // The point of better edges is what is done with them next.
        await adopt(options, say("count-flips", { count: reading.step }));
        return notes.answer(say("flips-adopted"));
      }
      const isFlips = [before.flow, options.flow].includes("flips");
      const isAlone = comparison.rivals.length === 0;
      const isHere = applies === "here" && !fromStart && isUnderWay && !isFlips && isAlone;
      await core.configure(options, isHere ? "continueWith" : "configure");
    },
  });

  const run = {
    play: () => enqueue(play),
    pause() {
      if (player.motion.peek() === "playing") player.rest(lead.clip.nearest(lead.u));
      else if (get().running) core.show(core.shown()?.step ?? 0);
      return enqueue(settle);
    },
    /** A tool is ended by its own buttons. */
    toggle: () => (isMoving() ? run.pause() : isEditing(get()) ? undefined : run.play()),
    ...atRest(moves, isUsable),

    /** While the scrubber is held. @param {number} u */
    scrub(u) {
      if (!core.isStill()) player.stop();
      player.place(u);
    },
    /** It was let go. */
    scrubbed() {
      player.rest(lead.clip.nearest(lead.u));
      return enqueue(settle);
    },
    loop() {
      player.loops.value = !player.loops.peek();
    },

    configure,
    /** What an opened mesh is for: noise taken off it, or all that bends. @param {"smooth" | "relax"} goal */
    async aim(goal) {
      patch({ isNew: false });
      await run.configure({ flow: "circle", goal });
      await run.play();
    },
    /** Everything as usual, but for flow and surface. */
    recommend() {
      const { flow, boundary, free, fixed, p, keep } = get().options;
      return run.configure({ ...defaults, flow, boundary, free, fixed, p, keep });
    },
    /** How edge flips are shown. @param {Partial<Arrangement>} change */
    arrange: (change) => enqueue(() => run.arranged(change)),
    /** @param {Partial<Arrangement>} change */
    async arranged(change) {
      const arrangement = { ...get().arrangement, ...change };
      patch({ arrangement });
      await solver.ask("arrange", { arrangement });
    },
    /** @param {FieldName} name */
    colour: (name) =>
      enqueue(async () => {
        const isOn = isMoving();
        const { goal } = get();
        // All steps are coloured anew, for which the solver goes through them.
        await core.rest();
        patch({ comparison: { ...get().comparison, difference: null } });
        await core.colour(name);
        if (isOn) await (goal === null ? play() : moves.runTo(goal));
      }),
    /** @param {Partial<View>} change */
    view: (change) => patch({ view: Object.freeze({ ...get().view, ...change }) }),

    /** Gives up the step or the edit in hand: whether there is one. */
    giveUp: core.giveUp,
    /** Ends a step that takes too long, or a solver that is silent; starts one that is gone. */
    halt: () => core.revive((step) => ({ id: "solver-ended", values: { step } })),

    /**
     * @param {string} format  of a mesh, or `csv`
     * @returns {Promise<{ format: string, bytes: Uint8Array<ArrayBuffer> | string }>}  the format
     *   is another where the solver cannot be asked
     */
    async export(format) {
      // What was asked for before may still have to put the solver where the display stands; one
      // that says nothing, or is on its way back, could not be.
      if (isUsable() && !get().isSilent) await run.pause();
      if (format === "csv") return { format, bytes: await solver.ask("history") };
      const file = await solver.export(format);
      if (file.format !== format) notes.answer(say("saved-own-copy"));
      for (const loss of file.losses) notes.note(say(loss), loss.id);
      return file;
    },
  };
  return run;
}
