// @ts-check
// The clip of a run, and how it is played, without a browser.

import assert from "node:assert/strict";
import { test } from "node:test";
import { Clip, changeOf, secondsOf } from "../../www/clip.js";
import { align } from "../../www/comparison.js";
import { createPlayer } from "../../www/player.js";

/** A sphere of a radius as points on three circles, with triangles between neighbours. @param {number} radius */
function ball(radius) {
  const positions = [];
  const [rings, around] = [8, 16];
  for (let i = 0; i <= rings; i += 1) {
    for (let j = 0; j < around; j += 1) {
      const [theta, phi] = [0.1 + (2.9 * i) / rings, (2 * Math.PI * j) / around];
      positions.push(
        radius * Math.sin(theta) * Math.cos(phi),
        radius * Math.sin(theta) * Math.sin(phi),
        radius * Math.cos(theta),
      );
    }
  }
  const triangles = [];
  for (let i = 0; i < rings; i += 1) {
    for (let j = 0; j < around; j += 1) {
      const [a, b] = [i * around + j, i * around + ((j + 1) % around)];
      triangles.push(a, a + around, b, b, a + around, b + around);
    }
  }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

const { triangles } = ball(1);

/** @param {number} step @param {Float32Array | null} positions @param {any} [more] @returns {any} */
const point = (step, positions, more = {}) => ({
  state: { step, energy: 10 - step, time: step * step, status: "ready", ...more.state },
  positions,
  field: null,
  panes: [],
  drawable: null,
  marked: new Uint32Array(),
  ...more,
});

/** Balls that shrink by these radii. @param {readonly number[]} radii */
function shrinking(radii) {
  const clip = new Clip();
  clip.clear(triangles);
  for (const [step, radius] of radii.entries()) clip.add(point(step, ball(radius).positions), step);
  return clip;
}

test("a half that is shown backwards grows at the front, as smooth as the rest", () => {
  const clip = shrinking([1, 0.95, 0.9]);
  for (const [n, radius] of [1.05, 1.1, 1.15].entries()) {
    clip.add(point(-1 - n, ball(radius).positions), 2);
  }
  assert.deepEqual(
    clip.points.map(({ state }) => state.step),
    [-3, -2, -1, 0, 1, 2],
  );
  const sums = clip.points.map(({ sum }) => sum);
  assert.equal(sums[0], 0);
  for (let n = 1; n < sums.length; n += 1) {
    const share = (sums[n] - sums[n - 1]) / clip.total;
    assert.ok(Math.abs(share - 0.2) < 0.01, `step ${n}: ${share}`);
    assert.equal(clip.points[n].isCut, false);
  }
  // Over the seam the surface is made of steps of both halves.
  const around = clip.around((sums[2] + sums[3]) / 2);
  assert.deepEqual(
    around.map(({ state }) => state.step),
    [-2, -1, 0, 1],
  );
  assert.equal(clip.seconds, secondsOf(3) + secondsOf(2));
});

test("the visible change is the displacement along the normal over the size", () => {
  const { change, isSharp } = changeOf(ball(1).positions, ball(1.1).positions, triangles, 2);
  // A uniform growth by 0.1 turns no normal; facets see it a little smaller.
  assert.ok(Math.abs(change - 0.05) < 0.002, String(change));
  assert.equal(isSharp, false);
  // A triangle that turns about its middle: half of the chord of the angle, and no displacement.
  const flat = Float32Array.of(-1, -1, 0, 1, -1, 0, 0, 2, 0);
  for (const [angle, sharp] of /** @type {const} */ ([
    [0.3, false],
    [0.9, true],
  ])) {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const turned = Float32Array.of(-1, -c, -s, 1, -c, -s, 0, 2 * c, 2 * s);
    const other = changeOf(flat, turned, Uint32Array.of(1, 2, 0), 1);
    assert.ok(Math.abs(other.change - Math.sin(angle / 2)) < 1e-6, String(other.change));
    assert.equal(other.isSharp, sharp, "40° are too far");
  }
});

test("clip time goes by the change and not by the steps", () => {
  const clip = shrinking([1, 0.9, 0.89, 0.5]);
  const [, a, b, c] = clip.points.map(({ sum }) => sum);
  assert.ok(Math.abs(a / clip.total - 0.2) < 0.01, "a tenth of five");
  assert.ok(Math.abs((b - a) / clip.total - 0.02) < 0.005);
  assert.equal(c, clip.total);
  assert.deepEqual(
    [0, a, (a + b) / 2, clip.total].map((u) => clip.at(u).index),
    [0, 1, 1, 3],
  );
  assert.equal(clip.nearest(b - 0.1 * (b - a)), 2);
  assert.equal(clip.indexOf(2), 2);
  assert.equal(clip.indexOf(7), 3);
});

/** The steps around a place, by number. @param {Clip} clip @param {number} u */
const around = (clip, u) => clip.around(u).map(({ state }) => state.step);

test("a surface is a true step, or between two steps with their neighbours", () => {
  const clip = shrinking([1, 0.8, 0.7, 0.65, 0.6]);
  const [a, b, c, d, e] = clip.points.map(({ sum }) => sum);
  for (const [n, u] of [a, b, c, d, e].entries()) assert.deepEqual(around(clip, u), [n]);
  assert.deepEqual(around(clip, (a + b) / 2), [0, 1, 2]);
  assert.deepEqual(around(clip, (b + c) / 2), [0, 1, 2, 3]);
  assert.deepEqual(around(clip, (d + e) / 2), [2, 3, 4]);
  // Numbers and colours are those of the last step that was passed.
  assert.equal(clip.surface((b + c) / 2)?.state.step, 1);
});

test("an edge that turns far makes a straight way, and a step without a surface is passed over", () => {
  const clip = new Clip();
  clip.clear(Uint32Array.of(1, 2, 0));
  const flat = Float32Array.of(-1, -1, 0, 1, -1, 0, 0, 2, 0);
  const turned = Float32Array.of(-1, 0, -1, 1, 0, -1, 0, 0, 2);
  for (const [step, positions] of [flat, flat, turned, null, turned].entries())
    clip.add(point(step, positions), step);
  assert.deepEqual(
    clip.points.map(({ isSharp }) => isSharp),
    [false, false, true, false, false],
  );
  const [, , c] = clip.points.map(({ sum }) => sum);
  assert.deepEqual(around(clip, c - 1e-9), [0, 1, 2]);
  assert.equal(clip.surface(clip.points[3].sum)?.state.step, 2);
});

test("where triangles change there is a cut, and equal places for steps without a change", () => {
  const clip = new Clip();
  clip.clear(triangles);
  const { positions } = ball(1);
  const pane = { name: "area", triangles, wireEdges: triangles };
  for (let step = 0; step < 5; step += 1) clip.add(point(step, positions, { panes: [pane] }), step);
  assert.deepEqual(
    clip.points.map(({ sum }) => Math.round((4 * sum) / clip.total)),
    [0, 1, 2, 3, 4],
  );
  assert.deepEqual(clip.around(0.9 * clip.points[1].sum), [clip.points[0]]);
});

test("after a pass of remeshing there is a cut, and motion on the new triangles", () => {
  const clip = new Clip();
  clip.clear(triangles);
  const made = { ...ball(1), wireEdges: new Uint32Array(), boundaryEdges: new Uint32Array() };
  const radii = [1, 0.9, 0.85, 0.75, 0.65];
  for (const [step, radius] of radii.entries())
    clip.add(point(step, ball(radius).positions, { drawable: step >= 2 ? made : null }), step);
  assert.deepEqual(
    clip.points.map(({ isCut }) => isCut),
    [false, false, true, false, false],
  );
  const [, a, b, c, d] = clip.points.map(({ change }) => change);
  // The pass counts as the step before it; then what is seen to change does.
  assert.equal(b, a);
  assert.ok(Math.abs(c / a - 1) < 0.1 && Math.abs(d / a - 1) < 0.1, `${a} ${c} ${d}`);
  const at = (/** @type {number} */ n) => clip.points[n].sum + 1e-6;
  assert.deepEqual(around(clip, at(1)), [1]);
  assert.deepEqual(around(clip, at(2)), [2, 3, 4]);
});

test("a step on another path takes the place of those after it", () => {
  const clip = shrinking([1, 0.9, 0.8, 0.7]);
  clip.add(point(2, ball(0.85).positions), 2);
  assert.deepEqual(
    clip.points.map(({ state }) => state.step),
    [0, 1, 2],
  );
  assert.equal(clip.last?.positions?.[0], ball(0.85).positions[0]);
  // A step that is shown again changes nothing.
  const { total } = clip;
  clip.add(point(1, ball(0.9).positions), 2);
  assert.equal(clip.points.length, 3);
  assert.ok(Math.abs(clip.total - total) < 1e-9);
});

test("long runs keep every number and some of the surfaces", () => {
  const clip = new Clip();
  clip.clear(new Uint32Array());
  // 12 MB each: more than 300 MB.
  for (let step = 0; step < 40; step += 1) clip.add(point(step, new Float32Array(3e6)), step);
  assert.equal(clip.points.length, 40);
  const kept = clip.points.filter(({ positions }) => positions).length;
  assert.ok(kept < 30 && kept >= 12, String(kept));
  assert.ok(clip.points[0].positions && clip.last?.positions);
});

test("a clip lasts eight seconds, shorter and longer ones six and ten", () => {
  assert.deepEqual([3, 23, 61].map(secondsOf), [6, 8, 10]);
});

/** Plays in time that the test makes. @param {Clip} clip @param {any} [more] */
function played(clip, more = {}) {
  /** @type {((time: number) => void)[]} */
  const due = [];
  const track = { clip, u: 0, isOpen: () => false, ...more.track };
  let ended = 0;
  const player = createPlayer({
    tracks: () => [track, ...(more.others ?? [])],
    lockstep: () => more.lockstep ?? "progress",
    isCalm: () => more.isCalm ?? false,
    onEnd: () => {
      ended += 1;
    },
    nextFrame: (draw) => due.push(draw),
  });
  let now = performance.now();
  const run = (/** @type {number} */ seconds, each = () => {}) => {
    for (let n = 0; n < 60 * seconds; n += 1) {
      now += 1000 / 60;
      due.shift()?.(now);
      each();
    }
  };
  return { player, track, run, ended: () => ended };
}

test("one Play lasts eight seconds, at an even pace, with hundreds of pictures", () => {
  const clip = shrinking([1, 0.9, 0.8, 0.75, 0.7, 0.6, 0.5, 0.4, 0.39]);
  const { player, track, run, ended } = played(clip);
  player.begin();
  /** @type {Set<number>} */
  const places = new Set();
  let most = 0;
  for (let second = 0; second < 8; second += 1) {
    const before = track.u;
    run(1, () => places.add(track.u));
    most = Math.max(most, (track.u - before) / clip.total);
    if (second === 6) assert.equal(ended(), 0, "not before");
  }
  run(0.5);
  assert.equal(ended(), 1);
  assert.equal(track.u, clip.total);
  assert.ok(places.size > 400, String(places.size));
  assert.ok(most <= 0.25, `no second holds more than a quarter: ${most}`);
});

test("while the end is unknown the display waits for the solver, and ends after it", () => {
  const clip = shrinking([1, 0.98, 0.97, 0.96]);
  let isOpen = true;
  const { player, track, run, ended } = played(clip, { track: { isOpen: () => isOpen } });
  player.begin();
  run(20);
  assert.equal(ended(), 0);
  assert.ok(track.u <= clip.total && track.u > 0.9 * clip.total);
  assert.equal(player.isWaiting.value, true);
  for (let step = 4; step < 12; step += 1)
    clip.add(point(step, ball(1 - 0.05 * step).positions), step);
  const share = track.u / clip.total;
  isOpen = false;
  run(2);
  assert.ok(track.u / clip.total > share && ended() === 0, "no rush to the end");
  run(8);
  assert.equal(ended(), 1);
});

test("reduced motion shows true steps alone, two a second", () => {
  const clip = shrinking([1, 0.9, 0.8, 0.7, 0.6]);
  const { player, track, run, ended } = played(clip, { isCalm: true });
  player.begin();
  const sums = clip.points.map(({ sum }) => sum);
  run(3, () => assert.ok(sums.includes(track.u), String(track.u)));
  assert.equal(ended(), 1);
});

test("pausing eases on to the nearest true step", async () => {
  const clip = shrinking([1, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4]);
  const { player, track, run } = played(clip);
  player.begin();
  run(3.1);
  const index = clip.nearest(track.u);
  const rested = player.rest(index);
  assert.equal(player.motion.value, "easing");
  run(0.3);
  await rested;
  assert.equal(track.u, clip.points[index].sum);
  assert.equal(player.motion.value, "still");
});

test("others keep up by progress, by step, or by time", () => {
  const lead = { clip: shrinking([1, 0.9, 0.8, 0.7, 0.6]), u: 0, isOpen: () => false };
  const other = { clip: shrinking([1, 0.95, 0.5]), u: 0, isOpen: () => false };
  lead.u = lead.clip.points[1].sum;
  align(lead, [other], "progress");
  assert.ok(Math.abs(other.u / other.clip.total - lead.u / lead.clip.total) < 1e-12);
  align(lead, [other], "step");
  assert.equal(other.u, other.clip.points[1].sum);
  // Times are squares of the steps: at time 2 the other is a third of the way from 1 to 4.
  lead.u = (2 * lead.clip.points[1].sum + lead.clip.points[2].sum) / 3;
  align(lead, [other], "time");
  const [, a, b] = other.clip.points.map(({ sum }) => sum);
  assert.ok(Math.abs(other.u - (a + (b - a) / 3)) < 1e-9);
  lead.u = lead.clip.total;
  align(lead, [other], "step");
  assert.equal(other.u, other.clip.total, "its last step stays");
});
