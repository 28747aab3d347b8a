//! What Huisken [H87](crate::bibliography#h87) proves of volume-preserving mean-curvature flow:
//! it makes convex surfaces round.

use super::figure::{Figure, Finding};
use super::measure::{off_sphere, volume_drift};
use super::measured::Run;
use crate::flow::Status;

/// How far the volume may drift, relative.
const KEPT: f64 = 1e-10;
/// How far the end may be from a sphere.
const ROUND: f64 = 2e-3;

fn round(run: &Run<'_>) -> Finding {
    // The square of the reduced volume, 36πV²/A³.
    let ratio = |volume: Option<f64>| volume.map_or(f64::NAN, |volume| volume.powi(2));
    let [first, last] = [run.first, run.last].map(|state| ratio(state.reduced_volume));
    let (drift, off) = (volume_drift(run.first, run.last), off_sphere(run.x));
    let status = run.last.status;
    let values = [
        ("first", first.into()),
        ("last", last.into()),
        ("off", off.into()),
        ("drift", drift.into()),
        ("steps", run.last.step.into()),
        ("status", status.into()),
    ];
    let is_round = off < ROUND && last > 0.99 && last > first;
    let ok = is_round && drift < KEPT && status == Status::Converged;
    Finding::new(ok, "measured-isoperimetric", &values)
}

pub(super) static FIGURES: &[Figure] = &[Figure {
    id: "volume-preserving-round",
    paper: "volume-preserving",
    number: "1987",
    sample: "spheroid",
    judge: round,
    ..Figure::PLAIN
}];
