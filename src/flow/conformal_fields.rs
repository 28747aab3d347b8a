//! The conformal maps of space that are no motions, as velocities: the scaling v = y and the
//! special conformal fields v = 2⟨b, y⟩y − |y|²b with b = e_x, e_y, e_z.
//!
//! ∫H² of a smooth closed surface does not change along them; that of a mesh does, a little. A
//! flow that has arrived would creep along them for ever, so their share is taken out of its
//! steps.

use glam::DVec3;

/// One scaling and three special conformal maps.
pub(super) const COUNT: usize = 4;

/// Velocity of the k-th field at y, the position from the centre over the size of the surface:
/// no unit.
pub(super) fn velocity(k: usize, y: DVec3) -> DVec3 {
    match k {
        0 => y,
        _ => {
            let b = DVec3::AXES[k - 1];
            2.0 * b.dot(y) * y - y.length_squared() * b
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A field is conformal if the symmetric part of its gradient is a multiple of the unit
    /// matrix.
    #[test]
    fn the_fields_are_conformal() {
        let at = DVec3::new(0.3, -0.8, 0.5);
        let step = 1e-5;
        for k in 0..COUNT {
            let column =
                |e: DVec3| (velocity(k, at + step * e) - velocity(k, at - step * e)) / (2.0 * step);
            let gradient = DVec3::AXES.map(column);
            let trace = gradient[0].x + gradient[1].y + gradient[2].z;
            let entries = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
            for (i, j) in entries {
                let symmetric = 0.5 * (gradient[i][j] + gradient[j][i]);
                let expected = if i == j { trace / 3.0 } else { 0.0 };
                assert!((symmetric - expected).abs() < 1e-9, "field {k}");
            }
        }
    }
}
