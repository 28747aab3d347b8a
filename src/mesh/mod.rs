//! Half-edge connectivity, without positions.
//!
//! [`HalfedgeMesh`] holds flat arrays and is built from a
//! [`PolygonSoup`] by [`build`](build::build). Faces may
//! have any degree. Surfaces need not be orientable: the two sides of an edge
//! normally run in opposite directions; an edge whose sides run the same way is
//! *twisted*, and a non-orientable surface has at least one. Boundary loops are
//! cycles of half-edges without a face.

pub mod build;
mod duplicate;
pub mod element;
pub mod error;
pub mod flip;
pub mod noise;
mod orient;
mod outline;
mod outward;
mod repair;
pub mod shape;
mod sides;
pub mod subdivide;
pub mod topology;
pub mod validate;
pub mod walk;

pub use build::{Built, build, build_as_given};
pub use element::{Edge, Face, Halfedge, Vertex};
pub use error::{MeshError, Repair};
#[cfg(feature = "solver")]
pub(crate) use repair::clean_faces;

use crate::soup::PolygonSoup;

/// Connectivity of a 2-manifold, possibly with boundary, possibly not orientable.
///
/// Invariants (checked by [`HalfedgeMesh::validate`]): `next` and `prev` are
/// inverse permutations whose cycles are the faces and the boundary loops; every
/// vertex has exactly one fan of faces; half-edge `2e` of edge `e` has a face.
#[derive(Clone, Debug, Default)]
pub struct HalfedgeMesh {
    next: Vec<Halfedge>,
    prev: Vec<Halfedge>,
    tail: Vec<Vertex>,
    face: Vec<Face>,
    halfedge_of_vertex: Vec<Halfedge>,
    halfedge_of_face: Vec<Halfedge>,
    halfedge_of_loop: Vec<Halfedge>,
}

impl HalfedgeMesh {
    /// Memory of the connectivity.
    pub fn bytes(&self) -> usize {
        let halfedges = 3 * size_of::<Halfedge>() + size_of::<Face>();
        self.n_halfedges() * halfedges
            + (self.n_vertices() + self.n_faces() + self.n_boundary_loops()) * size_of::<Halfedge>()
    }

    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.halfedge_of_vertex.len()
    }

    /// Number of edges.
    pub fn n_edges(&self) -> usize {
        self.next.len() / 2
    }

    /// Number of half-edges, boundary ones included: twice the number of edges.
    pub fn n_halfedges(&self) -> usize {
        self.next.len()
    }

    /// Number of faces, boundary loops not included.
    pub fn n_faces(&self) -> usize {
        self.halfedge_of_face.len()
    }

    /// Number of boundary loops.
    pub fn n_boundary_loops(&self) -> usize {
        self.halfedge_of_loop.len()
    }

    /// All vertices.
    pub fn vertices(&self) -> impl ExactSizeIterator<Item = Vertex> + Clone + use<> {
        (0..self.n_vertices() as u32).map(Vertex)
    }

    /// All edges.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Edge> + Clone + use<> {
        (0..self.n_edges() as u32).map(Edge)
    }

    /// All half-edges.
    pub fn halfedges(&self) -> impl ExactSizeIterator<Item = Halfedge> + Clone + use<> {
        (0..self.n_halfedges() as u32).map(Halfedge)
    }

    /// All faces.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = Face> + Clone + use<> {
        (0..self.n_faces() as u32).map(Face)
    }

    /// The following half-edge of the same face or boundary loop.
    pub fn next(&self, h: Halfedge) -> Halfedge {
        self.next[h.index()]
    }

    /// The preceding half-edge of the same face or boundary loop.
    pub fn prev(&self, h: Halfedge) -> Halfedge {
        self.prev[h.index()]
    }

    /// The vertex a half-edge starts from.
    pub fn tail(&self, h: Halfedge) -> Vertex {
        self.tail[h.index()]
    }

    /// The vertex a half-edge points to.
    pub fn tip(&self, h: Halfedge) -> Vertex {
        self.tail[self.next[h.index()].index()]
    }

    /// The face a half-edge belongs to; [`Face::NONE`] on a boundary loop.
    pub fn face(&self, h: Halfedge) -> Face {
        self.face[h.index()]
    }

    /// Whether a half-edge belongs to a boundary loop.
    pub fn is_boundary_halfedge(&self, h: Halfedge) -> bool {
        !self.face(h).is_some()
    }

    /// Whether an edge has a face on one side only.
    pub fn is_boundary_edge(&self, e: Edge) -> bool {
        self.is_boundary_halfedge(e.halfedge().twin())
    }

    /// Whether a vertex lies on a boundary loop.
    pub fn is_boundary_vertex(&self, v: Vertex) -> bool {
        // The builder starts a boundary vertex's fan at its boundary edge.
        self.is_boundary_edge(self.halfedge_of_vertex[v.index()].edge())
    }

    /// Whether the two sides of an edge run in the same direction.
    pub fn is_twisted(&self, e: Edge) -> bool {
        let h = e.halfedge();
        self.tail(h) == self.tail(h.twin())
    }

    /// The two end vertices of an edge.
    pub fn ends(&self, e: Edge) -> [Vertex; 2] {
        let h = e.halfedge();
        [self.tail(h), self.tip(h)]
    }

    /// One half-edge of a face, the one its corners are listed from.
    pub fn halfedge_of_face(&self, f: Face) -> Halfedge {
        self.halfedge_of_face[f.index()]
    }

    /// Whether every face is a triangle.
    pub fn is_triangular(&self) -> bool {
        self.faces().all(|f| {
            let h = self.halfedge_of_face(f);
            self.next(self.next(self.next(h))) == h
        })
    }

    /// Whether there is no boundary.
    pub fn is_closed(&self) -> bool {
        self.halfedge_of_loop.is_empty()
    }

    /// Whether the faces are consistently oriented: no edge is twisted.
    ///
    /// The builder orients what can be oriented, so `false` means that the
    /// surface is not orientable.
    pub fn is_oriented(&self) -> bool {
        self.edges().all(|e| !self.is_twisted(e))
    }

    /// The corners of a triangle, counter-clockwise seen from outside.
    pub fn triangle(&self, f: Face) -> [Vertex; 3] {
        let h = self.halfedge_of_face(f);
        let n = self.next(h);
        [self.tail(h), self.tail(n), self.tail(self.next(n))]
    }

    /// The two vertices opposite to an interior edge of a triangle mesh: the apex
    /// on the side of half-edge `2e`, then the one on the side of `2e + 1`.
    pub fn opposite_vertices(&self, e: Edge) -> [Vertex; 2] {
        let h = e.halfedge();
        [self.tail(self.prev(h)), self.tail(self.prev(h.twin()))]
    }

    /// The faces as lists of vertex indices, in order, joined to `positions`.
    pub fn to_soup(&self, positions: &[glam::DVec3]) -> PolygonSoup {
        let mut soup = PolygonSoup {
            positions: positions.to_vec(),
            ..PolygonSoup::default()
        };
        let mut corners = Vec::new();
        for f in self.faces() {
            corners.clear();
            corners.extend(self.face_vertices(f).map(|v| v.0));
            soup.push_face(&corners);
        }
        soup
    }
}
