//! A surface that is being remeshed: triangles with the faces at each vertex.
//!
//! Lists only grow while edges are split and collapsed; what is gone is marked and dropped by
//! [`Draft::compact`]. Every order in it follows from the mesh it was made of, so that the same
//! input gives the same output to the last bit.

use crate::interrupt::paced;
use crate::mesh::{self, HalfedgeMesh};
use crate::order;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// No vertex: what the corners of a face that is gone are.
const GONE: u32 = u32::MAX;

/// The working copy of a triangle mesh.
#[derive(Clone, Debug)]
pub(super) struct Draft {
    pub(super) x: Vec<DVec3>,
    /// Wanted length of the edges at each vertex.
    pub(super) size: Vec<f64>,
    /// Unit normals, of new vertices those of the edge.
    pub(super) normal: Vec<DVec3>,
    /// Vertices that are not moved and not removed.
    pub(super) held: Vec<bool>,
    /// Those that are held as they lie on an edge of the shape: they are split off and taken away
    /// along it.
    pub(super) creased: Vec<bool>,
    /// Faces at a vertex of a regular mesh: six, or three on the boundary.
    pub(super) regular: Vec<u8>,
    /// A vertex of the mesh at the start that is near.
    pub(super) seed: Vec<u32>,
    /// Corners of each face.
    pub(super) faces: Vec<[u32; 3]>,
    /// Faces at each vertex.
    pub(super) star: Vec<Vec<u32>>,
}

/// An edge between two faces: the ends, and each face with the vertex opposite.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hinge {
    pub(super) ends: [u32; 2],
    pub(super) faces: [u32; 2],
    pub(super) apexes: [u32; 2],
}

impl Hinge {
    /// The edges around the two faces, the smaller end first.
    pub(super) fn sides(&self) -> [[u32; 2]; 4] {
        let ([a, b], [c, d]) = (self.ends, self.apexes);
        [[a, c], [c, b], [b, d], [d, a]].map(|[v, w]| [v.min(w), v.max(w)])
    }
}

impl Draft {
    /// Of an oriented triangle mesh. Boundary vertices are held, with those that `held` marks.
    pub(super) fn of(mesh: &HalfedgeMesh, x: &[DVec3], held: &[bool]) -> Self {
        let n = x.len();
        let rim = |v| mesh.is_boundary_vertex(v);
        let mut draft = Self {
            x: x.to_vec(),
            size: vec![0.0; n],
            normal: Vec::new(),
            held: (mesh.vertices().zip(held))
                .map(|(v, h)| *h || rim(v))
                .collect(),
            creased: vec![false; n],
            regular: mesh
                .vertices()
                .map(|v| if rim(v) { 3 } else { 6 })
                .collect(),
            seed: (0..n as u32).collect(),
            faces: mesh
                .faces()
                .map(|f| mesh.triangle(f).map(|v| v.0))
                .collect(),
            star: Vec::new(),
        };
        draft.reconnect();
        draft
    }

    /// Finds stars and normals anew.
    pub(super) fn reconnect(&mut self) {
        self.star = vec![Vec::with_capacity(7); self.x.len()];
        for (f, corners) in (0..).zip(&self.faces) {
            for &v in corners {
                self.star[v as usize].push(f);
            }
        }
        self.normal = self.normals();
    }

    pub(super) fn is_alive(&self, v: u32) -> bool {
        !self.star[v as usize].is_empty()
    }

    pub(super) fn at(&self, v: u32) -> DVec3 {
        self.x[v as usize]
    }

    /// Normal of a triangle, as long as twice its area.
    pub(super) fn normal_of(&self, corners: [u32; 3]) -> DVec3 {
        let [a, b, c] = corners.map(|v| self.at(v));
        (b - a).cross(c - a)
    }

    /// Unit normals: those of the faces with the weights of Max [M99](crate::bibliography#m99),
    /// sin α/|e₁||e₂|, exact on spheres.
    pub(super) fn normals(&self) -> Vec<DVec3> {
        let mut sums = vec![DVec3::ZERO; self.x.len()];
        for corners in self.live_faces() {
            let points = corners.map(|v| self.at(v));
            for (i, v) in corners.into_iter().enumerate() {
                let (a, b) = (
                    points[(i + 1) % 3] - points[i],
                    points[(i + 2) % 3] - points[i],
                );
                let weight = (a.length_squared() * b.length_squared()).max(f64::MIN_POSITIVE);
                sums[v as usize] += a.cross(b) / weight;
            }
        }
        sums.into_iter().map(DVec3::normalize_or_zero).collect()
    }

    /// A third of the area of the faces at each vertex.
    pub(super) fn areas(&self) -> Vec<f64> {
        let mut areas = vec![0.0; self.x.len()];
        for corners in self.live_faces() {
            let share = self.normal_of(corners).length() / 6.0;
            for v in corners {
                areas[v as usize] += share;
            }
        }
        areas
    }

    pub(super) fn live_faces(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        paced(self.faces.iter().copied()).filter(|corners| corners[0] != GONE)
    }

    /// The vertices joined to one, each once, in the order of its faces.
    pub(super) fn ring(&self, v: u32) -> Vec<u32> {
        let mut ring = Vec::with_capacity(8);
        for &f in &self.star[v as usize] {
            for u in self.faces[f as usize] {
                if u != v && !ring.contains(&u) {
                    ring.push(u);
                }
            }
        }
        ring
    }

    pub(super) fn rings(&self) -> Vec<Vec<u32>> {
        (0..self.x.len() as u32).map(|v| self.ring(v)).collect()
    }

