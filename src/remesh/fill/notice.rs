//! What to say of a patch that is not all it could be.

use super::fair::Lowered;
use super::{FillNotice, Job};
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

/// Notices of one patch.
pub(super) fn of(job: &Job) -> impl Iterator<Item = FillNotice> {
    size(job).into_iter().chain(order(job))
}

fn size(job: &Job) -> Option<FillNotice> {
    let hemispheres = job.total_curvature? / TAU;
    (hemispheres > LARGEST && job.patch.n_free() > 0).then(|| FillNotice::LargeHole {
        loops: job.rim.loops.clone(),
        hemispheres,
    })
}

fn order(job: &Job) -> Option<FillNotice> {
    let cause = match job.lowered? {
        Lowered::NearBoundary => "near-boundary",
        Lowered::Size => "size",
        Lowered::Folds => "folds",
        Lowered::Rough => "rough",
        Lowered::Side => "side",
    };
    Some(FillNotice::LowOrder {
        loops: job.rim.loops.clone(),
        order: job.order,
        cause,
        vertices: job.patch.n_free(),
    })
}
