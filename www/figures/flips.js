// @ts-check
// Figures of Brink & Alboul, edge flips by area, Willmore and localised Willmore energy.

import { flips as readings, short, variation } from "./measures.js";

/** @import { Figure, Run } from "../figures.js" */

/** @param {Run} run */
function told(run) {
  const { area, willmore, localised } = readings(run);
  const all = [area, willmore, localised];
  return `area/Willmore/localised: ${all.map((r) => r.flips).join("/")} flips, area ${all.map((r) => short(r.area, 5)).join("/")}, W ${all.map((r) => short(r.circle)).join("/")}`;
}

/** @type {Figure["arrangement"]} */
const criteria = { compare: "criteria", flipsPerStep: null };

/** @type {readonly Figure[]} */
export const flips = [
  {
    id: "flips-6",
    paper: "flips",
    figure: "Fig. 6, top",
    title: "Torus, one mesh by all criteria",
    reports: "On points of a torus all three criteria lead to exactly the same mesh.",
    expected: "Other points, chosen so: 203 flips each, one area and one W (not so on all points)",
    sample: "sampled-torus",
    arrangement: criteria,
    steps: "rest",
    quick: true,
    measure: (run) => {
      const { area, willmore, localised } = readings(run);
      const same = (/** @type {typeof area} */ other) =>
        other.flips === 203 &&
        Math.abs(other.area - area.area) < 1e-9 &&
        Math.abs(other.circle - area.circle) < 1e-9;
      return { value: told(run), ok: [area, willmore, localised].every(same) };
    },
  },
  {
    id: "flips-6-curvature",
    paper: "flips",
    figure: "Fig. 6, bottom",
    title: "Torus, Gaussian curvature after Loop subdivision",
    reports: "Plots of Gaussian curvature of the subdivided meshes show it is visibly smoother.",
    expected: "Variation of K along the edges below 0.7 of the start",
    sample: "sampled-torus",
    arrangement: { compare: "start", subdivide: 2, flipsPerStep: null },
    colour: "gauss-curvature",
    steps: "rest",
    quick: true,
    measure: (run) => {
      const [before, after] = [variation(run, "start"), variation(run, "localised")];
      return {
        value: `Σ|ΔK| ${short(before)} → ${short(after)}`,
        ok: after < 0.7 * before,
      };
    },
  },
  {
    id: "flips-7",
    paper: "flips",
    figure: "Fig. 7",
    title: "Face with creases",
    reports: "By area or localised energy a face reaches a lower W than by the Willmore energy.",
    expected: "A made face: W by area and by localised energy below W by itself",
    shortfall:
      "On this face flips by the Willmore energy end lower. Which end is lower depends on the mesh: each is only a local minimum.",
    sample: "creased-face",
    arrangement: criteria,
    steps: "rest",
    quick: true,
    measure: (run) => {
      const { area, willmore, localised } = readings(run);
      const ok = area.circle < willmore.circle && localised.circle < willmore.circle;
      return { value: told(run), ok };
    },
  },
  {
    id: "flips-8",
    paper: "flips",
    figure: "Fig. 8",
    title: "Head with ears",
    reports: "Area and localised energy fall together and so does W.",
    expected:
      "Another shape than the bunny: area ≤ localised < Willmore in area, both below it in W",
    sample: "eared-head",
    arrangement: criteria,
    steps: "rest",
    quick: true,
    measure: (run) => {
      const { area, willmore, localised } = readings(run);
      const ok =
        area.area <= localised.area + 1e-12 &&
        localised.area < willmore.area &&
        area.circle < willmore.circle &&
        localised.circle < willmore.circle;
      return { value: told(run), ok };
    },
  },
  {
    id: "flips-8-volume",
    paper: "flips",
    figure: "Fig. 8, ears",
    title: "Ears lose volume",
    reports: "By area, narrow parts such as the bunny's ears lose volume.",
    expected: "A head with ears loses 0.2 to 2 % of its volume",
    sample: "eared-head",
    options: { criterion: "area" },
    arrangement: { compare: "none", flipsPerStep: null },
    steps: "rest",
    quick: true,
    measure: ({ first, last }) => {
      const lost = 1 - (last.volume ?? Number.NaN) / (first.volume ?? 1);
      return { value: `${short(100 * lost, 3)} % lost`, ok: lost >= 0.002 && lost <= 0.02 };
    },
  },
];
