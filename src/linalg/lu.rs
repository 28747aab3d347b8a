//! Numeric factorisation `L U` of unsymmetric matrices with a symmetric pattern.
//!
//! faer's supernodal LU pivots by rows, and so has to plan for the fill of AᵀA. With the leading
//! terms of the Willmore flow and of the flow of sixth order, it takes so many times as long, on
//! the order of elimination that it finds itself (COLAMD) and on ours (least times on one core
//! of a virtual AMD EPYC server; `tests/benches/linalg/elimination.rs` measures both):
//!
//! | unknowns | factor, native | factor, wasm | solution, wasm |
//! | --- | --- | --- | --- |
//! | 2,562, COLAMD | 1.6 to 1.7 | 1.8 to 2.0 | 1.0 |
//! | 10,242, COLAMD | 1.9 to 2.8 | 2.2 to 2.8 | 1.4 to 1.6 |
//! | 40,962, COLAMD | 2.6 | 2.9 to 3.2 | 1.5 |
//! | 2,562, ours | 3.0 to 3.3 | 4.1 to 4.9 | 2.2 to 3.3 |
//! | 10,242, ours | 7.5 to 13 | 8.3 to 11 | 2.4 to 3.0 |
//! | 40,962, ours | 18 to 21 | 20 | 3.8 to 3.9 |
//!
//! Residuals are alike. faer does not report a pivot that is zero; and on our order it ran out of
//! the 4 GiB of wasm at 40,962 unknowns of the sixth order.

use super::error::LinalgError;
use super::ldlt::fill;
use super::pattern::Pattern;
use super::symbolic::Symbolic;
use crate::interrupt;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_unit_lower_triangular_in_place,
};
use faer::prelude::ReborrowMut as _;
use faer::{Accum, MatMut, Par};
use std::ops::Range;
use std::sync::Arc;

/// Columns eliminated together: a block and the rows it updates stay in the cache.
const BLOCK: usize = 32;

/// Fronts of a solution between two looks at whether to go on.
const FRONTS: usize = 64;

/// Values of an unsymmetric matrix whose pattern is symmetric: two a slot.
#[derive(Clone, Debug, Default)]
pub struct Unsymmetric {
    /// A(i, j) with i ≥ j, diagonal included.
    pub lower: Vec<f64>,
    /// A(j, i) with i ≥ j; not read on the diagonal.
    pub upper: Vec<f64>,
}

impl Unsymmetric {
    /// Zeros in the places of a pattern.
    pub fn zeros(pattern: &Pattern) -> Self {
        Self {
            lower: vec![0.0; pattern.nnz()],
            upper: vec![0.0; pattern.nnz()],
        }
    }

    /// `y = A x`.
    pub fn multiply(&self, pattern: &Pattern, x: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for j in 0..pattern.n() {
            for k in pattern.column(j) {
                let i = pattern.rows()[k] as usize;
                y[i] += self.lower[k] * x[j];
                if i != j {
                    y[j] += self.upper[k] * x[i];
                }
            }
        }
    }
}

/// Factor `P A Pᵀ = L U` of a sparse unsymmetric matrix with a symmetric pattern, by the
/// multifrontal method over the supernodes of [`Symbolic`].
///
/// Rows are eliminated in the given order, without pivoting: right for matrices that are
/// nearly symmetric and positive definite, as those of implicit flows. Solutions deserve
/// a look at the residual.
pub struct Lu {
    symbolic: Arc<Symbolic>,
    fronts: Vec<Front>,
    /// Pattern of every front, end to end: rows below its own.
    rows: Vec<u32>,
    /// Every front after its children.
    postorder: Vec<u32>,
    /// Most entries that wait for a parent at a time, and those of the largest front.
    most_waiting: usize,
    largest_front: usize,
    /// By front, L with U on and above the diagonal (own columns), then U to the right.
    factor: Vec<f64>,
    is_factored: bool,
}

/// A supernode: rows `begin..begin + width`, coupled to those in `below`.
struct Front {
    begin: usize,
    width: usize,
    below: Range<usize>,
    /// Where its part of the factor starts.
    offset: usize,
    n_children: usize,
}

impl Front {
    fn size(&self) -> usize {
        self.width + self.below.len()
    }
}

const NONE: u32 = u32::MAX;

