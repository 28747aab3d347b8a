//! What the page states of a flow, symbol by symbol: the functional that does not rise, how a step
//! is solved, and what the symbols of both are. TeX; the equation of motion itself stands in the
//! row of the flow ([`super::spec`]).

use super::Monitored;
use super::spec::Family;
use serde::Serialize;

/// What does not rise.
pub const fn functional(monitored: Monitored) -> &'static [&'static str] {
    match monitored {
        Monitored::SmoothedCircle => &[
            r"E = \sum_i \Bigl( \sum_j \varphi(\beta_{ij}) - 2\pi \Bigr)",
            r"\varphi(\beta) = \sqrt{\beta^2 + \epsilon^2} - \epsilon",
        ],
        Monitored::Area => &[r"A = \int dA"],
        Monitored::Willmore => &[r"E = \int H^2 \, dA"],
        Monitored::PWillmore => &[r"E = \int |H|^p \, dA"],
        Monitored::Helfrich => &[r"E = \int (H - H_0)^2 \, dA + \tfrac14 (\sigma A - P V)"],
        Monitored::CurvatureVariation => &[r"F = \int \|\nabla H\|^2 \, dA"],
    }
}

/// Every functional.
pub const MONITORED: &[Monitored] = &[
    Monitored::SmoothedCircle,
    Monitored::Area,
    Monitored::Willmore,
    Monitored::PWillmore,
    Monitored::Helfrich,
    Monitored::CurvatureVariation,
];

/// How a step is solved, by the family and what chooses among its ways: an integrator, else the
/// scheme; nothing where there is one way.
pub const STEPS: &[(&str, &str)] = &[
    (
        "circle auto",
        r"\Bigl( \frac{M}{dt} + K_+ \Bigr) \Delta x = -\nabla E(x)",
    ),
    (
        "circle paper",
        r"\Bigl( \frac{I}{dt} + K \Bigr) \Delta x = -\nabla E(x)",
    ),
    (
        "circle forward-euler",
        r"\frac{M}{dt} \Delta x = -\nabla E(x)",
    ),
    (
        "circle backward-euler",
        r"\frac{M}{dt} \Delta x = -\nabla E(x + \Delta x)",
    ),
    ("circle l-bfgs", r"\Delta x = -\alpha B_k \nabla E(x)"),
    (
        "p-willmore auto",
        r"\Bigl( \frac{M}{dt} + L C L \Bigr) \Delta x = -\Pi \, 2^p (\nabla E + \lambda \nabla A - \mu \nabla V)",
    ),
    (
        "p-willmore paper",
        r"M \frac{x^{k+1} - x^k}{dt} = -2^p (\nabla E + \lambda \nabla A - \mu \nabla V)(\tfrac12 (x^k + x^{k+1}))",
    ),
    (
        "curvature",
        r"\frac{\varphi_i}{dt} = V_i^{k+1}(\varphi), \quad x^{k+1} = x^k + s \varphi n",
    ),
    ("flips", r"f(e) = W_m - W_n > 0"),
];

/// A symbol, and where it matters: where all that is said of it holds.
#[derive(Clone, Copy, Debug, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Symbol {
    /// As it is set.
    pub tex: &'static str,
    /// Its words and its value are called so.
    pub id: &'static str,
    /// Of flows of one of these families; of all where there is none.
    pub families: &'static [Family],
    /// Where this option is read.
    pub reads: Option<&'static str>,
    /// Where this is kept.
    pub keeps: Option<&'static str>,
    /// Where the equation of motion has it.
    pub in_formula: bool,
    /// Where it is not zero.
    pub is_set: bool,
}

const ANY: Symbol = Symbol {
    tex: "",
    id: "",
    families: &[],
    reads: None,
    keeps: None,
    in_formula: false,
    is_set: false,
};

const fn of(tex: &'static str, id: &'static str, families: &'static [Family]) -> Symbol {
    Symbol {
        tex,
        id,
        families,
        ..ANY
    }
}

const fn read(tex: &'static str, id: &'static str, option: &'static str) -> Symbol {
    Symbol {
        tex,
        id,
        reads: Some(option),
        ..ANY
    }
}

const fn kept(tex: &'static str, id: &'static str, keeps: &'static str) -> Symbol {
    Symbol {
        keeps: Some(keeps),
        ..read(tex, id, "keep")
    }
}

use Family::{Circle, Curvature, Flips, PWillmore};

/// In the order of the page.
pub const SYMBOLS: &[Symbol] = &[
    of(r"\beta_{ij}", "beta", &[Circle, Flips]),
    read(r"\epsilon", "epsilon", "epsilon"),
    read("p", "p", "p"),
    of("H", "mean", &[Circle, PWillmore, Curvature]),
    Symbol {
        in_formula: true,
        ..of("K", "gauss", &[])
    },
    of("n", "normal", &[Curvature]),
    Symbol {
        is_set: true,
        ..read(r"H_0 \ell", "spontaneous", "p")
    },
    kept(r"\lambda", "tension", "area"),
    kept(r"\mu", "pressure", "volume"),
    of("M", "mass", &[Circle, PWillmore]),
    of("K_+", "matrix", &[Circle]),
    read("dt", "dt", "dt"),
    read(r"\tau", "tau", "tau"),
    read("h", "edge", "epsilon"),
    read(r"\ell", "size", "p"),
    read("W_m, W_n", "localised", "criterion"),
];
