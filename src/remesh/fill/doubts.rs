//! What to say of a patch that is not all it could be.

use super::Job;
use super::fair::Lowered;
use crate::mesh::counted;
use std::f64::consts::{PI, TAU};

/// A hole that asks for more than so many times the total curvature of a hemisphere is only
/// guessed at. Of a hemisphere's own rim half a ring counts with the hole, which on coarse
/// meshes is a tenth.
const LARGEST: f64 = 1.2;

/// ∫K dA over a disc that continues the surface around it, by Gauss–Bonnet: 2π − Σ(π − α) with
/// the interior angles α that the surface around leaves it. 0 for a hole of a plane, 4π for
/// its outline.
pub(super) fn total_curvature(angles: &[f64]) -> f64 {
    TAU - angles.iter().map(|angle| PI - angle).sum::<f64>()
}

/// Sentences about one patch.
pub(super) fn of(job: &Job) -> impl Iterator<Item = String> {
    size(job).into_iter().chain(order(job))
}

fn size(job: &Job) -> Option<String> {
    let hemispheres = job.total_curvature? / TAU;
    (hemispheres > LARGEST && job.patch.n_free() > 0).then(|| {
        format!(
            "The hole at {} is larger than a hemisphere: closing it smoothly takes {hemispheres:.1} \
             times as much curvature, and its shape is a guess.",
            loops(job)
        )
    })
}

fn order(job: &Job) -> Option<String> {
    let why = match job.lowered? {
        Lowered::NearBoundary => "there are fewer than three rings of surface around it".to_owned(),
        Lowered::Size => format!(
            "it has {}",
            counted(job.patch.n_free(), "new vertex", "new vertices")
        ),
        Lowered::Folds => "a smoother one would fold over".to_owned(),
        Lowered::Rough => "the surface around it is too rough to be continued".to_owned(),
    };
    let how = match job.order {
        2 => "meets the surface around it with its tangent planes but not its curvature",
        1 => "meets the surface around it with a kink",
        _ => "stays a membrane",
    };
    Some(format!("The patch at {} {how}, as {why}.", loops(job)))
}

/// The loops in words.
fn loops(job: &Job) -> String {
    let numbers: Vec<String> = job.rim.loops.iter().map(usize::to_string).collect();
    let noun = if numbers.len() == 1 { "loop" } else { "loops" };
    format!("{noun} {}", numbers.join(", "))
}