impl Lu {
    /// Allocates a factor of that structure.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`].
    pub fn new(symbolic: Arc<Symbolic>) -> Result<Self, LinalgError> {
        let n = symbolic.n();
        let supernodes = &symbolic.supernodes;
        let count = supernodes.n_supernodes();
        let mut fronts: Vec<Front> = Vec::with_capacity(count);
        let mut rows: Vec<u32> = Vec::new();
        let mut front_of_row = vec![NONE; n];
        let mut offset = 0;
        for s in 0..count {
            let begin = supernodes.supernode_begin()[s] as usize;
            let end = supernodes.supernode_end()[s] as usize;
            front_of_row[begin..end].fill(s as u32);
            let start = rows.len();
            rows.extend(supernodes.supernode(s).pattern());
            let front = Front {
                begin,
                width: end - begin,
                below: start..rows.len(),
                offset,
                n_children: 0,
            };
            offset += front.width * (front.size() + front.below.len());
            fronts.push(front);
        }
        // The first row below a front belongs to its parent.
        let parents: Vec<u32> = fronts
            .iter()
            .map(|f| rows[f.below.clone()].iter().min().copied())
            .map(|row| row.map_or(NONE, |row| front_of_row[row as usize]))
            .collect();
        for &parent in parents.iter().filter(|&&p| p != NONE) {
            fronts[parent as usize].n_children += 1;
        }
        let mut factor = with_room(offset, n)?;
        fill(&mut factor, offset)?;
        let postorder = postorder(&parents);
        let (mut waiting, mut most_waiting) = (0, 0);
        let mut below = Vec::new();
        for &s in &postorder {
            let front = &fronts[s as usize];
            let children = below.len() - front.n_children;
            waiting -= below.drain(children..).sum::<usize>();
            if !front.below.is_empty() {
                let update = front.below.len().pow(2);
                below.push(update);
                waiting += update;
            }
            most_waiting = most_waiting.max(waiting);
        }
        Ok(Self {
            most_waiting,
            largest_front: fronts.iter().map(|f| f.size().pow(2)).max().unwrap_or(0),
            postorder,
            symbolic,
            fronts,
            rows,
            factor,
            is_factored: false,
        })
    }

    /// Number of entries stored for L and U, the zeros inside supernodes included.
    pub fn factor_len(&self) -> usize {
        self.factor.len()
    }

    /// Factors the matrix with these values.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`],
    /// [`LinalgError::OutOfMemory`], [`LinalgError::Interrupted`]; there is then no factor until a
    /// later call succeeds.
    ///
    /// # Panics
    /// If there are not two values a slot.
    pub fn factor(&mut self, values: &Unsymmetric) -> Result<(), LinalgError> {
        let symbolic = &*self.symbolic;
        assert_eq!(
            values.lower.len(),
            symbolic.slots.len(),
            "two values a slot"
        );
        assert_eq!(
            values.upper.len(),
            symbolic.slots.len(),
            "two values a slot"
        );
        self.is_factored = false;
        check(symbolic, values)?;
        let n = symbolic.n();
        // Place of a row in the present front.
        let mut place = vec![NONE; n];
        let mut matrix = with_room(self.largest_front, n)?;
        // What the fronts without a parent yet add to it; that of the last child is on top.
        let mut updates = with_room(self.most_waiting, n)?;
        let mut waiting: Vec<u32> = Vec::new();
        for &s in &self.postorder {
            interrupt::check()?;
            let front = &self.fronts[s as usize];
            let (size, width) = (front.size(), front.width);
            let below = &self.rows[front.below.clone()];
            matrix.clear();
            matrix.resize(size * size, 0.0);
            let own = front.begin as u32..(front.begin + width) as u32;
            for (k, row) in own.chain(below.iter().copied()).enumerate() {
                place[row as usize] = k as u32;
            }
            for k in 0..width {
                let column = front.begin + k;
                let j = symbolic.order[column];
                let entries = symbolic.column_starts[column] as usize
                    ..symbolic.column_starts[column + 1] as usize;
                for entry in entries {
                    let row = symbolic.rows[entry] as usize;
                    let slot = symbolic.slots[entry] as usize;
                    let (mut down, mut across) = (values.lower[slot], values.upper[slot]);
                    if symbolic.order[row] < j {
                        std::mem::swap(&mut down, &mut across);
                    }
                    let l = place[row] as usize;
                    matrix[k * size + l] = down;
                    if l != k {
                        matrix[l * size + k] = across;
                    }
                }
            }
            for _ in 0..front.n_children {
                let Some(child) = waiting.pop() else { break };
                let rows = &self.rows[self.fronts[child as usize].below.clone()];
                let rest = updates.len() - rows.len().pow(2);
                for (column, values) in rows.iter().zip(updates[rest..].chunks_exact(rows.len())) {
                    let column = &mut matrix[place[*column as usize] as usize * size..][..size];
                    for (row, value) in rows.iter().zip(values) {
                        column[place[*row as usize] as usize] += value;
                    }
                }
                updates.truncate(rest);
            }
            let eliminated = eliminate(&mut matrix, size, width);
            interrupt::check()?;
            eliminated.map_err(|k| LinalgError::ZeroPivot {
                row: symbolic.order[front.begin + k] as usize,
            })?;
            let (columns, rest) = self.factor[front.offset..].split_at_mut(width * size);
            columns.copy_from_slice(&matrix[..width * size]);
            for (column, part) in matrix[width * size..]
                .chunks_exact(size)
                .zip(rest.chunks_exact_mut(width))
            {
                part.copy_from_slice(&column[..width]);
                updates.extend_from_slice(&column[width..]);
            }
            if !below.is_empty() {
                waiting.push(s);
            }
        }
        self.is_factored = true;
        Ok(())
    }

