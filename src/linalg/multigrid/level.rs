//! One level of the hierarchy: its matrix, and how errors are smoothed on it.

use super::galerkin::Galerkin;
use super::rows::Rows;
use glam::Vec3A;
use std::ops::Range;

/// Sweeps before and after the coarser levels: as quick as one, in fewer iterations.
pub(super) const SWEEPS: usize = 2;

/// A level that is not the coarsest.
pub(super) struct Level {
    pub(super) a: Rows,
    /// Place of the diagonal entry of each row, and what to divide by.
    diagonal: Vec<u32>,
    inverse: Vec<f32>,
    /// From the next coarser level.
    pub(super) p: Rows,
    pub(super) galerkin: Galerkin,
    pub(super) b: Vec<Vec3A>,
    pub(super) x: Vec<Vec3A>,
}

impl Level {
    /// Also answers the structure of the next coarser matrix.
    pub(super) fn new(a: Rows, p: Rows) -> (Self, Rows) {
        let diagonal = (0..a.n())
            .map(|i| {
                let row = a.row(i);
                let before = a.columns[row.clone()].partition_point(|&j| (j as usize) < i);
                (row.start + before) as u32
            })
            .collect();
        let (galerkin, coarse) = Galerkin::new(&a, &p);
        let zero = vec![Vec3A::ZERO; a.n()];
        let this = Self {
            diagonal,
            inverse: vec![0.0; a.n()],
            p,
            galerkin,
            b: zero.clone(),
            x: zero,
            a,
        };
        (this, coarse)
    }

    /// Takes note of the matrix's new values, and writes those of the next coarser one.
    pub(super) fn update(&mut self, coarse: &mut Rows) {
        for (inverse, &at) in self.inverse.iter_mut().zip(&self.diagonal) {
            *inverse = self.a.values[at as usize].recip();
        }
        self.galerkin.update(&self.a, &self.p, coarse);
    }

    /// b − A x at row `i`, of the entries in that range.
    fn residual(&self, i: usize, range: Range<usize>) -> Vec3A {
        let mut r = self.b[i];
        for (j, value) in self.a.entries(range) {
            r -= self.x[j] * value;
        }
        r
    }

    /// Forward sweeps of Gauss and Seidel from x = 0.
    pub(super) fn smooth_from_zero(&mut self) {
        for i in 0..self.a.n() {
            let before = self.a.starts[i] as usize..self.diagonal[i] as usize;
            self.x[i] = self.residual(i, before) * self.inverse[i];
        }
        for _ in 1..SWEEPS {
            (0..self.a.n()).for_each(|i| self.relax(i));
        }
    }

    /// Backward sweeps: the adjoint of those before, which keeps the cycle symmetric.
    pub(super) fn smooth_backwards(&mut self) {
        for _ in 0..SWEEPS {
            (0..self.a.n()).rev().for_each(|i| self.relax(i));
        }
    }

    fn relax(&mut self, i: usize) {
        let r = self.residual(i, self.a.row(i));
        self.x[i] += r * self.inverse[i];
    }

    /// Pᵀ(b − A x).
    pub(super) fn restrict(&self, coarse: &mut [Vec3A]) {
        coarse.fill(Vec3A::ZERO);
        for i in 0..self.a.n() {
            let r = self.residual(i, self.a.row(i));
            for (c, weight) in self.p.entries(self.p.row(i)) {
                coarse[c] += r * weight;
            }
        }
    }

    /// x + P y.
    pub(super) fn correct(&mut self, y: &[Vec3A]) {
        for (i, x) in self.x.iter_mut().enumerate() {
            for (c, weight) in self.p.entries(self.p.row(i)) {
                *x += y[c] * weight;
            }
        }
    }
}
