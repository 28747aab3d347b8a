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
    /** @type {[string, ...unknown[]][]} */
    this.calls = [];
  }

  /**
   * @param {Uint8Array} bytes
   * @param {string} name
   */
  load(bytes, name) {
    this.calls.push(["load", Buffer.from(bytes).toString(), name]);
    if (this.refuse) {
      const values = { a: 3, b: 4, faces: [0, 1, 2], others: 0 };
      throw refusal("NonManifoldEdge", "mesh-non-manifold-edge", values);
    }
    return { name, info };
  }

  selfIntersections() {
    this.calls.push(["selfIntersections"]);
    return { pairs: Uint32Array.of(0, 1, 0, 2), triangles: Uint32Array.of(0, 1, 2) };
  }

  /** @param {{ maxSteps?: number }} options */
  configure(options) {
    this.limit = options.maxSteps ?? Infinity;
    this.calls.push(["configure", options]);
  }

  state() {
    const isSpent = this.step_ >= this.limit;
    const status = this.over ? this.ending : isSpent ? "stepLimit" : "running";
    const message = { id: "reason-at-rest", values: {} };
    return { status, message, step: this.step_, monitored: "smoothedCircle" };
  }

  curvatureJump() {
    return null;
  }

  step() {
    if (this.step_ === this.endAfter) {
      this.over = true;
      return null;
    }
    if (this.step_ + 1 >= this.failAt) {
      throw refusal("NonFiniteEnergy", "flow-non-finite-energy", { step: this.step_ + 1 });
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
    return { loops: [0], verticesAdded: 1, facesAdded: 3, firstVertex: 3, warnings: [] };
  }

  info() {
    return info;
  }

  /** @param {string} format */
  export(format) {
    return Buffer.from(`${format} of step ${this.step_}`);
  }

  history() {
    return "step,energy\n";
  }

  shapes() {
    const whole = { label: "Around", default: 8, low: 3, high: 100, integer: true };
    const real = { label: "Large radius", default: 2, low: 0, high: 10, integer: false };
    const parameters = [
      { name: "around", ...whole },
      { name: "major", ...real },
    ];
    return [{ name: "torus", label: "Torus", parameters }];
  }

  /**
   * @param {string} name
   * @param {unknown} parameters
   */
  sample(name, parameters) {
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
