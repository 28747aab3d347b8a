// @ts-check
// The energy and the equation of each flow, and the values of their symbols: what is stated, not
// how it is shown.

/** @import { PageState } from "../state.js" */
/** @import { Part } from "./mathml.js" */

import { t } from "../language.js";
import { flowOf, settled, usualBoundary } from "../options.js";
import { dot, frac, root, row, sub, subsup, sum, sup } from "./mathml.js";
import { formatNumber } from "./number.js";

/**
 * @typedef {object} Statement
 * @property {Part[]} energy    what falls
 * @property {Part[]} equation  what is solved
 * @property {string} source
 * @property {[Part, string, string][]} symbols  with what each is, and its value now
 */

export const paper = {
  circle: "A. I. Bobenko, P. Schröder, Discrete Willmore Flow (2005)",
  p: "A. Gruber, E. Aulisa, Computational p-Willmore Flow with Conformal Penalty (2020)",
  curvature: "G. Xu, Q. Zhang, Minimal Mean-Curvature-Variation Surfaces (2006)",
  flips: "W. Brink, L. Alboul, Willmore energy vs area as criteria for mesh optimisation",
};

const number = (/** @type {number | null | undefined} */ value) => formatNumber(value, 4);
const beta = sub.bind(null, "β");
const change = () => row("Δ", "x");
const power = (/** @type {Part} */ base, /** @type {Part} */ exponent) => sup(base, exponent);
const square = (/** @type {Part} */ base) => sup(base, "2");
const xAt = (/** @type {Part} */ step) => sup("x", step);

/** dt and τ, the same without a unit. @param {Readonly<PageState>} s @param {Part} unit @param {string} what */
const stepSize = ({ reading, configured }, unit, what) =>
  /** @type {Statement["symbols"]} */ ([
    ["dt", t("step size"), number(reading?.dt ?? configured?.dt)],
    [row("τ = dt /", unit), what, number(reading?.tau ?? configured?.tau)],
  ]);

/** @param {Readonly<PageState>} s @returns {Statement} */
function circle(s) {
  const { options, configured, mesh } = s;
  const isPaper = options.scheme === "paper";
  const isExact = isPaper || options.epsilon === 0;
  const isAreaMass =
    !isPaper && (options.mass === "area" || (options.mass === "auto" && options.goal === "smooth"));
  const gradient = (/** @type {Part} */ at) => row("∇ E (", at, ")");
  const mass = () => frac("M", "dt");
  /** @type {Record<string, Part>} */
  const equations = {
    "semi-implicit": row("(", mass(), "+", sub("K", "+"), ")", change(), "= −", gradient("x")),
    "forward-euler": row(mass(), change(), "= −", gradient("x")),
    "backward-euler": row(mass(), change(), "= −", gradient(row("x", "+", change()))),
    "l-bfgs": row(change(), "= −", "α", sub("B", "k"), gradient("x")),
  };
  const plain = row("(", frac("I", "dt"), "+", "K", ")", change(), "= −", gradient("x"));
  const rounded = row("φ (", "β", ") =", root(row(square("β"), "+", square("ε"))), "− ε");
  const boundary = options.boundary ?? usualBoundary(options.flow) ?? "clamped";
  /** @type {Record<string, string>} */
  const boundaries = {
    clamped: t("interior vertices count"),
    fixed: t("a vertex at infinity closes each loop; the boundary is held"),
    free: t("a vertex at infinity closes each loop"),
  };
  return {
    energy: [
      row(
        "W =",
        sum("i"),
        sub("W", "i"),
        ",",
        sub("W", "i"),
        "=",
        sum("j"),
        beta("ij"),
        "− 2",
        "π",
      ),
      ...(isExact
        ? [row("E = W")]
        : [
            row("E =", sum("i"), "(", sum("j"), "φ (", beta("ij"), ") − 2", "π", ")", ","),
            rounded,
          ]),
    ],
    equation: [
      row("M", dot("x"), "= −", gradient("x")),
      isPaper && options.integrator === "semi-implicit" ? plain : equations[options.integrator],
    ],
    source: `${paper.circle}: ${t("W in section 2, K in eq. (1), the step in section 4")}`,
    symbols: [
      [beta("ij"), t("angle between the circumcircles of the triangles at edge ij"), ""],
      ...(isExact
        ? []
        : /** @type {Statement["symbols"]} */ ([
            [
              "ε",
              options.sharpen
                ? t("rounds off the cone of an angle at 0; goes to 0 at the end")
                : t("rounds off the cone of an angle at 0"),
              number(options.epsilon),
            ],
          ])),
      ["M", t("mass of a vertex"), isAreaMass ? t("area") : "1"],
      ...(options.integrator === "semi-implicit"
        ? /** @type {Statement["symbols"]} */ ([
            isPaper
              ? ["K", t("K of eq. (1) as it is, with K x = ∇E"), ""]
              : [
                  sub("K", "+"),
                  t("K of eq. (1), with K x = ∇E, made semi-definite star by star"),
                  "",
                ],
          ])
        : []),
      ...(options.integrator === "l-bfgs"
        ? /** @type {Statement["symbols"]} */ ([
            [sub("B", "k"), t("inverse of the Hessian, from the last steps"), ""],
            ["α", t("what the line search finds"), ""],
          ])
        : []),
      ...stepSize(s, square("h"), t("without a unit")),
      ["h", t("mean edge length at the start"), number(configured?.meanEdgeLength)],
      ...(mesh && !mesh.info.closed
        ? /** @type {Statement["symbols"]} */ ([["i", t("which vertices"), boundaries[boundary]]])
        : []),
    ],
  };
}

