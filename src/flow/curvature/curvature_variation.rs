//! Minimal mean-curvature-variation flow, of sixth order: decreases F = ∫|∇H|² dA.
//!
//! Xu & Zhang [XZ06](crate::bibliography#xz06), equations (3.1) and (3.8):
//!
//! ```math
//! V = -\bigl(\Delta^2 H + 2 (2H^2 - K) \Delta H + 2 \langle \nabla H, \diamond H \rangle
//!   - 2H |\nabla H|^2\bigr), \qquad \frac{dF}{dt} = -\int V^2 \, dA.
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
/// ```math
/// V' = -\bigl(\Delta^2 H' + (2H^2 - K) \Delta H' + (2H \Delta H - |\nabla H|^2) H'
///   - \Delta H \, K' + \langle \diamond H - H \nabla H, \nabla H' \rangle
///   + \langle \nabla H, \diamond H' \rangle\bigr).
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
