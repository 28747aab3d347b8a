//! Sparse matrices in single precision, by rows.

use crate::linalg::Pattern;
use std::ops::Range;

/// A sparse matrix with the entries of each row in ascending order of their columns.
#[derive(Default)]
pub(super) struct Rows {
    pub(super) starts: Vec<u32>,
    pub(super) columns: Vec<u32>,
    pub(super) values: Vec<f32>,
    pub(super) n_columns: usize,
}

impl Rows {
    /// No rows yet; [`end_row`](Self::end_row) adds them.
    pub(super) fn empty(n_columns: usize) -> Self {
        Self {
            starts: vec![0],
            n_columns,
            ..Self::default()
        }
    }

    /// All entries of a symmetric pattern, both triangles, with the value zero.
    pub(super) fn of_pattern(pattern: &Pattern) -> Self {
        let mut rows = Self {
            starts: vec![0; pattern.n() + 1],
            n_columns: pattern.n(),
            ..Self::default()
        };
        for_each_entry(pattern, |i, _, _| rows.starts[i + 1] += 1);
        rows.add_up();
        let mut next = rows.starts.clone();
        rows.columns.resize(rows.len_in_starts(), 0);
        rows.values.resize(rows.columns.len(), 0.0);
        for_each_entry(pattern, |i, j, _| {
            rows.columns[next[i] as usize] = j as u32;
            next[i] += 1;
        });
        rows
    }

    /// Takes the values of a pattern's slots, each times `scale`.
    pub(super) fn take(&mut self, pattern: &Pattern, values: &[f64], scale: f64) {
        let mut next = self.starts.clone();
        for_each_entry(pattern, |i, _, slot| {
            self.values[next[i] as usize] = (values[slot] * scale) as f32;
            next[i] += 1;
        });
    }

    pub(super) fn n(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of entries.
    pub(super) fn len(&self) -> usize {
        self.columns.len()
    }

    /// Where the entries of row `i` are.
    // Two loads in the innermost loops: a call costs more, and code for size makes one.
    #[inline(always)]
    pub(super) fn row(&self, i: usize) -> Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    /// Columns and values of the entries in that range.
    #[inline(always)]
    pub(super) fn entries(&self, range: Range<usize>) -> impl Iterator<Item = (usize, f32)> {
        let columns = self.columns[range.clone()].iter().map(|&j| j as usize);
        columns.zip(self.values[range].iter().copied())
    }

    /// Adds an entry to the row that is being written.
    pub(super) fn push(&mut self, column: u32, value: f32) {
        self.columns.push(column);
        self.values.push(value);
    }

    /// Ends that row.
    pub(super) fn end_row(&mut self) {
        self.starts.push(self.columns.len() as u32);
    }

    pub(super) fn transposed(&self) -> Self {
        let mut result = Self {
            starts: vec![0; self.n_columns + 1],
            columns: vec![0; self.len()],
            values: vec![0.0; self.len()],
            n_columns: self.n(),
        };
        for &j in &self.columns {
            result.starts[j as usize + 1] += 1;
        }
        result.add_up();
        let mut next = result.starts.clone();
        for i in 0..self.n() {
            for (j, value) in self.entries(self.row(i)) {
                let at = next[j] as usize;
                (result.columns[at], result.values[at]) = (i as u32, value);
                next[j] += 1;
            }
        }
        result
    }

    /// Turns numbers of entries, each one place after its row, into starts.
    fn add_up(&mut self) {
        let mut total = 0;
        for start in &mut self.starts {
            total += *start;
            *start = total;
        }
    }

    fn len_in_starts(&self) -> usize {
        self.starts.last().map_or(0, |&end| end as usize)
    }
}

/// Calls `visit(row, column, slot)` for every entry of both triangles; those of a row come in
/// ascending order of their columns.
fn for_each_entry(pattern: &Pattern, mut visit: impl FnMut(usize, usize, usize)) {
    for j in 0..pattern.n() {
        for slot in pattern.column(j) {
            let i = pattern.rows()[slot] as usize;
            visit(j, i, slot);
            if i != j {
                visit(i, j, slot);
            }
        }
    }
}
