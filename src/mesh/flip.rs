//! The edge flip: the other diagonal of the two triangles at an edge.

use super::{Edge, Halfedge, HalfedgeMesh, Vertex};

/// Whether an edge can be flipped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flippable {
    /// The other diagonal joins two vertices that have no edge yet.
    Yes,
    /// There is a face on one side only.
    Boundary,
    /// The other diagonal is an edge already, between these vertices; or both triangles have
    /// the same third vertex.
    PartnerExists(Vertex, Vertex),
    /// A face on either side is no triangle, or the two run against each other, as somewhere
    /// on every one-sided surface.
    NotTriangles,
}

/// Where the walks about the elements at an edge begin: at its two ends, at the two vertices
/// opposite, and around its two faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Anchors {
    vertices: [(Vertex, Halfedge); 4],
    faces: [Halfedge; 2],
}

impl HalfedgeMesh {
    /// Whether an edge lies between two triangles that run alike about it. Unlike
    /// [`flippable`](Self::flippable) that takes no walk about a vertex.
    pub fn joins_triangles(&self, e: Edge) -> bool {
        let h = e.halfedge();
        let is_triangle = |h| self.next(self.next(h)) == self.prev(h);
        !self.is_boundary_edge(e) && !self.is_twisted(e) && is_triangle(h) && is_triangle(h.twin())
    }

    /// Whether the flip of an edge leaves a mesh without double edges.
    pub fn flippable(&self, e: Edge) -> Flippable {
        if self.is_boundary_edge(e) {
            return Flippable::Boundary;
        }
        if !self.joins_triangles(e) {
            return Flippable::NotTriangles;
        }
        let [k, l] = self.opposite_vertices(e);
        if k == l || self.neighbours(k).any(|v| v == l) {
            return Flippable::PartnerExists(k, l);
        }
        Flippable::Yes
    }

    /// Where the walks about the elements at an edge between two triangles begin.
    pub fn anchors(&self, e: Edge) -> Anchors {
        let h = e.halfedge();
        let ([i, j], [k, l]) = (self.ends(e), self.opposite_vertices(e));
        let face = |h| self.halfedge_of_face[self.face(h).index()];
        Anchors {
            vertices: [i, j, k, l].map(|v| (v, self.halfedge_of_vertex[v.index()])),
            faces: [face(h), face(h.twin())],
        }
    }

    /// Takes a flip back: every element is as it was, in the order it was.
    ///
    /// # Panics
    /// Unless the edge was just flipped, or all that was done since has been taken back.
    pub fn unflip(&mut self, e: Edge, before: Anchors) {
        // A flip turns the quadrilateral by a quarter: three more make it whole.
        for _ in 0..3 {
            self.turn(e);
        }
        for (v, h) in before.vertices {
            self.halfedge_of_vertex[v.index()] = h;
        }
        for (h, first) in [e.halfedge(), e.halfedge().twin()]
            .into_iter()
            .zip(before.faces)
        {
            let face = self.face(h);
            self.halfedge_of_face[face.index()] = first;
        }
    }

    /// Flips an edge: of the triangles `ijk` and `jil` about edge `ij` become `ilk` and
    /// `jkl` about `lk`. The edge, its sides and both faces keep their numbers, and every
    /// other element is as it was. Twice flipped, the triangles are the same again.
    ///
    /// # Panics
    /// Unless the edge is [`flippable`](Self::flippable).
    pub fn flip(&mut self, e: Edge) {
        assert_eq!(self.flippable(e), Flippable::Yes, "edge {}", e.0);
        self.turn(e);
    }

