//! Elimination by `L D Lᵀ` and solving with it, supernode by supernode.
//!
//! Left-looking: a supernode takes what all those before do to it, and is then eliminated. faer
//! does the same in one call, which on large meshes takes seconds; here a look at whether it is
//! to go on comes between any two products of a few milliseconds. The products are faer's.

use super::error::LinalgError;
use super::symbolic::Symbolic;
use crate::interrupt;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_unit_lower_triangular_in_place, solve_unit_upper_triangular_in_place,
};
use faer::prelude::ReborrowMut as _;
use faer::{Accum, MatMut, MatRef, Par};

/// Columns of a supernode eliminated together.
const PANEL: usize = 64;
/// Columns of a product.
const CHUNK: usize = 64;
const NONE: u32 = u32::MAX;

/// Numbers that an elimination writes to beside the factor.
pub(super) fn work_len(symbolic: &Symbolic) -> usize {
    let starts = symbolic.supernodes.supernode_begin().iter();
    let ends = symbolic.supernodes.supernode_end().iter();
    let sizes = starts.zip(ends).enumerate().map(|(s, (begin, end))| {
        let width = (end - begin) as usize;
        2 * width + symbolic.supernodes.supernode(s).pattern().len()
    });
    CHUNK * sizes.max().unwrap_or(0).max(PANEL)
}

/// What waits to be done to later supernodes: a list for each, of those that are eliminated.
struct Waiting {
    first: Vec<u32>,
    next: Vec<u32>,
    /// Number of the row below its own that each comes to next.
    at: Vec<u32>,
    /// Supernode of each row.
    owner: Vec<u32>,
}

impl Waiting {
    fn new(symbolic: &Symbolic) -> Self {
        let supernodes = &symbolic.supernodes;
        let count = supernodes.n_supernodes();
        let mut owner = vec![NONE; symbolic.n()];
        for s in 0..count {
            let (begin, end) = (
                supernodes.supernode_begin()[s],
                supernodes.supernode_end()[s],
            );
            owner[begin as usize..end as usize].fill(s as u32);
        }
        Self {
            first: vec![NONE; count],
            next: vec![NONE; count],
            at: vec![0; count],
            owner,
        }
    }

    /// Puts a supernode to whom it comes next, if there is one.
    fn put(&mut self, s: usize, below: &[u32]) {
        if let Some(&row) = below.get(self.at[s] as usize) {
            let target = self.owner[row as usize] as usize;
            self.next[s] = std::mem::replace(&mut self.first[target], s as u32);
        }
    }
}

/// Eliminates the matrix with these entries, in the order of the structure's own, into `factor`.
///
/// # Errors
/// [`LinalgError::ZeroPivot`], [`LinalgError::Interrupted`].
pub(super) fn eliminate(
    symbolic: &Symbolic,
    matrix: &[f64],
    factor: &mut [f64],
    work: &mut [f64],
) -> Result<(), LinalgError> {
    let supernodes = &symbolic.supernodes;
    let offsets = supernodes.col_ptr_for_val();
    let mut waiting = Waiting::new(symbolic);
    // Row of the present supernode that a row of the matrix is.
    let mut place = vec![NONE; symbolic.n()];
    for (s, &offset) in offsets.iter().take(supernodes.n_supernodes()).enumerate() {
        let begin = supernodes.supernode_begin()[s] as usize;
        let end = supernodes.supernode_end()[s] as usize;
        let below = supernodes.supernode(s).pattern();
        let (width, size) = (end - begin, end - begin + below.len());
        let (before, rest) = factor.split_at_mut(offset as usize);
        let block = &mut rest[..width * size];
        block.fill(0.0);
        let own = begin as u32..end as u32;
        for (k, row) in own.chain(below.iter().copied()).enumerate() {
            place[row as usize] = k as u32;
        }
        for (k, column) in (begin..end).enumerate() {
            let entries = symbolic.column_starts[column]..symbolic.column_starts[column + 1];
            for entry in entries.start as usize..entries.end as usize {
                let row = place[symbolic.rows[entry] as usize] as usize;
                block[k * size + row] = matrix[entry];
            }
        }
        let mut next = std::mem::replace(&mut waiting.first[s], NONE);
        while next != NONE {
            let d = next as usize;
            next = waiting.next[d];
            let done = Factored::of(symbolic, before, d);
            let from = waiting.at[d] as usize;
            let rows = done.below[from..].partition_point(|&row| (row as usize) < end);
            done.subtract(from, rows, &place, block, size, work)?;
            waiting.at[d] += rows as u32;
            waiting.put(d, done.below);
        }
        eliminate_block(block, size, width, work)?.map_or(Ok(()), |k| {
            Err(LinalgError::ZeroPivot {
                row: symbolic.order[begin + k] as usize,
            })
        })?;
        waiting.put(s, below);
    }
    Ok(())
}

