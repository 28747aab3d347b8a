// @ts-check
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

/** @import { Options } from "../options.js" */
/** @import { Comparison, Rival } from "../store.js" */
/** @import { Core } from "./core.js" */

/** What a second pane does otherwise at first: the first that makes sense. @type {Record<string, readonly Partial<Options>[]>} */
const contrasts = {
  flow: [{ flow: "mean-curvature" }, { flow: "circle" }],
  p: [
    { flow: "p-willmore", p: 4 },
    { flow: "p-willmore", p: 2 },
  ],
  regularise: [
    { flow: "p-willmore", regularise: "off", remesh: "off" },
    { flow: "p-willmore", regularise: "nonlinear", remesh: "off" },
  ],
  scheme: [{ scheme: "paper" }, { scheme: "auto" }],
};

/** @typedef {"flow" | "p" | "regularise" | "scheme" | "then"} Contrast */

/** @param {Core} core */
export function createCompare(core) {
  const { get, patch, notes, player, lead, rivals, enqueue, rest, solver } = core;
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

  /** @param {number} id @param {string} reason */
  function lost(id, reason) {
    changed(id, { phase: "lost", reason, running: false });
    notes.error({ message: say("pane-lost", { reason }), hint: say("pane-lost.hint") });
  }

  /** @param {number} id */
  function employ(id) {
    const own = createSolver({
      onReady() {},
      onProgress() {},
      onSilent() {},
      onCrashed: (reason) => lost(id, reason),
      onStopped(reading, fault) {
        changed(id, { reading, running: false, reason: fault?.message ?? "" });
        const { last } = track.clip;
        if (last?.state.step === reading.step) last.state = reading;
        player.place(lead.u);
      },
      onFrame(frame) {
        const { motion } = player;
        take(track, frame, false);
        if (!frame.stored) changed(id, { reading: frame.state });
        if (motion.peek() === "still") player.place(lead.u);
      },
    });
    const track = {
      clip: new Clip(),
      u: 0,
      isOpen: () => rivalOf(id)?.running ?? false,
      solver: own,
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
      const wanted = optionsOf(options, change);
      const configured = await track.solver.configure(withSelection(wanted, mesh));
      const first = track.clip.points[0];
      if (colour !== "none") {
        const field = await track.solver.colour(colour);
        if (first) first.field = field;
      }
      const { state: reading, heldVertices: held } = configured;
      changed(id, { phase: "ready", reason: "", reading, held });
    } catch (error) {
      const fault = /** @type {any} */ (error);
      if (fault?.kind === LOST) return;
      const said = typeof fault?.message === "object" ? sayFault(fault) : fault;
      changed(id, { phase: "lost", reason: String(said?.message ?? error) });
      notes.error({ message: String(said?.message ?? error), hint: said?.hint ?? "" });
    }
    player.place(lead.u);
  }

  /** Whose time is another cannot be kept in step by it. */
  function keepUnits() {
    const { options, comparison } = get();
    const all = [options, ...comparison.rivals.map(({ change }) => optionsOf(options, change))];
    if (comparison.lockstep === "time" && !timeUnitsAgree(all)) compared({ lockstep: "progress" });
  }

  /** @param {Partial<Options>} change */
  async function add(change) {
    lastId += 1;
    const id = lastId;
    const rival = { id, change, reason: "", running: false, reading: null, held: null };
    compared({ rivals: [...get().comparison.rivals, { ...rival, phase: "loading" }] });
    await begin(id, change);
    keepUnits();
    await catchUp(id);
  }

  /** A pane that was begun anew goes as far as the first has come. @param {number} id */
  async function catchUp(id) {
    const { last, points } = lead.clip;
    if (last && points.length > 1) await runOne(id, core.isOver() ? null : last.state.step);
  }

  /** @param {number} id @param {number | null} [until] */
  async function runOne(id, until = null) {
    const track = rivals.get(id);
    const rival = rivalOf(id);
    if (!track || rival?.phase !== "ready") return;
    const { last } = track.clip;
    if (last && rival.reading && last.state.step !== rival.reading.step) {
      await track.solver.seek(last.state.step);
    }
    changed(id, { running: true });
    await track.solver.run(until);
  }

  /** Ends the workers of panes that are no more. */
  function dismiss() {
    const ids = get().comparison.rivals.map(({ id }) => id);
    for (const [id, track] of rivals) {
      if (ids.includes(id)) continue;
      rivals.delete(id);
      track.solver.dismiss();
    }
    if (ids.length === 0) patch({ comparison: alone });
    player.redraw();
  }

  function close() {
    compared({ rivals: [], shown: "side", difference: null });
    dismiss();
  }

  core.settleRival = async (id) => {
    if (!rivalOf(id)?.running) return;
    const reading = await rivals.get(id)?.solver.pause();
    changed(id, { running: false, ...(reading ? { reading } : {}) });
  };
  core.runRivals = async () => {
    await Promise.all(get().comparison.rivals.map(({ id }) => runOne(id)));
  };
  core.followRivals = async () => {
    const { options, comparison } = get();
    if (options.flow === "flips") close();
    else await Promise.all(comparison.rivals.map(({ id, change }) => begin(id, change)));
    keepUnits();
  };
  core.colourRivals = async (name) => {
    for (const track of rivals.values()) {
      for (const point of track.clip.points) point.field = null;
      await track.solver.colour(name).catch(() => null);
      if (track.clip.points.length > 0) track.solver.stored().catch(() => {});
    }
  };

  const compare = {
    /** What of a comparison is asked for at first; never a twin. @param {Contrast} what */
    contrast: (what) =>
      enqueue(async () => {
        await rest();
        close();
        const { options, reading } = get();
        if (what === "then") {
          if (reading) compared({ withStart: true });
          return;
        }
        for (const one of contrasts[what]) {
          const change = changeOf(options, optionsOf(options, one));
          if (Object.keys(change).length === 0) continue;
          // An exponent is of a flow that reads it.
          const own = { ...options, ...one };
          if (change.flow && what !== "flow" && !isRead(what, options))
            await core.configure(optionsOf(options, { flow: own.flow }));
          const now = get().options;
          await add(changeOf(now, optionsOf(now, one)));
          return;
        }
      }),
    /** One more, with the first difference that is not there yet. */
    add: () =>
      enqueue(async () => {
        await rest();
        const { options, comparison } = get();
        if (comparison.rivals.length >= MOST_PANES - 1) return;
        const taken = [
          options,
          ...comparison.rivals.map(({ change }) => optionsOf(options, change)),
        ];
        const flows = ["circle", "mean-curvature", "p-willmore", "surface-diffusion", "willmore"];
        const flow = flows.find((id) => taken.every((one) => one.flow !== id)) ?? "mmcv";
        await add({ flow: /** @type {Options["flow"]} */ (flow) });
      }),
    /** @param {number} id @param {Partial<Options>} edit */
    change: (id, edit) =>
      enqueue(async () => {
        await rest();
        const rival = rivalOf(id);
        if (!rival) return;
        const { options } = get();
        const before = optionsOf(options, rival.change);
        const isOther = edit.flow !== undefined && edit.flow !== before.flow;
        const wanted = isOther ? optionsOf(options, edit) : { ...before, ...edit };
        await begin(id, changeOf(options, wanted));
        keepUnits();
        await catchUp(id);
      }),
    /** @param {number} id */
    remove: (id) =>
      enqueue(async () => {
        await rest();
        compared({
          rivals: get().comparison.rivals.filter((one) => one.id !== id),
          shown: "side",
          difference: null,
        });
        dismiss();
      }),
    close: () => enqueue(() => rest().then(close)),
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
    /** Before the flow of a link is configured. @param {import("../link.js").Scene["comparison"]} linked */
    prepare(linked) {
      close();
      if (!linked) return;
      const { panes, shown, difference } = linked;
      const lockstep = linked.lockstep === "time" ? "time" : "progress";
      const made = panes.map(({ change }) => {
        lastId += 1;
        return {
          id: lastId,
          change,
          phase: /** @type {const} */ ("loading"),
          reason: "",
          running: false,
          reading: null,
          held: null,
        };
      });
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
  return compare;
}
