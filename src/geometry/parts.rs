//! Surfaces in several parts that hang together with no other.

use super::measure;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// The centre of the first of several parts whose area from `before` to `now` has shrunk below
/// a share of itself.
pub fn shrunken_part(
    mesh: &HalfedgeMesh,
    before: &[DVec3],
    now: &[DVec3],
    share: f64,
) -> Option<DVec3> {
    let (part_of, count) = mesh.components();
    if count < 2 {
        return None;
    }
    let areas = |x: &[DVec3]| {
        let mut areas = vec![0.0; count];
        for (of, area) in part_of.iter().zip(measure::vertex_areas(mesh, x)) {
            areas[*of as usize] += area;
        }
        areas
    };
    let (first, last) = (areas(before), areas(now));
    let part = (0..count).find(|&part| last[part] < share * first[part])?;
    let inside = part_of
        .iter()
        .zip(now)
        .filter(|(of, _)| **of as usize == part);
    let (sum, n) = inside.fold((DVec3::ZERO, 0.0), |(sum, n), (_, p)| (sum + *p, n + 1.0));
    Some(sum / n)
}
