// @ts-check
// Figures of Gruber & Aulisa, Computational p-Willmore Flow with Conformal Penalty, 2020.

import { drift, near, offSphere, short } from "./measures.js";

/** @import { Figure, Run } from "../figures.js" */

const clifford = 2 * Math.PI ** 2;
const sphere = 4 * Math.PI;
/** Of ∫H²/4π: the axisymmetric minimiser of reduced volume 0.6. */
const discocyte = 1.95568;

/** @param {Run} run */
function kept(run) {
  const { first, last } = run;
  const off = drift(run, ["area", "volume"]);
  return {
    value: `∫H² ${short(first.energy)} → ${short(last.energy)}, angle ${short(first.minAngleDegrees, 3)}° → ${short(last.minAngleDegrees, 3)}°, drift ${short(off, 1)}, ${last.status}`,
    ok: off < 1e-8 && last.energy < first.energy,
  };
}

/** @param {Run} run */
function mended({ regularised }) {
  if (!regularised) return { value: "not regularised", ok: false };
  const { before, after, distance } = regularised;
  const volume = Math.abs((after.volume ?? Number.NaN) / (before.volume ?? 1) - 1);
  return {
    value: `inverted ${before.inverted} → ${after.inverted}, angle ${short(before.minAngleDegrees, 2)}° → ${short(after.minAngleDegrees, 3)}°, distortion ${short(before.distortion, 3)} → ${short(after.distortion, 3)}, moved ${short(100 * distance, 2)} %, volume ${short(100 * volume, 2)} %`,
    ok: after.inverted === 0 && after.distortion < before.distortion / 3 && distance < 0.01,
  };
}

