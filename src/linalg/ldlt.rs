//! Numeric factorisation `L D Lᵀ` into memory that is allocated once.

use super::entry::Entry;
use super::error::LinalgError;
use super::supernodal;
use super::symbolic::Symbolic;
use crate::interrupt;
use faer::MatMut;
use std::sync::Arc;

/// Numbers that are set to zero between two signs of life.
const PIECE: usize = 1 << 20;

/// Signs of the eigenvalues, by Sylvester's law of inertia those of the pivots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inertia {
    /// Number of positive eigenvalues.
    pub positive: usize,
    /// Number of negative eigenvalues; 0 means positive definite.
    pub negative: usize,
}

/// Factor `P A Pᵀ = L D Lᵀ` of a sparse symmetric matrix; D is diagonal.
///
/// There is no pivoting and no regularisation: an indefinite matrix is factored all the
/// same, and the [`Inertia`] of D tells. Rounding then grows with L, so its solutions
/// deserve a look at the residual.
pub struct Ldlt {
    symbolic: Arc<Symbolic>,
    /// Entries of `P A Pᵀ`.
    matrix: Vec<f64>,
    /// L below the diagonal and D on it, supernode by supernode.
    factor: Vec<f64>,
    is_factored: bool,
    /// Permuted right-hand sides, column by column.
    columns: Vec<f64>,
    /// What elimination and solving write to.
    work: Vec<f64>,
}

impl Ldlt {
    /// Allocates a factor of that structure, and the memory to compute it and to solve
    /// for one field.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::Interrupted`].
    pub fn new(symbolic: Arc<Symbolic>) -> Result<Self, LinalgError> {
        let zeroed = |len| zeroed(len, symbolic.n());
        Ok(Self {
            matrix: zeroed(symbolic.slots.len())?,
            factor: zeroed(symbolic.factor_len())?,
            is_factored: false,
            columns: zeroed(3 * symbolic.n())?,
            work: zeroed(supernodal::work_len(&symbolic))?,
            symbolic,
        })
    }

    /// Makes room to solve for that many columns at once, which costs less than one
    /// after the other: the factor is read once.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`].
    pub fn reserve_columns(&mut self, n_columns: usize) -> Result<(), LinalgError> {
        let n = self.symbolic.n();
        if self.columns.len() < n * n_columns {
            self.columns = zeroed(n * n_columns, n)?;
        }
        Ok(())
    }

    /// Structure this is a factor of.
    pub fn symbolic(&self) -> &Arc<Symbolic> {
        &self.symbolic
    }

    /// Bytes held besides the shared structure.
    pub fn allocated_bytes(&self) -> usize {
        let numbers = [&self.matrix, &self.factor, &self.columns, &self.work];
        let numbers: usize = numbers.map(Vec::capacity).iter().sum();
        numbers * size_of::<f64>()
    }

    /// Factors the matrix with these values, one a slot of the pattern.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`],
    /// [`LinalgError::Interrupted`]; there is then no factor until a later call succeeds.
    ///
    /// # Panics
    /// If `values` has not one value a slot.
    pub fn factor(&mut self, values: &[f64]) -> Result<Inertia, LinalgError> {
        let symbolic = &*self.symbolic;
        assert_eq!(values.len(), symbolic.slots.len(), "one value a slot");
        self.is_factored = false;
        interrupt::check()?;
        for (entry, &slot) in self.matrix.iter_mut().zip(&symbolic.slots) {
            *entry = values[slot as usize];
        }
        if let Some(k) = self.matrix.iter().position(|entry| !entry.is_finite()) {
            let column = symbolic
                .column_starts
                .partition_point(|&start| start as usize <= k)
                - 1;
            return Err(LinalgError::NonFiniteEntry {
                column: symbolic.order[column] as usize,
            });
        }
        supernodal::eliminate(symbolic, &self.matrix, &mut self.factor, &mut self.work)?;
        self.is_factored = true;
        Ok(self.inertia())
    }

    /// Counts the signs on the diagonals of the supernodes, where D is stored.
    fn inertia(&self) -> Inertia {
        let pivots = supernodal::pivots(&self.symbolic, &self.factor);
        let negative = pivots.filter(|pivot| *pivot < 0.0).count();
        Inertia {
            positive: self.symbolic.n() - negative,
            negative,
        }
    }

    /// Replaces right-hand sides by solutions, for one or more fields end to end; by anything where the
    /// work is given up.
    ///
    /// O(entries of L) a column; as many fields go together as
    /// [room was made for](Self::reserve_columns).
    ///
    /// # Panics
    /// If there is no factor, or `rhs` is not whole fields.
    pub fn solve_in_place<T: Entry>(&mut self, rhs: &mut [T]) {
        let n = self.symbolic.n();
        assert!(self.is_factored, "no factor to solve with");
        assert!(rhs.len().is_multiple_of(n.max(1)), "whole fields");
        let room = self.columns.len() / (n.max(1) * T::COLUMNS) * n;
        if room > 0 {
            rhs.chunks_mut(room)
                .for_each(|fields| self.solve_together(fields));
        }
    }

    fn solve_together<T: Entry>(&mut self, fields: &mut [T]) {
        let n = self.symbolic.n();
        let order = &self.symbolic.order;
        let columns = &mut self.columns[..T::COLUMNS * fields.len()];
        for (field, columns) in fields
            .chunks_exact(n)
            .zip(columns.chunks_exact_mut(T::COLUMNS * n))
        {
            if interrupt::check().is_err() {
                return;
            }
            let mut columns = MatMut::from_column_major_slice_mut(columns, n, T::COLUMNS);
            for (k, &i) in order.iter().enumerate() {
                field[i as usize].scatter(&mut columns, k);
            }
        }
        supernodal::solve(&self.symbolic, &self.factor, columns, &mut self.work);
        for (field, columns) in fields
            .chunks_exact_mut(n)
            .zip(columns.chunks_exact_mut(T::COLUMNS * n))
        {
            if interrupt::check().is_err() {
                return;
            }
            let columns = MatMut::from_column_major_slice_mut(columns, n, T::COLUMNS);
            for (k, &i) in order.iter().enumerate() {
                field[i as usize] = T::gather(&columns, k);
            }
        }
    }
}

/// Zeros up to a length that there is room for: memory that is touched first takes time.
pub(super) fn fill(numbers: &mut Vec<f64>, len: usize) -> Result<(), LinalgError> {
    while numbers.len() < len {
        interrupt::check()?;
        numbers.resize(len.min(numbers.len() + PIECE), 0.0);
    }
    Ok(())
}

/// That many zeros, or an error instead of the end of the program.
fn zeroed(len: usize, n: usize) -> Result<Vec<f64>, LinalgError> {
    let mut numbers = Vec::new();
    let room = numbers.try_reserve_exact(len);
    room.map_err(|_| LinalgError::OutOfMemory { n })?;
    fill(&mut numbers, len)?;
    Ok(numbers)
}
