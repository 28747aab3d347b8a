//! Conformal regularisation of Gruber & Aulisa [GA20](crate::bibliography#ga20) (Problems 4.3 and
//! 5.3): vertices slide along the surface until its elements are as similar as can be to their
//! reference shapes.
//!
//! The reference of a triangle has the angles of Algorithm 1, that of a quadrilateral is a
//! square. One pass minimises, over displacements v,
//!
//! ```math
//! CD(x + v) + \sum_i \frac{1}{2\epsilon} \langle v_i, n_i \rangle^2, \qquad CD = \sum_T 2 (D_T - A_T),
//! ```
//!
//! with the normals held, a linear least-squares problem with a symmetric positive definite
//! matrix of 3n rows. The printed sign of ε would make it indefinite. CD has no unit but
//! length², and so has v: ε is a pure number, the same for a mesh in millimetres and in
//! metres. The penalty is lumped at the vertices (P1); one value an element (P0) imposes
//! 2n conditions on 3n unknowns and locks as ε → 0.

mod preconditioner;

use crate::energy::conformal::reference_angles;
use crate::interrupt::{self, paced};
use crate::linalg::{LinalgError, LinearSystem, Pattern, Workspace, conjugate_gradients};
use crate::operator::Elements;
use glam::{DMat3, DVec3};
use preconditioner::Preconditioner;
use serde::{Deserialize, Serialize};

/// Where the normals are taken that a pass holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Mode {
    /// No regularisation.
    Off,
    /// At the start: one linear solve.
    Linear,
    /// Half way to the end, by two rounds of fixed-point iteration: the same mesh quality
    /// for a several times smaller change of volume.
    #[default]
    Nonlinear,
}

/// The relative residual asked of a solve. A displacement need not be exact, as whatever it is
/// the next pass starts from there; but a mesh in other units is to move alike, and what
/// rounding does to iterates goes with what is left of the residual.
const TOLERANCE: f64 = 1e-8;

/// Iterations of a solve at most: ten to twenty do on the meshes of a flow.
const MAX_ITERATIONS: usize = 200;

/// Displacements below this share of an edge need no second solve: off the surface they are
/// of second order.
const NEARLY_LINEAR: f64 = 0.03;

/// Factor on the diagonal of a vertex that stays: its neighbours move as if it stood still,
/// up to the inverse of this. A row of the unit matrix instead would change the pattern.
const PINNED: f64 = 1e9;

/// Normals that a pass holds: of every quadrature point, and of every vertex.
pub(super) struct Normals {
    pub(super) points: Vec<DVec3>,
    pub(super) vertices: Vec<DVec3>,
}

/// The least-squares problem on one connectivity.
pub struct Regulariser {
    elements: Elements,
    /// ⟨∇̂φ_i, ∇̂φ_j⟩ integrated over the reference, pair by pair of corners of an element;
    /// one row for all elements where they share a reference.
    couplings: Vec<[f64; 6]>,
    /// Slots of the three columns of a block below the diagonal, pair by pair.
    slots: Vec<[u32; 3]>,
    pattern: Pattern,
    values: Vec<f64>,
    preconditioner: Preconditioner,
    workspace: Workspace<f64>,
    /// Of the last solve.
    iterations: usize,
}

/// Corner pairs of an element, smaller first.
const PAIRS: [(usize, usize); 6] = [(0, 1), (1, 2), (0, 2), (2, 3), (0, 3), (1, 3)];

