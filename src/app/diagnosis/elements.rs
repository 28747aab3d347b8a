//! Where on the surface it is: the elements that a sentence names.

use crate::energy::circle::angle::diamond_angle;
use crate::geometry::{curvature, quality};
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Circle angles below this are those of four points on a circle, up to roundoff: there the
/// exact energy's gradient is left out.
const KINK: f64 = 1e-6;

/// The vertex with the largest |H|.
pub(super) fn most_curved(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<u32> {
    let curvature = curvature::pointwise_mean_curvature(mesh, x);
    let size = |v: &usize| curvature[*v].abs();
    (0..x.len())
        .max_by(|a, b| size(a).total_cmp(&size(b)))
        .map(|v| v as u32)
}

/// Interior edges with a vertex that moves whose four points lie on a circle: two ends each.
pub(super) fn cocircular_edges(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    is_free: impl Fn(usize) -> bool,
) -> Vec<u32> {
    let at = |v: Vertex| x[v.index()];
    mesh.edges()
        .filter(|&e| !mesh.is_boundary_edge(e))
        .filter(|&e| {
            let ([i, j], [k, l]) = (mesh.ends(e), mesh.opposite_vertices(e));
            [i, j, k, l].iter().any(|v| is_free(v.index()))
                && diamond_angle(at(k), at(j), at(l), at(i)).beta < KINK
        })
        .flat_map(|e| mesh.ends(e).map(|v| v.0))
        .collect()
}

/// Faces that lie against their neighbours.
pub(super) fn folded_faces(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<u32> {
    let folded = mesh.faces().filter(|&f| quality::is_folded(mesh, x, f));
    folded.map(|f| f.0).collect()
}
