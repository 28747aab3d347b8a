//! The circle-angle Willmore energy of Bobenko & Schröder [BS05](crate::bibliography#bs05).
//!
//! ```math
//! W_i = \sum_{\text{edges at } i} \beta - 2\pi, \qquad W = \sum_i W_i \qquad \text{(Section 2, as printed)}
//! ```
//!
//! Dimensionless, ≥ 0, invariant under Möbius transformations; 0 exactly when every
//! star is convex and spherical. W/2 tends to the smooth ∫(H² − K) dA where edges
//! follow curvature lines on a right-angled lattice; on other lattices the limit is
//! larger, and it diverges on lattices that are not Delaunay. No orientation is used.

pub mod angle;
pub mod hessian;
pub mod star;

use crate::interrupt::paced;
use crate::mesh::{HalfedgeMesh, Vertex};
use angle::{
    CORNER_PAIRS, DIAMOND_PAIRS, Smoothing, corner_angle, corner_weights, diamond_angle,
    diamond_weights,
};
use glam::DVec3;
use std::f64::consts::TAU;

/// What the energy of an open surface is (Section 3.3 of the paper).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, serde::Deserialize, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Boundary {
    /// W summed over interior vertices; with the boundary vertices and those within
    /// one edge of them held, positions and tangent planes are kept (G¹).
    #[default]
    Clamped,
    /// The functional of [`Free`](Self::Free) with the boundary vertices held.
    Fixed,
    /// Every boundary loop is closed by a vertex at infinity: boundary edges add the
    /// angles β₂, boundary vertices the angles β₃, and each loop its own W_∞.
    Free,
}

/// β of an interior edge; vertices in the order `k, j, l, i` of [`diamond_angle`].
#[derive(Clone, Copy, Debug)]
pub struct Diamond {
    /// `k, j, l, i`: the edge is `(i, j)`.
    pub v: [u32; 4],
    /// How many of W_i and W_j are part of the energy: 0, 1 or 2.
    pub count: u8,
}

/// β₂ or β₃: the vertices `p, v, n` of [`corner_angle`]. Counts twice in W.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// `p, v, n`.
    pub v: [u32; 3],
}

/// The energy of one mesh: which angles it sums.
#[derive(Clone, Debug)]
pub struct CircleEnergy {
    n_vertices: usize,
    diamonds: Vec<Diamond>,
    /// β₂, one a boundary edge, then β₃, one a boundary vertex.
    corners: Vec<Corner>,
    /// Index in `corners` where the β₃ begin.
    first_turn: usize,
    /// Vertices whose W_i counts, with one more a loop for its vertex at infinity.
    counted: Vec<bool>,
    n_counted: usize,
}

/// Everything one pass over the angles yields.
#[derive(Clone, Debug, Default)]
pub struct Evaluation {
    /// Σ φ(β) − 2π (number of vertices counted): W itself when ε = 0.
    pub value: f64,
    /// W.
    pub exact: f64,
    /// The gradient at every vertex, held ones included; unit 1/length.
    pub gradient: Vec<DVec3>,
    /// Edge weights of each diamond, then of each corner, each counted once.
    pub weights: Weights,
    /// Angles left out of the gradient because it is undefined there.
    pub skipped: usize,
}

/// Edge weights ω of the angles: the linearisation K of Eq. (1) in the paper.
#[derive(Clone, Debug, Default)]
pub struct Weights {
    /// Over [`DIAMOND_PAIRS`], one entry a diamond.
    pub diamonds: Vec<[f64; 6]>,
    /// Over [`CORNER_PAIRS`], one entry a corner.
    pub corners: Vec<[f64; 3]>,
}

