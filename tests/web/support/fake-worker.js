// @ts-check
// A worker of the solver made of numbers written down: a surface of one triangle whose first
// coordinate is a third of its step. It crashes, or falls silent, when it is told to.

/** @typedef {{ id: number, name: string, fields: any, run?: number, shown?: boolean }} Request */

const info = { vertices: 3, faces: 1, boundaryLoops: 1, warnings: [] };
const triangle = { triangles: Uint32Array.of(0, 1, 2), free: null, fixed: null };
const edges = { wireEdges: new Uint32Array(), boundaryEdges: new Uint32Array() };

/** @param {number} step */
const exactAt = (step) => Float64Array.of(step / 3, 0, 0, 1, 0, 0, 0, 1, 0);

const begun = () => ({ at: 0, exact: exactAt(0), stored: [0] });

export class FakeWorker {
  /** All that were started, oldest first. @type {FakeWorker[]} */
  static all = [];
  /** Whether one crashes at a request. @type {(request: Request, worker: FakeWorker) => boolean} */
  static crashesAt = () => false;
  /** Whether one leaves a request without an answer. @type {(request: Request) => boolean} */
  static ignores = () => false;

  /** Whether one refuses a request. @type {(request: Request) => boolean} */
  static refuses = () => false;

  static get last() {
    return FakeWorker.all[FakeWorker.all.length - 1];
  }

  /** Forgets all of them. */
  static begin() {
    FakeWorker.all = [];
    FakeWorker.crashesAt = () => false;
    FakeWorker.ignores = () => false;
    FakeWorker.refuses = () => false;
    Object.assign(globalThis, {
      Worker: FakeWorker,
    });
  }

  /** @type {((event: { data: any }) => void) | null} */
  onmessage = null;
  onerror = null;
  isTerminated = false;
  /** @type {Request[]} what was asked of it */
  asked = [];
  run = 0;
  /** @type {string | null} */
  mesh = null;
  isConfigured = false;
  exact = exactAt(0);
  time = 0;
  /** Steps that can be shown. @type {number[]} */
  stored = [];
  at = 0;
  /** The half of a film that waits. */
  other = begun();
  /** Frames that the page has taken. */
  acknowledged = 0;

  constructor() {
    FakeWorker.all.push(this);
    queueMicrotask(() => this.say({ type: "ready", version: "1" }));
  }

  terminate() {
    this.isTerminated = true;
  }

  /** @param {any} data */
  say(data) {
    if (!this.isTerminated) this.onmessage?.({ data });
  }

  /** @param {string} message */
  crash(message) {
    this.say({ type: "crashed", message });
  }

  /** @param {any} message */
  postMessage(message) {
    if (message.ack !== undefined) this.acknowledged += 1;
    if (message.id === undefined) return;
    // As in a browser, it is answered later.
    setImmediate(() => this.answer(message));
  }

  state() {
    return {
      ...{ step: this.at, time: this.at, status: "ready", message: null, energy: 8 - this.at },
      ...{ dt: 1, area: 1, volume: null, minAngleDegrees: 45, flips: null },
      canStepBack: this.stored[0] < this.at,
    };
  }

  frame() {
    const [start] = this.stored;
    const last = this.stored[this.stored.length - 1];
    const timeline = {
      ...{ start, first: start, last, at: this.at, stored: this.stored.length, branches: [] },
      previous: this.at > start ? this.at - 1 : null,
      next: this.at < last ? this.at + 1 : null,
    };
    this.say({
      ...{ type: "frame", run: this.run, state: this.state(), reports: [] },
      ...{ positions: Float32Array.from(this.exact), exact: this.exact, field: null },
      ...{
        flippedTriangles: new Uint32Array(),
        triangles: null,
        panes: [],
        curves: null,
        jump: null,
        look: null,
      },
      ...{ timeline, story: null },
    });
  }

  /** @param {Request} request */
  answer(request) {
    const { id, name, fields, run, shown } = request;
    if (this.isTerminated) return;
    this.asked.push(request);
    if (FakeWorker.crashesAt(request, this)) return this.crash(`at ${name}`);
    if (FakeWorker.ignores(request)) return;
    if (run !== undefined) this.run = run;
    try {
      if (FakeWorker.refuses(request)) throw refusal("Refused");
      const ok = this.perform(name, fields);
      if (shown) this.frame();
      this.say({ id, ok });
    } catch (error) {
      this.say({ id, error });
    }
  }

  /** @param {string} name @param {any} fields @returns {any} */
  perform(name, fields) {
    if (name === "readOptions") return {};
    if (name === "unpack") return { ...fields.files[0], others: [] };
    if (name === "load" || name === "sample") {
      if (fields.name === "broken.obj") throw refusal("BadMesh");
      this.mesh = fields.name;
      this.isConfigured = false;
      this.exact = exactAt(0);
      return this.loaded();
    }
    if (!this.mesh) throw refusal("NoMesh");
    if (name === "configure" || name === "reset") {
      this.isConfigured = true;
      this.place(0, exactAt(0));
      if (name === "configure") this.other = begun();
    } else if (name === "step") {
      this.at += 1;
      this.exact = exactAt(this.at);
      this.stored = [...this.stored.filter((step) => step < this.at), this.at];
    } else if (name === "back") {
      this.at = Math.max(this.at - 1, this.stored[0]);
      this.exact = exactAt(this.at);
    } else if (name === "turn") {
      const { at, exact, stored } = this;
      Object.assign(this, this.other);
      this.other = { at, exact, stored };
    } else if (name === "restore") this.place(fields.step, fields.exact);
    else if (name === "adopt") return this.loaded();
    else if (name === "export") return Uint8Array.of(this.at);
    else if (name === "losses") return [];
    else if (name === "run") return true;
    else if (name === "seek") {
      this.at = fields.step;
      this.exact = exactAt(this.at);
    } else if (name === "writeRecipe") throw refusal("NoRecipe", "app-no-recipe");
    if (name === "configure") {
      const heldVertices = new Uint8Array(3);
      return {
        freeVertices: 3,
        meanEdgeLength: 1,
        dt: 1,
        tau: 1,
        heldVertices,
        state: this.state(),
      };
    }
    return name === "colour" ? null : this.state();
  }

  /** @param {number} step @param {Float64Array<ArrayBuffer>} exact */
  place(step, exact) {
    this.at = step;
    this.exact = exact;
    this.stored = [step];
  }

  loaded() {
    const name = String(this.mesh).replace(/\.\w+$/, "");
    const positions = Float32Array.from(this.exact);
    return { name, info, positions, shift: [0, 0, 0], trianglesOnly: true, ...triangle, ...edges };
  }
}

/** @param {string} kind @param {string} [id] */
const refusal = (kind, id = "app-no-mesh") => ({
  kind,
  message: { id, values: {} },
  hint: null,
  detail: {},
});
