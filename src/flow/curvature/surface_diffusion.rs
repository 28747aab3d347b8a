//! Surface diffusion, V = ΔH: decreases the area and keeps the volume, of a closed surface to the
//! last digits (see `kept`).
//!
//! In the paper's sign of H the velocity is −ΔH.

use super::curvatures::Curvatures;
use super::velocity::Velocity;
use crate::flow::FlowError;

/// V_i = Σ_j Δ_ij H_j.
pub(super) fn linearise(
    at: &Curvatures,
    i: usize,
    velocity: &mut Velocity,
) -> Result<(), FlowError> {
    let row = at.row(i)?;
    let weights = at.operators.laplacian(row);
    for (&j, weight) in at.operators.members(row).iter().zip(weights) {
        velocity.add(j, *weight);
    }
    Ok(())
}
