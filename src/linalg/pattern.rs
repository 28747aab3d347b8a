//! Where a symmetric sparse matrix may be non-zero.

use super::entry::Entry;
use crate::interrupt;
use std::ops::Range;

/// Sparsity pattern of a symmetric matrix: its lower triangle by columns.
///
/// Rows ascend within a column and the diagonal entry is always present, so it comes
/// first. Values live apart, in a plain slice of [`nnz`](Self::nnz) numbers; the
/// position of an entry in it is its *slot*. Built once per connectivity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    column_starts: Vec<u32>,
    rows: Vec<u32>,
}

impl Pattern {
    /// Pattern of `n` rows in which every clique couples all its members.
    ///
    /// The cliques are the stencils that will be added up: the two triangles about an
    /// edge, the triangle, the 1-ring. A vertex may repeat in one. The iterator is
    /// walked twice. O(Σ k²) for cliques of k members.
    ///
    /// # Panics
    /// If a member is not below `n`.
    pub fn from_cliques<C: AsRef<[u32]>>(
        n: usize,
        cliques: impl Iterator<Item = C> + Clone,
    ) -> Self {
        let mut starts = vec![1_usize; n + 1];
        for_each_pair(cliques.clone(), |column, _| starts[column as usize] += 1);
        let mut total = 0;
        for start in &mut starts {
            total += std::mem::replace(start, total);
        }

        interrupt::pulse();
        let mut next = starts.clone();
        let mut rows = vec![0; starts[n]];
        let mut push = |column: u32, row: u32| {
            rows[next[column as usize]] = row;
            next[column as usize] += 1;
        };
        (0..n as u32).for_each(|i| push(i, i));
        for_each_pair(cliques, push);

        interrupt::pulse();
        // Sorts each column and moves it, without repetitions, onto the end of the last.
        let mut column_starts = Vec::with_capacity(n + 1);
        let mut end = 0;
        for j in 0..n {
            column_starts.push(end as u32);
            let (from, to) = (starts[j], starts[j + 1]);
            rows[from..to].sort_unstable();
            for k in from..to {
                if k == from || rows[k] != rows[k - 1] {
                    rows[end] = rows[k];
                    end += 1;
                }
            }
        }
        column_starts.push(end as u32);
        rows.truncate(end);
        rows.shrink_to_fit();
        Self {
            column_starts,
            rows,
        }
    }

    /// Number of rows.
    pub fn n(&self) -> usize {
        self.column_starts.len() - 1
    }

    /// Number of entries of the lower triangle, diagonal included.
    pub fn nnz(&self) -> usize {
        self.rows.len()
    }

    /// Slot of the entry (i, j), which is that of (j, i), or `None` if it is not in the
    /// pattern. O(log of the column's length).
    pub fn find(&self, i: u32, j: u32) -> Option<usize> {
        let (row, column) = (i.max(j), i.min(j));
        let range = self.column(column as usize);
        let k = self.rows[range.clone()].binary_search(&row).ok()?;
        Some(range.start + k)
    }

    /// Slot of an entry that is in the pattern, as [`find`](Self::find).
    ///
    /// # Panics
    /// If the entry is not in the pattern.
    pub fn slot(&self, i: u32, j: u32) -> usize {
        let Some(slot) = self.find(i, j) else {
            panic!("entry ({i}, {j}) is not in the pattern");
        };
        slot
    }

    /// Slots of the diagonal, one a row.
    pub fn diagonal_slots(&self) -> &[u32] {
        &self.column_starts[..self.n()]
    }

    /// Slots of column `j` of the lower triangle.
    pub fn column(&self, j: usize) -> Range<usize> {
        self.column_starts[j] as usize..self.column_starts[j + 1] as usize
    }

    /// Row of each slot.
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// `y = A x` for one or more fields stored end to end; one pass over the matrix a field. Fields of
    /// zeros where the work is given up.
    ///
    /// # Panics
    /// If `values` has not [`nnz`](Self::nnz) entries, or `x` and `y` are not whole
    /// fields of the same number.
    pub fn multiply<T: Entry>(&self, values: &[f64], x: &[T], y: &mut [T]) {
        let n = self.n();
        assert_eq!(values.len(), self.nnz(), "one value a slot");
        assert!(
            x.len() == y.len() && x.len().is_multiple_of(n.max(1)),
            "whole fields"
        );
        y.fill(T::ZERO);
        if n == 0 {
            return;
        }
        for (x, y) in x.chunks_exact(n).zip(y.chunks_exact_mut(n)) {
            if interrupt::check().is_err() {
                return;
            }
            for j in 0..n {
                let range = self.column(j);
                let (rows, values) = (&self.rows[range.clone()], &values[range]);
                let x_j = x[j];
                let mut y_j = x_j * values[0];
                for (&i, &a) in rows[1..].iter().zip(&values[1..]) {
                    y[i as usize] += x_j * a;
                    y_j += x[i as usize] * a;
                }
                y[j] += y_j;
            }
        }
    }
}

/// Calls `visit(column, row)` with column < row for every pair of members of a clique.
fn for_each_pair<C: AsRef<[u32]>>(
    cliques: impl Iterator<Item = C>,
    mut visit: impl FnMut(u32, u32),
) {
    for clique in cliques {
        let clique = clique.as_ref();
        for (k, &i) in clique.iter().enumerate() {
            for &j in &clique[..k] {
                if i != j {
                    visit(i.min(j), i.max(j));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn cliques_couple_their_members_and_nothing_else() {
        let cliques: [&[u32]; 4] = [&[0, 1, 2], &[2, 3], &[1, 2], &[4, 4]];
        let pattern = Pattern::from_cliques(6, cliques.iter());
        assert_eq!(pattern.n(), 6);
        assert_eq!(pattern.rows(), [0, 1, 2, 1, 2, 2, 3, 3, 4, 5]);
        assert_eq!(pattern.diagonal_slots(), [0, 3, 5, 7, 8, 9]);
        assert_eq!(pattern.slot(0, 2), 2);
        assert_eq!(pattern.slot(2, 0), 2);
        assert_eq!(pattern.slot(3, 2), 6);
    }

    #[test]
    #[should_panic(expected = "entry (3, 0) is not in the pattern")]
    fn a_slot_outside_the_pattern_is_refused() {
        Pattern::from_cliques(4, [[0, 1], [2, 3]].iter()).slot(3, 0);
    }

    #[test]
    fn an_empty_pattern_has_no_entries() {
        let pattern = Pattern::from_cliques(0, std::iter::empty::<[u32; 2]>());
        assert_eq!((pattern.n(), pattern.nnz()), (0, 0));
        pattern.multiply::<f64>(&[], &[], &mut []);
    }

    #[test]
    fn product_of_two_fields_is_that_of_the_full_matrix() {
        // [2 1 0; 1 3 -1; 0 -1 4]
        let pattern = Pattern::from_cliques(3, [[0, 1], [1, 2]].iter());
        let values = [2.0, 1.0, 3.0, -1.0, 4.0];
        let x = [1.0, 2.0, 3.0, -1.0, 0.5, 0.0].map(|c| c * DVec3::new(1.0, -2.0, 0.0));
        let mut y = [DVec3::NAN; 6];
        pattern.multiply(&values, &x, &mut y);
        let expected = [4.0, 4.0, 10.0, -1.5, 0.5, -0.5].map(|c| c * DVec3::new(1.0, -2.0, 0.0));
        assert_eq!(y, expected);
    }
}
