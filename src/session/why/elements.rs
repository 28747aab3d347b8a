//! Where on the surface it is: the elements that a sentence names.

use crate::energy::circle::angle::diamond_angle;
use crate::geometry::{curvature, measure, quality};
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Circle angles below this are those of four points on a circle, up to roundoff: there the
/// exact energy's gradient is left out.
const KINK: f64 = 1e-6;
/// Neighbours of the sharpest vertex that bend at least so much of it belong to the same neck.
const SHARE: f64 = 0.5;

/// Where the surface bends most in one edge.
pub(super) struct Sharpest {
    /// The vertex.
    pub(super) vertex: u32,
    /// 2|H|√m there, m its area: an edge length over a radius of curvature; no unit. On a
    /// closed ring of n edges of equilateral triangles about a cylinder it is 5.8/n.
    pub(super) bend: f64,
    /// |H| there.
    pub(super) mean_curvature: f64,
    /// The vertices about it that bend as much.
    pub(super) ring: Vec<u32>,
    /// Whether their total Gaussian curvature is negative, as of a neck, and not positive, as
    /// of a tip.
    pub(super) is_neck: bool,
}

/// The largest 2|H|√m of interior vertices, with the vertices about it.
pub(super) fn sharpest(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<Sharpest> {
    let (gradient, areas) = (
        curvature::area_gradient(mesh, x),
        measure::vertex_areas(mesh, x),
    );
    let bend = |v: Vertex| {
        let area = areas[v.index()];
        if mesh.is_boundary_vertex(v) || area <= 0.0 {
            return 0.0;
        }
        gradient[v.index()].length() / area.sqrt()
    };
    let top = mesh
        .vertices()
        .max_by(|&a, &b| bend(a).total_cmp(&bend(b)))?;
    let most = bend(top);
    let mut ring = vec![top];
    let mut next = 0;
    while let Some(&v) = ring.get(next) {
        next += 1;
        for w in mesh.neighbours(v) {
            if bend(w) > SHARE * most && !ring.contains(&w) && ring.len() < 200 {
                ring.push(w);
            }
        }
    }
    let defect = curvature::integrated_gauss_curvature(mesh, x);
    let total: f64 = ring.iter().map(|v| defect[v.index()]).sum();
    Some(Sharpest {
        vertex: top.0,
        bend: most,
        mean_curvature: 0.5 * most / areas[top.index()].sqrt(),
        ring: ring.into_iter().map(|v| v.0).collect(),
        is_neck: total < 0.0,
    })
}

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