    /// The edges between two faces, each once, in the order of the faces. Those that lie
    /// between held vertices are no one's to change and are left out.
    pub(super) fn edges(&self) -> Vec<[u32; 2]> {
        let mut edges = Vec::with_capacity(3 * self.faces.len() / 2);
        for corners in self.live_faces() {
            for i in 0..3 {
                let (a, b) = (corners[i], corners[(i + 1) % 3]);
                // Two faces run along an edge in opposite directions.
                if a < b && !self.is_held([a, b]) {
                    edges.push([a, b]);
                }
            }
        }
        edges
    }

    /// Whether a vertex stays whatever there is around it.
    pub(super) fn is_fixed(&self, v: usize) -> bool {
        self.held[v] && !self.creased[v]
    }

    /// Whether an edge stays: between held vertices, unless both are on edges of the shape.
    pub(super) fn is_held(&self, edge: [u32; 2]) -> bool {
        let ends = edge.map(|v| v as usize);
        ends.iter().all(|&v| self.held[v]) && ends.iter().any(|&v| !self.creased[v])
    }

    /// The two faces at an edge, that which runs from `a` to `b` first; `None` if there is no
    /// such edge, or one face only.
    pub(super) fn hinge(&self, [a, b]: [u32; 2]) -> Option<Hinge> {
        let (mut faces, mut apexes) = ([GONE; 2], [GONE; 2]);
        for &f in &self.star[a as usize] {
            let corners = self.faces[f as usize];
            let Some(i) = corners.iter().position(|&v| v == a) else {
                continue;
            };
            let (next, last) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
            if next == b {
                (faces[0], apexes[0]) = (f, last);
            } else if last == b {
                (faces[1], apexes[1]) = (f, next);
            }
        }
        (!faces.contains(&GONE)).then_some(Hinge {
            ends: [a, b],
            faces,
            apexes,
        })
    }

    pub(super) fn length(&self, [a, b]: [u32; 2]) -> f64 {
        self.at(a).distance(self.at(b))
    }

    /// Length of an edge over what it should be.
    pub(super) fn stretch(&self, [a, b]: [u32; 2]) -> f64 {
        2.0 * self.length([a, b]) / (self.size[a as usize] + self.size[b as usize])
    }

    /// The edges of a stretch that `wanted` accepts with it, the smallest first.
    pub(super) fn by_stretch(&self, wanted: impl Fn(f64) -> bool) -> Vec<[u32; 2]> {
        let edges = self.edges().into_iter().map(|e| (self.stretch(e), e));
        let mut found: Vec<_> = edges.filter(|(stretch, _)| wanted(*stretch)).collect();
        order::sort_by(&mut found, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        found.into_iter().map(|(_, e)| e).collect()
    }

    /// The middle of an edge on the surface: that of the cubic which touches the tangent planes
    /// at both ends. It leaves the chord by a quarter of its length at most. On an edge of the shape
    /// there is no tangent plane.
    pub(super) fn middle(&self, [a, b]: [u32; 2]) -> DVec3 {
        let edge = self.at(b) - self.at(a);
        let tangent = |v: u32| match self.creased[v as usize] {
            true => edge,
            false => edge - edge.dot(self.normal[v as usize]) * self.normal[v as usize],
        };
        let bulge = (tangent(a) - tangent(b)) / 8.0;
        let across = bulge - bulge.dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE) * edge;
        0.5 * (self.at(a) + self.at(b)) + across.clamp_length_max(0.25 * edge.length())
    }

    /// Drops what is gone.
    pub(super) fn compact(&mut self) {
        let mut number = vec![GONE; self.x.len()];
        let mut kept = 0;
        for (v, number) in number.iter_mut().enumerate() {
            if !self.star[v].is_empty() {
                *number = kept as u32;
                self.x[kept] = self.x[v];
                self.size[kept] = self.size[v];
                self.held[kept] = self.held[v];
                self.creased[kept] = self.creased[v];
                self.regular[kept] = self.regular[v];
                self.seed[kept] = self.seed[v];
                kept += 1;
            }
        }
        self.x.truncate(kept);
        self.size.truncate(kept);
        self.held.truncate(kept);
        self.creased.truncate(kept);
        self.regular.truncate(kept);
        self.seed.truncate(kept);
        self.faces.retain(|corners| corners[0] != GONE);
        for corners in &mut self.faces {
            *corners = corners.map(|v| number[v as usize]);
        }
        self.reconnect();
    }

    /// Marks a face as gone and takes it out of the stars of its corners.
    pub(super) fn remove_face(&mut self, f: u32) {
        for v in self.faces[f as usize] {
            self.leave(v, f);
        }
        self.faces[f as usize] = [GONE; 3];
    }

    /// Takes a face out of a vertex's star.
    pub(super) fn leave(&mut self, v: u32, f: u32) {
        self.star[v as usize].retain(|&g| g != f);
    }

    /// The mesh, which runs around its faces as the one it came from does; `None` where it is
    /// no surface any more.
    pub(super) fn mesh(&self) -> Option<HalfedgeMesh> {
        let mut soup = PolygonSoup {
            positions: self.x.clone(),
            ..PolygonSoup::default()
        };
        for corners in self.live_faces() {
            soup.push_face(&corners);
        }
        let built = mesh::build_as_given(&soup).ok()?;
        // A repair would mean that an operation broke the surface.
        built.repairs.is_empty().then_some(built.mesh)
    }
}
