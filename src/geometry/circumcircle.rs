//! The circle through the corners of a triangle.

use glam::DVec3;
use std::f64::consts::TAU;

/// A circle in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub centre: DVec3,
    /// Two orthogonal vectors of its plane, as long as its radius.
    pub axes: [DVec3; 2],
}

impl Circle {
    /// The circumcircle, in the plane of the triangle; `None` where the corners are collinear.
    pub fn through([a, b, c]: [DVec3; 3]) -> Option<Self> {
        let (u, v) = (b - a, c - a);
        let w = u.cross(v);
        let normal = w.try_normalize()?;
        let from_a = (u.length_squared() * v.cross(w) + v.length_squared() * w.cross(u))
            / (2.0 * w.length_squared());
        let found = Self {
            centre: a + from_a,
            axes: [-from_a, normal.cross(-from_a)],
        };
        found.centre.is_finite().then_some(found)
    }

    /// Its radius.
    pub fn radius(&self) -> f64 {
        self.axes[0].length()
    }

    /// So many points of it, evenly around.
    pub fn points(&self, count: usize) -> impl Iterator<Item = DVec3> + '_ {
        (0..count).map(move |k| {
            let (sin, cos) = (TAU * k as f64 / count as f64).sin_cos();
            self.centre + cos * self.axes[0] + sin * self.axes[1]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_passes_through_the_corners_in_their_plane() {
        let corners = [
            DVec3::new(0.1, 0.2, -0.3),
            DVec3::new(1.3, -0.4, 0.5),
            DVec3::new(0.4, 0.9, 1.1),
        ];
        let circle = Circle::through(corners).expect("a circle");
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        for p in corners.into_iter().chain(circle.points(7)) {
            assert!((p.distance(circle.centre) - circle.radius()).abs() < 1e-15);
            assert!((p - corners[0]).dot(normal).abs() < 1e-15);
        }
        assert!(Circle::through([DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]).is_none());
    }
}
