//! How good the triangles are, and which have folded over.

use super::measure::{face_vector_area, triangle_points};
use crate::interrupt::paced;
use crate::mesh::{Face, HalfedgeMesh};
use glam::DVec3;

/// Shape of a triangle: 4√3 area / Σ edge², 1 when equilateral, 0 when flat.
/// Scale-free.
pub fn triangle_quality([a, b, c]: [DVec3; 3]) -> f64 {
    let edges = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
    if edges > 0.0 {
        2.0 * 3f64.sqrt() * (b - a).cross(c - a).length() / edges
    } else {
        0.0
    }
}

/// Height over length of the longest side, at and below which a triangle has no area: the digits
/// that files are written with make as much of corners on a line.
const FLAT: f64 = 1e-8;

/// Whether a triangle has no area: corners on a line, or at one place.
pub fn is_flat([a, b, c]: [DVec3; 3]) -> bool {
    let sides = [
        a.distance_squared(b),
        b.distance_squared(c),
        c.distance_squared(a),
    ];
    (b - a).cross(c - a).length() <= FLAT * sides.into_iter().fold(0.0, f64::max)
}

/// Triangles without area.
pub fn flat_triangles(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<Face> {
    mesh.faces()
        .filter(|f| is_flat(triangle_points(mesh, x, *f)))
        .collect()
}

/// The worst triangle and its quality.
pub fn worst_triangle(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<(Face, f64)> {
    mesh.faces()
        .map(|f| (f, triangle_quality(triangle_points(mesh, x, f))))
        .min_by(|a, b| a.1.total_cmp(&b.1))
}

/// Normal of a triangle, as long as twice its area.
fn scaled_normal(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> DVec3 {
    let [a, b, c] = triangle_points(mesh, x, f);
    (b - a).cross(c - a)
}

/// Whether a face is folded over: its normal opposes the sum of its neighbours'.
///
/// Uses the orientation of neighbours only, so that twisted edges do no harm.
pub fn is_folded(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> bool {
    let sides = mesh.cycle(mesh.halfedge_of_face(f));
    let neighbours = sides.filter(|h| mesh.face(h.twin()).is_some()).map(|h| {
        let n = scaled_normal(mesh, x, mesh.face(h.twin())).normalize_or_zero();
        if mesh.is_twisted(h.edge()) { -n } else { n }
    });
    neighbours.sum::<DVec3>().dot(scaled_normal(mesh, x, f)) < 0.0
}

/// Faces folded over between two states: their normal has turned by more than a right
/// angle, and afterwards opposes their neighbours'. A face that unfolds, or turns along
/// with its neighbours, is not one of them.
pub fn newly_folded(mesh: &HalfedgeMesh, before: &[DVec3], after: &[DVec3]) -> Vec<Face> {
    let turned =
        |f: &Face| scaled_normal(mesh, before, *f).dot(scaled_normal(mesh, after, *f)) < 0.0;
    paced(mesh.faces())
        .filter(turned)
        .filter(|f| is_folded(mesh, after, *f))
        .collect()
}

/// The face with the largest area, and that area over the mean.
pub fn largest_face(mesh: &HalfedgeMesh, x: &[DVec3]) -> (u32, f64) {
    let (mut face, mut largest, mut total) = (0, 0.0, 0.0);
    for f in paced(mesh.faces()) {
        let area = face_vector_area(mesh, x, f).length();
        total += area;
        if area > largest {
            (face, largest) = (f.0, area);
        }
    }
    (face, largest * mesh.n_faces() as f64 / total)
}