/** @type {readonly Figure[]} */
export const pWillmore = [
  {
    id: "p-willmore-1",
    paper: "p-willmore",
    figure: "Fig. 1",
    title: "Area kept, p = 2",
    reports: "A cow of 23,400 triangles rounds off, its area all but unchanged.",
    expected:
      "Another shape, a bumpy sphere: ∫H² within 0.6 % of 4π, a sphere to 1e-3, area to 1e-8",
    sample: "bumps-kept",
    steps: "rest",
    quick: true,
    measure: (run) => {
      const [off, round] = [drift(run, ["area"]), offSphere(run.positions)];
      return {
        value: `∫H² = ${short(run.last.energy / sphere)}·4π, off ${short(round, 2)}, drift ${short(off, 1)}`,
        ok: near(run.last.energy, sphere, 6e-3) && round < 1e-3 && off < 1e-8,
      };
    },
  },
  ...[
    {
      p: 0,
      steps: 100,
      reports: "Under p = 0, mean-curvature flow, the letter C shrinks.",
      expected: "Area below a fifth",
      holds: (/** @type {Run} */ { first, last }) => last.area < 0.2 * first.area,
    },
    {
      p: 2,
      steps: 120,
      reports: "Under p = 2 the letter C becomes a round sphere.",
      expected: "∫H² within 1 % of a sphere's",
      holds: (/** @type {Run} */ { last }) => near(last.energyNormalised, 1, 0.01),
    },
    {
      p: 4,
      steps: 160,
      reports: "Under p = 4 the letter C grows without end.",
      expected: "Area above 1.8 times",
      holds: (/** @type {Run} */ { first, last }) => last.area > 1.8 * first.area,
    },
  ].map(
    ({ p, steps, reports, expected, holds }) =>
      /** @type {Figure} */ ({
        id: `p-willmore-2-p${p}`,
        paper: "p-willmore",
        figure: `Fig. 2, p = ${p}`,
        title: `Letter C, p = ${p}`,
        reports,
        expected: `${expected} after at most ${steps} steps`,
        sample: "letter-c",
        options: { p },
        colour: "mean-curvature",
        steps,
        quick: false,
        measure: (run) => ({
          value: `area × ${short(run.last.area / run.first.area, 3)}, ∫|H|^p = ${short(run.last.energyNormalised)} of the sphere's, ${run.last.status}`,
          ok: holds(run),
        }),
      }),
  ),
  .../** @type {const} */ (["linear", "nonlinear"]).map(
    (mode) =>
      /** @type {Figure} */ ({
        id: `p-willmore-3-${mode}`,
        paper: "p-willmore",
        figure: `Fig. 3, ${mode}`,
        title: `Regularisation, ${mode}`,
        reports: `${mode === "linear" ? "Linear regularisation improves a cow's mesh, more roughly than the nonlinear one" : "Nonlinear regularisation improves a cow's mesh"} with slight changes to its shape.`,
        expected:
          "Another shape, an ellipsoid with folded triangles: none left, distortion below a third, moved less than 1 % of its size",
        sample: "bad-mesh",
        regularise: { mode },
        steps: 0,
        quick: true,
        measure: mended,
      }),
  ),
  {
    id: "p-willmore-4",
    paper: "p-willmore",
    figure: "Fig. 4",
    title: "Torus to the Clifford torus",
    reports: "A deformed torus flows to the Clifford torus, the global minimum.",
    expected: "A thin torus: ∫H² within 1.6 % of 2π², reduced volume within 1.2 % of 0.7116",
    sample: "thin-torus",
    steps: "rest",
    quick: true,
    measure: ({ last }) => ({
      value: `∫H² = ${short(last.energy / clifford)}·2π², v = ${short(last.reducedVolume ?? 0)}`,
      ok: near(last.energy, clifford, 0.016) && near(last.reducedVolume ?? 0, 0.71164, 0.012),
    }),
  },
  {
    id: "p-willmore-5",
    paper: "p-willmore",
    figure: "Fig. 5",
    title: "Torus knot, area and volume kept",
    reports: "A (3,4)-torus knot relaxes, area and volume kept, and stays nearly isometric.",
    expected: "∫H² falls, area and volume to 1e-8, smallest angle above half of the first",
    sample: "torus-knot",
    steps: 50,
    quick: false,
    measure: (run) => {
      const { value, ok } = kept(run);
      return { value, ok: ok && run.last.minAngleDegrees > 0.5 * run.first.minAngleDegrees };
    },
  },
  ...[
    { id: "p-willmore-6", sample: "vesicle", what: "Another shape, a spheroid" },
    { id: "p-willmore-6-blob", sample: "blob", what: "Another shape, a blob without symmetry" },
  ].map(
    ({ id, sample, what }) =>
      /** @type {Figure} */ ({
        id,
        paper: "p-willmore",
        figure: "Fig. 6",
        title: `Biconcave disc from a ${sample}`,
        reports: "A rabbit, area and volume kept, becomes a biconcave disc as a red blood cell.",
        expected: `${what}, led to v = 0.6: ∫H² within 1.2 % of ${discocyte}·4π, the axisymmetric minimiser`,
        sample,
        steps: "rest",
        quick: false,
        measure: ({ last }) => ({
          value: `∫H² = ${short(last.energy / sphere)}·4π at v = ${short(last.reducedVolume ?? 0, 6)}, ${last.status}`,
          ok:
            last.status === "converged" &&
            near(last.energy / sphere, discocyte, 0.012) &&
            near(last.reducedVolume ?? 0, 0.6, 1e-8),
        }),
      }),
  ),
  {
    id: "p-willmore-7",
    paper: "p-willmore",
    figure: "Fig. 7",
    title: "One pass of linear regularisation",
    reports: "One linear pass improves a statue of 483,000 triangles.",
    expected:
      "Another shape, an ellipsoid with skewed triangles: none folded, distortion below a third, moved less than 1 %",
    sample: "rough-mesh",
    regularise: { mode: "linear", iterations: 1 },
    steps: 0,
    quick: true,
    measure: mended,
  },
  {
    id: "p-willmore-8",
    paper: "p-willmore",
    figure: "Fig. 8",
    title: "Genus 4, free",
    reports: "A statue of genus 4 flows to a round surface with four handles.",
    expected: "Another surface of genus 4: ∫H² from above to between 2π² and 8π",
    sample: "genus-4",
    steps: "rest",
    quick: false,
    measure: ({ first, last, info }) => ({
      value: `genus ${info.genus}, ∫H² ${short(first.energy)} → ${short(last.energy)} = ${short(last.energy / (8 * Math.PI))}·8π, ${last.status}`,
      ok: info.genus === 4 && last.energy > clifford && last.energy < 8 * Math.PI,
    }),
  },
  {
    id: "p-willmore-9",
    paper: "p-willmore",
    figure: "Fig. 9, top",
    title: "Trefoil, regularised",
    reports: "Regularised, a trefoil keeps nearly perfect triangles all the way to the minimum.",
    expected:
      "∫H² falls to a plateau, area and volume to 1e-8, smallest angle not below the first (no final minimum is known)",
    sample: "trefoil-kept",
    steps: 60,
    quick: false,
    measure: (run) => {
      const { value, ok } = kept(run);
      return { value, ok: ok && run.last.minAngleDegrees >= run.first.minAngleDegrees };
    },
  },
  {
    id: "p-willmore-9-off",
    paper: "p-willmore",
    figure: "Fig. 9, bottom",
    title: "Trefoil, not regularised",
    reports: "Without regularisation the mesh degenerates and the flow gets stuck.",
    expected: "Area and volume to 1e-8, smallest angle below half of the first",
    sample: "trefoil-kept",
    options: { regularise: "off" },
    steps: "rest",
    quick: false,
    measure: (run) => {
      const { value, ok } = kept(run);
      return { value, ok: ok && run.last.minAngleDegrees < 0.5 * run.first.minAngleDegrees };
    },
  },
  ...[
    { p: 0, dt: 2e-3 },
    { p: 2, dt: 2e-4 },
    { p: 4, dt: 1e-5 },
  ].map(
    ({ p, dt }) =>
      /** @type {Figure} */ ({
        id: `p-willmore-10-p${p}`,
        paper: "p-willmore",
        figure: `Fig. 10, p = ${p}`,
        title: `Energy under refinement, p = ${p}`,
        reports: "The energy decreases in every case and appears to converge with refinement.",
        expected:
          "Another shape, an ellipsoid on three meshes: at one time the energies come closer by a factor of 3 to 5",
        sample: "ellipsoid-p",
        options: { p, dt, keep: [], regularise: "off" },
        refine: [{ level: 2 }, { level: 3 }],
        steps: 30,
        quick: p === 2,
        measure: ({ first, last, refined }) => {
          const [coarse, middle] = refined;
          if (!coarse || !middle) return { value: "one mesh only", ok: false };
          const ratio = (coarse.energy - middle.energy) / (middle.energy - last.energy);
          const together = [coarse, middle].every(({ time }) => near(time, last.time, 1e-9));
          const energies = [coarse, middle, last].map(({ energy }) => short(energy, 5));
          const told = `${energies.join(", ")}: ratio ${short(ratio, 3)}`;
          return {
            value: together ? told : `${told}, not at one time`,
            ok: together && last.energy < first.energy && Math.abs(ratio - 4) < 1,
          };
        },
      }),
  ),
  {
    id: "p-willmore-11",
    paper: "p-willmore",
    figure: "Fig. 11",
    title: "One step, then regularisation",
    reports: "One step of the flow and two nonlinear passes remesh an armadillo all but unseen.",
    expected:
      "Another shape, an ellipsoid with folded triangles: none left, distortion below a third, moved less than 1 %",
    sample: "bad-mesh",
    options: { regularise: "off", keep: [], tau: 1e-4 },
    regularise: { mode: "nonlinear", iterations: 2 },
    steps: 1,
    quick: true,
    measure: mended,
  },
  ...[0, 2, 4].map(
    (p) =>
      /** @type {Figure} */ ({
        id: `p-willmore-12-p${p}`,
        paper: "p-willmore",
        figure: `Fig. 12, p = ${p}`,
        title: `Volume kept, p = ${p}`,
        reports: "A rabbit, its volume kept, becomes a sphere for every p, on different ways.",
        expected: "Another shape, an ellipsoid: a sphere to 2e-3, volume to 1e-8",
        sample: "ellipsoid-p",
        options: { p },
        steps: "rest",
        quick: false,
        measure: (run) => {
          const [off, round] = [drift(run, ["volume"]), offSphere(run.positions)];
          return {
            value: `off ${short(round, 2)}, drift ${short(off, 1)}, ${run.steps} steps, ${run.last.status}`,
            ok: round < 2e-3 && off < 1e-8,
          };
        },
      }),
  ),
];