    fn turn(&mut self, e: Edge) {
        let h = e.halfedge();
        let t = h.twin();
        let (jk, ki) = (self.next(h), self.prev(h));
        let (il, lj) = (self.next(t), self.prev(t));
        let (i, j) = (self.tail(h), self.tail(t));
        let (k, l) = (self.tail(ki), self.tail(lj));
        let (f, g) = (self.face(h), self.face(t));
        // Boundary vertices begin at a boundary edge, which this is not.
        for (v, from) in [(i, il), (j, jk)] {
            if self.halfedge_of_vertex[v.index()].edge() == e {
                self.halfedge_of_vertex[v.index()] = from;
            }
        }
        self.tail[h.index()] = l;
        self.tail[t.index()] = k;
        for (face, cycle) in [(f, [h, ki, il]), (g, [t, lj, jk])] {
            self.halfedge_of_face[face.index()] = cycle[0];
            for (n, &side) in cycle.iter().enumerate() {
                let next = cycle[(n + 1) % 3];
                self.next[side.index()] = next;
                self.prev[next.index()] = side;
                self.face[side.index()] = face;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::noise::SplitMix64;
    use crate::mesh::{build, shape};

    #[test]
    fn connectivity_is_valid_after_each_of_ten_thousand_flips() {
        for name in ["icosphere", "hemisphere"] {
            let level: &[(String, f64)] = &[("level".into(), 2.0)];
            let values = if name == "icosphere" { level } else { &[] };
            let sample = shape::make(name, values).expect("a shape");
            let mut mesh = build(&sample.soup).expect("a surface").mesh;
            let characteristic = mesh.euler_characteristic();
            let mut random = SplitMix64::new(3);
            let mut flips = 0;
            while flips < 5000 {
                let e = Edge::new(random.below(mesh.n_edges()));
                if mesh.flippable(e) == Flippable::Yes {
                    mesh.flip(e);
                    flips += 1;
                    mesh.validate().expect("valid");
                }
            }
            assert_eq!(mesh.euler_characteristic(), characteristic);
        }
    }

    #[test]
    fn two_flips_give_the_same_triangles() {
        let sample = shape::make("torus", &[]).expect("a shape");
        let mut mesh = build(&sample.soup).expect("a surface").mesh;
        let faces = |mesh: &HalfedgeMesh| {
            let sorted = |f| {
                let mut corners = mesh.triangle(f);
                corners.sort();
                corners
            };
            let mut all: Vec<_> = mesh.faces().map(sorted).collect();
            all.sort();
            all
        };
        let before = faces(&mesh);
        for e in mesh.edges().step_by(7) {
            if mesh.flippable(e) == Flippable::Yes {
                let opposite = mesh.opposite_vertices(e);
                mesh.flip(e);
                let mut ends = mesh.ends(e);
                ends.sort();
                let mut expected = opposite;
                expected.sort();
                assert_eq!(ends, expected);
                mesh.flip(e);
                assert_eq!(faces(&mesh), before);
            }
        }
    }

    #[test]
    fn what_cannot_be_flipped_is_told_apart() {
        let of = |name: &str| {
            let sample = shape::make(name, &[]).expect("a shape");
            build(&sample.soup).expect("a surface").mesh
        };
        let tetrahedron = build(
            &shape::make("tetrahedron", &[("level".into(), 0.0)])
                .expect("a shape")
                .soup,
        );
        let tetrahedron = tetrahedron.expect("a surface").mesh;
        for e in tetrahedron.edges() {
            assert!(matches!(
                tetrahedron.flippable(e),
                Flippable::PartnerExists(..)
            ));
        }
        let disk = of("disk");
        let boundary = disk.edges().filter(|&e| disk.is_boundary_edge(e));
        assert!(boundary.clone().count() > 0);
        for e in boundary {
            assert_eq!(disk.flippable(e), Flippable::Boundary);
        }
        let moebius = of("moebius");
        let twisted = moebius.edges().filter(|&e| moebius.is_twisted(e));
        for e in twisted.filter(|&e| !moebius.is_boundary_edge(e)) {
            assert_eq!(moebius.flippable(e), Flippable::NotTriangles);
        }
    }
}
