// Plays clips: how far along each the display is. Solving runs ahead or behind by itself; here
// time passes at an even pace of visible change, slower where the display would overtake.

import { batch, signal } from "@preact/signals-core";
import { secondsOf } from "./clip.js";
import { align } from "./comparison.js";

/** @import { Clip } from "./clip.js" */

/** Steps, or milliseconds, before the display begins. */
const HEAD_START = { steps: 3, milliseconds: 300 };
/** Seconds that easing on to a true step takes. */
const EASE = 0.2;
/** Steps a second where motion is reduced. */
const CALM_RATE = 2;
/** Clip seconds a second. */
export const speeds = [0.25, 0.5, 1, 2, 4];
/** Seconds between two pictures that count: a window in the background plays on from where it was. */
const LONGEST = 0.25;

/** How far a clip is played. @typedef {{ clip: Clip, isOpen: () => boolean, u: number }} Track */

/** @typedef {"still" | "playing" | "easing"} Motion */

/**
 * @param {object} page @param {() => readonly Track[]} page.tracks  the first leads
 * @param {() => "progress" | "step" | "time"} page.lockstep  how the others keep up
 * @param {() => boolean} page.isCalm  whether motion is to be reduced
 * @param {() => void} page.onEnd  the last step is shown and no more will come
 * @param {(draw: (time: number) => void) => unknown} [page.nextFrame]
 */
export function createPlayer({
  tracks,
  lockstep,
  isCalm,
  onEnd,
  nextFrame = requestAnimationFrame,
}) {
  /** @type {import("@preact/signals-core").Signal<Motion>} */
  const motion = signal("still");
  /** Changes whenever something else is to be drawn. */
  const tick = signal(0);
  /** Whether the display waits for the solver. */
  const isWaiting = signal(false);
  const speed = signal(1);
  const loops = signal(false);

  let last = 0;
  let isDue = false;
  /** Seconds played, and when the clip is to end. */
  let [spent, end] = [0, 0];
  /** The share of the clip that was to be played at first. */
  let toPlay = 1;
  let wasOpen = false;
  let lastArrival = 0;
  /** Mean seconds from one step to the next. */
  let pace = 0.1;
  /** @type {{ from: number, to: number, spent: number, done: () => void } | null} */
  let ease = null;

  const redraw = () => {
    tick.value = tick.peek() + 1;
  };

  /** @param {Track} track  share of the way that is left, of what there is */
  const rest = ({ clip, u }) => Math.max(clip.total - u, 0);

  /** The same as a share of it. @param {Track} track */
  const share = (track) => (track.clip.total > 0 ? rest(track) / track.clip.total : 1);

  /** How long the clip lasts. */
  const seconds = () => tracks()[0]?.clip.seconds ?? secondsOf(0);

  /** @param {Track} track @param {number} by  seconds */
  function advance(track, by) {
    const left = Math.max(end - spent, 1e-3);
    // Not faster than steps come, so that the picture does not stop and go.
    const horizon = track.isOpen() ? Math.max(left, 2 * pace) : left;
    track.u = Math.min(track.u + rest(track) * Math.min(by / horizon, 1), track.clip.total);
  }

  /** @param {number} by  seconds */
  function play(by) {
    const all = tracks();
    const [lead] = all;
    const isOpen = all.some((one) => one.isOpen());
    const steps = lead.clip.points.length - 1;
    if (isOpen && spent === 0 && lead.u === 0) {
      const waited = performance.now() - lastStart;
      if (steps < HEAD_START.steps && waited < HEAD_START.milliseconds) return;
    }
    // As long as usual, and what came late not in a rush.
    if (wasOpen) end = Math.max(seconds() * toPlay, spent + 0.6 * seconds() * share(lead));
    wasOpen = isOpen;
    const isFree = lockstep() === "progress";
    const moved = isFree ? all : [lead];
    if (isCalm()) playCalm(by, moved);
    else for (const track of moved) advance(track, by);
    if (!isFree) align(lead, all.slice(1), lockstep());
    spent += by;
    const near = lead.clip.at(lead.u);
    isWaiting.value = lead.isOpen() && near.index >= steps - 1 && spent > 1;
    const isThere = moved.every((one) => rest(one) <= 1e-6 * one.clip.total);
    if (!isOpen && (isThere || (!isCalm() && spent >= end))) finish(all);
  }

  let sinceStep = 0;
  /** True steps only. @param {number} by @param {readonly Track[]} all */
  function playCalm(by, all) {
    sinceStep += by;
    if (sinceStep < 1 / CALM_RATE) return;
    sinceStep = 0;
    for (const track of all) {
      const { index } = track.clip.at(track.u + 1e-9);
      const next = track.clip.points[index + 1];
      if (next) track.u = next.sum;
    }
  }

  const halt = () =>
    batch(() => {
      motion.value = "still";
      isWaiting.value = false;
    });

  /** @param {readonly Track[]} all */
  function finish(all) {
    place(all[0].clip.total);
    if (loops.peek()) return begin(true);
    batch(() => {
      halt();
      redraw();
    });
    onEnd();
  }

  /** @param {number} time  milliseconds */
  function frame(time) {
    isDue = false;
    const by = Math.min((time - last) / 1000, LONGEST);
    last = time;
    if (motion.peek() === "playing") play(by * speed.peek());
    else if (ease) {
      ease.spent = Math.min(ease.spent + by, EASE);
      const s = ease.spent / EASE;
      const [lead] = tracks();
      lead.u = ease.from + (ease.to - ease.from) * s * s * (3 - 2 * s);
      if (s >= 1) {
        const { done } = ease;
        ease = null;
        motion.value = "still";
        done();
      }
    }
    redraw();
    request();
  }

  function request() {
    if (isDue || motion.peek() === "still") return;
    isDue = true;
    nextFrame(frame);
  }

  let lastStart = 0;
  /** @param {boolean} [fromStart] */
  function begin(fromStart = false) {
    if (fromStart) for (const track of tracks()) track.u = 0;
    const [lead] = tracks();
    [spent, end, wasOpen, ease, sinceStep] = [0, 0, true, null, 0];
    lastStart = lastArrival = performance.now();
    toPlay = share(lead);
    if (tracks().some((one) => one.isOpen())) toPlay = Math.max(toPlay, 0.5);
    last = performance.now();
    motion.value = "playing";
    request();
  }

  /** Where all stand when the first stands there. @param {number} u */
  function place(u) {
    const [lead, ...others] = tracks();
    lead.u = u;
    align(lead, others, lockstep());
    redraw();
  }

  return {
    motion,
    tick,
    isWaiting,
    speed,
    loops,
    seconds,
    begin,
    place,
    redraw,
    /** A step has come: how fast they do. */
    arrived() {
      const now = performance.now();
      pace = 0.7 * pace + 0.3 * Math.min((now - lastArrival) / 1000, 5);
      lastArrival = now;
      redraw();
    },
    /** Stops where it is. */
    stop() {
      ease = null;
      halt();
    },
    /** Stops on a true step. @param {number} index  of the first clip's points */
    async rest(index) {
      const [lead] = tracks();
      const to = lead.clip.points[index]?.sum ?? 0;
      isWaiting.value = false;
      if (isCalm() || motion.peek() === "still") {
        motion.value = "still";
        return place(to);
      }
      await new Promise((done) => {
        ease = { from: lead.u, to, spent: 0, done: () => done(null) };
        motion.value = "easing";
        last = performance.now();
        request();
      });
    },
  };
}

/** @typedef {ReturnType<typeof createPlayer>} Player */