impl Regulariser {
    /// Prepares the problem; `x` helps to order the elimination.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`].
    pub fn new(elements: Elements, x: &[DVec3]) -> Result<Self, LinalgError> {
        let n = elements.n_vertices();
        let cliques = elements.corners().map(|corners| {
            let mut rows = Vec::with_capacity(12);
            rows.extend(corners.iter().flat_map(|&v| [3 * v, 3 * v + 1, 3 * v + 2]));
            rows
        });
        let pattern = Pattern::from_cliques(3 * n, cliques);
        let pairs = elements.degree() * (elements.degree() - 1) / 2;
        let mut slots = Vec::with_capacity(pairs * elements.len());
        for corners in elements.corners() {
            for &(i, j) in &PAIRS[..pairs] {
                let (low, high) = order(corners[i], corners[j]);
                slots.push([0, 1, 2].map(|c| pattern.slot(3 * high, 3 * low + c) as u32));
            }
        }
        interrupt::check()?;
        let values = vec![0.0; pattern.nnz()];
        let couplings = couplings(&elements);
        let all = elements.corners().enumerate().flat_map(|(e, corners)| {
            let coupling = couplings[if couplings.len() == 1 { 0 } else { e }];
            let ends = PAIRS[..pairs]
                .iter()
                .map(|&(i, j)| [corners[i], corners[j]]);
            ends.zip(coupling)
        });
        let ring = Pattern::from_cliques(n, elements.corners());
        interrupt::check()?;
        let preconditioner = Preconditioner::new(ring, all, x)?;
        Ok(Self {
            elements,
            couplings,
            slots,
            pattern,
            values,
            preconditioner,
            workspace: Workspace::default(),
            iterations: 0,
        })
    }

