//! The edge-flip optimiser of Brink & Alboul: the flip that gains most, again and again,
//! until none gains anything.

use super::reduction::{Criterion, Quad, willmore_reduction};
use crate::energy::circle::angle::diamond_angle;
use crate::geometry::measure;
use crate::mesh::flip::Flippable;
use crate::mesh::{Edge, HalfedgeMesh, Vertex};
use glam::DVec3;
use std::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashMap};
use std::f64::consts::TAU;

/// A flip must gain more than this share of the area of its two triangles: f_a falls like
/// the fourth power of their size, and an absolute bound would stop fine meshes silently.
const LEAST_AREA_GAIN: f64 = 1e-12;
/// A flip must take more than this off the angles.
const LEAST_ANGLE_GAIN: f64 = 1e-11;

/// A flip that was made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flip {
    /// The edge, which keeps its number.
    pub edge: Edge,
    /// Its ends before.
    pub before: [Vertex; 2],
    /// Its ends after.
    pub after: [Vertex; 2],
    /// f(e) of the criterion.
    pub reduction: f64,
    /// Total area after.
    pub area: f64,
    /// W after; see [`FlipOptimiser::willmore`].
    pub willmore: f64,
}

/// An edge that may gain from a flip. The greatest reduction comes first; of equal ones the
/// edge with the smallest (min, max) of its ends.
struct Candidate {
    reduction: f64,
    key: (u32, u32),
    edge: Edge,
    version: u32,
}

impl Candidate {
    fn rank(&self, other: &Self) -> Ordering {
        let by_gain = self.reduction.total_cmp(&other.reduction);
        by_gain.then_with(|| Reverse(self.key).cmp(&Reverse(other.key)))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.rank(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank(other)
    }
}

/// Greedy optimisation of the connectivity of a triangle mesh; positions stay.
///
/// A queue with lazy deletion: every edge has a version, raised when its reduction changes,
/// and entries of an older version are passed over. A flip whose other diagonal is an edge
/// already waits under that edge and is queued again when it is flipped away, so that the
/// result is that of searching all edges every time. O(E log E) in practice.
pub struct FlipOptimiser {
    mesh: HalfedgeMesh,
    x: Vec<DVec3>,
    criterion: Criterion,
    guards_folds: bool,
    queue: BinaryHeap<Candidate>,
    versions: Vec<u32>,
    waiting: HashMap<(u32, u32), Vec<Edge>>,
    area: f64,
    angles: f64,
    flips: usize,
    rejected: usize,
}

fn key([a, b]: [Vertex; 2]) -> (u32, u32) {
    (a.0.min(b.0), a.0.max(b.0))
}

impl FlipOptimiser {
    /// Prepares the optimiser. With `guards_folds` no flip may turn a face against the sum
    /// of the two there were; off by default, since it also forbids unfolding.
    pub fn new(
        mesh: HalfedgeMesh,
        x: Vec<DVec3>,
        criterion: Criterion,
        guards_folds: bool,
    ) -> Self {
        let mut this = Self {
            versions: vec![0; mesh.n_edges()],
            area: measure::area(&mesh, &x),
            angles: total_angles(&mesh, &x),
            queue: BinaryHeap::new(),
            waiting: HashMap::new(),
            flips: 0,
            rejected: 0,
            mesh,
            x,
            criterion,
            guards_folds,
        };
        for e in this.mesh.edges() {
            this.enqueue(e);
        }
        this
    }

    /// The mesh as it is now.
    pub fn mesh(&self) -> &HalfedgeMesh {
        &self.mesh
    }

    /// Gives the mesh back.
    pub fn into_mesh(self) -> HalfedgeMesh {
        self.mesh
    }

    /// Number of flips made.
    pub fn flips(&self) -> usize {
        self.flips
    }

    /// How often a flip that would have gained was refused: its other diagonal was there, or
    /// the fold guard was against it.
    pub fn rejected(&self) -> usize {
        self.rejected
    }

    /// Total area, kept up flip by flip.
    pub fn area(&self) -> f64 {
        self.area
    }

    /// W = 2 Σ β − 2πV over interior edges, kept up flip by flip: Σ W_i as printed on closed
    /// meshes; on open ones it differs from that by a constant.
    pub fn willmore(&self) -> f64 {
        2.0 * self.angles - TAU * self.mesh.n_vertices() as f64
    }

