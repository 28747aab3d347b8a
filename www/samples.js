// @ts-check
// The surfaces the page offers: a shape of the solver's, and options that show it well.

/** @import { FlowOptions } from "./protocol.js" */

/**
 * @typedef {object} Sample
 * @property {string} id
 * @property {string} label
 * @property {string} note         what to look for
 * @property {string} shape        name of the solver's shape …
 * @property {Record<string, number>} parameters  … and its parameters
 * @property {FlowOptions} options
 */

/** @type {readonly Sample[]} */
export const samples = [
  {
    id: "icosahedron",
    label: "Subdivided icosahedron",
    note: "Becomes a round sphere; W starts at exactly 60π and falls to zero (figure 6).",
    shape: "icosahedron",
    parameters: { level: 4 },
    options: {},
  },
  {
    id: "bumpy-sphere",
    label: "Bumpy sphere",
    note: "Bumps melt, short ones first, until the sphere is round and W is zero.",
    shape: "bumpy-sphere",
    parameters: { level: 4 },
    options: {},
  },
  {
    id: "coarse-torus",
    label: "Subdivided coarse torus",
    note: "Rounds off, then its proportions creep towards R/r = √2 (figure 8).",
    shape: "coarse-torus",
    parameters: { level: 2 },
    options: {},
  },
  {
    id: "clifford-torus",
    label: "Clifford torus",
    note: "The minimum among tori: W/2 is near 2π², and the flow hardly moves it.",
    shape: "clifford-torus",
    parameters: {},
    // Its edges lie on lines of curvature, where rounded angles would bias the minimum.
    options: { epsilon: 0.001 },
  },
  {
    id: "pipe",
    label: "Pipe with clamped ends",
    note: "Both ends keep their position and tangent; the bend between them relaxes (figure 9).",
    shape: "pipe",
    parameters: {},
    options: { boundary: "clamped" },
  },
  {
    id: "six-sided-hole",
    label: "Six-sided hole",
    note: "Fills a hexagonal hole smoothly, from a harmonic first guess (figure 10).",
    shape: "six-sided-hole",
    parameters: {},
    options: { boundary: "clamped", prefill: true },
  },
  {
    id: "scar",
    label: "Scar on a stone",
    note: "Only the damaged patch moves, and closes without a seam (figure 11).",
    shape: "scar",
    parameters: {},
    options: {},
  },
  {
    id: "noisy-scan",
    label: "Noisy scan",
    note: "Ten steps take away the noise and leave the shape (figure 12).",
    shape: "scan",
    parameters: { resolution: 140, loops: 30 },
    options: { goal: "smooth", detail: 4, smoothSteps: 10 },
  },
  {
    id: "trefoil",
    label: "Trefoil knot",
    note: "A knotted tube fattens; it cannot untie itself.",
    shape: "trefoil",
    parameters: {},
    options: {},
  },
  {
    id: "vesicle",
    label: "Vesicle, deflated",
    note: "Area kept, the volume is led down to 0.6 of the ball’s: a biconcave disc, as a red blood cell (p-Willmore, figure 6).",
    shape: "ellipsoid",
    parameters: { a: 1, b: 1, c: 0.65, level: 4 },
    options: { flow: "p-willmore", keep: ["area", "volume"], reducedVolume: 0.6 },
  },
  {
    id: "blob",
    label: "Blob, deflated",
    note: "Without any symmetry at the start it ends as a biconcave disc too, an elliptical one (p-Willmore, figure 6).",
    shape: "bumpy-sphere",
    parameters: { level: 4, amplitude: 0.2, frequency: 3, seed: 2 },
    options: { flow: "p-willmore", keep: ["area", "volume"], reducedVolume: 0.6 },
  },
  {
    id: "letter-c",
    label: "Letter C",
    note: "Rounds off to a sphere with p = 2; shrinks with p = 0, grows with p = 4 (p-Willmore, figure 2).",
    shape: "letter-c",
    parameters: {},
    options: { flow: "p-willmore" },
  },
  {
    id: "thin-torus",
    label: "Thin torus",
    note: "Thickens into the Clifford torus: ∫H² falls to 2π² (p-Willmore, figure 4).",
    shape: "torus",
    parameters: { major: 1, minor: 0.25, around: 72, tube: 24 },
    options: { flow: "p-willmore" },
  },
  {
    id: "torus-knot",
    label: "Torus knot",
    note: "Area and volume kept; without regularisation the mesh degenerates (p-Willmore, figure 5).",
    shape: "torus-knot",
    parameters: { p: 3, q: 4, along: 240, around: 16 },
    options: { flow: "p-willmore", keep: ["area", "volume"] },
  },
  {
    id: "bad-mesh",
    label: "Ellipsoid, badly meshed",
    note: "Triangles have turned over; “Regularise the mesh now” mends them without changing the shape (p-Willmore, figures 3, 7 and 11).",
    shape: "ellipsoid",
    parameters: { level: 4, jitter: 0.35 },
    options: { flow: "p-willmore", keep: ["volume"] },
  },
  {
    id: "trefoil-kept",
    label: "Trefoil, area and volume kept",
    note: "A thick knotted tube comes to rest on a plateau of ∫H² (p-Willmore, figure 9).",
    shape: "trefoil",
    parameters: { along: 180, around: 18 },
    options: { flow: "p-willmore", keep: ["area", "volume"] },
  },
  {
    id: "bumps-kept",
    label: "Bumpy sphere, area kept",
    note: "Rounds off without growing or shrinking (p-Willmore, figure 1).",
    shape: "bumpy-sphere",
    parameters: { level: 4 },
    options: { flow: "p-willmore", keep: ["area"] },
  },
  {
    id: "ellipsoid-p",
    label: "Ellipsoid, volume kept, p = 4",
    note: "A sphere in the end, on another way for every exponent p (p-Willmore, figure 12).",
    shape: "ellipsoid",
    parameters: { level: 4 },
    options: { flow: "p-willmore", p: 4, keep: ["volume"] },
  },
  {
    id: "sampled-torus",
    label: "Sampled torus",
    note: "Each cell is cut along either diagonal; flips tidy that up. Here the three criteria end at the same mesh (edge flips, figure 6).",
    shape: "sampled-torus",
    parameters: { jitter: 0.05 },
    options: { flow: "flips" },
  },
  {
    id: "uneven-torus",
    label: "Sampled torus, uneven",
    note: "Here area and localised energy lead to one mesh, the Willmore energy to another.",
    shape: "sampled-torus",
    parameters: {},
    options: { flow: "flips" },
  },
  {
    id: "creased-face",
    label: "Face with creases",
    note: "Long vertical edges make creases; flips smooth most of them out (edge flips, figure 7).",
    shape: "creased-face",
    parameters: {},
    options: { flow: "flips" },
  },
  {
    id: "eared-head",
    label: "Head with ears",
    note: "By area or localised energy W ends lower than by itself, and the ears lose volume (edge flips, figure 8).",
    shape: "eared-head",
    parameters: { jitter: 0.2 },
    options: { flow: "flips" },
  },
  {
    id: "counterexample",
    label: "Counterexample",
    note: "Flipping this edge raises the area and lowers the localised energy: f_a = 15/2 − 2√2 − √89/2 = −0.0454, f_l = +0.0068.",
    shape: "counterexample",
    parameters: {},
    options: { flow: "flips" },
  },
  {
    id: "moebius",
    label: "Möbius strip",
    note: "One side and one edge; the energy needs no orientation.",
    shape: "moebius",
    parameters: {},
    options: { boundary: "fixed" },
  },
  {
    id: "klein-bottle",
    label: "Klein bottle",
    note: "Closed and one-sided: it has no volume, but it has an energy.",
    shape: "klein-bottle",
    parameters: {},
    options: {},
  },
];