    /// Iterations of the last solve.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// The mesh as elements.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    fn pairs(&self) -> usize {
        self.elements.degree() * (self.elements.degree() - 1) / 2
    }

    fn coupling(&self, e: usize) -> &[f64; 6] {
        &self.couplings[if self.couplings.len() == 1 { 0 } else { e }]
    }

    /// CD = Σ 2 (D − A) ≥ 0, unit length²; with triangles the reading of
    /// [`conformal_distortion`](crate::energy::conformal::conformal_distortion).
    pub fn distortion(&self, x: &[DVec3]) -> f64 {
        let mut total = 0.0;
        for (e, corners) in paced(self.elements.corners().enumerate()) {
            // Rows of the coupling sum to zero: Σ_ij a_ij ⟨x_i, x_j⟩ = −Σ_{i<j} a_ij |x_i − x_j|².
            for (&(i, j), a) in PAIRS[..self.pairs()].iter().zip(self.coupling(e)) {
                total -= a * x[corners[i] as usize].distance_squared(x[corners[j] as usize]);
            }
        }
        total - 2.0 * self.area(x)
    }

    fn area(&self, x: &[DVec3]) -> f64 {
        paced(0..self.elements.len())
            .flat_map(|e| self.elements.nodes(x, e))
            .map(|node| node.area)
            .sum()
    }

    /// Normals of the surface at `x`.
    pub(super) fn normals(&self, x: &[DVec3]) -> Normals {
        let mut points = Vec::with_capacity(self.elements.len() * self.elements.points().len());
        let mut vertices = vec![DVec3::ZERO; x.len()];
        for (e, corners) in paced(self.elements.corners().enumerate()) {
            for node in self.elements.nodes(x, e) {
                points.push(node.normal);
                for (&v, shape) in corners.iter().zip(node.shape) {
                    vertices[v as usize] += shape * node.area * node.normal;
                }
            }
        }
        vertices.iter_mut().for_each(|n| *n = n.normalize_or_zero());
        Normals { points, vertices }
    }

    /// One pass: the displacement v from `x`, of every vertex.
    ///
    /// # Errors
    /// [`LinalgError`], where the matrix is singular in double precision or memory is short.
    pub fn displacement(
        &mut self,
        x: &[DVec3],
        mode: Mode,
        epsilon: f64,
    ) -> Result<Vec<DVec3>, LinalgError> {
        let at_start = self.normals(x);
        interrupt::check()?;
        let linear = self.solve(x, &at_start, epsilon, None)?;
        let scale = (self.area(x) / x.len() as f64).sqrt();
        let farthest = linear.iter().map(|v| v.length()).fold(0.0, f64::max);
        if mode != Mode::Nonlinear || farthest < NEARLY_LINEAR * scale {
            return Ok(linear);
        }
        interrupt::check()?;
        let half_way: Vec<DVec3> = x.iter().zip(&linear).map(|(x, v)| *x + 0.5 * *v).collect();
        let central = self.normals(&half_way);
        interrupt::check()?;
        self.solve(x, &central, epsilon, None)
    }

    /// Solves (K + (1/ε) n nᵀ + diag(K) damping) v = −K x for these normals; vertices with
    /// infinite damping stay where they are.
    pub(super) fn solve(
        &mut self,
        x: &[DVec3],
        normals: &Normals,
        epsilon: f64,
        damping: Option<&[f64]>,
    ) -> Result<Vec<DVec3>, LinalgError> {
        let mut rhs = vec![DVec3::ZERO; x.len()];
        self.assemble(x, normals, &mut rhs);
        interrupt::check()?;
        let factors = damping.map(|damping| {
            let factors = damping.iter().map(|extra| 1.0 + extra);
            let factors = factors.map(|f| if f.is_infinite() { PINNED } else { f });
            factors.collect::<Vec<f64>>()
        });
        let slots = self.pattern.diagonal_slots();
        let mut stiffness = Vec::with_capacity(x.len());
        for (v, n) in normals.vertices.iter().enumerate() {
            let block = [0, 1, 2].map(|c| slots[3 * v + c] as usize);
            if let Some(factors) = &factors {
                if factors[v] == PINNED {
                    rhs[v] = DVec3::ZERO;
                }
                block
                    .iter()
                    .for_each(|&slot| self.values[slot] *= factors[v]);
            }
            let n = n.to_array();
            let mut along = 0.0;
            for c in 0..3 {
                for r in c..3 {
                    let value = &mut self.values[block[c] + r - c];
                    *value += n[r] * n[c] / epsilon;
                    along += if r == c { 1.0 } else { 2.0 } * n[r] * n[c] * *value;
                }
            }
            stiffness.push(along);
        }
        let rhs: Vec<f64> = rhs.iter().flat_map(|f| f.to_array()).collect();
        if let Some(row) = rhs.iter().position(|value| !value.is_finite()) {
            return Err(LinalgError::NonFiniteRightHandSide { row });
        }
        self.preconditioner.damp(factors.as_deref())?;
        let mut v = vec![0.0; rhs.len()];
        self.workspace.resize(rhs.len());
        let system = LinearSystem {
            pattern: &self.pattern,
            values: &self.values,
            rhs: &rhs,
        };
        let preconditioner = &mut self.preconditioner;
        let precondition = |r: &mut [f64]| preconditioner.apply(r, &normals.vertices, &stiffness);
        let workspace = &mut self.workspace;
        let (tolerance, limit) = (TOLERANCE, MAX_ITERATIONS);
        let reached =
            conjugate_gradients(system, &mut v, precondition, tolerance, limit, workspace);
        interrupt::check()?;
        self.iterations = reached.iterations;
        let mut v: Vec<DVec3> = v.chunks_exact(3).map(DVec3::from_slice).collect();
        // What is left of them is of the order of 1/PINNED.
        for (v, damping) in v.iter_mut().zip(damping.unwrap_or_default()) {
            if damping.is_infinite() {
                *v = DVec3::ZERO;
            }
        }
        Ok(v)
    }

    /// K for these normals into `values`, and −K x into `rhs`; some of it where the work is given
    /// up.
    ///
    /// At a quadrature point with normal n the block of corners i, j is
    /// a_ij (2I − n nᵀ) + c_ij n×, with a_ij = ŵ ⟨∇̂φ_i, ∇̂φ_j⟩ and c_ij = 2ŵ ∇̂φ_i × ∇̂φ_j:
    /// the Gauss–Newton form of the Cauchy–Riemann equations ∂₂u = n × ∂₁u.
    fn assemble(&mut self, x: &[DVec3], normals: &Normals, rhs: &mut [DVec3]) {
        self.values.fill(0.0);
        let points = self.elements.points();
        let pairs = self.pairs();
        let shared = self.couplings.len() == 1;
        let mut normal = normals.points.iter();
        let diagonal = self.pattern.diagonal_slots();
        for (e, corners) in paced(self.elements.corners().enumerate()) {
            let mut blocks = [DMat3::ZERO; 6];
            let triangle = self.couplings[if shared { 0 } else { e }];
            for point in points {
                let n = normal.next().copied().unwrap_or_default();
                let along = projector(n);
                let turn = cross_matrix(n);
                for (k, &(i, j)) in PAIRS[..pairs].iter().enumerate() {
                    let (p, q) = (point.slope[i], point.slope[j]);
                    let a = if shared {
                        point.weight * (p[0] * q[0] + p[1] * q[1])
                    } else {
                        triangle[k]
                    };
                    let c = 2.0 * point.weight * (p[0] * q[1] - p[1] * q[0]);
                    blocks[k] += along * a + turn * c;
                }
            }
            let slots = &self.slots[e * pairs..(e + 1) * pairs];
            for ((&(i, j), block), slots) in PAIRS.iter().zip(blocks).zip(slots) {
                let (u, v) = (corners[i], corners[j]);
                let difference = x[v as usize] - x[u as usize];
                // Each row of blocks sums to zero: that of i with x_j, that of j with x_i.
                rhs[u as usize] -= block * difference;
                rhs[v as usize] += block.transpose() * difference;
                // Stored below the diagonal: row of the larger vertex.
                let lower = if u > v { block } else { block.transpose() };
                for (c, &slot) in slots.iter().enumerate() {
                    let column = lower.col(c).to_array();
                    for (r, value) in column.into_iter().enumerate() {
                        self.values[slot as usize + r] += value;
                    }
                }
                for w in [u, v] {
                    // K_ii = −Σ_j K_ij, in which the cross products cancel.
                    let block = -0.5 * (block + block.transpose());
                    add_diagonal(&mut self.values, diagonal, w, block);
                }
            }
        }
    }
}

