//! The edge-flip optimiser of Brink & Alboul [BA](crate::bibliography#ba): the flip that gains
//! most, again and again, until none gains anything; and every flip back again.

mod angles;
pub mod conjecture;
pub mod lab;
mod queue;
pub mod reduction;

use crate::energy::circle::angle::diamond_angle;
use crate::geometry::measure;
use crate::geometry::quality::triangle_quality;
use crate::mesh::flip::{Anchors, Flippable};
use crate::mesh::{Edge, HalfedgeMesh, Vertex};
use angles::Angles;
use glam::DVec3;
use queue::{Key, Queue};
use reduction::{Criterion, Quad, sides, willmore_reduction};
use std::collections::HashMap;
use std::f64::consts::TAU;
use std::rc::Rc;

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

/// A flip must gain more than this share of the area of its two triangles: f_a falls like
/// the fourth power of their size, and an absolute bound would stop fine meshes silently.
const LEAST_AREA_GAIN: f64 = 1e-12;
/// A flip must take more than this off the angles.
const LEAST_ANGLE_GAIN: f64 = 1e-11;

/// Quality up to which a face has no area.
const FLAT: f64 = 2e-10;

/// What the search for a flip, and the flip itself, did to edges other than those about it.
#[derive(Default)]
struct Trace {
    /// Would have gained, and were refused.
    refused: Vec<Edge>,
    /// Waited before, and no longer.
    released: Vec<(Edge, Key)>,
}

impl Trace {
    fn is_empty(&self) -> bool {
        self.refused.is_empty() && self.released.is_empty()
    }
}

/// Greedy optimisation of the connectivity of a triangle mesh; positions stay.
///
/// A flip whose other diagonal is an edge already waits under that edge and is queued again
/// when it is flipped away, so that the result is that of searching all edges every time.
/// O(E log E) in practice.
pub struct FlipOptimiser {
    mesh: HalfedgeMesh,
    x: Rc<Vec<DVec3>>,
    criterion: Criterion,
    guards_folds: bool,
    queue: Queue,
    /// For Willmore energy, whose reductions share them.
    angles: Option<Angles>,
    made: Vec<Flip>,
    /// Of each flipped edge, before.
    anchors: Vec<Anchors>,
    /// Area and Σ β at the start and after each flip.
    totals: Vec<[f64; 2]>,
    /// By the number of flips made before.
    traces: HashMap<usize, Trace>,
    /// Since the last flip.
    trace: Trace,
    rejected: usize,
}

fn key([a, b]: [Vertex; 2]) -> Key {
    (a.0.min(b.0), a.0.max(b.0))
}

