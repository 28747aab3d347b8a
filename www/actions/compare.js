// Flows beside that of the page: a worker and a clip each. They solve at their own pace; the
// player shows them in step.

import { LOST } from "../channel.js";
import { Clip } from "../clip.js";
import { changeOf, MOST_PANES, optionsOf, timeUnitsAgree } from "../comparison.js";
import { isRead } from "../options.js";
import { createSolver, withSelection } from "../solver.js";
import { alone } from "../store.js";
import { faultOf, say } from "../words.js";
import { take } from "./core.js";

/** @import { Scene } from "../link.js" */
/** @import { Options } from "../options.js" */
/** @import { Comparison, Rival } from "../store.js" */
/** @import { Core } from "./core.js" */

/** @typedef {"flow" | "p" | "regularise" | "scheme" | "then"} Contrast */

/** What a second pane does otherwise at first: the first that makes sense. @type {Record<string, readonly Partial<Options>[]>} */
const contrasts = {
  flow: [{ flow: "mean-curvature" }, { flow: "circle" }],
  p: [4, 2].map((p) => ({ flow: "p-willmore", p })),
  regularise: [
    { flow: "p-willmore", regularise: "off", remesh: "off" },
    { flow: "p-willmore", regularise: "nonlinear", remesh: "off" },
  ],
  scheme: [{ scheme: "paper" }, { scheme: "auto" }],
};

/** Flows of panes that are added, in this order. @type {Options["flow"][]} */
const others = ["circle", "mean-curvature", "p-willmore", "surface-diffusion", "willmore"];

