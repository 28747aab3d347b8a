// A run as a clip: its true steps, and how much the surface visibly changes from each to the
// next. Nothing here knows of a screen or a solver.

/** @import { Pane, State as Reading } from "./generated/types.js" */
/** @import { Field, Marked } from "./store.js" */

/**
 * A true step.
 * @typedef {object} Point
 * @property {Reading} state
 * @property {Float32Array | null} positions  null where memory was short
 * @property {Field | null} field
 * @property {readonly Pane[]} panes  what stands beside it, and in its place where edges are flipped
 * @property {import("./viewer.js").Drawable | null} drawable  its triangles, where remeshing made
 *   them: one object as long as they stay; null where they are those of the start
 * @property {Marked} marked
 * @property {number} change   visible change from the step before
 * @property {number} sum      visible change from the start to here
 * @property {boolean} isCut   it cannot be reached smoothly from the step before
 * @property {boolean} isSharp an edge turns too far for a curve: straight lines
 */

/** Bytes of positions and colours that are kept. */
const MOST_BYTES = 300e6;
/** Triangles that the change is measured at. */
const SAMPLED = 12_000;
/** What a step takes at least, so that steps without a change have each their place. */
const LEAST = 1e-5;
/** Half of a turn of the normals counts as much as a displacement of the size. */
const TURN = 0.5;
const COS_40 = Math.cos((40 / 180) * Math.PI);

/** Seconds that a clip of so many steps lasts. @param {number} steps */
export const secondsOf = (steps) => (steps < 6 ? 6 : steps > 60 ? 10 : 8);

/** @param {Float32Array} p  root mean square distance from the middle */
function sizeOf(p) {
  const count = p.length / 3;
  const middle = [0, 0, 0];
  for (let i = 0; i < p.length; i += 1) middle[i % 3] += p[i] / count;
  let sum = 0;
  for (let i = 0; i < p.length; i += 1) sum += (p[i] - middle[i % 3]) ** 2;
  return Math.sqrt(sum / count) || 1;
}

/** Unit normal and two sides of a triangle, before and after. */
const before = new Float64Array(9);
const after = new Float64Array(9);

/**
 * Nothing is made anew here: it is done for thousands of triangles at each step.
 * @param {Float32Array} p @param {number} i @param {number} j @param {number} k  its corners
 * @param {Float64Array} out  unit normal, and two sides
 */
function measure(p, i, j, k, out) {
  for (let c = 0; c < 3; c += 1) {
    out[c + 3] = p[j + c] - p[i + c];
    out[c + 6] = p[k + c] - p[i + c];
  }
  out[0] = out[4] * out[8] - out[5] * out[7];
  out[1] = out[5] * out[6] - out[3] * out[8];
  out[2] = out[3] * out[7] - out[4] * out[6];
  const length = Math.sqrt(out[0] ** 2 + out[1] ** 2 + out[2] ** 2) || 1;
  for (let c = 0; c < 3; c += 1) out[c] /= length;
}

/**
 * The visible change between two surfaces of the same triangles: the root mean square of the
 * displacement along the normal over the size, and half of that of the turn of the unit normals.
 * @param {Float32Array} a @param {Float32Array} b @param {Uint32Array} triangles
 * @param {number} size @returns {{ change: number, isSharp: boolean }}
 */
export function changeOf(a, b, triangles, size) {
  const stride = 3 * Math.max(1, Math.floor(triangles.length / 3 / SAMPLED));
  let [count, moved, turned] = [0, 0, 0];
  let isSharp = false;
  const [m, n] = [before, after];
  for (let t = 0; t + 2 < triangles.length; t += stride) {
    const i = 3 * triangles[t];
    const j = 3 * triangles[t + 1];
    const k = 3 * triangles[t + 2];
    measure(a, i, j, k, m);
    measure(b, i, j, k, n);
    let along = 0;
    let [dot, mm, nn] = [0, 0, 0];
    for (let c = 0; c < 3; c += 1) {
      along += (b[i + c] - a[i + c] + b[j + c] - a[j + c] + b[k + c] - a[k + c]) * m[c];
      turned += (n[c] - m[c]) ** 2;
      dot += m[c + 3] * n[c + 3];
      mm += m[c + 3] ** 2;
      nn += n[c + 3] ** 2;
    }
    moved += (along / 3) ** 2;
    if (dot < COS_40 * Math.sqrt(mm * nn)) isSharp = true;
    count += 1;
  }
  if (count === 0) return { change: 0, isSharp: false };
  return { change: Math.sqrt(moved / count) / size + TURN * Math.sqrt(turned / count), isSharp };
}

export class Clip {
  /** @type {Point[]} oldest first */
  points = [];
  /** @type {Uint32Array} */
  #triangles = new Uint32Array();
  #size = 1;
  /** Every so manyth step keeps its positions. */
  #every = 1;

  /** @param {Uint32Array} [triangles]  that the change is measured on */
  clear(triangles = this.#triangles) {
    this.points = [];
    this.#triangles = triangles;
    this.#every = 1;
  }