/** @param {Readonly<PageState>} s @returns {Statement} */
function pWillmore(s) {
  const { reading } = s;
  const options = settled(s.options);
  const { p, keep, spontaneousCurvature: bent, tension, pressure } = options;
  const hasTerms = p === 2 && (bent !== 0 || tension !== 0 || pressure !== 0);
  const isPaper = options.scheme === "paper";
  const absolute = power(row("| H |"), "p");
  const multipliers = reading?.multipliers;
  const dA = () => row("d", "A");
  const energy = hasTerms
    ? row(
        "E = ∫",
        square(row("( H −", sub("H", "0"), ")")),
        dA(),
        "+ ¼ (",
        "σ",
        "A",
        "− P",
        "V",
        ")",
      )
    : p === 0
      ? row("E = ∫", dA(), "= A")
      : row("E = ∫", absolute, dA());
  const kept = [
    ...(keep.includes("area") ? ["+ λ ∇ A"] : []),
    ...(keep.includes("volume") ? ["− μ ∇ V"] : []),
  ];
  const { sets, paper: own } = flowOf(options.flow);
  const papers = Object.keys(sets).length > 0 ? `${own}; ${paper.p}` : paper.p;
  // Of the paper's energy W^p = 2^p E.
  const force = () =>
    kept.length > 0 ? row(sup("2", "p"), "( ∇ E", ...kept, ")") : row(sup("2", "p"), "∇ E");
  return {
    energy: [energy],
    equation: [
      row("M", dot("x"), "= −", force()),
      isPaper
        ? row(
            "M",
            frac(row(xAt("k+1"), "−", xAt("k")), "dt"),
            "= −",
            force(),
            "( ½ (",
            xAt("k"),
            "+",
            xAt("k+1"),
            ") )",
          )
        : row("(", frac("M", "dt"), "+ L C L )", change(), "= − Π (", force(), ")"),
      ...(p !== 0 || keep.includes("area")
        ? []
        : keep.includes("volume")
          ? [
              row(dot("x"), "= 2 (", sub("H", "m"), "−", "H", ")", "n", ","),
              row(sub("H", "m"), "= ∫", "H", dA(), "/ ∫", dA()),
            ]
          : [row(dot("x"), "=", "Δ", "x", "= − 2", "H", "n")]),
    ],
    source: `${papers}: ${t("the flow in theorem 3.2, eqs. (5)–(7); kept area and volume in problem 3.5; the paper’s step in problem 5.1. Its W^p, with Y = 2H, is 2^p E.")}`,
    symbols: [
      ["p", t("exponent"), String(p)],
      ["H", t("mean curvature, (κ₁ + κ₂)/2, positive on a sphere"), ""],
      ...(hasTerms
        ? /** @type {Statement["symbols"]} */ ([
            [row(sub("H", "0"), "ℓ"), t("spontaneous curvature"), number(bent)],
            [row("σ", square("ℓ")), t("tension, per ∫(2H)² dA"), number(tension)],
            [row("P", power("ℓ", "3")), t("pressure, per ∫(2H)² dA"), number(pressure)],
          ])
        : []),
      ...(keep.includes("area")
        ? /** @type {Statement["symbols"]} */ ([
            ["λ", t("tension that keeps the area, per E"), number(multipliers?.tension)],
          ])
        : []),
      ...(keep.includes("volume")
        ? /** @type {Statement["symbols"]} */ ([
            [
              "μ",
              t("pressure that keeps or leads the volume, per E"),
              number(multipliers?.pressure),
            ],
          ])
        : []),
      ...(isPaper
        ? []
        : /** @type {Statement["symbols"]} */ ([
            ["L", t("cotangent Laplacian; C = p max(1, p − 1) |2H|^(p−2)/m on its diagonal"), ""],
            ["Π", t("onto the vertex normals"), ""],
          ])),
      ...stepSize(s, power("ℓ", String(p + 2)), t("without a unit")),
      ["ℓ", t("√(A/4π) at the start"), number(lengthOf(s))],
      ...(options.regularise === "off"
        ? []
        : /** @type {Statement["symbols"]} */ ([
            [
              "ε",
              t("of the conformal penalty after each step (problem 5.3)"),
              number(options.regulariseEpsilon),
            ],
          ])),
    ],
  };
}

