// @ts-check
// Figures of Bobenko & Schröder, Discrete Willmore Flow, 2005.

import { apart, near, offPlane, offSphere, short, torusFit } from "./measures.js";

/** @import { Figure } from "../figures.js" */

/** @type {readonly Figure[]} */
export const circle = [
  {
    id: "circle-6",
    paper: "circle",
    figure: "Fig. 6",
    title: "Subdivided icosahedron to a sphere",
    reports: "After 24 steps the energy is 1e-7; a perfect sphere would have zero.",
    expected: "W starts at 60π and is at most 1e-7 after 24 steps of dt = 0.0345; a round sphere",
    sample: "icosahedron",
    options: { scheme: "paper", dt: 0.0345 },
    steps: 24,
    quick: true,
    measure: ({ first, last, steps, positions }) => ({
      value: `W ${short(first.energy / Math.PI)}π → ${short(last.energy, 2)} in ${steps} steps, off the sphere ${short(offSphere(positions), 2)}`,
      ok:
        near(first.energy, 60 * Math.PI, 1e-9) &&
        last.energy <= 1e-7 &&
        offSphere(positions) < 1e-3,
    }),
  },
  {
    id: "circle-6-adaptive",
    paper: "circle",
    figure: "Fig. 6",
    title: "Subdivided icosahedron, adaptive steps",
    reports: "The sphere is reached within a few minimisation steps.",
    expected: "W ≤ 1e-7 after at most 12 steps, then converged",
    sample: "icosahedron",
    steps: "rest",
    quick: true,
    measure: ({ last, steps }) => ({
      value: `W ${short(last.energy, 2)} after ${steps} steps, ${last.status}`,
      ok: last.energy <= 1e-7 && steps <= 12 && last.status === "converged",
    }),
  },
  {
    id: "circle-7-fixed",
    paper: "circle",
    figure: "Fig. 7, left",
    title: "Boundary fixed",
    reports: "A cat's head with its boundary fixed relaxes between its boundary curves.",
    expected: "Another shape, a saddle: W falls by at least nine tenths, the surface stays curved",
    sample: "saddle",
    options: { boundary: "fixed" },
    steps: 100,
    quick: true,
    measure: ({ first, last, positions }) => ({
      value: `W ${short(first.energy)} → ${short(last.energy)}, out of plane ${short(offPlane(positions), 2)}`,
      ok: last.energy < 0.1 * first.energy && offPlane(positions) > 0.1,
    }),
  },
  {
    id: "circle-7-free",
    paper: "circle",
    figure: "Fig. 7, right",
    title: "Boundary free",
    reports:
      "A cat's head with its boundary free evolves to a planar polygon, its boundary convex.",
    expected: "Another shape, a saddle: W < 1e-6, that is planar with a convex boundary",
    sample: "saddle",
    steps: 100,
    quick: true,
    measure: ({ first, last, positions }) => ({
      value: `W ${short(first.energy)} → ${short(last.energy, 2)}, out of plane ${short(offPlane(positions), 2)}`,
      ok: last.energy < 1e-6 && offPlane(positions) < 1e-4,
    }),
  },
  {
    id: "circle-8",
    paper: "circle",
    figure: "Fig. 8",
    title: "Coarse torus becomes geometric",
    reports: "Almost immediately the vertices flow to the surface of a geometric torus.",
    expected: "τ = 0.01: W within 5 % of 57 after 100 steps, less than 2.5 % off a torus",
    sample: "coarse-torus",
    options: { scheme: "paper", tau: 0.01 },
    steps: 100,
    quick: true,
    measure: ({ first, last, positions }) => {
      const { off } = torusFit(positions);
      return {
        value: `W ${short(first.energy)} → ${short(last.energy)}, off a torus ${short(100 * off, 2)} %`,
        ok: near(first.energy, 764.397, 1e-5) && near(last.energy, 57, 0.05) && off < 0.025,
      };
    },
  },
  {
    id: "circle-8-long",
    paper: "circle",
    figure: "Fig. 8, long",
    title: "Coarse torus fattens",
    reports:
      "Subsequent evolution aligns edges with the curvature directions and fattens the torus.",
    expected: "τ = 0.003, 1000 steps: R/r from 2.13 to 2.04 (±0.02), less than 1.5 % off a torus",
    sample: "coarse-torus",
    options: { scheme: "paper", tau: 0.003 },
    steps: 1000,
    quick: false,
    measure: ({ start, positions }) => {
      const { ratio, off } = torusFit(positions);
      return {
        value: `R/r ${short(torusFit(start).ratio)} → ${short(ratio)}, off a torus ${short(100 * off, 2)} %`,
        ok: Math.abs(ratio - 2.04) < 0.02 && off < 0.015,
      };
    },
  },
  {
    id: "circle-9",
    paper: "circle",
    figure: "Fig. 9",
    title: "Pipe between two circles",
    reports: "A pipe with circular boundary loops evolves as the torus does, to a fat pipe.",
    expected: "W from 398.65 to below 80 in 50 steps",
    sample: "pipe",
    steps: 50,
    quick: true,
    measure: ({ first, last }) => ({
      value: `W ${short(first.energy, 5)} → ${short(last.energy)}`,
      ok: near(first.energy, 398.65, 1e-5) && last.energy < 80,
    }),
  },
  {
    id: "circle-10",
    paper: "circle",
    figure: "Fig. 10",
    title: "Six-sided hole filled",
    reports: "A six-sided hole is filled smoothly though many edges begin with β = 0.",
    expected: "Not frozen: after 100 steps W is at least 60 lower",
    sample: "six-sided-hole",
    options: { prefill: false },
    steps: 100,
    quick: true,
    measure: ({ first, last }) => ({
      value: `W ${short(first.energy)} → ${short(last.energy)}`,
      ok: last.energy < first.energy - 60,
    }),
  },
  {
    id: "circle-11",
    paper: "circle",
    figure: "Fig. 11",
    title: "Scar restored",
    reports: "A marked region of the Egea model is restored, its surroundings held.",
    expected:
      "Another shape, a scarred stone: W within 2 % of 6.408, where the undamaged stone comes to rest, in 20 steps",
    sample: "scar",
    steps: 20,
    quick: true,
    measure: ({ first, last }) => ({
      value: `W ${short(first.energy)} → ${short(last.energy)}`,
      ok: near(last.energy, 6.408, 0.02),
    }),
  },
  ...[
    { steps: 10, share: 0.7 },
    { steps: 100, share: 1.5 },
  ].map(
    ({ steps, share }) =>
      /** @type {Figure} */ ({
        id: `circle-12-${steps}`,
        paper: "circle",
        figure: `Fig. 12, ${steps} steps`,
        title: `Scan smoothed by ${steps} steps`,
        reports: `A scan of 37,000 vertices with 88 boundary loops loses its noise; shown after ${steps} steps.`,
        expected: `A made scan with 88 loops and ${steps === 10 ? "38,000 vertices" : "38,000 vertices, whose features begin to go"}: distance to the clean surface below ${share} of the noise`,
        sample: "range-scan",
        options: { tau: 0.01, smoothSteps: steps, boundary: "fixed" },
        reference: { shape: "scan-clean", parameters: { resolution: 285, loops: 88 } },
        steps,
        quick: steps === 10,
        measure: ({ first, last, start, positions, reference }) => {
          if (!reference) return { value: "no clean surface to compare", ok: false };
          const [before, after] = [start, positions].map((x) => apart(x, reference));
          return {
            value: `W ${short(first.energy)} → ${short(last.energy)}, distance × ${short(after / before, 3)}`,
            ok: last.energy < first.energy && after < share * before,
          };
        },
      }),
  ),
];
