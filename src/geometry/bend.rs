//! Where a surface bends most within one edge: a neck or a tip that the mesh hardly shows.

use super::{curvature, measure};
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Neighbours of the sharpest vertex that bend at least so much of it belong to the same neck.
const SHARE: f64 = 0.5;
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
    /// Whether their total Gaussian curvature is negative, as of a neck, and not positive, as
    /// of a tip.
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
        let mut next = 0;
        while let Some(&v) = ring.get(next) {
            next += 1;
            for w in mesh.neighbours(v) {
                if bend(w) > SHARE * most && !ring.contains(&w) && ring.len() < MOST {
                    ring.push(w);
                }
            }
        }
        let defect = curvature::integrated_gauss_curvature(mesh, x);
        let total: f64 = ring.iter().map(|v| defect[v.index()]).sum();
        let mean_curvature = 0.5 * most / areas[top.index()].sqrt();
        let edges = mesh.neighbours(top);
        let edges = edges.map(|w| x[w.index()].distance(x[top.index()]));
        let along = 2.0 * mean_curvature * edges.fold(0.0, f64::max);
        Some(Sharpest {
            vertex: top.0,
            bend: if total < NECK { along.max(most) } else { most },
            mean_curvature,
            ring: ring.into_iter().map(|v| v.0).collect(),
            is_neck: total < 0.0,
        })
    }
}