    /// f(e) of the criterion; `None` on the boundary and across twisted edges.
    pub fn reduction(&self, e: Edge) -> Option<f64> {
        match self.mesh.flippable(e) {
            Flippable::Boundary | Flippable::NotTriangles => None,
            _ => Some(match self.criterion {
                Criterion::Area => Quad::of(&self.mesh, &self.x, e).area_reduction(),
                Criterion::Willmore => willmore_reduction(&self.mesh, &self.x, e),
                Criterion::Localised => Quad::of(&self.mesh, &self.x, e).localised_reduction(),
            }),
        }
    }

    fn threshold(&self, e: Edge) -> f64 {
        match self.criterion {
            Criterion::Area => LEAST_AREA_GAIN * Quad::of(&self.mesh, &self.x, e).area(),
            _ => LEAST_ANGLE_GAIN,
        }
    }

    fn enqueue(&mut self, e: Edge) {
        let version = &mut self.versions[e.index()];
        *version += 1;
        let version = *version;
        let Some(reduction) = self.reduction(e) else {
            return;
        };
        if reduction > self.threshold(e) {
            let key = key(self.mesh.ends(e));
            self.queue.push(Candidate {
                reduction,
                key,
                edge: e,
                version,
            });
        }
    }

    /// Makes the flip that gains most; `None` when none gains anything.
    pub fn step(&mut self) -> Option<Flip> {
        while let Some(candidate) = self.queue.pop() {
            let Candidate {
                edge,
                version,
                reduction,
                ..
            } = candidate;
            if self.versions[edge.index()] != version {
                continue;
            }
            match self.mesh.flippable(edge) {
                Flippable::Yes if self.guards_folds && self.folds(edge) => self.rejected += 1,
                Flippable::Yes => return Some(self.flip(edge, reduction)),
                Flippable::PartnerExists(k, l) => {
                    self.rejected += 1;
                    self.waiting.entry(key([k, l])).or_default().push(edge);
                }
                Flippable::Boundary | Flippable::NotTriangles => {}
            }
        }
        None
    }

    fn flip(&mut self, edge: Edge, reduction: f64) -> Flip {
        let before = self.mesh.ends(edge);
        self.area -= Quad::of(&self.mesh, &self.x, edge).area_reduction();
        self.angles -= 0.5 * willmore_reduction(&self.mesh, &self.x, edge);
        self.mesh.flip(edge);
        self.flips += 1;
        for e in self.affected(edge) {
            self.enqueue(e);
        }
        for e in self.waiting.remove(&key(before)).unwrap_or_default() {
            self.enqueue(e);
        }
        Flip {
            edge,
            before,
            after: self.mesh.ends(edge),
            reduction,
            area: self.area,
            willmore: self.willmore(),
        }
    }

    /// Edges whose reduction a flip changes: itself and the four sides; for Willmore energy,
    /// which looks across them, also the sides of the triangles beyond, 13 in all.
    fn affected(&self, flipped: Edge) -> Vec<Edge> {
        let mesh = &self.mesh;
        let h = flipped.halfedge();
        let sides = [
            mesh.next(h),
            mesh.prev(h),
            mesh.next(h.twin()),
            mesh.prev(h.twin()),
        ];
        let mut edges = vec![flipped];
        edges.extend(sides.map(|s| s.edge()));
        if self.criterion == Criterion::Willmore {
            for side in sides.map(|s| s.twin()) {
                if !mesh.is_boundary_halfedge(side) {
                    edges.push(mesh.next(side).edge());
                    edges.push(mesh.prev(side).edge());
                }
            }
        }
        edges
    }

    /// Whether a face after the flip would oppose the two before.
    fn folds(&self, e: Edge) -> bool {
        let Quad { i, j, k, l } = Quad::of(&self.mesh, &self.x, e);
        let normal = |a: DVec3, b: DVec3, c: DVec3| (b - a).cross(c - a);
        let before = normal(i, j, k) + normal(j, i, l);
        normal(i, l, k).dot(before) < 0.0 || normal(j, k, l).dot(before) < 0.0
    }
}

/// Σ β over interior edges.
fn total_angles(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    mesh.edges()
        .filter(|&e| !mesh.is_boundary_edge(e))
        .map(|e| {
            let Quad { i, j, k, l } = Quad::of(mesh, x, e);
            diamond_angle(k, j, l, i).beta
        })
        .sum()
}
