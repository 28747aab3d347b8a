//! Where a surface bends most within one edge: a neck or a tip that the mesh hardly shows.

use super::{curvature, measure};
use crate::mesh::{Face, HalfedgeMesh, Vertex};
use glam::DVec3;

/// Neighbours of the sharpest vertex that bend at least so much of it belong to the same neck.
const SHARE: f64 = 0.5;
/// The faces within so many widths of a neck, or of its longest edge, go around it.
const WIDE: f64 = 4.0;
/// Vertices that are told of a neck.
const MOST: usize = 200;
/// Total Gaussian curvature below which a ring is a neck beyond doubt: a whole catenoid has −4π.
const NECK: f64 = -1.0;

/// Where the surface bends most in one edge.
pub struct Sharpest {
    /// The vertex.
    pub vertex: u32,
    /// 2|H|√m there, m its area: an edge length over a radius of curvature; no unit. On a
    /// closed ring of n edges of equilateral triangles about a cylinder it is 5.8/n. Where the
    /// ring is a neck beyond doubt it is 2|H| times the longest edge there, if that is more: a mesh
    /// that is fine around a neck and coarse along it shows it no better.
    pub bend: f64,
    /// |H| there.
    pub mean_curvature: f64,
    /// The vertices about it that bend as much.
    pub ring: Vec<u32>,
    /// Whether it is a neck: the faces near by, some widths of a neck so thin, go around, and their total
    /// Gaussian curvature is negative. That of a tip is positive, and its faces are a disk.
    pub is_neck: bool,
}

deferred! {
    /// The largest 2|H|√m of interior vertices, with the vertices about it.
    pub fn sharpest(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<Sharpest> {
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
        let mut is_known = vec![false; x.len()];
        is_known[top.index()] = true;
        let mut next = 0;
        while let Some(&v) = ring.get(next) {
            next += 1;
            for w in mesh.neighbours(v) {
                if bend(w) > SHARE * most && !is_known[w.index()] {
                    is_known[w.index()] = true;
                    ring.push(w);
                }
            }
        }
        let defect = curvature::integrated_gauss_curvature(mesh, x);
        let total: f64 = ring.iter().map(|v| defect[v.index()]).sum();
        let mean_curvature = 0.5 * most / areas[top.index()].sqrt();
        let edges = mesh.neighbours(top);
        let edges = edges.map(|w| x[w.index()].distance(x[top.index()]));
        let longest = edges.fold(0.0, f64::max);
        let along = 2.0 * mean_curvature * longest;
        // A neck is 1/|H| wide.
        let reach = longest.max(1.0 / mean_curvature);
        let near = joined_within(mesh, x, top, WIDE * reach);
        let inside = mesh
            .vertices()
            .filter(|v| near[v.index()] && !mesh.is_boundary_vertex(*v));
        let curvature: f64 = inside.map(|v| defect[v.index()]).sum();
        let is_neck = curvature < 0.0 && goes_around(mesh, &near);
        Some(Sharpest {
            vertex: top.0,
            bend: if total < NECK { along.max(most) } else { most },
            mean_curvature,
            ring: ring.into_iter().take(MOST).map(|v| v.0).collect(),
            is_neck,
        })
    }
}

/// The vertices that are joined to one within a distance of it.
fn joined_within(mesh: &HalfedgeMesh, x: &[DVec3], top: Vertex, distance: f64) -> Vec<bool> {
    let mut near = vec![false; x.len()];
    near[top.index()] = true;
    let mut found = vec![top];
    while let Some(v) = found.pop() {
        for w in mesh.neighbours(v) {
            let is_new = !near[w.index()];
            if is_new && x[w.index()].distance(x[top.index()]) < distance {
                near[w.index()] = true;
                found.push(w);
            }
        }
    }
    near
}

/// Whether the faces at some vertices that hang together are no disk: their Euler characteristic is
/// below one, as that of an annulus is.
fn goes_around(mesh: &HalfedgeMesh, near: &[bool]) -> bool {
    let (mut is_vertex, mut is_edge) = (near.to_vec(), vec![false; mesh.n_edges()]);
    let mut faces = 0;
    let is_near = |f: &Face| mesh.face_vertices(*f).any(|v| near[v.index()]);
    for f in mesh.faces().filter(is_near) {
        faces += 1;
        for h in mesh.cycle(mesh.halfedge_of_face(f)) {
            is_vertex[mesh.tail(h).index()] = true;
            is_edge[h.edge().index()] = true;
        }
    }
    let count = |of: &[bool]| of.iter().filter(|is| **is).count();
    count(&is_vertex) + faces < count(&is_edge) + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    /// Of a waist of six edges, a saddle (which curves both ways too, but goes around nothing) and a
    /// flat ellipsoid (whose rim goes around, and curves one way).
    #[test]
    fn a_neck_goes_around_and_curves_both_ways() {
        let waist = |p: DVec3| {
            let girth = 0.1 + p.z * p.z;
            DVec3::new(p.x * girth, p.y * girth, p.z)
        };
        let saddle = |p: DVec3| 3.0 * DVec3::Z * p.x * p.y + p.with_z(0.0);
        let flat = |p: DVec3| p * DVec3::new(1.0, 1.0, 0.1);
        let around = vec![("around".to_owned(), 6.0)];
        type Shaping<'a> = &'a dyn Fn(DVec3) -> DVec3;
        let cases: [(&str, Vec<_>, Shaping, bool); 3] = [
            ("cylinder", around, &waist, true),
            ("disk", vec![], &saddle, false),
            ("icosphere", vec![], &flat, false),
        ];
        for (name, values, shaped, is_neck) in cases {
            let built = build(&shape::make(name, &values).expect("a shape").soup);
            let built = built.expect("a surface");
            let x: Vec<DVec3> = built.positions.iter().map(|p| shaped(*p)).collect();
            let found = sharpest(&built.mesh, &x).expect("a vertex");
            assert_eq!(
                found.is_neck,
                is_neck,
                "{name}: {} vertices",
                found.ring.len()
            );
        }
    }
}