  /** Other steps can be shown no more. @param {number} first @param {number} last */
  keep(first, last) {
    this.points = this.points.filter(({ state }) => state.step >= first && state.step <= last);
    const start = this.points[0]?.sum ?? 0;
    for (const point of this.points) point.sum -= start;
  }

  get total() {
    return this.points.at(-1)?.sum ?? 0;
  }

  /** How long it lasts; where it has two halves, each as if it were alone. */
  get seconds() {
    const steps = Math.max(this.points.length - 1, 0);
    const back = Math.max(-(this.points[0]?.state.step ?? 0), 0);
    return back > 0 ? secondsOf(back) + secondsOf(steps - back) : secondsOf(steps);
  }

  get last() {
    return this.points.at(-1) ?? null;
  }

  /**
   * Puts a step in its place; later ones than `last` are of another path, and go.
   * @param {Omit<Point, "change" | "sum" | "isCut" | "isSharp">} made @param {number} last
   */
  add(made, last) {
    const { step } = made.state;
    while (this.last && this.last.state.step > last) this.points.pop();
    const index = this.indexOf(step - 1) + 1;
    const isThere = this.points[index]?.state.step === step;
    const point = { ...made, change: 0, sum: 0, isCut: false, isSharp: false };
    this.points.splice(index, isThere ? 1 : 0, point);
    if (this.points.length === 1 && point.positions) this.#size = sizeOf(point.positions);
    this.#measure(index);
    if (this.points.reduce((sum, one) => sum + bytesOf(one), 0) > MOST_BYTES) this.#thin();
  }

  /** Sums from a point on, of which this one and the next have changed. @param {number} from */
  #measure(from) {
    for (let n = from; n < this.points.length; n += 1) {
      const point = this.points[n];
      const before = this.points[n - 1];
      if (before && n <= from + 1) point.change = Math.max(this.#change(before, point), LEAST);
      point.sum = before ? before.sum + point.change : 0;
    }
  }

  /** @param {Point} a @param {Point} b */
  #change(a, b) {
    const isOther = a.drawable !== b.drawable;
    const isLike = a.positions?.length === b.positions?.length;
    b.isCut = isOther || !isLike || !a.positions || b.panes.length > 0 || a.panes.length > 0;
    // Nothing can be measured from triangles to others: as much as a step next to it.
    if (isOther) return a.change || (this.points[this.points.indexOf(b) + 1]?.change ?? 0);
    if (b.isCut || !a.positions || !b.positions) return 0;
    const triangles = b.drawable?.triangles ?? this.#triangles;
    const { change, isSharp } = changeOf(a.positions, b.positions, triangles, this.#size);
    b.isSharp = isSharp;
    return change;
  }

  /** Lets every other surface go; numbers stay. */
  #thin() {
    this.#every *= 2;
    this.points.forEach((point, n) => {
      if (n % this.#every === 0 || n === this.points.length - 1) return;
      [point.positions, point.field, point.panes] = [null, null, []];
    });
  }

  /**
   * The point at or before a place, and the share of the way to the next.
   * @param {number} u  from 0 to `total` @param {(point: Point) => number} of  what places are told by
   */
  at(u, of = ({ sum }) => sum) {
    const found = this.points.findLastIndex((point) => of(point) <= u);
    const index = Math.max(found, 0);
    const [last, next] = [this.points[index], this.points[index + 1]];
    const share = next ? (u - of(last)) / (of(next) - of(last)) : 0;
    return { index, share: Math.min(Math.max(share, 0), 1) };
  }

  /** The nearest point that has a surface. @param {number} u */
  nearest(u) {
    const { index, share } = this.at(u);
    const near = share > 0.5 ? index + 1 : index;
    for (let n = 0; n < this.points.length; n += 1) {
      for (const m of [near - n, near + n]) if (this.points[m]?.positions) return m;
    }
    return near;
  }

  /** Where a step stands; that before where it is not there. @param {number} step */
  indexOf(step) {
    return this.points.findLastIndex(({ state }) => state.step <= step);
  }

  /** The last step at or before a place that has a surface. @param {number} u */
  surface(u) {
    const last = this.points.findLast(({ sum, positions }) => sum <= u && positions);
    return last ?? this.points[0] ?? null;
  }

  /**
   * The steps that the surface at a place is made of: a true one, or the two around it with
   * their neighbours, as far as the surface moves smoothly from one to the next.
   * @param {number} u @returns {Point[]}
   */
  around(u) {
    const last = this.surface(u);
    if (!last?.positions) return [];
    const n = this.points.indexOf(last);
    const m = this.points.findIndex(({ positions }, k) => k > n && positions);
    const next = this.points[m];
    if (!next || next.isCut || u <= last.sum) return [last];
    const before = last.isCut ? null : this.points[n - 1];
    const after = this.points[m + 1]?.isCut ? null : this.points[m + 1];
    const steps = [before, last, next, after];
    return steps.filter((point) => point != null).filter(({ positions }) => positions);
  }
}

/** @param {Point} point */
function bytesOf({ positions, field, panes }) {
  let bytes = (positions?.byteLength ?? 0) + (field?.values.byteLength ?? 0);
  for (const { triangles, wireEdges } of panes) bytes += 2 * (triangles.length + wireEdges.length);
  return bytes;
}
