//! The matrix of a coarser level, PᵀAP, into places that are found once.

use super::rows::Rows;
use crate::interrupt;

const NONE: u32 = u32::MAX;

/// What the triple product with one prolongation keeps from matrix to matrix.
pub(super) struct Galerkin {
    /// Pᵀ.
    restriction: Rows,
    /// AP.
    image: Rows,
    /// Where each column of the row being written is; for as many columns as a matrix has.
    places: Vec<u32>,
}

impl Galerkin {
    /// Of the structures of A and P; also answers that of PᵀAP.
    pub(super) fn new(a: &Rows, p: &Rows) -> (Self, Rows) {
        let mut places = vec![NONE; p.n_columns];
        let restriction = p.transposed();
        let image = structure(a, p, &mut places);
        let coarse = structure(&restriction, &image, &mut places);
        let this = Self {
            restriction,
            image,
            places,
        };
        (this, coarse)
    }

    /// Writes PᵀAP.
    pub(super) fn update(&mut self, a: &Rows, p: &Rows, coarse: &mut Rows) {
        multiply(a, p, &mut self.image, &mut self.places);
        multiply(&self.restriction, &self.image, coarse, &mut self.places);
    }

    /// Multiplications of an update.
    pub(super) fn operations(&self, a: &Rows, p: &Rows) -> usize {
        let of = |a: &Rows, b: &Rows| -> usize {
            let columns = a.columns.iter();
            columns.map(|&k| b.row(k as usize).len()).sum()
        };
        of(a, p) + of(&self.restriction, &self.image)
    }
}

/// Rows between two looks at whether to go on.
const ROWS: usize = 1024;

/// Where A B may be non-zero; nowhere from where the work is given up.
fn structure(a: &Rows, b: &Rows, places: &mut [u32]) -> Rows {
    places.fill(NONE);
    let mut product = Rows::empty(b.n_columns);
    let mut goes_on = true;
    for i in 0..a.n() {
        if i.is_multiple_of(ROWS) {
            goes_on = interrupt::check().is_ok();
        }
        if !goes_on {
            product.end_row();
            continue;
        }
        let start = product.len();
        for &k in &a.columns[a.row(i)] {
            for &j in &b.columns[b.row(k as usize)] {
                if std::mem::replace(&mut places[j as usize], i as u32) != i as u32 {
                    product.columns.push(j);
                }
            }
        }
        product.columns[start..].sort_unstable();
        product.end_row();
    }
    product.values.resize(product.len(), 0.0);
    product.columns.shrink_to_fit();
    product
}

/// Writes A B, or some of it where the work is given up.
fn multiply(a: &Rows, b: &Rows, product: &mut Rows, places: &mut [u32]) {
    product.values.fill(0.0);
    for i in 0..a.n() {
        if i.is_multiple_of(ROWS) && interrupt::check().is_err() {
            return;
        }
        let row = product.row(i);
        for (at, &j) in row.clone().zip(&product.columns[row]) {
            places[j as usize] = at as u32;
        }
        for (k, factor) in a.entries(a.row(i)) {
            for (j, value) in b.entries(b.row(k)) {
                product.values[places[j] as usize] += factor * value;
            }
        }
    }
}