/** √(A/4π) of the surface at the start. @param {Readonly<PageState>} s */
const lengthOf = ({ mesh }) => (mesh ? Math.sqrt(mesh.info.area / (4 * Math.PI)) : null);

/** @param {Readonly<PageState>} s @returns {Statement} */
function byCurvature(s) {
  const { flow } = s.options;
  const lap = (/** @type {Part} */ of) => row("Δ", of);
  const grad = () => row("∇", "H");
  const dA = () => row("d", "A");
  const norm = () => square(row("‖", grad(), "‖"));
  /** @type {Record<string, { energy: Part, velocity: Part[], order: string, where: string }>} */
  const laws = {
    "mean-curvature": {
      energy: row("A = ∫", dA()),
      velocity: [row("V = −", "H")],
      order: "2",
      where: t("eq. (3.6), with H of the opposite sign"),
    },
    "surface-diffusion": {
      energy: row("A = ∫", dA()),
      velocity: [row("V =", lap("H"))],
      order: "4",
      where: t("eq. (3.6), with H of the opposite sign"),
    },
    willmore: {
      energy: row("E = ∫", square("H"), dA()),
      velocity: [row("V =", lap("H"), "+ 2", "H", "(", square("H"), "− K", ")")],
      order: "4",
      where: t("eq. (3.6), with H of the opposite sign"),
    },
    mmcv: {
      energy: row("F = ∫", norm(), dA()),
      velocity: [
        row("V = −", square("Δ"), "H", "− 2 ( 2", square("H"), "− K )", lap("H")),
        row("− 2 ⟨", grad(), ",", "◇", "H", "⟩ + 2", "H", norm()),
      ],
      order: "6",
      where: t("F in (1.1), V in (3.1) and (3.8), with H and ◇ of the opposite sign"),
    },
  };
  const { energy, velocity, order, where } = laws[flow];
  return {
    energy: [energy],
    equation: [
      row(dot("x"), "= V", "n"),
      ...velocity,
      row(frac(sub("φ", "i"), "dt"), "=", subsup("V", "i", "k+1"), "(", "φ", ")"),
      row(xAt("k+1"), "=", xAt("k"), "+ s", "φ", "n"),
    ],
    source: `${paper.curvature}: ${where}; ${t("the step in section 4")}`,
    symbols: [
      ["H", t("mean curvature by quadratic fits, positive on a sphere"), ""],
      ...(flow === "mean-curvature" || flow === "surface-diffusion"
        ? []
        : /** @type {Statement["symbols"]} */ ([["K", t("Gaussian curvature"), ""]])),
      ...(flow === "mmcv"
        ? /** @type {Statement["symbols"]} */ ([
            ["◇", t("gradient with the other curvature along each principal direction"), ""],
          ])
        : []),
      ["n", t("outward normal"), ""],
      [sub("V", "i"), t("linear in the next φ: one factor of each product is new"), ""],
      ["s", t("share of the step: no vertex moves by more than half an edge"), ""],
      ...stepSize(s, power("ℓ", order), t("without a unit; ℓ² is the area of a free patch")),
    ],
  };
}

