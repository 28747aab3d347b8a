//! What of a factorisation depends on the pattern alone.

use super::error::LinalgError;
use super::ordering::{Graph, LEAF, minimum_degree, nested_dissection};
use super::pattern::Pattern;
use crate::interrupt;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::cholesky::{simplicial, supernodal};
use faer::sparse::{FaerError, SymbolicSparseColMatRef};
use glam::DVec3;

/// Below this size only minimum degree is tried: either order takes under a millisecond.
const DISSECTION_FROM: usize = 500;

/// Minimum degree is found for at most so many rows together, where there are points to part them
/// by: it is one call, which cannot be given up. In parts it is no match for itself as a whole on
/// regular grids, where dissection takes up to 1.6 times as many operations.
const DEGREE_UP_TO: usize = 60_000;

/// Rows between two looks at whether to go on.
const ROWS: usize = 4096;

/// How the order of elimination was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ordering {
    /// Approximate minimum degree.
    MinimumDegree,
    /// Geometric nested dissection.
    NestedDissection,
}

/// Order of elimination and structure of the factor `P A Pᵀ = L D Lᵀ`.
///
/// Computed once per connectivity and shared by all factors with that pattern. `faer`
/// stores `L` by supernodes: runs of columns with nearly the same rows, kept dense.
#[derive(Debug)]
pub struct Symbolic {
    /// Row eliminated first, second, …
    pub(super) order: Vec<u32>,
    /// Lower triangle of `P A Pᵀ` by columns.
    pub(super) column_starts: Vec<u32>,
    pub(super) rows: Vec<u32>,
    /// Slot in the pattern of each entry of that triangle.
    pub(super) slots: Vec<u32>,
    pub(super) supernodes: supernodal::SymbolicSupernodalCholesky<u32>,
    ordering: Ordering,
    flops: f64,
}

impl Symbolic {
    /// Analyses a pattern; `points`, one a row, allow nested dissection.
    ///
    /// Of minimum degree, in parts of 60,000 rows at most, and nested dissection the order with fewer
    /// operations is kept.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`],
    /// [`LinalgError::Interrupted`].
    ///
    /// # Panics
    /// If there are points but not one a row.
    pub fn analyse(pattern: &Pattern, points: Option<&[DVec3]>) -> Result<Self, LinalgError> {
        let n = pattern.n();
        assert!(
            points.is_none_or(|points| points.len() == n),
            "one point a row"
        );
        let graph = Graph::new(pattern);
        interrupt::check()?;
        let best = Elimination::best(&graph, points)?;
        Self::of(pattern, &graph, best)
    }

    fn of(pattern: &Pattern, graph: &Graph, best: Elimination) -> Result<Self, LinalgError> {
        let (supernodes, flops) = best.supernodes()?;
        interrupt::check()?;
        let Elimination {
            order,
            inverse,
            ordering,
            ..
        } = best;

        let mut column_starts = vec![0];
        let (mut rows, mut slots) = (Vec::new(), Vec::new());
        rows.reserve_exact(pattern.nnz());
        slots.reserve_exact(pattern.nnz());
        for (k, &j) in order.iter().enumerate() {
            if k.is_multiple_of(ROWS) {
                interrupt::check()?;
            }
            rows.push(k as u32);
            slots.push(pattern.diagonal_slots()[j as usize]);
            for &i in graph
                .neighbours(j)
                .iter()
                .filter(|&&i| inverse[i as usize] > k as u32)
            {
                rows.push(inverse[i as usize]);
                slots.push(pattern.slot(i, j) as u32);
            }
            column_starts.push(rows.len() as u32);
        }
        Ok(Self {
            order,
            column_starts,
            rows,
            slots,
            supernodes,
            ordering,
            flops,
        })
    }

    /// Number of rows.
    pub fn n(&self) -> usize {
        self.order.len()
    }

    /// Which of the two orders was kept.
    pub fn ordering(&self) -> Ordering {
        self.ordering
    }

    /// The row eliminated first, second, …: a permutation of `0..n`.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Operations of a factorisation, `Σ c²` over the columns of `L` with c entries.
    pub fn flops(&self) -> f64 {
        self.flops
    }

    /// Number of entries stored for `L` and `D`, the zeros inside supernodes included.
    pub fn factor_len(&self) -> usize {
        self.supernodes.len_val()
    }
}

/// An order with its elimination tree.
struct Elimination {
    ordering: Ordering,
    order: Vec<u32>,
    /// When each row is eliminated.
    inverse: Vec<u32>,
    /// Strict upper triangle of the permuted matrix by columns.
    column_starts: Vec<u32>,
    rows: Vec<u32>,
}

