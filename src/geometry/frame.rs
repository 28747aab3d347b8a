//! Where a mesh lies: moved near the origin before any arithmetic on it.

use glam::DVec3;

/// Offsets below this many bounding diagonals are left alone, so that an ordinary
/// file's coordinates come back bit for bit.
const FAR: f64 = 16.0;

/// A translation that keeps coordinates small against the size of the mesh.
///
/// Far from the origin, positions have fewer digits left for the shape: at an offset
/// of 10⁶ diameters gradients are good to 1e-8 only.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// Subtracted from the file's coordinates.
    pub shift: DVec3,
}

impl Frame {
    /// The frame for these positions: no shift unless they lie far from the origin.
    pub fn of(x: &[DVec3]) -> Self {
        let (low, high) = x
            .iter()
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), &p| {
                (l.min(p), h.max(p))
            });
        let centre = 0.5 * (low + high);
        let far = !x.is_empty() && centre.length() > FAR * (high - low).length();
        Self {
            shift: if far { centre } else { DVec3::ZERO },
        }
    }

    /// Into the frame.
    pub fn enter(&self, x: &mut [DVec3]) {
        x.iter_mut().for_each(|p| *p -= self.shift);
    }

    /// Back to the file's coordinates.
    pub fn leave(&self, x: &[DVec3]) -> Vec<DVec3> {
        x.iter().map(|&p| p + self.shift).collect()
    }
}
