// @ts-check
// Figures of Xu & Zhang, minimal mean-curvature-variation flow.

import { offUnit, short } from "./measures.js";

/** @import { Figure, Run } from "../figures.js" */

const names = ["mean-curvature", "surface-diffusion", "willmore", "mmcv"];
/** @param {Run} run */
const told = ({ jumps }) =>
  names.map((name) => `${name} ${short(jumps[name] ?? Number.NaN, 3)}`).join(", ");

/** @type {readonly Figure[]} */
export const curvature = [
  ...[
    {
      id: "curvature-5.1-cylinder",
      figure: "Fig. 5.1 (a–c)",
      title: "Cylinder recovered",
      reports: "A cylinder with missing parts is correctly recovered, in 100 steps.",
      sample: "cylinder-gaps",
      coordinates: /** @type {2 | 3} */ (2),
      bound: 5e-4,
    },
    {
      id: "curvature-5.1-sphere",
      figure: "Fig. 5.1 (d–f)",
      title: "Sphere recovered",
      reports: "A sphere with eight openings is perfectly recovered, in 350 steps.",
      sample: "sphere-openings",
      coordinates: /** @type {2 | 3} */ (3),
      bound: 5e-4,
    },
    {
      id: "curvature-5.4",
      figure: "Fig. 5.4",
      title: "Corners of a dodecahedron interpolated",
      reports: "A smooth surface interpolates the corners of a dodecahedron.",
      sample: "dodecahedron",
      coordinates: /** @type {2 | 3} */ (3),
      bound: 1e-3,
    },
  ].map(
    ({ coordinates, bound, ...figure }) =>
      /** @type {Figure} */ ({
        ...figure,
        paper: "curvature",
        expected: `The ${coordinates === 2 ? "cylinder" : "sphere"} of radius 1 to ${bound}, at rest`,
        colour: "mean-curvature",
        steps: "rest",
        quick: true,
        measure: ({ start, positions, steps, last }) => {
          const off = offUnit(positions, coordinates);
          return {
            value: `off ${short(offUnit(start, coordinates), 2)} → ${short(off, 2)} in ${steps} steps, ${last.status}`,
            ok: off < bound && last.status === "converged",
          };
        },
      }),
  ),
  {
    id: "curvature-5.2-two",
    paper: "curvature",
    figure: "Fig. 5.2 (a–c)",
    title: "Two tubes blended",
    reports: "Tubes are blended smoothly by the sixth-order flow, in 5 steps.",
    expected: "Coaxial tubes of radius 0.5: the cylinder between them to 1e-3 of it, at rest",
    sample: "two-tubes",
    colour: "mean-curvature",
    steps: "rest",
    quick: true,
    measure: ({ positions, steps, last, jump }) => {
      // Along the axis the tubes lie on, which is not said, they are off least.
      const off = Math.min(...[0, 1, 2].map((axis) => offTube(positions, axis, 0.5)));
      return {
        value: `off ${short(off, 2)}, jump ${short(jump?.relative ?? Number.NaN, 2)} in ${steps} steps, ${last.status}`,
        ok: off < 1e-3 && last.status === "converged",
      };
    },
  },
  ...[
    {
      id: "curvature-5.2-three",
      figure: "Fig. 5.2 (d–f)",
      sample: "three-tubes",
      title: "Three tubes blended",
      paperSteps: 50,
    },
    {
      id: "curvature-5.2-six",
      figure: "Fig. 5.2 (g–i)",
      sample: "six-tubes",
      title: "Six tubes blended",
      paperSteps: 10,
    },
  ].map(
    ({ paperSteps, ...figure }) =>
      /** @type {Figure} */ ({
        ...figure,
        paper: "curvature",
        reports: `Tubes are blended smoothly by the sixth-order flow, in ${paperSteps} steps.`,
        expected: "At rest, its jump of curvature at most 0.45 of that of surface diffusion",
        arrangement: { compare: "flows" },
        colour: "mean-curvature",
        steps: 60,
        quick: true,
        measure: (run) => ({
          value: told(run),
          ok:
            run.last.status === "converged" &&
            run.jumps.mmcv <= 0.45 * run.jumps["surface-diffusion"],
        }),
      }),
  ),
  {
    id: "curvature-5.3",
    paper: "curvature",
    figure: "Fig. 5.3",
    title: "Holes filled",
    reports: "Holes of a head are filled smoothly, with continuous curvature at their rims.",
    expected:
      "A sphere with holes instead of a head: closed, at rest, and the jump of curvature at the rims below 0.1",
    sample: "holed-sphere",
    colour: "mean-curvature",
    steps: "rest",
    quick: true,
    measure: ({ info, jump, last, steps }) => ({
      value: `${info.boundaryLoops} loops left, ${last.status} in ${steps} steps, jump ${jump ? short(jump.relative, 2) : "not measurable"}`,
      ok: info.closed && last.status === "converged" && (jump?.relative ?? 1) < 0.1,
    }),
  },
  {
    id: "curvature-5.5",
    paper: "curvature",
    figure: "Fig. 5.5",
    title: "Flows compared on a blend",
    reports:
      "The sixth-order flow joins with continuous mean curvature, the fourth-order ones do not.",
    expected: "Jump at most 0.45 of that of surface diffusion and of the Willmore flow",
    sample: "three-tubes",
    arrangement: { compare: "flows" },
    colour: "mean-curvature",
    steps: 60,
    quick: true,
    measure: (run) => ({
      value: told(run),
      ok:
        run.jumps.mmcv <= 0.45 * run.jumps["surface-diffusion"] &&
        run.jumps.mmcv <= 0.45 * run.jumps.willmore,
    }),
  },
  {
    id: "curvature-5.6",
    paper: "curvature",
    figure: "Fig. 5.6",
    title: "Flows compared on a graph",
    reports:
      "Mean-curvature and Willmore flow are not curvature continuous, the sixth-order one is.",
    expected:
      "The function as repaired: jump at most 0.06 and half of the fourth-order flows', 0.9 and more under mean-curvature flow",
    sample: "four-bumps",
    arrangement: { compare: "flows" },
    colour: "mean-curvature",
    steps: 60,
    quick: true,
    measure: (run) => {
      const { jumps } = run;
      return {
        value: told(run),
        ok:
          jumps.mmcv <= 0.06 &&
          jumps.mmcv <= 0.5 * Math.min(jumps["surface-diffusion"], jumps.willmore) &&
          jumps["mean-curvature"] > 0.9,
      };
    },
  },
];

/** @param {Float32Array} positions @param {number} axis @param {number} radius */
function offTube(positions, axis, radius) {
  let most = 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [a, b] = [0, 1, 2].filter((k) => k !== axis).map((k) => positions[i + k]);
    most = Math.max(most, Math.abs(Math.hypot(a, b) / radius - 1));
  }
  return most;
}
