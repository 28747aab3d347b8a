//! Knots and links that come undone. An immersed surface may pass through itself, and what is knotted
//! and what is not can then be carried into each other: Pinkall
//! [P85](crate::bibliography#p85). A knotted tube that bends less and less ends as the torus
//! that bends least, Clifford's, with ∫H² = 2π² by Marques and Neves
//! [MN14](crate::bibliography#mn14); two tubes as two of these.

use super::figure::{Figure, Finding, Steps};
use super::measure::{area_drift, near};
use super::measured::Run;
use std::f64::consts::PI;

/// How far the end may be from the energy of smooth tori, relative.
const MET: f64 = 0.01;
/// How far the area may drift, relative.
const KEPT: f64 = 1e-8;

fn undone(run: &Run<'_>, tubes: usize) -> Finding {
    let info = run.info();
    let least = 2.0 * PI * PI * tubes as f64;
    let (first, last) = (run.first.energy, run.last.energy);
    let [most, left] = run.crossings();
    let drift = area_drift(run.first, run.last);
    let values = [
        ("tubes", tubes.into()),
        ("first", (first / least).into()),
        ("last", (last / least).into()),
        ("crossings", most.into()),
        ("left", left.into()),
        ("alignment", run.least_alignment().into()),
        ("drift", drift.into()),
        ("status", run.last.status.into()),
    ];
    let is_torus = info.components == tubes && info.genus == Some(tubes as i64);
    let ok = is_torus && near(last, least, MET) && drift < KEPT && most > 0;
    Finding::new(ok, "measured-undone", &values)
}

const PLAIN: Figure = Figure {
    paper: "knots",
    number: "1985",
    steps: Steps::Rest,
    quick: false,
    ..Figure::PLAIN
};

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "knot-undone",
        sample: "trefoil-tube",
        judge: |run| undone(run, 1),
        ..PLAIN
    },
    Figure {
        id: "link-undone",
        sample: "linked-tubes",
        judge: |run| undone(run, 2),
        quick: true,
        ..PLAIN
    },
];
