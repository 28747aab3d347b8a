//! Willmore flow, V = ΔH + 2H(H² − K): decreases ∫H² dA.
//!
//! In the paper's sign of H the velocity is −(ΔH + 2H(H² − K)).

use super::curvatures::Curvatures;
use super::surface_diffusion;
use super::velocity::Velocity;
use crate::flow::FlowError;

/// H².
pub(super) fn density(at: &Curvatures, _row: usize, i: usize) -> f64 {
    at.mean[i].powi(2)
}

/// V_i = Σ_j Δ_ij H_j + (2H² − K)_i H_i − H_i K_i.
pub(super) fn linearise(
    at: &Curvatures,
    i: usize,
    velocity: &mut Velocity,
) -> Result<(), FlowError> {
    surface_diffusion::linearise(at, i, velocity)?;
    let (h, k) = (at.mean[i], at.gauss[i]);
    velocity.add(i as u32, 2.0 * h * h - k);
    velocity.on_gauss = -h;
    Ok(())
}
