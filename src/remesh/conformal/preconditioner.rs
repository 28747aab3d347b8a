//! The preconditioner of a regularising pass: one scalar matrix for what slides along the
//! surface, whose factor is that of the connectivity, and the diagonal for what is held.

use crate::interrupt;
use crate::linalg::{Ldlt, LinalgError, Pattern, Symbolic};
use glam::DVec3;
use std::sync::Arc;

/// Share of the mean diagonal that is added to the scalar matrix, in whose kernel the
/// constants are.
const SHIFT: f64 = 1e-3;

/// P⁻¹ r = Π (2L + δI)⁻¹ Π r + n (n·r)/(nᵀ K_ii n), vertex by vertex, with Π = I − n nᵀ.
///
/// L has the entries tr(K_ij)/5 = Σ a_ij: as tr(2I − n nᵀ) = 5 and tr(n×) = 0 they are the
/// couplings of the reference shapes, which no position changes.
pub(super) struct Preconditioner {
    pattern: Pattern,
    values: Vec<f64>,
    factor: Ldlt,
    /// Whether the factor is that of a damped matrix.
    is_damped: bool,
    field: Vec<DVec3>,
}

impl Preconditioner {
    /// Of couplings a_ij between pairs of vertices; `x` helps to order the elimination.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`], [`LinalgError::ZeroPivot`].
    pub(super) fn new(
        pattern: Pattern,
        couplings: impl Iterator<Item = ([u32; 2], f64)>,
        x: &[DVec3],
    ) -> Result<Self, LinalgError> {
        let mut values = vec![0.0; pattern.nnz()];
        let diagonal = pattern.diagonal_slots();
        for ([i, j], a) in couplings {
            values[pattern.slot(i, j)] += 2.0 * a;
            values[diagonal[i as usize] as usize] -= 2.0 * a;
            values[diagonal[j as usize] as usize] -= 2.0 * a;
        }
        let trace: f64 = diagonal.iter().map(|&slot| values[slot as usize]).sum();
        let shift = SHIFT * trace / pattern.n() as f64;
        for &slot in diagonal {
            values[slot as usize] += shift;
        }
        interrupt::check()?;
        let symbolic = Symbolic::analyse(&pattern, Some(x))?;
        interrupt::check()?;
        let mut factor = Ldlt::new(Arc::new(symbolic))?;
        factor.reserve_columns(3)?;
        factor.factor(&values)?;
        Ok(Self {
            field: vec![DVec3::ZERO; pattern.n()],
            pattern,
            values,
            factor,
            is_damped: false,
        })
    }

    /// Makes ready for a matrix whose diagonal is greater by these factors, or by none.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`].
    pub(super) fn damp(&mut self, factors: Option<&[f64]>) -> Result<(), LinalgError> {
        match factors {
            Some(factors) => {
                let mut values = self.values.clone();
                for (&slot, factor) in self.pattern.diagonal_slots().iter().zip(factors) {
                    values[slot as usize] *= factor;
                }
                self.factor.factor(&values)?;
            }
            None if self.is_damped => {
                self.factor.factor(&self.values)?;
            }
            None => {}
        }
        self.is_damped = factors.is_some();
        Ok(())
    }

    /// Replaces r by P⁻¹ r, for these normals and the numbers nᵀ K_ii n.
    pub(super) fn apply(&mut self, r: &mut [f64], normals: &[DVec3], stiffness: &[f64]) {
        let vertices = || r.chunks_exact(3).map(DVec3::from_slice).zip(normals);
        for (field, (r, &n)) in self.field.iter_mut().zip(vertices()) {
            *field = r - n * n.dot(r);
        }
        self.factor.solve_in_place(&mut self.field);
        let all = self.field.iter().zip(normals).zip(stiffness);
        for (r, ((slid, &n), stiffness)) in r.chunks_exact_mut(3).zip(all) {
            let held = n.dot(DVec3::from_slice(r));
            let held = if held == 0.0 { 0.0 } else { held / stiffness };
            (*slid + n * (held - n.dot(*slid))).write_to_slice(r);
        }
    }
}