impl CircleEnergy {
    /// The energy of a triangle mesh under a boundary condition.
    pub fn new(mesh: &HalfedgeMesh, boundary: Boundary) -> Self {
        let closes_loops = boundary != Boundary::Clamped;
        let counted: Vec<bool> = mesh
            .vertices()
            .map(|v| closes_loops || !mesh.is_boundary_vertex(v))
            .collect();
        let diamonds = mesh
            .edges()
            .filter(|&e| !mesh.is_boundary_edge(e))
            .map(|e| {
                let ([i, j], [k, l]) = (mesh.ends(e), mesh.opposite_vertices(e));
                let count = u8::from(counted[i.index()]) + u8::from(counted[j.index()]);
                Diamond {
                    v: [k.0, j.0, l.0, i.0],
                    count,
                }
            })
            .collect();
        let mut corners = Vec::new();
        let mut first_turn = 0;
        if closes_loops {
            for e in mesh.edges().filter(|&e| mesh.is_boundary_edge(e)) {
                let ([a, b], [o, _]) = (mesh.ends(e), mesh.opposite_vertices(e));
                corners.push(Corner { v: [a.0, o.0, b.0] });
            }
            first_turn = corners.len();
            for h in mesh.boundary_loops().flatten() {
                let v = [mesh.tail(mesh.prev(h)), mesh.tail(h), mesh.tip(h)];
                corners.push(Corner { v: v.map(|v| v.0) });
            }
        }
        let n_counted = counted.iter().filter(|&&c| c).count()
            + if closes_loops {
                mesh.n_boundary_loops()
            } else {
                0
            };
        Self {
            n_vertices: mesh.n_vertices(),
            diamonds,
            corners,
            first_turn,
            counted,
            n_counted,
        }
    }

    /// The interior edges' angles.
    pub fn diamonds(&self) -> &[Diamond] {
        &self.diamonds
    }

    /// The angles β₂ and then β₃ of boundary edges and vertices.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// The position in [`corners`](Self::corners) of the first β₃.
    pub fn first_turn(&self) -> usize {
        self.first_turn
    }

    /// Whether W_i of vertex `i` is part of the energy.
    pub fn counts(&self, v: Vertex) -> bool {
        self.counted[v.index()]
    }

    /// Number of vertices whose W_i counts, those at infinity included.
    pub fn n_counted(&self) -> usize {
        self.n_counted
    }

    /// How many angles the energy sums, each as often as it counts: U_ε exceeds W_ε by ε times
    /// this.
    pub fn angle_count(&self) -> f64 {
        let diamonds: f64 = self.diamonds.iter().map(|d| f64::from(d.count)).sum();
        diamonds + 2.0 * self.corners.len() as f64
    }

    /// The angles that the energy sums, each with how often it counts.
    pub fn angles(&self, x: &[DVec3]) -> Vec<(f64, f64)> {
        let at = |v: u32| x[v as usize];
        let diamonds = paced(&self.diamonds).filter(|d| d.count > 0).map(|d| {
            let [k, j, l, i] = d.v.map(at);
            (diamond_angle(k, j, l, i).beta, f64::from(d.count))
        });
        let corners = self.corners.iter().map(|c| {
            let [p, v, n] = c.v.map(at);
            (corner_angle(p, v, n).beta, 2.0)
        });
        diamonds.chain(corners).collect()
    }

    /// The energy alone: W if `smoothing` is exact.
    pub fn value(&self, x: &[DVec3], smoothing: Smoothing) -> f64 {
        let angles = self.angles(x).into_iter();
        let terms = angles.map(|(beta, count)| count * smoothing.value(beta));
        accurate_sum(terms) - TAU * self.n_counted as f64
    }

