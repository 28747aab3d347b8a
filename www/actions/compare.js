// @ts-check
// What a user can ask for where flows are compared: panes, what each does otherwise, what is
// shown of them, and ready-made comparisons.

/** @import { Comparison } from "../comparison.js" */
/** @import { Options } from "../options.js" */
/** @import { Contest } from "./contest.js" */
/** @import { Core } from "./core.js" */

import { changeOf, MOST_PANES, newRival, optionsOf, timeUnitsAgree } from "../comparison.js";
import { comparisonTransitions as on } from "../comparison-state.js";
import { t } from "../language.js";
import { transitions as to } from "../state.js";

/**
 * A comparison from a link: what each pane does otherwise, and where it stands.
 * @typedef {object} Linked
 * @property {readonly { change: Partial<Options>, step: number | null }[]} panes  step: null, as the first
 * @property {Comparison["lockstep"]} lockstep
 * @property {Comparison["shown"]} shown
 * @property {Comparison["difference"]} difference
 */

/** @param {Core} core @param {Contest} contest */
export function createCompare({ store, voice, enqueue, rest, configure, arrange }, contest) {
  let lastId = 0;
  /** @param {Partial<Options>} change */
  function born(change) {
    lastId += 1;
    return newRival(lastId, change);
  }

  /** One of them side by side is enough. */
  async function clearStage() {
    if (store.get().arrangement.compare !== "none") await arrange({ compare: "none" });
  }

  /** Times of different units cannot be kept in step. */
  function keepUnits() {
    const { options, comparison } = store.get();
    const { rivals, lockstep } = comparison;
    const all = [options, ...rivals.map(({ change }) => optionsOf(options, change))];
    if (lockstep === "time" && !timeUnitsAgree(all)) {
      store.update(on.compared, { lockstep: "step" });
      voice.answer(t("Times of these flows have different units: the panes now go by step."));
    }
  }

  /** Lets those behind come to where the first of all stands. */
  function catchUp() {
    keepUnits();
    const { lockstep } = store.get().comparison;
    const most = Math.max(...contest.standings().map((one) => one[lockstep]));
    if (most === 0) return;
    store.update(to.started, null);
    contest.play((one) => one[lockstep] >= most);
  }

  function close() {
    store.update(on.compared, { rivals: [] });
    contest.dismiss();
  }

  const actions = {
    /** One pane more, which does as the first does. */
    addPane: () =>
      enqueue(async () => {
        await rest();
        const { comparison, reading } = store.get();
        if (!reading || comparison.rivals.length >= MOST_PANES - 1) return;
        await clearStage();
        const rival = born({});
        store.update(on.compared, { rivals: [...comparison.rivals, rival] });
        await contest.follow([rival.id]);
        catchUp();
      }),

    /** @param {number} id */
    removePane: (id) =>
      enqueue(async () => {
        await rest();
        const { rivals, shown, difference } = store.get().comparison;
        const gone = 1 + rivals.findIndex((one) => one.id === id);
        if (gone === 0) return;
        /** @param {number} n */
        const moved = (n) => (n > gone ? n - 1 : n);
        store.update(on.compared, {
          rivals: rivals.filter((one) => one.id !== id),
          shown: shown === "side" || shown === gone ? "side" : moved(shown),
          difference: difference === null || difference === gone ? null : moved(difference),
        });
        contest.dismiss();
        await contest.show();
      }),

    closeComparison: () =>
      enqueue(async () => {
        await rest();
        close();
        await contest.show();
      }),

    /**
     * What a pane does otherwise; it begins anew and comes to where the others stand.
     * @param {number} id @param {Partial<Options>} edit
     */
    changePane: (id, edit) =>
      enqueue(async () => {
        await rest();
        const { options, comparison } = store.get();
        const rival = comparison.rivals.find((one) => one.id === id);
        if (!rival) return;
        const before = optionsOf(options, rival.change);
        const change = changeOf(options, optionsOf(before, edit));
        try {
          await contest.begin(id, change);
        } catch (error) {
          // Told again, so that the form shows what is in force.
          const { rivals } = store.get().comparison;
          store.update(on.compared, {
            rivals: rivals.map((one) => ({ ...one, change: { ...one.change } })),
          });
          throw error;
        }
        await contest.settle();
        catchUp();
      }),

    /**
     * A ready-made comparison.
     * @param {{ main: Partial<Options>, panes: readonly Partial<Options>[] }} preset
     */
    preset: ({ main, panes }) =>
      enqueue(async () => {
        await rest();
        const { options, comparison } = store.get();
        await clearStage();
        store.update(on.compared, { ...comparison, rivals: panes.map(born) });
        try {
          await configure(optionsOf(options, main));
          keepUnits();
        } catch (error) {
          store.update(on.compared, comparison);
          contest.dismiss();
          throw error;
        }
      }),

    /** @param {Pick<Comparison, "lockstep">} change */
    lockstep: (change) => enqueue(async () => store.update(on.compared, change)),
    /** @param {Partial<Pick<Comparison, "quantity" | "abscissa">>} change */
    plotPanes: (change) => store.update(on.compared, change),
    /** Colours all panes by the distance to one of them. @param {number | null} difference */
    difference: (difference) =>
      enqueue(async () => {
        store.update(on.compared, { difference });
        await contest.show();
      }),

    /** The first pane in the place of all, then the second, and so on. */
    flip() {
      const { shown } = store.get().comparison;
      if (contest.isOpen()) store.update(on.compared, { shown: shown === 0 ? 1 : 0 });
      else voice.answer(t("There is no pane to flip to yet: add one under “Compare flows”."));
    },
    sideBySide: () => store.update(on.compared, { shown: "side" }),
  };

  return {
    actions,
    close,
    /** Before the flow of a link is configured. @param {Linked | null | undefined} linked  null: nothing is compared any more */
    prepare(linked) {
      if (linked === undefined) return;
      close();
      if (!linked) return;
      const { panes, lockstep, shown, difference } = linked;
      const rivals = panes.map(({ change }) => born(change));
      store.update(on.compared, { rivals, lockstep, shown, difference });
    },
  };
}