impl Elimination {
    /// Of minimum degree and nested dissection the order with fewer operations. What is faer's is
    /// one call each, between which the work can be given up.
    fn best(graph: &Graph, points: Option<&[DVec3]>) -> Result<Self, LinalgError> {
        let failed = |error| LinalgError::from_faer(error, graph.n());
        let order = match points {
            Some(points) if graph.n() > DEGREE_UP_TO => {
                nested_dissection(graph, points, DEGREE_UP_TO)
            }
            _ => minimum_degree(graph),
        };
        interrupt::check()?;
        let by_degree = Self::new(graph, order.map_err(failed)?, Ordering::MinimumDegree)?;
        let Some(points) = points.filter(|points| points.len() >= DISSECTION_FROM) else {
            return Ok(by_degree);
        };
        let few = by_degree.flops().map_err(failed)?;
        interrupt::check()?;
        let order = nested_dissection(graph, points, LEAF).map_err(failed)?;
        interrupt::check()?;
        let dissected = Self::new(graph, order, Ordering::NestedDissection)?;
        let is_cheaper = dissected.flops().map_err(failed)? < few;
        interrupt::check()?;
        Ok(if is_cheaper { dissected } else { by_degree })
    }

    fn new(graph: &Graph, order: Vec<u32>, ordering: Ordering) -> Result<Self, LinalgError> {
        let n = order.len();
        let mut inverse = vec![0; n];
        for (k, &i) in order.iter().enumerate() {
            inverse[i as usize] = k as u32;
        }
        let (mut column_starts, mut rows) = (vec![0], Vec::new());
        for (k, &j) in order.iter().enumerate() {
            if k.is_multiple_of(ROWS) {
                interrupt::check()?;
            }
            let neighbours = graph.neighbours(j).iter().map(|&i| inverse[i as usize]);
            rows.extend(neighbours.filter(|&i| i < k as u32));
            column_starts.push(rows.len() as u32);
        }
        Ok(Self {
            ordering,
            order,
            inverse,
            column_starts,
            rows,
        })
    }

    /// Operations of a factorisation.
    fn flops(&self) -> Result<f64, FaerError> {
        let n = self.order.len();
        let (mut tree, mut counts) = (vec![0; n], vec![0; n]);
        self.tree(&mut tree, &mut counts)?;
        Ok(flops(&counts))
    }

    /// Upper triangle in the form `faer` takes.
    fn upper(&self) -> SymbolicSparseColMatRef<'_, u32> {
        let n = self.order.len();
        SymbolicSparseColMatRef::new_unsorted_checked(n, n, &self.column_starts, None, &self.rows)
    }

    /// Elimination tree, and the number of entries of each column of `L`.
    fn tree<'a>(
        &self,
        tree: &'a mut [i32],
        counts: &mut [u32],
    ) -> Result<simplicial::EliminationTreeRef<'a, u32>, FaerError> {
        let scratch =
            simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(tree.len(), self.rows.len());
        let mut memory = MemBuffer::try_new(scratch)?;
        let stack = MemStack::new(&mut memory);
        Ok(simplicial::prefactorize_symbolic_cholesky(
            tree,
            counts,
            self.upper(),
            stack,
        ))
    }

    /// The structure of the factor, and the operations of a factorisation.
    fn supernodes(
        &self,
    ) -> Result<(supernodal::SymbolicSupernodalCholesky<u32>, f64), LinalgError> {
        let n = self.order.len();
        let failed = |error| LinalgError::from_faer(error, n);
        let (mut tree, mut counts) = (vec![0; n], vec![0; n]);
        let tree = self.tree(&mut tree, &mut counts).map_err(failed)?;
        interrupt::check()?;
        let scratch = supernodal::factorize_supernodal_symbolic_cholesky_scratch::<u32>(n);
        let mut memory = MemBuffer::try_new(scratch).map_err(|error| failed(error.into()))?;
        let supernodes = supernodal::factorize_supernodal_symbolic_cholesky(
            self.upper(),
            tree,
            &counts,
            MemStack::new(&mut memory),
            SymbolicSupernodalParams::default(),
        )
        .map_err(failed)?;
        Ok((supernodes, flops(&counts)))
    }
}

/// Σ c² over columns with so many entries.
fn flops(counts: &[u32]) -> f64 {
    counts.iter().map(|&c| f64::from(c) * f64::from(c)).sum()
}
