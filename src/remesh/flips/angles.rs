//! The angles that Willmore energy is the sum of, kept from flip to flip.
//!
//! The reduction of an edge is made of eight, and a flip changes the reductions of thirteen edges;
//! but of the angles themselves only those about the two triangles that are flipped.

use super::reduction::{reduction_by_sides, side_angle, side_angle_beyond, sides};
use crate::mesh::{Edge, HalfedgeMesh};
use glam::DVec3;

/// The angles of the mesh as it is, and those after each single flip, by half-edges. An angle is
/// the same from both sides of its edge but for rounding, and is kept for both: what is read
/// here has the bits of [`willmore_reduction`](super::reduction::willmore_reduction).
pub(super) struct Angles {
    /// From the triangle of the half-edge outwards.
    now: Vec<f64>,
    /// Of the next and of the previous side, once the edge of the half-edge is flipped.
    beyond: Vec<[f64; 2]>,
}

impl Angles {
    pub(super) fn new(mesh: &HalfedgeMesh, x: &[DVec3]) -> Self {
        Self {
            now: mesh.halfedges().map(|h| side_angle(mesh, x, h)).collect(),
            beyond: mesh
                .halfedges()
                .map(|h| [0, 1].map(|place| side_angle_beyond(mesh, x, h, place)))
                .collect(),
        }
    }

    /// f_w of an edge between two triangles.
    pub(super) fn reduction(&self, mesh: &HalfedgeMesh, e: Edge) -> f64 {
        reduction_by_sides(mesh, e, |first, place, side| {
            self.now[side.index()] - self.beyond[first.index()][place]
        })
    }

    /// Takes over that an edge was flipped.
    pub(super) fn update(&mut self, mesh: &HalfedgeMesh, x: &[DVec3], flipped: Edge) {
        let around = sides(mesh, flipped).map(|(.., side)| side);
        let edges = around.map(|side| side.edge()).into_iter().chain([flipped]);
        for h in edges.flat_map(|e| [e.halfedge(), e.halfedge().twin()]) {
            self.now[h.index()] = side_angle(mesh, x, h);
            self.beyond[h.index()] = [0, 1].map(|place| side_angle_beyond(mesh, x, h, place));
        }
        // Of the triangles beyond, the sides that are not between: each has one of these sides
        // as its previous or next one.
        for far in around.map(|side| side.twin()) {
            for (first, place) in [(mesh.next(far), 1), (mesh.prev(far), 0)] {
                self.beyond[first.index()][place] = side_angle_beyond(mesh, x, first, place);
            }
        }
    }
}
