//! Lawson's surfaces ξ_{g,1} [L70](crate::bibliography#l70). Kusner conjectures
//! [K89](crate::bibliography#k89) that of all closed surfaces with g handles their stereographic
//! images bend least, as by Marques & Neves [MN14](crate::bibliography#mn14) the Clifford torus
//! ξ_{1,1} does for g = 1.
//!
//! ∫H² is their area in the 3-sphere, which Heller, Heller & Traizet
//! [HHT23](crate::bibliography#hht23) expand in 1/(2g + 2):
//! 8π(1 − ln 2/(2g + 2) − (9/4)ζ(3)/(2g + 2)³ + …).

use super::figure::{Figure, Finding, Steps};
use super::measure::{area_drift, near};
use super::measured::Run;

/// How far the end may be from the energy of the smooth surface, relative: on some 2,400 vertices
/// it is half of that.
const MET: f64 = 0.007;
/// How far the area may drift, relative.
const KEPT: f64 = 1e-8;

/// Of g handles, with the energy `least`.
fn lawson(run: &Run<'_>, genus: usize, least: f64) -> Finding {
    let found = run.info().genus;
    let (first, last) = (run.first.energy, run.last.energy);
    let drift = area_drift(run.first, run.last);
    let values = [
        ("genus", found.map(|genus| genus as f64).into()),
        ("first", first.into()),
        ("last", last.into()),
        ("least", least.into()),
        ("off", (100.0 * (last / least - 1.0)).into()),
        ("drift", drift.into()),
        ("angle", run.last.min_angle_degrees.into()),
        ("status", run.last.status.into()),
    ];
    let ok = found == Some(genus as i64) && near(last, least, MET) && drift < KEPT;
    Finding::new(ok, "measured-lawson", &values)
}

const PLAIN: Figure = Figure {
    paper: "lawson",
    number: "1970",
    steps: Steps::Rest,
    ..Figure::PLAIN
};

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "lawson-2",
        sample: "lawson-two-handles",
        judge: |run| lawson(run, 2, 21.892),
        ..PLAIN
    },
    Figure {
        id: "lawson-3",
        sample: "lawson-three-handles",
        judge: |run| lawson(run, 3, 22.82),
        ..PLAIN
    },
];