    /// Replaces a right-hand side by the solution, or leaves it where the work is given up. O(entries
    /// of L and U).
    ///
    /// # Panics
    /// If there is no factor, or not one value a row.
    pub fn solve_in_place(&self, rhs: &mut [f64]) {
        let order = &self.symbolic.order;
        assert!(self.is_factored, "no factor to solve with");
        assert_eq!(rhs.len(), order.len(), "one value a row");
        let mut y: Vec<f64> = order.iter().map(|&i| rhs[i as usize]).collect();
        // What a front subtracts from the rows below its own.
        let mut sums = Vec::new();
        for (s, front) in self.fronts.iter().enumerate() {
            if s.is_multiple_of(FRONTS) && interrupt::check().is_err() {
                return;
            }
            let (size, width) = (front.size(), front.width);
            let below = &self.rows[front.below.clone()];
            let columns = self.factor[front.offset..].chunks_exact(size).take(width);
            let own = &mut y[front.begin..front.begin + width];
            sums.clear();
            sums.resize(below.len(), 0.0);
            for (k, column) in columns.enumerate() {
                let value = own[k];
                for (y, l) in own[k + 1..].iter_mut().zip(&column[k + 1..width]) {
                    *y -= l * value;
                }
                for (sum, l) in sums.iter_mut().zip(&column[width..]) {
                    *sum += l * value;
                }
            }
            for (&row, sum) in below.iter().zip(&sums) {
                y[row as usize] -= sum;
            }
        }
        for (s, front) in self.fronts.iter().enumerate().rev() {
            if s.is_multiple_of(FRONTS) && interrupt::check().is_err() {
                return;
            }
            let (size, width) = (front.size(), front.width);
            let (columns, rest) = self.factor[front.offset..].split_at(width * size);
            let below = &self.rows[front.below.clone()];
            for (&row, column) in below.iter().zip(rest.chunks_exact(width)) {
                let value = y[row as usize];
                let own = &mut y[front.begin..front.begin + width];
                for (y, u) in own.iter_mut().zip(column) {
                    *y -= u * value;
                }
            }
            for (k, column) in columns.chunks_exact(size).enumerate().rev() {
                let own = &mut y[front.begin..front.begin + width];
                own[k] /= column[k];
                let value = own[k];
                for (y, u) in own[..k].iter_mut().zip(column) {
                    *y -= u * value;
                }
            }
        }
        for (&i, y) in order.iter().zip(y) {
            rhs[i as usize] = y;
        }
    }
}

/// An empty list with room for so many numbers, or an error instead of the end of the
/// program.
fn with_room(len: usize, n: usize) -> Result<Vec<f64>, LinalgError> {
    let mut numbers = Vec::new();
    numbers
        .try_reserve_exact(len)
        .map_err(|_| LinalgError::OutOfMemory { n })?;
    Ok(numbers)
}

/// Every node after its children, those of a node in one run.
fn postorder(parents: &[u32]) -> Vec<u32> {
    let n = parents.len();
    let (mut first, mut next) = (vec![NONE; n + 1], vec![NONE; n]);
    for (child, &parent) in parents.iter().enumerate().rev() {
        let parent = if parent == NONE { n } else { parent as usize };
        next[child] = first[parent];
        first[parent] = child as u32;
    }
    let mut order = Vec::with_capacity(n);
    let mut stack = vec![n as u32];
    while let Some(&top) = stack.last() {
        let child = first[top as usize];
        if child == NONE {
            stack.pop();
            if (top as usize) < n {
                order.push(top);
            }
        } else {
            first[top as usize] = next[child as usize];
            stack.push(child);
        }
    }
    order
}

fn check(symbolic: &Symbolic, values: &Unsymmetric) -> Result<(), LinalgError> {
    let is_bad = |slot: u32| {
        let (l, u) = (values.lower[slot as usize], values.upper[slot as usize]);
        !(l.is_finite() && u.is_finite())
    };
    match symbolic.slots.iter().position(|&slot| is_bad(slot)) {
        None => Ok(()),
        Some(k) => {
            let starts = &symbolic.column_starts;
            let column = starts.partition_point(|&start| start as usize <= k) - 1;
            Err(LinalgError::NonFiniteEntry {
                column: symbolic.order[column] as usize,
            })
        }
    }
}