impl FlipOptimiser {
    /// Prepares the optimiser. With `guards_folds` no flip may turn a face against the sum
    /// of the two there were; off by default, since it also forbids unfolding.
    pub fn new(
        mesh: HalfedgeMesh,
        x: Rc<Vec<DVec3>>,
        criterion: Criterion,
        guards_folds: bool,
    ) -> Self {
        let totals = [measure::area(&mesh, &x), total_angles(&mesh, &x)];
        let by_angles = criterion == Criterion::Willmore;
        let mut this = Self {
            queue: Queue::new(mesh.n_edges()),
            angles: by_angles.then(|| Angles::new(&mesh, &x)),
            made: Vec::new(),
            anchors: Vec::new(),
            totals: vec![totals],
            traces: HashMap::new(),
            trace: Trace::default(),
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

    /// What is to become small.
    pub fn criterion(&self) -> Criterion {
        self.criterion
    }

    /// Number of flips made.
    pub fn flips(&self) -> usize {
        self.made.len()
    }

    /// Flips made, oldest first.
    pub fn made(&self) -> &[Flip] {
        &self.made
    }

    /// How often a flip that would have gained was refused: its other diagonal was there, or
    /// the fold guard was against it, or a face would have had no area.
    pub fn rejected(&self) -> usize {
        self.rejected
    }

    /// Area and W after so many of the flips made.
    pub fn costs_after(&self, flips: usize) -> Option<[f64; 2]> {
        let [area, angles] = *self.totals.get(flips)?;
        Some([area, self.energy(angles)])
    }

    fn energy(&self, angles: f64) -> f64 {
        2.0 * angles - TAU * self.mesh.n_vertices() as f64
    }

    fn total(&self) -> [f64; 2] {
        self.totals.last().copied().unwrap_or_default()
    }

    /// Total area, kept up flip by flip.
    pub fn area(&self) -> f64 {
        self.total()[0]
    }

    /// W = 2 Σ β − 2πV over interior edges, kept up flip by flip: Σ W_i as printed on closed
    /// meshes; on open ones it differs from that by a constant.
    pub fn willmore(&self) -> f64 {
        self.energy(self.total()[1])
    }

    /// f(e) of the criterion where it is a gain, whether or not the other diagonal is there;
    /// none on the boundary and across twisted edges.
    fn gain(&self, e: Edge) -> Option<f64> {
        if !self.mesh.joins_triangles(e) {
            return None;
        }
        if let Some(angles) = &self.angles {
            let reduction = angles.reduction(&self.mesh, e);
            return (reduction > LEAST_ANGLE_GAIN).then_some(reduction);
        }
        let quad = Quad::of(&self.mesh, &self.x, e);
        if self.criterion == Criterion::Area {
            let reduction = quad.area_reduction();
            return (reduction > LEAST_AREA_GAIN * quad.area()).then_some(reduction);
        }
        if quad.surely_loses() {
            return None;
        }
        let reduction = quad.localised_reduction();
        (reduction > LEAST_ANGLE_GAIN).then_some(reduction)
    }

    fn enqueue(&mut self, e: Edge) {
        if let Some(key) = self.queue.remove(e) {
            self.trace.released.push((e, key));
        }
        if let Some(reduction) = self.gain(e) {
            self.queue.push(e, reduction, key(self.mesh.ends(e)));
        }
    }

    /// Looks again at the edges whose reductions a flip, or taking it back, has changed: itself
    /// and the four sides; for Willmore energy, which looks across them, also the sides of the
    /// triangles beyond, 13 in all.
    fn renew(&mut self, flipped: Edge) {
        if let Some(angles) = &mut self.angles {
            angles.update(&self.mesh, &self.x, flipped);
        }
        self.enqueue(flipped);
        let around = sides(&self.mesh, flipped).map(|(.., side)| side);
        for side in around {
            self.enqueue(side.edge());
        }
        if self.angles.is_none() {
            return;
        }
        for side in around.map(|side| side.twin()) {
            if !self.mesh.is_boundary_halfedge(side) {
                self.enqueue(self.mesh.next(side).edge());
                self.enqueue(self.mesh.prev(side).edge());
            }
        }
    }

    fn refuse(&mut self, e: Edge, until: Key) {
        self.rejected += 1;
        self.trace.refused.push(e);
        self.queue.park(e, until);
    }

    /// Makes the flip that gains most; `None` when none gains anything.
    pub fn step(&mut self) -> Option<Flip> {
        while let Some((edge, reduction)) = self.queue.pop() {
            match self.mesh.flippable(edge) {
                Flippable::Yes if self.flattens(edge) || self.guards_folds && self.folds(edge) => {
                    self.refuse(edge, queue::NEVER);
                }
                Flippable::Yes => return Some(self.flip(edge, reduction)),
                Flippable::PartnerExists(k, l) => self.refuse(edge, key([k, l])),
                Flippable::Boundary | Flippable::NotTriangles => {}
            }
        }
        None
    }

    fn flip(&mut self, edge: Edge, reduction: f64) -> Flip {
        let before = self.mesh.ends(edge);
        let [area, angles] = self.total();
        let off_area = match self.criterion {
            Criterion::Area => reduction,
            _ => Quad::of(&self.mesh, &self.x, edge).area_reduction(),
        };
        let off_angles = match self.criterion {
            Criterion::Willmore => reduction,
            _ => willmore_reduction(&self.mesh, &self.x, edge),
        };
        self.totals
            .push([area - off_area, angles - 0.5 * off_angles]);
        self.anchors.push(self.mesh.anchors(edge));
        self.mesh.flip(edge);
        self.renew(edge);
        for e in self.queue.waiting_for(key(before)) {
            self.enqueue(e);
        }
        let trace = std::mem::take(&mut self.trace);
        if !trace.is_empty() {
            self.traces.insert(self.made.len(), trace);
        }
        let flip = Flip {
            edge,
            before,
            after: self.mesh.ends(edge),
            reduction,
            area: self.area(),
            willmore: self.willmore(),
        };
        self.made.push(flip);
        flip
    }

    /// Takes the last flip back and answers it; everything is as before it, the totals to
    /// the last bit and the elements in their order, so that the same flips follow again.
    pub fn back(&mut self) -> Option<Flip> {
        let last = self.made.pop()?;
        let trace = std::mem::take(&mut self.trace);
        self.undo_refusals(trace.refused);
        self.mesh.unflip(last.edge, self.anchors.pop()?);
        self.totals.pop();
        self.renew(last.edge);
        let trace = self.traces.remove(&self.made.len()).unwrap_or_default();
        for (e, until) in trace.released {
            self.queue.remove(e);
            self.queue.park(e, until);
        }
        self.undo_refusals(trace.refused);
        self.trace = Trace::default();
        Some(last)
    }

    fn undo_refusals(&mut self, refused: Vec<Edge>) {
        self.rejected -= refused.len();
        for e in refused {
            self.enqueue(e);
        }
    }

    /// Whether a face after the flip would have no area, where both before have one.
    fn flattens(&self, e: Edge) -> bool {
        let Quad { i, j, k, l } = Quad::of(&self.mesh, &self.x, e);
        let is_any_flat =
            |pair: [[DVec3; 3]; 2]| pair.into_iter().any(|t| triangle_quality(t) <= FLAT);
        is_any_flat([[i, l, k], [j, k, l]]) && !is_any_flat([[i, j, k], [j, i, l]])
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

#[cfg(test)]
mod tests;
