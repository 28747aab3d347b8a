//! Circulators: around a face, around a boundary loop, around a vertex.

use super::{Edge, Face, Halfedge, HalfedgeMesh, Vertex};

/// One edge seen from a vertex it ends at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spoke {
    /// The edge.
    pub edge: Edge,
    /// Its other end.
    pub neighbour: Vertex,
    /// The face between this spoke and the next; [`Face::NONE`] at the boundary.
    pub face: Face,
}

impl HalfedgeMesh {
    /// The cycle of half-edges that `start` belongs to.
    pub fn cycle(&self, start: Halfedge) -> impl Iterator<Item = Halfedge> + '_ {
        let mut at = Some(start);
        std::iter::from_fn(move || {
            let h = at?;
            let n = self.next(h);
            at = (n != start).then_some(n);
            Some(h)
        })
    }

    /// The corners of a face in order.
    pub fn face_vertices(&self, f: Face) -> impl Iterator<Item = Vertex> + '_ {
        self.cycle(self.halfedge_of_face(f)).map(|h| self.tail(h))
    }

    /// The boundary loops, each as its half-edges in order.
    pub fn boundary_loops(&self) -> impl Iterator<Item = impl Iterator<Item = Halfedge> + '_> {
        self.halfedge_of_loop.iter().map(|&h| self.cycle(h))
    }

    /// The edges at a vertex in cyclic order. At a boundary vertex the first and
    /// the last are the two boundary edges, and the last one's `face` is `NONE`.
    ///
    /// On an oriented mesh the order is clockwise seen from outside; no use of
    /// orientation is made, so that the walk crosses twisted edges.
    pub fn star(&self, v: Vertex) -> impl Iterator<Item = Spoke> + '_ {
        let first = self.halfedge_of_vertex[v.index()];
        let mut at = Some(first);
        std::iter::from_fn(move || {
            let h = at?;
            let outgoing = self.tail(h) == v;
            let spoke = Spoke {
                edge: h.edge(),
                neighbour: if outgoing { self.tip(h) } else { self.tail(h) },
                face: self.face(h),
            };
            // Across the face to its other edge at v, then to that edge's far side.
            let across = if outgoing { self.prev(h) } else { self.next(h) }.twin();
            at = (across != first).then_some(across);
            Some(spoke)
        })
    }

    /// The vertices joined to `v` by an edge, in cyclic order.
    pub fn neighbours(&self, v: Vertex) -> impl Iterator<Item = Vertex> + '_ {
        self.star(v).map(|spoke| spoke.neighbour)
    }

    /// Number of edges at a vertex.
    pub fn valence(&self, v: Vertex) -> usize {
        self.star(v).count()
    }
}
