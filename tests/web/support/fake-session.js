// @ts-check
// A `Session` made of numbers written down, for tests of what stands around it.

/** @type {any} */
const energies = {
  circle: 12,
  circleNormalised: 6,
  willmore: 18,
  willmoreConsistent: 19,
  pWillmore: { 0: 4, 1: 5, 2: 18, 3: 7, 4: 8 },
  area: 4,
  volume: null,
  conformalDistortion: 0.5,
  gradientNorm: 0.25,
};

const info = {
  ...{ vertices: 3, faces: 1, area: 4, volume: null },
  warnings: [{ id: "repair-turned-faces", values: { count: 1 } }],
  repairs: [],
  gap: null,
};

export class FakeSession {
  /**
   * @param {{ endAfter?: number, ending?: string, failAt?: number, refuse?: boolean }} [behaviour]
   *   ends after a number of steps, converged unless told otherwise, fails in one, or refuses
   *   every mesh
   */
  constructor({
    endAfter = Infinity,
    ending = "converged",
    failAt = Infinity,
    refuse = false,
  } = {}) {
    this.endAfter = endAfter;
    this.ending = ending;
    this.limit = Infinity;
    this.failAt = failAt;
    this.refuse = refuse;
    this.step_ = 0;
    this.over = false;
    /** @type {ReturnType<typeof refusal> | null} */
    this.fault = null;
    /** @type {[string, ...unknown[]][]} */
    this.calls = [];
  }

  /**
   * As the solver's: one command by its name, with its fields.
   * @param {Record<string, any>} command
   */
  perform(command) {
    const [[name, fields]] = Object.entries(command);
    const method = /** @type {any} */ (this)[name];
    return { [name]: method.call(this, fields) };
  }

  /** @param {{ files: { bytes: Uint8Array, name: string }[] }} fields */
  unpack({ files: [file] }) {
    return { ...file, others: [] };
  }

  /** @param {{ bytes: Uint8Array, name: string }} file */
  load({ bytes, name }) {
    this.calls.push(["load", Buffer.from(bytes).toString(), name]);
    if (this.refuse) {
      const values = { a: 3, b: 4, faces: [0, 1, 2], others: 0 };
      throw refusal("NonManifoldEdge", "mesh-non-manifold-edge", values);
    }
    return { name, info, numbers: { first: 0, vertices: null, faces: null } };
  }

  /** @param {{ numbers: number[] }} fields  of vertices as the file counts, here from 0 */
  numbered({ numbers }) {
    return numbers;
  }

  selfIntersections() {
    this.calls.push(["selfIntersections"]);
    return { pairs: Uint32Array.of(0, 1, 0, 2), triangles: Uint32Array.of(0, 1, 2) };
  }

  /** @param {{ options: { maxSteps?: number } }} fields */
  configure({ options }) {
    this.limit = options.maxSteps ?? Infinity;
    this.calls.push(["configure", options]);
  }

  state() {
    const isSpent = this.step_ >= this.limit;
    const status = this.over ? this.ending : isSpent ? "stepLimit" : "ready";
    const message = { id: "reason-at-rest", values: {} };
    return { status, message, step: this.step_, monitored: "smoothedCircle" };
  }

  outcome() {
    const { status, message: reason, step: steps, monitored } = this.state();
    const ended = { id: "ended", values: { status, steps } };
    const why = this.fault?.message ?? reason;
    return {
      status,
      isBreakdown: ["singular", "collapsed", "failed"].includes(status),
      message: { id: "run-over", values: { ended, reason: why } },
      reason: why,
      fault: this.fault,
      monitored,
      curvatureJump: null,
      warnings: status === "stalled" ? [{ id: "run-not-at-rest", values: { reason } }] : [],
    };
  }

  step() {
    if (this.step_ === this.endAfter) {
      this.over = true;
      return null;
    }
    if (this.step_ + 1 >= this.failAt) {
      const fault = refusal("NonFiniteEnergy", "flow-non-finite-energy", { step: this.step_ + 1 });
      [this.over, this.ending, this.fault] = [true, "failed", fault];
      throw fault;
    }
    this.step_ += 1;
    const cost = { gradientNorm: 1, milliseconds: 2, flippedFaces: 0, warnings: [] };
    return { step: this.step_, energy: 12 - this.step_, dt: 0.1, ...cost };
  }

  /** @param {unknown} options */
  energy(options) {
    this.calls.push(["energy", options]);
    return energies;
  }

  /** One new vertex. */
  fill() {
    return { filled: [0], left: [], newVertices: 1, firstVertex: 3, warnings: [] };
  }

  info() {
    return info;
  }

  /** @param {{ format: string }} fields */
  export({ format }) {
    return Buffer.from(`${format} of step ${this.step_}`);
  }

  losses() {
    return [];
  }

  history() {
    return "step,energy\n";
  }

  /** @param {{ name: string, parameters: unknown }} fields */
  sample({ name, parameters }) {
    this.calls.push(["sample", name, parameters]);
    return { name, info, fixed: new Uint32Array([0, 2]), free: null };
  }
}

/**
 * @param {string} kind
 * @param {string} id
 * @param {Record<string, unknown>} values
 */
function refusal(kind, id, values) {
  return { kind, message: { id, values }, hint: { id: `${id}.hint`, values }, detail: {} };
}