/** @param {Readonly<PageState>} s @returns {Statement} */
function flips(s) {
  const { criterion } = s.options;
  const a = sub.bind(null, "a");
  const around = (/** @type {string} */ m) =>
    row(beta(`${m}ilk`), "+", beta(`${m}jkl`), "+", beta(`${m}kij`), "+", beta(`${m}lji`));
  /** @type {Record<string, { energy: Part[], gain: Part[], where: string }>} */
  const rules = {
    area: {
      energy: [row("A =", sum("t"), sub("a", "t"))],
      gain: [row(sub("f", "a"), "=", a("ikj"), "+", a("ijl"), "−", a("ikl"), "−", a("jlk"))],
      where: t("eq. (1)"),
    },
    willmore: {
      energy: [row("W =", sum("v"), "(", sum("e"), "β", "− 2", "π", ")")],
      gain: [
        row("½", sub("f", "w"), "=", beta("iktj"), "+", beta("ilju"), "+", beta("jkiv")),
        row("+", beta("jlwi"), "−", beta("iktl"), "−", beta("ilku")),
        row("−", beta("jklv"), "−", beta("jlwk")),
      ],
      where: t("eqs. (2) and (4), with its third term β of jkiv, as it must be"),
    },
    localised: {
      energy: [row(sub("W", "m"), "=", around("m"), "− 2", "π")],
      gain: [
        row(sub("f", "l"), "=", sub("W", "m"), "−", sub("W", "n")),
        row("=", around("m")),
        row("− (", around("n"), ")"),
      ],
      where: t("eq. (5)"),
    },
  };
  const { energy, gain, where } = rules[criterion];
  const now = s.reading?.flips?.[0];
  return {
    energy,
    equation: [
      ...gain,
      row("flip", sup("e", "*"), "=", "arg max", "f (", "e", ") ,", "f (", sup("e", "*"), ") > 0"),
    ],
    source: `${paper.flips}: ${where}`,
    symbols: [
      [row("e = ( i , j )"), t("an edge, with apexes k and l"), ""],
      ["β", t("angle between circumcircles, of four vertices in order"), ""],
      ["a", t("area of a triangle"), ""],
      ...(criterion === "localised"
        ? /** @type {Statement["symbols"]} */ ([
            [row("m , n"), t("the middles of (i, j) and (k, l)"), ""],
          ])
        : []),
      ...(criterion === "willmore"
        ? /** @type {Statement["symbols"]} */ ([
            [row("t , u , v , w"), t("the vertices beyond ik, il, jk and jl"), ""],
          ])
        : []),
      ["f", t("what the last flip gained"), number(now?.reduction)],
      ["A", t("area now"), number(now?.area)],
      ["W", t("Willmore energy now"), number(now?.circle)],
    ],
  };
}

/** @param {Readonly<PageState>} s @returns {Statement} */
export function statementOf(s) {
  const { family } = flowOf(s.options.flow);
  if (family === "circle") return circle(s);
  if (family === "p-willmore") return pWillmore(s);
  return family === "flips" ? flips(s) : byCurvature(s);
}