/// Eliminates the columns of a dense block, whose lower part is there; answers the number of a
/// pivot that is zero or not finite.
fn eliminate_block(
    block: &mut [f64],
    size: usize,
    width: usize,
    work: &mut [f64],
) -> Result<Option<usize>, LinalgError> {
    for begin in (0..width).step_by(PANEL) {
        let end = (begin + PANEL).min(width);
        let (panel, later) = block[begin * size..].split_at_mut((end - begin) * size);
        if let Some(k) = eliminate_panel(panel, size, begin) {
            return Ok(Some(begin + k));
        }
        let columns = end - begin;
        if end == size {
            continue;
        }
        let whole = MatMut::from_column_major_slice_mut(panel, size, columns);
        let (upper, down) = whole.split_at_row_mut(end);
        let diagonal = upper.as_ref().submatrix(begin, 0, columns, columns);
        // L D below the panel.
        solve_unit_lower_triangular_in_place(diagonal, down.transpose_mut(), Par::Seq);
        for first in (end..width).step_by(CHUNK) {
            interrupt::check()?;
            let count = CHUNK.min(width - first);
            let right = &mut work[..columns * count];
            for (k, column) in panel.chunks_exact(size).enumerate() {
                let pivot = column[begin + k];
                for (j, value) in column[first..first + count].iter().enumerate() {
                    right[j * columns + k] = value / pivot;
                }
            }
            let left = MatRef::from_column_major_slice(panel, size, columns);
            let target = &mut later[(first - end) * size..][..count * size];
            matmul(
                MatMut::from_column_major_slice_mut(target, size, count).submatrix_mut(
                    first,
                    0,
                    size - first,
                    count,
                ),
                Accum::Add,
                left.submatrix(first, 0, size - first, columns),
                MatRef::from_column_major_slice(right, columns, count),
                -1.0,
                Par::Seq,
            );
        }
        for (k, column) in panel.chunks_exact_mut(size).enumerate() {
            let pivot = column[begin + k];
            column[end..].iter_mut().for_each(|value| *value /= pivot);
        }
    }
    Ok(None)
}

/// Eliminates the square at the top of a panel, whose first row is `begin`.
fn eliminate_panel(panel: &mut [f64], size: usize, begin: usize) -> Option<usize> {
    let end = begin + panel.len() / size;
    for k in 0..end - begin {
        let (left, right) = panel.split_at_mut((k + 1) * size);
        let column = &mut left[k * size..][begin..end];
        let pivot = column[k];
        if pivot == 0.0 || !pivot.is_finite() {
            return Some(k);
        }
        for (j, later) in (k + 1..).zip(right.chunks_exact_mut(size)) {
            let u = column[j] / pivot;
            let later = &mut later[begin + j..end];
            for (value, l) in later.iter_mut().zip(&column[j..]) {
                *value -= l * u;
            }
        }
        column[k + 1..].iter_mut().for_each(|l| *l /= pivot);
    }
    None
}

/// Solves with a factor for columns end to end, in the order of elimination; leaves anything in
/// them where the work is given up.
pub(super) fn solve(symbolic: &Symbolic, factor: &[f64], columns: &mut [f64], work: &mut [f64]) {
    let n = symbolic.n().max(1);
    for some in columns.chunks_mut(CHUNK * n) {
        let count = symbolic.supernodes.n_supernodes();
        for s in 0..count {
            if interrupt::check().is_err() {
                return;
            }
            Factored::of(symbolic, factor, s).forward(some, n, work);
        }
        for s in (0..count).rev() {
            if interrupt::check().is_err() {
                return;
            }
            Factored::of(symbolic, factor, s).backward(some, n, work);
        }
    }
}

/// D of a factor.
pub(super) fn pivots<'a>(
    symbolic: &'a Symbolic,
    factor: &'a [f64],
) -> impl Iterator<Item = f64> + 'a {
    let blocks = (0..symbolic.supernodes.n_supernodes()).map(|s| Factored::of(symbolic, factor, s));
    blocks.flat_map(|block| (0..block.width).map(move |k| block.pivot(k)))
}

/// A supernode of a factor: L below the diagonal, D on it.
struct Factored<'a> {
    block: &'a [f64],
    begin: usize,
    width: usize,
    /// Rows below its own.
    below: &'a [u32],
}

