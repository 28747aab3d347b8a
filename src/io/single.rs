//! Positions in single precision, which rounds at 2⁻²⁴ of the distance from the origin: far away
//! that would be more than what a mesh is made of.

use glam::DVec3;

use super::WriteError;

/// Coordinates beyond so many sizes of the mesh are rounded by more than 10⁻⁶ of its size.
const FAR: f64 = 16.0;

/// Where to measure positions from: the origin, or for a mesh far from it the middle of its box,
/// rounded to single precision itself.
pub(super) fn centre(positions: &[DVec3]) -> DVec3 {
    let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let high = positions
        .iter()
        .copied()
        .fold(DVec3::NEG_INFINITY, DVec3::max);
    let size = (high - low).max_element();
    let farthest = low.abs().max(high.abs()).max_element();
    let middle = (low + 0.5 * (high - low)).as_vec3();
    if farthest > FAR * size && middle.is_finite() {
        middle.as_dvec3()
    } else {
        DVec3::ZERO
    }
}

/// Smaller meshes are rounded by more than 10⁻⁶ of their size: numbers are 2⁻¹⁴⁹ apart at least.
const SMALLEST: f64 = 1.5e-39;

/// Refuses positions that single precision cannot hold, or cannot tell apart.
pub(super) fn check_positions(
    positions: impl Iterator<Item = DVec3> + Clone,
) -> Result<(), WriteError> {
    check(positions.clone())?;
    let first = positions.clone().next().unwrap_or_default();
    let size = positions.fold(0.0_f64, |size, p| size.max((p - first).abs().max_element()));
    match size {
        0.0 | SMALLEST.. => Ok(()),
        _ => Err(WriteError::BelowSingle),
    }
}

/// Refuses vectors that single precision cannot hold.
pub(super) fn check(vectors: impl IntoIterator<Item = DVec3>) -> Result<(), WriteError> {
    let found = vectors.into_iter().position(|v| !v.as_vec3().is_finite());
    found.map_or(Ok(()), |vertex| Err(WriteError::BeyondSingle { vertex }))
}
