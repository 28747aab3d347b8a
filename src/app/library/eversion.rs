//! The sphere turned inside out by its own bending: Francis, Sullivan, Kusner, Brakke, Hartman
//! and Chappell, The minimax sphere eversion, [FSKBHC97](crate::bibliography#fskbhc97).
//!
//! Smale's theorem [S58](crate::bibliography#s58) says that there is an eversion, a regular
//! homotopy from the round sphere to itself with its sides exchanged; it may pass through itself
//! but never crease. By Max and Banchoff [MB81](crate::bibliography#mb81), each passes through a
//! surface with a quadruple point, and ∫H² is at least 16π there by Li and Yau. Morin's surface
//! after Kusner is critical and has exactly that much. It is a saddle: pushed to either side it
//! flows down to the round sphere, and the two ways make the eversion.

use super::figure::{Figure, Finding, Steps};
use super::measured::Run;
use crate::app::State;
use std::f64::consts::PI;

/// ∫H² of any sphere.
const SPHERE: f64 = 4.0 * PI;
/// The same at the end, over that of a sphere, at most.
const ROUND: f64 = 1.005;
/// How far the volume at the end may be from that of the ball, relative.
const BALL: f64 = 0.01;
/// Least product of a face normal with a normal at its corners, on every surface: one that is
/// immersed has no crease.
const IMMERSED: f64 = 0.3;

/// Signed volume over that of the ball of the same area.
fn share_of_ball(state: &State) -> f64 {
    let ball = state.area.powf(1.5) / (6.0 * PI.sqrt());
    state.volume.map_or(f64::NAN, |volume| volume / ball)
}

fn everted(run: &Run<'_>) -> Finding {
    let Some(back) = run.back() else {
        return Finding::new(false, "measured-incomplete", &[]);
    };
    let ends = [back, run.last];
    let energies = ends.map(|end| end.energy / SPHERE);
    let volumes = ends.map(share_of_ball);
    let crossings = ends.map(|end| end.crossings);
    let alignment = run.least_alignment();
    let values = [
        ("halfway", (run.first.energy / SPHERE).into()),
        ("firstEnergy", energies[0].into()),
        ("lastEnergy", energies[1].into()),
        ("firstVolume", volumes[0].into()),
        ("lastVolume", volumes[1].into()),
        ("crossings", run.first.crossings.map(|n| n as f64).into()),
        ("firstCrossings", crossings[0].map(|n| n as f64).into()),
        ("lastCrossings", crossings[1].map(|n| n as f64).into()),
        ("alignment", alignment.into()),
    ];
    let is_round = energies.iter().all(|&energy| energy < ROUND);
    let is_turned = (volumes[0] - 1.0).abs() < BALL && (volumes[1] + 1.0).abs() < BALL;
    let is_embedded = crossings == [Some(0); 2] && run.first.crossings > Some(0);
    let ok = is_round && is_turned && is_embedded && alignment > IMMERSED;
    Finding::new(ok, "measured-eversion", &values)
}

const HALVES: Figure = Figure {
    paper: "eversion",
    number: "1997",
    steps: Steps::Count(600),
    // As little as the sample is pushed to the other side: between the two no seam is seen.
    back: Some(&[("push", 0.03)]),
    quick: false,
    judge: everted,
    ..Figure::PLAIN
};

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "eversion",
        sample: "morin",
        quick: true,
        ..HALVES
    },
    Figure {
        id: "eversion-fine",
        sample: "morin-fine",
        ..HALVES
    },
];