    /// Energy, gradient and edge weights in one pass, into buffers that are kept.
    pub fn evaluate(&self, x: &[DVec3], smoothing: Smoothing, out: &mut Evaluation) {
        let at = |v: u32| x[v as usize];
        out.gradient.clear();
        out.gradient.resize(self.n_vertices, DVec3::ZERO);
        out.weights.diamonds.clear();
        out.weights.corners.clear();
        out.skipped = 0;
        let (mut terms, mut angles) = (Accumulator::default(), Accumulator::default());
        for d in paced(&self.diamonds) {
            let y = d.v.map(at);
            let angle = diamond_angle(y[0], y[1], y[2], y[3]);
            let count = f64::from(d.count);
            terms.add(count * smoothing.value(angle.beta));
            angles.add(count * angle.beta);
            let weights = diamond_weights(y, angle, smoothing);
            if d.count > 0 {
                out.skipped += usize::from(weights.is_none());
            }
            let weights = weights.unwrap_or_default();
            let mut pulls = [DVec3::ZERO; 4];
            for (w, (p, q)) in weights.iter().zip(DIAMOND_PAIRS) {
                let pull = count * *w * (y[p] - y[q]);
                pulls[p] += pull;
                pulls[q] -= pull;
            }
            for (v, pull) in d.v.into_iter().zip(pulls) {
                out.gradient[v as usize] += pull;
            }
            out.weights.diamonds.push(weights);
        }
        out.weights
            .diamonds
            .resize(self.diamonds.len(), Default::default());
        for c in &self.corners {
            let y = c.v.map(at);
            let angle = corner_angle(y[0], y[1], y[2]);
            terms.add(2.0 * smoothing.value(angle.beta));
            angles.add(2.0 * angle.beta);
            let weights = corner_weights(y, angle, smoothing);
            out.skipped += usize::from(weights.is_none());
            let weights = weights.unwrap_or_default();
            for (w, (p, q)) in weights.iter().zip(CORNER_PAIRS) {
                let pull = 2.0 * *w * (y[p] - y[q]);
                out.gradient[c.v[p] as usize] += pull;
                out.gradient[c.v[q] as usize] -= pull;
            }
            out.weights.corners.push(weights);
        }
        let flat = TAU * self.n_counted as f64;
        (out.value, out.exact) = (terms.sum() - flat, angles.sum() - flat);
    }

    /// W_i of every vertex, dimensionless; 0 where it does not count.
    ///
    /// Their sum is W, up to the W_∞ of the vertices at infinity.
    pub fn vertex_energies(&self, x: &[DVec3]) -> Vec<f64> {
        let at = |v: u32| x[v as usize];
        let mut w: Vec<f64> = self
            .counted
            .iter()
            .map(|&c| if c { -TAU } else { 0.0 })
            .collect();
        let mut add = |v: u32, beta: f64| {
            if self.counted[v as usize] {
                w[v as usize] += beta;
            }
        };
        for d in &self.diamonds {
            let [k, j, l, i] = d.v.map(at);
            let beta = diamond_angle(k, j, l, i).beta;
            add(d.v[1], beta);
            add(d.v[3], beta);
        }
        for (c, corner) in self.corners.iter().enumerate() {
            let [p, v, n] = corner.v.map(at);
            let beta = corner_angle(p, v, n).beta;
            if c < self.first_turn {
                add(corner.v[0], beta);
                add(corner.v[2], beta);
            } else {
                add(corner.v[1], beta);
            }
        }
        w
    }
}

/// Compensated summation: the energy of a near-sphere is what is left of 2π a vertex.
#[derive(Default)]
struct Accumulator {
    sum: f64,
    lost: f64,
}

impl Accumulator {
    fn add(&mut self, term: f64) {
        // Neumaier's variant; terms are never negative here, so |sum| ≥ |term| soon.
        let total = self.sum + term;
        self.lost += if self.sum >= term {
            (self.sum - total) + term
        } else {
            (term - total) + self.sum
        };
        self.sum = total;
    }

    fn sum(&self) -> f64 {
        self.sum + self.lost
    }
}

fn accurate_sum(terms: impl Iterator<Item = f64>) -> f64 {
    let mut accumulator = Accumulator::default();
    terms.for_each(|t| accumulator.add(t));
    accumulator.sum()
}
