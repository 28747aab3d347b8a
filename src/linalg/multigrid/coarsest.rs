//! The coarsest level, which is solved directly.

use super::rows::Rows;
use crate::linalg::{Ldlt, LinalgError, Pattern, Symbolic};
use glam::{DVec3, Vec3A};
use std::sync::Arc;

pub(super) struct Coarsest {
    pub(super) a: Rows,
    factor: Ldlt,
    values: Vec<f64>,
    /// Right-hand side, then solution.
    pub(super) field: Vec<Vec3A>,
    exact: Vec<DVec3>,
}

impl Coarsest {
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`].
    pub(super) fn new(a: Rows, points: &[DVec3]) -> Result<Self, LinalgError> {
        let n = a.n();
        let pairs = (0..n).flat_map(|i| a.columns[a.row(i)].iter().map(move |&j| [i as u32, j]));
        let pattern = Pattern::from_cliques(n, pairs);
        let factor = Ldlt::new(Arc::new(Symbolic::analyse(&pattern, Some(points))?))?;
        Ok(Self {
            factor,
            values: Vec::with_capacity(pattern.nnz()),
            field: vec![Vec3A::ZERO; n],
            exact: vec![DVec3::ZERO; n],
            a,
        })
    }

    /// Entries of the factor.
    pub(super) fn factor_len(&self) -> usize {
        self.factor.symbolic().factor_len()
    }

    /// Factors the matrix; answers whether it is positive definite.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`].
    pub(super) fn update(&mut self) -> Result<bool, LinalgError> {
        // The entries of a row from the diagonal on are those of the lower triangle's column.
        self.values.clear();
        for i in 0..self.a.n() {
            let row = self.a.entries(self.a.row(i));
            let lower = row.filter(|&(j, _)| j >= i);
            self.values.extend(lower.map(|(_, v)| f64::from(v)));
        }
        Ok(self.factor.factor(&self.values)?.negative == 0)
    }

    pub(super) fn solve(&mut self) {
        for (exact, b) in self.exact.iter_mut().zip(&self.field) {
            *exact = b.as_dvec3();
        }
        self.factor.solve_in_place(&mut self.exact);
        for (x, exact) in self.field.iter_mut().zip(&self.exact) {
            *x = exact.as_vec3a();
        }
    }
}
