//! Inversion in a sphere, the Möbius transformation that is no similarity.

use super::measure::{bounding_box, triangle_points, volume};
use super::nearest::point_triangle_distance;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// x ↦ `image` + r² M (x − c)/|x − c|² with c the centre, r the radius and M the identity or a
/// reflection.
///
/// With `image` = c it is the inversion in the sphere about c, followed by a reflection in a
/// plane through c if there is a `mirror`; either way it undoes itself. Any other `image`
/// moves the result. Circles go to circles, and angles between them stay.
///
/// An inversion alone reverses orientation: of a closed surface around c the outside becomes
/// the inside as well, and its normals, by the order of its corners, still point outward. Of
/// any other surface they would not; there the reflection mends it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inversion {
    /// c.
    pub centre: DVec3,
    /// r.
    pub radius: f64,
    /// Unit normal of the mirror.
    pub mirror: Option<DVec3>,
    /// Where a point at infinity goes.
    pub image: DVec3,
}

impl Inversion {
    /// The image of a point.
    pub fn apply(&self, x: DVec3) -> DVec3 {
        let from = x - self.centre;
        let from = self.mirror.map_or(from, |m| from - 2.0 * from.dot(m) * m);
        self.image + (self.radius * self.radius / from.length_squared()) * from
    }

    /// The inversion about `centre` of a surface at `x` that keeps the middle and the diagonal
    /// of its bounding box, and the side its normals point to. The farther the centre, the
    /// nearer it is to doing nothing.
    pub fn framed(mesh: &HalfedgeMesh, x: &[DVec3], centre: DVec3) -> Self {
        let (low, high) = bounding_box(x);
        let middle = 0.5 * (low + high);
        let plain = Self {
            centre,
            radius: 1.0,
            mirror: None,
            image: DVec3::ZERO,
        };
        let mapped = |map: &Self| -> Vec<DVec3> { x.iter().map(|&p| map.apply(p)).collect() };
        let mut map = plain;
        let mut y = mapped(&map);
        let turns_inside_out = match (volume(mesh, x), volume(mesh, &y)) {
            (Some(before), Some(after)) => before * after < 0.0,
            // Open or one-sided: as seen from a centre far away.
            _ => true,
        };
        if turns_inside_out {
            let towards = (middle - centre).try_normalize().unwrap_or(DVec3::Z);
            map.mirror = Some(towards);
            y = mapped(&map);
        }
        let (to_low, to_high) = bounding_box(&y);
        let scale = (high - low).length() / (to_high - to_low).length();
        Self {
            radius: scale.sqrt(),
            image: middle - scale * 0.5 * (to_low + to_high),
            ..map
        }
    }
}

/// Distance from a point to a surface.
pub fn distance_to_surface(mesh: &HalfedgeMesh, x: &[DVec3], p: DVec3) -> f64 {
    mesh.faces()
        .map(|f| point_triangle_distance(p, triangle_points(mesh, x, f)))
        .fold(f64::INFINITY, f64::min)
}
