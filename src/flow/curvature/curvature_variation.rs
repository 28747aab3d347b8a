//! Minimal mean-curvature-variation flow, of sixth order: decreases F = ∫|∇H|² dA.
//!
//! Xu & Zhang, equations (3.1) and (3.8):
//!
//! ```text
//! V = −(Δ²H + 2(2H² − K)ΔH + 2⟨∇H, ◇H⟩ − 2H|∇H|²),   dF/dt = −∫V² dA.
//! ```
//!
//! The paper's H and ◇ have the opposite sign; each term is odd in them, and its V is
//! the bracket itself. V has the unit 1/length⁵. Surfaces of constant mean curvature
//! stay as they are. F falls when a surface is scaled up: closed surfaces without held
//! vertices inflate.

use super::curvatures::Curvatures;
use super::velocity::Velocity;
use crate::flow::FlowError;

/// |∇H|².
pub(super) fn density(at: &Curvatures, row: usize, _i: usize) -> f64 {
    at.operators.gradient_of(row, &at.mean).length_squared()
}

/// The paper's splits, section 4: of every product one factor is taken at the next surface,
///
/// ```text
/// V' = −(Δ²H' + (2H²−K)ΔH' + (2HΔH − |∇H|²)H' − ΔH K' + ⟨◇H − H∇H, ∇H'⟩ + ⟨∇H, ◇H'⟩).
/// ```
pub(super) fn linearise(
    at: &Curvatures,
    i: usize,
    velocity: &mut Velocity,
) -> Result<(), FlowError> {
    let operators = &at.operators;
    let row = at.row(i)?;
    let members = operators.members(row);
    let (h, k) = (at.mean[i], at.gauss[i]);
    let laplacian = operators.laplacian_of(row, &at.mean);
    let gradient = operators.gradient_of(row, &at.mean);
    let diamond = operators.diamond_of(row, &at.mean);
    for (&j, weight) in members.iter().zip(operators.laplacian(row)) {
        let inner = at.row(j as usize)?;
        let weights = operators.laplacian(inner);
        for (&l, inner_weight) in operators.members(inner).iter().zip(weights) {
            velocity.add(l, -weight * inner_weight);
        }
    }
    let across = diamond - h * gradient;
    for (at, &j) in members.iter().enumerate() {
        let first = across.dot(operators.gradient(row)[at]);
        let second = gradient.dot(operators.diamond(row)[at]);
        let third = (2.0 * h * h - k) * operators.laplacian(row)[at];
        velocity.add(j, -(first + second + third));
    }
    velocity.add(i as u32, gradient.length_squared() - 2.0 * h * laplacian);
    velocity.on_gauss = laplacian;
    Ok(())
}