impl<'a> Factored<'a> {
    fn of(symbolic: &'a Symbolic, factor: &'a [f64], s: usize) -> Self {
        let supernodes = &symbolic.supernodes;
        let offsets = supernodes.col_ptr_for_val();
        let begin = supernodes.supernode_begin()[s] as usize;
        Self {
            block: &factor[offsets[s] as usize..offsets[s + 1] as usize],
            begin,
            width: supernodes.supernode_end()[s] as usize - begin,
            below: supernodes.supernode(s).pattern(),
        }
    }

    /// The square on the diagonal, and what is below.
    fn parts(&self) -> (MatRef<'a, f64>, MatRef<'a, f64>) {
        let size = self.width + self.below.len();
        MatRef::from_column_major_slice(self.block, size, self.width).split_at_row(self.width)
    }

    fn pivot(&self, k: usize) -> f64 {
        self.block[k * (self.width + self.below.len()) + k]
    }

    /// Subtracts L D Lᵀ of the rows `from` on from a later block, whose columns the first `rows` of
    /// them are.
    fn subtract(
        &self,
        from: usize,
        rows: usize,
        place: &[u32],
        block: &mut [f64],
        size: usize,
        work: &mut [f64],
    ) -> Result<(), LinalgError> {
        let own_size = self.width + self.below.len();
        let l = MatRef::from_column_major_slice(self.block, own_size, self.width);
        for begin in (0..rows).step_by(CHUNK) {
            interrupt::check()?;
            let columns = CHUNK.min(rows - begin);
            let top = self.width + from + begin;
            let below = &self.below[from + begin..];
            let (right, product) = work.split_at_mut(self.width * columns);
            for (k, column) in self.block.chunks_exact(own_size).enumerate() {
                let pivot = column[k];
                for (j, l) in column[top..top + columns].iter().enumerate() {
                    right[j * self.width + k] = pivot * l;
                }
            }
            let product = &mut product[..below.len() * columns];
            matmul(
                MatMut::from_column_major_slice_mut(product, below.len(), columns),
                Accum::Replace,
                l.submatrix(top, 0, below.len(), self.width),
                MatRef::from_column_major_slice(right, self.width, columns),
                1.0,
                Par::Seq,
            );
            for (j, values) in product.chunks_exact(below.len()).enumerate() {
                let column = &mut block[place[below[j] as usize] as usize * size..][..size];
                for (&row, value) in below[j..].iter().zip(&values[j..]) {
                    column[place[row as usize] as usize] -= value;
                }
            }
        }
        Ok(())
    }

    /// L y = b, of what stands before it done, and y = D⁻¹ y.
    fn forward(&self, columns: &mut [f64], n: usize, work: &mut [f64]) {
        let count = columns.len() / n;
        let (diagonal, down) = self.parts();
        let mut all = MatMut::from_column_major_slice_mut(columns, n, count);
        let mut own = all.rb_mut().submatrix_mut(self.begin, 0, self.width, count);
        solve_unit_lower_triangular_in_place(diagonal, own.rb_mut(), Par::Seq);
        let product = &mut work[..self.below.len() * count];
        matmul(
            MatMut::from_column_major_slice_mut(product, self.below.len(), count),
            Accum::Replace,
            down,
            own.as_ref(),
            1.0,
            Par::Seq,
        );
        for (c, column) in columns.chunks_exact_mut(n).enumerate() {
            let values = &product[c * self.below.len()..];
            for (&row, value) in self.below.iter().zip(values) {
                column[row as usize] -= value;
            }
            for (k, value) in column[self.begin..].iter_mut().take(self.width).enumerate() {
                *value /= self.pivot(k);
            }
        }
    }

    /// Lᵀ x = y, of what stands after it done.
    fn backward(&self, columns: &mut [f64], n: usize, work: &mut [f64]) {
        let count = columns.len() / n;
        let (diagonal, down) = self.parts();
        let later = &mut work[..self.below.len() * count];
        for (c, column) in columns.chunks_exact(n).enumerate() {
            let values = &mut later[c * self.below.len()..];
            for (&row, value) in self.below.iter().zip(values) {
                *value = column[row as usize];
            }
        }
        let all = MatMut::from_column_major_slice_mut(columns, n, count);
        let mut own = all.submatrix_mut(self.begin, 0, self.width, count);
        matmul(
            own.rb_mut(),
            Accum::Add,
            down.transpose(),
            MatRef::from_column_major_slice(later, self.below.len(), count),
            -1.0,
            Par::Seq,
        );
        solve_unit_upper_triangular_in_place(diagonal.transpose(), own, Par::Seq);
    }
}
