//! Whether a mesh needs a pass: by its angles, and by its edges against their wanted lengths.

use super::draft::Draft;
use super::{Kind, size};
use crate::geometry::measure::{min_angle_degrees, triangle_angles, triangle_points};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// Smallest angle, in degrees, below which a mesh needs a pass …
const SMALLEST: f64 = 22.0;
/// … and below which it needs one at once.
const URGENT: f64 = 15.0;
/// Smallest angle below which a mesh is none for a flow to begin with.
const THIN: f64 = 2.0;
/// The angle that all but one in a hundred are above.
const QUANTILE: f64 = 30.0;
const QUANTILE_SHARE: usize = 100;
/// Lengths over the wanted ones that all but one edge in a hundred are between.
const LENGTHS: std::ops::RangeInclusive<f64> = 0.48..=1.6;
const LENGTHS_SHARE: usize = 100;

/// Whether a pass cannot wait.
pub fn is_urgent(mesh: &HalfedgeMesh, x: &[DVec3]) -> bool {
    min_angle_degrees(mesh, x) < URGENT
}

/// Whether a mesh has triangles too thin for a flow to begin with: those of many parts of machines, and
/// of rough scans.
pub fn is_unfit(mesh: &HalfedgeMesh, x: &[DVec3]) -> bool {
    min_angle_degrees(mesh, x) < THIN
}

/// Whether a pass would do good, on a mesh that is to have so many vertices.
pub fn is_due(mesh: &HalfedgeMesh, x: &[DVec3], kind: Kind, vertices: usize) -> bool {
    let corners = mesh
        .faces()
        .flat_map(|f| triangle_angles(triangle_points(mesh, x, f)));
    let mut angles: Vec<f64> = corners.map(f64::to_degrees).collect();
    angles.sort_unstable_by(f64::total_cmp);
    let quantile = angles.get(angles.len() / QUANTILE_SHARE);
    if angles.first().is_some_and(|a| *a < SMALLEST) || quantile.is_some_and(|a| *a < QUANTILE) {
        return true;
    }
    let mut draft = Draft::of(mesh, x, &vec![false; x.len()]);
    draft.size = size::field(&draft, kind, vertices);
    let edges = draft.edges();
    let off = edges
        .iter()
        .filter(|e| !LENGTHS.contains(&draft.stretch(**e)));
    off.count() * LENGTHS_SHARE > edges.len()
}
