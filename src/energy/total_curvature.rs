//! Total mean curvature ∫2H dA of a triangle mesh.

use crate::geometry::measure::face_vector_area;
use crate::mesh::{Edge, HalfedgeMesh};
use glam::DVec3;

/// Exterior dihedral angle θ_e in (−π, π), positive where the surface bends as a sphere
/// with outward normal; 0 on the boundary.
fn dihedral_angle(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> f64 {
    if mesh.is_boundary_edge(e) {
        return 0.0;
    }
    let h = e.halfedge();
    let normal = |f| face_vector_area(mesh, x, f).normalize_or_zero();
    let (m, n) = (normal(mesh.face(h)), normal(mesh.face(h.twin())));
    let [a, b] = mesh.ends(e).map(|v| x[v.index()]);
    (b - a).normalize_or_zero().dot(m.cross(n)).atan2(m.dot(n))
}

/// Σ_e |e| θ_e, which tends to ∫2H dA; unit length, positive on a sphere (8πR).
pub fn value(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    mesh.edges()
        .map(|e| {
            let [a, b] = mesh.ends(e);
            x[a.index()].distance(x[b.index()]) * dihedral_angle(mesh, x, e)
        })
        .sum()
}

/// Adds `factor` times the gradient: Σ_e θ_e ∂|e|, for by Schläfli's formula the angles'
/// own change, Σ_e |e| ∂θ_e, vanishes on a closed surface.
pub fn add_gradient(mesh: &HalfedgeMesh, x: &[DVec3], factor: f64, gradient: &mut [DVec3]) {
    for e in mesh.edges() {
        let [a, b] = mesh.ends(e).map(|v| v.index());
        let along = (x[b] - x[a]).normalize_or_zero();
        let push = factor * dihedral_angle(mesh, x, e) * along;
        gradient[b] += push;
        gradient[a] -= push;
    }
}