/// Eliminates the first `width` columns of a dense matrix stored by columns; the rest becomes
/// the Schur complement, unless the work is given up. Fails with the number of a pivot that is zero
/// or not finite.
fn eliminate(matrix: &mut [f64], size: usize, width: usize) -> Result<(), usize> {
    let mut begin = 0;
    while begin < width && interrupt::check().is_ok() {
        let end = (begin + BLOCK).min(width);
        for k in begin..end {
            let (left, right) = matrix.split_at_mut((k + 1) * size);
            let column = &mut left[k * size..];
            let pivot = column[k];
            if pivot == 0.0 || !pivot.is_finite() {
                return Err(k);
            }
            column[k + 1..end].iter_mut().for_each(|l| *l /= pivot);
            for later in right.chunks_exact_mut(size).take(end - k - 1) {
                let u = later[k];
                for (a, l) in later[k + 1..end].iter_mut().zip(&column[k + 1..end]) {
                    *a -= l * u;
                }
            }
        }
        if end < size {
            let whole = MatMut::from_column_major_slice_mut(matrix, size, size);
            let trailing = whole.submatrix_mut(begin, begin, size - begin, size - begin);
            let block = end - begin;
            let (diagonal, mut right, mut down, rest) = trailing.split_at_mut(block, block);
            let diagonal = diagonal.as_ref();
            solve_unit_lower_triangular_in_place(diagonal, right.rb_mut(), Par::Seq);
            let transposed = down.rb_mut().transpose_mut();
            solve_lower_triangular_in_place(diagonal.transpose(), transposed, Par::Seq);
            matmul(
                rest,
                Accum::Add,
                down.as_ref(),
                right.as_ref(),
                -1.0,
                Par::Seq,
            );
        }
        begin = end;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn noise(seed: &mut u64) -> f64 {
        *seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 33) as f64 / (1u64 << 30) as f64 - 1.0
    }

    /// Two-ring couplings on a square lattice, dominant diagonal, unsymmetric values.
    fn lattice(side: u32) -> (Pattern, Vec<DVec3>, Unsymmetric) {
        let at = |i: u32, j: u32| i * side + j;
        let mut cliques = Vec::new();
        for i in 0..side - 2 {
            for j in 0..side - 2 {
                cliques.push([0, 1, 2].map(|k| at(i + k, j)).to_vec());
                cliques.push([0, 1, 2].map(|k| at(i, j + k)).to_vec());
                cliques.push(vec![at(i, j), at(i + 1, j + 1), at(i + 1, j)]);
            }
        }
        let pattern = Pattern::from_cliques((side * side) as usize, cliques.iter());
        let mut values = Unsymmetric::zeros(&pattern);
        let mut seed = 7;
        for k in 0..pattern.nnz() {
            values.lower[k] = noise(&mut seed);
            values.upper[k] = noise(&mut seed);
        }
        for &slot in pattern.diagonal_slots() {
            values.lower[slot as usize] = 6.0;
        }
        let point = |k| DVec3::new(f64::from(k / side), f64::from(k % side), 0.0);
        (pattern, (0..side * side).map(point).collect(), values)
    }

    #[test]
    fn solutions_satisfy_the_unsymmetric_system() {
        for side in [4, 9, 40] {
            let (pattern, points, values) = lattice(side);
            let symbolic = Symbolic::analyse(&pattern, Some(&points)).expect("a structure");
            let mut lu = Lu::new(Arc::new(symbolic)).expect("room");
            lu.factor(&values).expect("a factor");
            let mut seed = 3;
            let x: Vec<f64> = (0..pattern.n()).map(|_| noise(&mut seed)).collect();
            let mut b = vec![0.0; x.len()];
            values.multiply(&pattern, &x, &mut b);
            lu.solve_in_place(&mut b);
            let error = x
                .iter()
                .zip(&b)
                .map(|(x, y)| (x - y).abs())
                .fold(0.0, f64::max);
            assert!(error < 1e-12, "side {side}: {error:.1e}");
        }
    }

    #[test]
    fn zero_pivots_and_entries_that_are_not_numbers_are_told() {
        let (pattern, points, mut values) = lattice(6);
        let symbolic = Arc::new(Symbolic::analyse(&pattern, Some(&points)).expect("a structure"));
        let mut lu = Lu::new(symbolic).expect("room");
        values.upper[3] = f64::NAN;
        let refused = lu.factor(&values);
        assert!(matches!(refused, Err(LinalgError::NonFiniteEntry { .. })));
        values.lower.fill(0.0);
        values.upper.fill(0.0);
        assert!(matches!(
            lu.factor(&values),
            Err(LinalgError::ZeroPivot { .. })
        ));
    }
}