/** @param {Core} core */
export function createCompare(core) {
  const { get, patch, notes, player, lead, solver } = core;
  const rivals = () => get().comparison.rivals;
  let lastId = 0;

  /** @param {Partial<Comparison>} change */
  const compared = (change) => patch({ comparison: { ...get().comparison, ...change } });
  /** @param {Rival} rival @param {Partial<Rival>} change */
  function changed(rival, change) {
    Object.assign(rival, change);
    compared({});
  }
  /** What all panes do. */
  const allOptions = () => {
    const { options } = get();
    return [options, ...rivals().map(({ change }) => optionsOf(options, change))];
  };

  /** @param {Rival["change"]} change */
  function employ(change) {
    const clip = new Clip();
    lastId += 1;
    /** @type {Rival} */
    const rival = {
      ...{ clip, u: 0, id: lastId, change, phase: "loading", reason: "", running: false },
      ...{ reading: null, held: null, mesh: null, isOpen: () => rival.running },
      solver: createSolver({
        onCrashed(reason) {
          changed(rival, { phase: "lost", reason, running: false });
          notes.error({ message: say("pane-lost", { reason }), hint: say("pane-lost.hint") });
        },
        onStopped(reading, fault) {
          changed(rival, { reading, running: false, reason: fault?.message ?? "" });
          if (clip.last?.state.step === reading.step) clip.last.state = reading;
          player.place(lead.u);
        },
        onFrame(frame) {
          take(rival, frame, false);
          if (!frame.stored) changed(rival, { reading: frame.state });
          if (core.isStill()) player.place(lead.u);
        },
      }),
    };
    return rival;
  }

  /** Puts a pane at the start. @param {Rival} rival @param {Rival["change"]} change */
  async function begin(rival, change) {
    const { clip, solver: own } = rival;
    const { mesh, options, colour } = get();
    const origin = solver.origin();
    if (!mesh || !origin) return;
    changed(rival, { phase: "loading", change, running: false, u: 0 });
    clip.clear(mesh.triangles);
    try {
      if (rival.mesh !== mesh) await own.same(origin);
      rival.mesh = mesh;
      const wanted = withSelection(optionsOf(options, change), mesh);
      const { state: reading, heldVertices: held } = await own.configure(wanted);
      const field = colour === "none" ? null : await own.ask("colour", { field: colour });
      if (clip.points[0]) clip.points[0].field = field;
      changed(rival, { phase: "ready", reason: "", reading, held });
    } catch (error) {
      const fault = faultOf(error);
      if (fault.kind === LOST) return;
      changed(rival, { phase: "lost", reason: fault.message });
      notes.error(fault);
    }
    player.place(lead.u);
  }

  /** Whose time is another cannot be kept in step by it. */
  function keepUnits() {
    const isTime = get().comparison.lockstep === "time";
    if (isTime && !timeUnitsAgree(allOptions())) compared({ lockstep: "progress" });
  }

  /** A pane from its start, as far as the first has come. @param {Rival} rival @param {Rival["change"]} change */
  async function follow(rival, change) {
    await begin(rival, change);
    keepUnits();
    const { last, points } = lead.clip;
    if (last && points.length > 1) await runOne(rival, core.isOver() ? null : last.state.step);
  }

  /** @param {Rival["change"]} change */
  async function add(change) {
    const rival = employ(change);
    compared({ rivals: [...rivals(), rival] });
    await follow(rival, change);
  }

  /** @param {Rival} rival @param {number | null} [until] */
  async function runOne(rival, until = null) {
    const { phase, clip, reading, solver: own } = rival;
    if (phase !== "ready") return;
    const { last } = clip;
    if (last && reading && last.state.step !== reading.step) await own.seek(last.state.step);
    changed(rival, { running: true });
    await own.run(until);
  }

  /** Panes that are no more. @param {readonly Rival[]} some */
  function dismiss(some) {
    for (const rival of some) rival.solver.dismiss();
    const rest = rivals().filter((rival) => !some.includes(rival));
    if (rest.length === 0) patch({ comparison: alone });
    else compared({ rivals: rest, shown: "side", difference: null });
    player.redraw();
  }
  const close = () => dismiss(rivals());

  core.beside = {
    settle: () =>
      Promise.all(
        rivals().map(async (rival) => {
          if (!rival.running) return;
          const reading = await rival.solver.ask("pause");
          changed(rival, { running: false, ...(reading && { reading }) });
        }),
      ),
    run: () => Promise.all(rivals().map((rival) => runOne(rival))),
    async follow() {
      if (get().options.flow === "flips") close();
      else await Promise.all(rivals().map((rival) => begin(rival, rival.change)));
      keepUnits();
    },
    async colour(name) {
      for (const { clip, solver: own } of rivals()) {
        for (const point of clip.points) point.field = null;
        await own.ask("colour", { field: name }).catch(() => null);
        if (clip.points.length > 0) own.stored().catch(() => {});
      }
    },
  };

  const changes = {
    /** What of a comparison is asked for at first; never a twin. @param {Contrast} what */
    async contrast(what) {
      close();
      const { options, reading } = get();
      if (what === "then") return reading && compared({ withStart: true });
      const differs = (/** @type {Partial<Options>} */ one) =>
        changeOf(options, optionsOf(options, one));
      const one = contrasts[what].find((each) => Object.keys(differs(each)).length > 0);
      if (!one) return;
      // An exponent is of a flow that reads it.
      if (differs(one).flow && what !== "flow" && !isRead(what, options))
        await core.configure(optionsOf(options, { flow: one.flow ?? options.flow }));
      await add(changeOf(get().options, optionsOf(get().options, one)));
    },
    /** One more, with the first difference that is not there yet. */
    async add() {
      const taken = allOptions().map(({ flow }) => flow);
      const flow = others.find((id) => !taken.includes(id)) ?? "mmcv";
      if (taken.length < MOST_PANES) await add({ flow });
    },
    /** @param {Rival} rival @param {Partial<Options>} edit */
    async change(rival, edit) {
      const { options } = get();
      const before = optionsOf(options, rival.change);
      const isOther = edit.flow !== undefined && edit.flow !== before.flow;
      const wanted = isOther ? optionsOf(options, edit) : { ...before, ...edit };
      await follow(rival, changeOf(options, wanted));
    },
    /** @param {Rival} rival */
    remove: (rival) => dismiss([rival]),
    close,
  };

  return {
    ...core.atRest(changes),
    /** @param {Partial<Pick<Comparison, "lockstep" | "shown" | "difference">>} change */
    show(change) {
      compared(change);
      player.place(lead.u);
    },
    /** The first pane in the place of all, then the second, and so on. */
    flip() {
      const { rivals: all, shown, withStart } = get().comparison;
      const count = 1 + all.length + (withStart ? 1 : 0);
      if (count > 1) compared({ shown: shown === "side" ? 1 : (shown + 1) % count });
      else notes.answer(say("nothing-to-flip"));
    },
    /** Before the flow of a link is configured. @param {Scene["comparison"]} linked */
    prepare(linked) {
      close();
      if (!linked) return;
      const { panes, shown, difference } = linked;
      const lockstep = linked.lockstep === "time" ? "time" : "progress";
      const made = panes.map(({ change }) => employ(change));
      compared({ rivals: made, lockstep, shown, difference });
    },
    /** Where the panes of a link stand. @param {readonly (number | null)[]} steps @param {number} main */
    runTo: (steps, main) =>
      Promise.all(
        rivals().map((rival, n) => (steps[n] ?? main) > 0 && runOne(rival, steps[n] ?? main)),
      ),
  };
}
