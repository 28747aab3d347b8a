//! The linear system of a step: (M/τ + L diag(c) L) d = b, one scalar matrix for the three
//! coordinates.

use crate::flow::FlowError;
use crate::interrupt::paced;
use crate::linalg::{Ldlt, Method, Pattern, SolveInfo, Solver};
use crate::operator::{Elements, Laplacian};
use glam::DVec3;
use std::sync::Arc;

/// The residual asked of an iterative solve.
const TOLERANCE: f64 = 1e-8;

/// Pattern, matrix and solver on one connectivity.
pub(super) struct PWillmoreSystem {
    laplacian: Laplacian,
    /// Slots of the lower triangle of row i's outer product, for every i end to end. Empty
    /// where the stiffness is L itself.
    slots: Vec<u32>,
    solver: Solver,
    stiffness: Vec<f64>,
    matrix: Vec<f64>,
}

impl PWillmoreSystem {
    /// Analyses the pattern: two rings, or with `is_second_order` (p = 0) one.
    pub(super) fn new(
        elements: &Elements,
        x: &[DVec3],
        is_second_order: bool,
    ) -> Result<Self, FlowError> {
        let laplacian = Laplacian::new(elements);
        let n = laplacian.n();
        let edges = Pattern::from_cliques(n, elements.corners());
        let pattern = if is_second_order {
            edges.clone()
        } else {
            Pattern::from_cliques(n, (0..n).map(|i| laplacian.members(i)))
        };
        let mut slots = Vec::new();
        if !is_second_order {
            for i in 0..n {
                let members = laplacian.members(i);
                for (k, &a) in members.iter().enumerate() {
                    slots.extend(members[..=k].iter().map(|&b| pattern.slot(a, b) as u32));
                }
            }
        }
        Ok(Self {
            slots,
            stiffness: vec![0.0; pattern.nnz()],
            matrix: Vec::new(),
            solver: Solver::on_mesh(pattern, x, edges),
            laplacian,
        })
    }

    /// Assembles the stiffness L diag(c) L at `x`; L where c is empty. Some of it where the work is
    /// given up.
    pub(super) fn assemble(&mut self, elements: &Elements, x: &[DVec3], c: &[f64]) {
        self.laplacian.assemble(elements, x);
        self.stiffness.fill(0.0);
        if c.is_empty() {
            let pattern = self.solver.pattern();
            for i in paced(0..self.laplacian.n()) {
                let row = self.laplacian.members(i).iter().zip(self.laplacian.row(i));
                for (&j, value) in row.filter(|(j, _)| **j as usize >= i) {
                    self.stiffness[pattern.slot(i as u32, j)] += value;
                }
            }
            return;
        }
        let mut slots = self.slots.iter();
        for (i, c) in paced(c.iter().enumerate()) {
            let row = self.laplacian.row(i);
            for (k, a) in row.iter().enumerate() {
                for (b, &slot) in row[..=k].iter().zip(&mut slots) {
                    self.stiffness[slot as usize] += c * a * b;
                }
            }
        }
    }

    /// See [`Solver::release`].
    pub(super) fn release(&mut self) {
        self.matrix = Vec::new();
        self.solver.release();
    }

    /// See [`Solver::is_too_large_to_factor`].
    pub(super) fn is_iterative(&self) -> bool {
        self.solver.is_too_large_to_factor()
    }

    /// The factor of M/τ + s · stiffness, as a preconditioner.
    pub(super) fn factor(&mut self, mass: &[f64], tau: f64, s: f64) -> Result<Ldlt, FlowError> {
        self.matrix.clear();
        self.matrix.extend(self.stiffness.iter().map(|k| s * k));
        for (&slot, m) in self.solver.pattern().diagonal_slots().iter().zip(mass) {
            self.matrix[slot as usize] += m / tau;
        }
        let mut factor = Ldlt::new(Arc::clone(self.solver.symbolic()?))?;
        factor.factor(&self.matrix)?;
        Ok(factor)
    }

    /// Solves for one or more fields end to end.
    pub(super) fn solve(
        &mut self,
        mass: &[f64],
        tau: f64,
        rhs: &[DVec3],
        solution: &mut [DVec3],
    ) -> Result<SolveInfo, FlowError> {
        self.matrix.clone_from(&self.stiffness);
        for (&slot, m) in self.solver.pattern().diagonal_slots().iter().zip(mass) {
            self.matrix[slot as usize] += m / tau;
        }
        // To so small a residual multigrid takes longer, as far as a factor fits into memory.
        let method = Method::Direct;
        Ok(self
            .solver
            .solve(&self.matrix, rhs, solution, TOLERANCE, method)?)
    }
}
