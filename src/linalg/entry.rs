//! What a field holds at each row.

use faer::MatMut;
use glam::DVec3;
use std::ops::{AddAssign, Mul, Sub, SubAssign};

/// A number a row, or a vector of three for three columns at once.
pub trait Entry:
    Copy + PartialEq + AddAssign + SubAssign + Sub<Output = Self> + Mul<f64, Output = Self>
{
    /// Zero.
    const ZERO: Self;
    /// Number of columns a field stands for.
    const COLUMNS: usize;

    /// ⟨self, other⟩.
    fn dot(self, other: Self) -> f64;
    /// Whether every component is finite.
    fn is_finite(self) -> bool;
    /// Writes into one row of columns.
    fn scatter(self, columns: &mut MatMut<'_, f64>, row: usize);
    /// Reads one row of columns.
    fn gather(columns: &MatMut<'_, f64>, row: usize) -> Self;
}

impl Entry for f64 {
    const ZERO: Self = 0.0;
    const COLUMNS: usize = 1;

    fn dot(self, other: Self) -> f64 {
        self * other
    }

    fn is_finite(self) -> bool {
        f64::is_finite(self)
    }

    fn scatter(self, columns: &mut MatMut<'_, f64>, row: usize) {
        columns[(row, 0)] = self;
    }

    fn gather(columns: &MatMut<'_, f64>, row: usize) -> Self {
        columns[(row, 0)]
    }
}

impl Entry for DVec3 {
    const ZERO: Self = DVec3::ZERO;
    const COLUMNS: usize = 3;

    fn dot(self, other: Self) -> f64 {
        DVec3::dot(self, other)
    }

    fn is_finite(self) -> bool {
        DVec3::is_finite(self)
    }

    fn scatter(self, columns: &mut MatMut<'_, f64>, row: usize) {
        columns[(row, 0)] = self.x;
        columns[(row, 1)] = self.y;
        columns[(row, 2)] = self.z;
    }

    fn gather(columns: &MatMut<'_, f64>, row: usize) -> Self {
        DVec3::new(columns[(row, 0)], columns[(row, 1)], columns[(row, 2)])
    }
}