/// Adds the lower triangle of a symmetric block to the diagonal block of vertex `v`.
fn add_diagonal(values: &mut [f64], diagonal: &[u32], v: u32, block: DMat3) {
    for c in 0..3 {
        let slot = diagonal[3 * v as usize + c] as usize;
        for (r, value) in block.col(c).to_array().into_iter().enumerate().skip(c) {
            values[slot + r - c] += value;
        }
    }
}

fn order(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// 2I − n nᵀ.
fn projector(n: DVec3) -> DMat3 {
    DMat3::from_diagonal(DVec3::splat(2.0)) - DMat3::from_cols(n * n.x, n * n.y, n * n.z)
}

/// The matrix of v ↦ n × v.
fn cross_matrix(n: DVec3) -> DMat3 {
    DMat3::from_cols(n.cross(DVec3::X), n.cross(DVec3::Y), n.cross(DVec3::Z))
}

/// a_ij of every element, pair by pair.
fn couplings(elements: &Elements) -> Vec<[f64; 6]> {
    if elements.degree() == 4 {
        let mut square = [0.0; 6];
        for point in elements.points() {
            for (a, (i, j)) in square.iter_mut().zip(PAIRS) {
                let (p, q) = (point.slope[i], point.slope[j]);
                *a += point.weight * (p[0] * q[0] + p[1] * q[1]);
            }
        }
        return vec![square];
    }
    let mut incident = vec![0usize; elements.n_vertices()];
    for corners in elements.corners() {
        corners.iter().for_each(|&v| incident[v as usize] += 1);
    }
    let mut couplings: Vec<[f64; 6]> = elements
        .corners()
        .map(|corners| {
            let angles = reference_angles([0, 1, 2].map(|k| incident[corners[k] as usize]));
            let [a, b, c] = angles.map(|angle| -0.5 / angle.tan());
            // Opposite to the pairs (0, 1), (1, 2), (0, 2).
            [c, a, b, 0.0, 0.0, 0.0]
        })
        .collect();
    if couplings.len() == 1 {
        // A lone triangle must not be taken for a shared reference.
        couplings.push(couplings[0]);
    }
    couplings
}
