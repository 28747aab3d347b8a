import { perform } from "../session.js";

// @ts-check
// The table `refinement` of `umbilic bench`: energies of surfaces that are known, at several
// resolutions, with observed orders.

/** @typedef {import("./solver.js").Session} Session */

const cases = [
  { shape: "icosphere", parameters: { level: 2 } },
  { shape: "torus", parameters: { major: 1, minor: 0.4, around: 28, tube: 14 } },
  { shape: "sampled-torus", parameters: { jitter: 0 } },
  { shape: "lattice-torus", parameters: { columns: 26, rows: 30, shear: 0.5 } },
  { shape: "icosahedron", parameters: { level: 2 } },
];

export const refinementColumns = [
  ...["shape", "vertices", "h", "area", "areaOrder", "circle", "circleOrder"],
  ...["cotangent", "cotangentOrder", "fitted", "fittedOrder"],
];

/** @param {Session} session @param {{ maxVertices: number }} limits */
export function* refinementRows(session, { maxVertices }) {
  for (const { shape, parameters } of cases) {
    /** @type {import("../generated/types.js").StudyReport} */
    let study = perform(session, "study", { options: { shape, parameters } });
    while (!study.finished) study = perform(session, "study");
    for (const [k, { vertices, h }] of study.rows.entries()) {
      if (vertices > maxVertices) break;
      /** @type {Record<string, number | string | null>} */
      const row = { shape: k === 0 ? shape : "", vertices, h };
      for (const { quantity, values, orders } of study.trends) {
        row[quantity] = values[k];
        // Two digits of an order are all that it has.
        row[`${quantity}Order`] = orders[k] === null ? null : Number(orders[k].toFixed(2));
      }
      yield row;
    }
  }
}
