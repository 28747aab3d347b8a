//! Missing sides of solid shapes.

use super::boundary::Rim;
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Faces that meet at more than this angle, in degrees, meet in an edge of the shape.
const CREASE: f64 = 50.0;
/// So many of those end at the rim of a missing side.
const CORNERS: usize = 3;
/// A rim in a plane leaves it by no more than this share of its size.
const FLAT: f64 = 0.01;

/// Whether a hole lies in a plane and edges of the shape end at its rim, as where a side of a box is
/// missing. A smooth patch would go on from the faces around it, and bulge: a membrane is that side.
pub(super) fn is_side(mesh: &HalfedgeMesh, x: &[DVec3], rim: &Rim) -> bool {
    let points: Vec<DVec3> = rim.vertices.iter().map(|v| x[*v as usize]).collect();
    is_flat(&points) && corners(mesh, x, &rim.vertices) >= CORNERS
}

fn is_flat(points: &[DVec3]) -> bool {
    let centre = points.iter().sum::<DVec3>() / points.len() as f64;
    let arms = || points.iter().map(|p| *p - centre);
    let next = arms().cycle().skip(1);
    let normal = arms().zip(next).map(|(a, b)| a.cross(b)).sum::<DVec3>();
    let normal = normal.normalize_or_zero();
    let size = arms().map(DVec3::length).fold(0.0, f64::max);
    normal != DVec3::ZERO && arms().all(|arm| arm.dot(normal).abs() <= FLAT * size)
}

/// Vertices of the rim at which an edge of the shape ends.
fn corners(mesh: &HalfedgeMesh, x: &[DVec3], rim: &[u32]) -> usize {
    let least = CREASE.to_radians().cos();
    let ends = |v: &&u32| {
        let spokes: Vec<DVec3> = mesh
            .neighbours(Vertex(**v))
            .map(|w| x[w.index()] - x[**v as usize])
            .collect();
        let across = |k: usize| spokes[k].cross(spokes[k + 1]).normalize_or_zero();
        (1..spokes.len().saturating_sub(1)).any(|k| across(k - 1).dot(across(k)) < least)
    };
    rim.iter().filter(ends).count()
}
