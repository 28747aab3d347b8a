// Flows beside that of the page: a worker and a clip each. They solve at their own pace; the
// player shows them in step.

import { LOST } from "../channel.js";
import { Clip } from "../clip.js";
import { changeOf, MOST_PANES, optionsOf, timeUnitsAgree } from "../comparison.js";
import { isRead } from "../options.js";
import { createSolver, withSelection } from "../solver.js";
import { alone } from "../store.js";
import { say, sayFault } from "../words.js";
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
  const { get, patch, notes, player, lead, rivals, solver } = core;
  let lastId = 0;

  /** @param {Partial<Comparison>} change */
  const compared = (change) => patch({ comparison: { ...get().comparison, ...change } });
  /** @param {number} id @param {Partial<Rival>} change */
  const changed = (id, change) =>
    compared({
      rivals: get().comparison.rivals.map((one) => (one.id === id ? { ...one, ...change } : one)),
    });
  /** @param {number} id */
  const rivalOf = (id) => get().comparison.rivals.find((one) => one.id === id);
  /** What all panes do. */
  const allOptions = () => {
    const { options, comparison } = get();
    return [options, ...comparison.rivals.map(({ change }) => optionsOf(options, change))];
  };

  /** @param {Rival["change"]} change @returns {Rival} */
  function fresh(change) {
    lastId += 1;
    const empty = { reason: "", running: false, reading: null, held: null };
    return { ...empty, id: lastId, change, phase: "loading" };
  }

  /** @param {number} id */
  function employ(id) {
    const own = createSolver({
      onCrashed(reason) {
        changed(id, { phase: "lost", reason, running: false });
        notes.error({ message: say("pane-lost", { reason }), hint: say("pane-lost.hint") });
      },
      onStopped(reading, fault) {
        changed(id, { reading, running: false, reason: fault?.message ?? "" });
        const { last } = track.clip;
        if (last?.state.step === reading.step) last.state = reading;
        player.place(lead.u);
      },
      onFrame(frame) {
        take(track, frame, false);
        if (!frame.stored) changed(id, { reading: frame.state });
        if (core.isStill()) player.place(lead.u);
      },
    });
    const track = {
      ...{ clip: new Clip(), u: 0, solver: own },
      isOpen: () => rivalOf(id)?.running ?? false,
      mesh: /** @type {unknown} */ (null),
    };
    rivals.set(id, track);
    return track;
  }

  /** Puts a pane at the start. @param {number} id @param {Partial<Options>} change */
  async function begin(id, change) {
    const track = /** @type {ReturnType<typeof employ>} */ (rivals.get(id) ?? employ(id));
    const { mesh, options, colour } = get();
    const origin = solver.origin();
    if (!mesh || !origin) return;
    changed(id, { phase: "loading", change, running: false });
    track.clip.clear(mesh.triangles);
    track.u = 0;
    try {
      if (track.mesh !== mesh) await track.solver.same(origin);
      track.mesh = mesh;
      const wanted = withSelection(optionsOf(options, change), mesh);
      const { state: reading, heldVertices: held } = await track.solver.configure(wanted);
      const first = track.clip.points[0];
      const field = colour === "none" ? null : await track.solver.colour(colour);
      if (first && field) first.field = field;
      changed(id, { phase: "ready", reason: "", reading, held });
    } catch (error) {
      const fault = /** @type {any} */ (error);
      if (fault?.kind === LOST) return;
      const said = typeof fault?.message === "object" ? sayFault(fault) : fault;
      const message = String(said?.message ?? error);
      changed(id, { phase: "lost", reason: message });
      notes.error({ message, hint: said?.hint ?? "" });
    }
    player.place(lead.u);
  }

  /** Whose time is another cannot be kept in step by it. */
  function keepUnits() {
    const isTime = get().comparison.lockstep === "time";
    if (isTime && !timeUnitsAgree(allOptions())) compared({ lockstep: "progress" });
  }

  /** A pane from its start, as far as the first has come. @param {number} id @param {Partial<Options>} change */
  async function follow(id, change) {
    await begin(id, change);
    keepUnits();
    const { last, points } = lead.clip;
    if (last && points.length > 1) await runOne(id, core.isOver() ? null : last.state.step);
  }

  /** @param {Partial<Options>} change */
  async function add(change) {
    const rival = fresh(change);
    compared({ rivals: [...get().comparison.rivals, rival] });
    await follow(rival.id, change);
  }

  /** @param {number} id @param {number | null} [until] */
  async function runOne(id, until = null) {
    const track = rivals.get(id);
    const rival = rivalOf(id);
    if (!track || rival?.phase !== "ready") return;
    const { last } = track.clip;
    if (last && rival.reading && last.state.step !== rival.reading.step)
      await track.solver.seek(last.state.step);
    changed(id, { running: true });
    await track.solver.run(until);
  }

  /** Ends the workers of panes that are no more. */
  function dismiss() {
    for (const [id, track] of rivals) {
      if (rivalOf(id)) continue;
      rivals.delete(id);
      track.solver.dismiss();
    }
    if (get().comparison.rivals.length === 0) patch({ comparison: alone });
    player.redraw();
  }

  function close() {
    compared({ rivals: [] });
    dismiss();
  }

  core.beside = {
    settle: () =>
      Promise.all(
        [...rivals].map(async ([id, track]) => {
          if (!track.isOpen()) return;
          const reading = await track.solver.pause();
          changed(id, { running: false, ...(reading && { reading }) });
        }),
      ),
    run: () => Promise.all(get().comparison.rivals.map(({ id }) => runOne(id))),
    async follow() {
      const { options, comparison } = get();
      if (options.flow === "flips") close();
      else await Promise.all(comparison.rivals.map(({ id, change }) => begin(id, change)));
      keepUnits();
    },
    async colour(name) {
      for (const { clip, solver: own } of rivals.values()) {
        for (const point of clip.points) point.field = null;
        await own.colour(name).catch(() => null);
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
    /** @param {number} id @param {Partial<Options>} edit */
    async change(id, edit) {
      const rival = rivalOf(id);
      if (!rival) return;
      const { options } = get();
      const before = optionsOf(options, rival.change);
      const isOther = edit.flow !== undefined && edit.flow !== before.flow;
      const wanted = isOther ? optionsOf(options, edit) : { ...before, ...edit };
      await follow(id, changeOf(options, wanted));
    },
    /** @param {number} id */
    remove(id) {
      const rest = get().comparison.rivals.filter((one) => one.id !== id);
      compared({ rivals: rest, shown: "side", difference: null });
      dismiss();
    },
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
      const made = panes.map(({ change }) => fresh(change));
      compared({ rivals: made, lockstep, shown, difference });
    },
    /** Where the panes of a link stand. @param {readonly (number | null)[]} steps @param {number} main */
    runTo: (steps, main) =>
      Promise.all(
        get().comparison.rivals.map(({ id }, n) =>
          (steps[n] ?? main) > 0 ? runOne(id, steps[n] ?? main) : null,
        ),
      ),
  };
}
