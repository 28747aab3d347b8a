//! One weighted least-squares fit of a quadratic through its centre.

use glam::{DVec2, DVec3};
use std::cmp::Ordering;
use std::f64::consts::FRAC_1_SQRT_2;

/// Derivatives fitted: f_u, f_v, f_uu, f_uv, f_vv.
const N: usize = 5;
/// Column of uv.
const UV: usize = 3;

/// A column with less than this share of all columns outside the span of those before it
/// lies in that span: the neighbours are in special position.
const RANK: f64 = 1e-9;

/// Weights that give the five derivatives from differences f_j − f_i.
#[derive(Clone, Debug, Default)]
pub(super) struct Fit {
    rows: Vec<[f64; N]>,
    triangle: [[f64; N]; N],
}

impl Fit {
    /// Fits to neighbours at `parameters`, each with the weight 1/d^`power`, d its distance.
    /// `None` if they do not determine a quadratic.
    ///
    /// By Gram–Schmidt with a second pass: as orthogonal as Householder's reflections on
    /// the few well-scaled columns there are, and without a singular value decomposition a
    /// vertex.
    pub(super) fn compute(&mut self, parameters: &[DVec2], power: i32) -> Option<()> {
        if parameters.len() < N {
            return None;
        }
        let distance = |p: &DVec2| p.length();
        let h = parameters.iter().map(distance).sum::<f64>() / parameters.len() as f64;
        // Scaled by h: the condition does not depend on the unit.
        let weight = |p: &DVec2| (h / p.length()).powi(power);
        self.rows.clear();
        self.rows.extend(parameters.iter().map(|p| {
            let (u, v) = (p.x / h, p.y / h);
            let row = [u, v, 0.5 * u * u, u * v, 0.5 * v * v];
            row.map(|c| c * weight(p))
        }));
        self.triangle = [[0.0; N]; N];
        let size = (0..N).map(|k| self.column_norm(k)).fold(0.0, f64::max);
        for k in 0..N {
            for _ in 0..2 {
                for i in 0..k {
                    let along: f64 = self.rows.iter().map(|row| row[i] * row[k]).sum();
                    self.rows
                        .iter_mut()
                        .for_each(|row| row[k] -= along * row[i]);
                    self.triangle[i][k] += along;
                }
            }
            let norm = self.column_norm(k);
            // Not greater, or not a number.
            if norm.partial_cmp(&(RANK * size)) != Some(Ordering::Greater) {
                return None;
            }
            self.rows.iter_mut().for_each(|row| row[k] /= norm);
            self.triangle[k][k] = norm;
        }
        // R⁻¹ Qᵀ W, in units of h.
        let scale = [h, h, h * h, h * h, h * h];
        for (row, p) in self.rows.iter_mut().zip(parameters) {
            for i in (0..N).rev() {
                for k in i + 1..N {
                    row[i] -= self.triangle[i][k] * row[k];
                }
                row[i] /= self.triangle[i][i];
            }
            let weight = weight(p);
            row.iter_mut()
                .zip(scale)
                .for_each(|(c, s)| *c *= weight / s);
        }
        Some(())
    }

    fn column_norm(&self, k: usize) -> f64 {
        self.rows
            .iter()
            .map(|row| row[k] * row[k])
            .sum::<f64>()
            .sqrt()
    }

    /// Whether the ratio of the largest to the smallest singular value of the weighted,
    /// scaled rows is at most `limit`.
    pub(super) fn is_conditioned(&self, limit: f64) -> bool {
        // ‖R‖ ‖R⁻¹‖ in the Frobenius norm is an upper bound, and cheap.
        self.condition_bound() <= limit || self.is_ratio_within(limit)
    }

    /// R of the columns u, v, ½u², uv/√2, ½v². Turned axes turn them among themselves, so that their
    /// singular values are the same for all axes.
    fn even_triangle(&self) -> [[f64; N]; N] {
        let mut r = self.triangle;
        r.iter_mut().for_each(|row| row[UV] *= FRAC_1_SQRT_2);
        r
    }

    fn condition_bound(&self) -> f64 {
        let r = &self.even_triangle();
        let mut inverse = [[0.0; N]; N];
        for j in 0..N {
            inverse[j][j] = 1.0 / r[j][j];
            for i in (0..j).rev() {
                let sum: f64 = (i + 1..=j).map(|k| r[i][k] * inverse[k][j]).sum();
                inverse[i][j] = -sum / r[i][i];
            }
        }
        let square = |m: &[[f64; N]; N]| -> f64 { m.iter().flatten().map(|v| v * v).sum() };
        (square(r) * square(&inverse)).sqrt()
    }

    /// Whether that ratio, whose square is one of eigenvalues of RᵀR, is at most `limit`. By cyclic
    /// Jacobi rotations, as far as needed: eigenvalues are as far from the diagonal as what is left
    /// beside it is large, at most (Weyl).
    fn is_ratio_within(&self, limit: f64) -> bool {
        let mut a = self.gram();
        for _ in 0..12 {
            let (mut off, mut least, mut most) = (0.0, f64::INFINITY, 0.0f64);
            for (i, row) in a.iter().enumerate() {
                (least, most) = (least.min(row[i]), most.max(row[i]));
                off += row[..i].iter().map(|v| v * v).sum::<f64>();
            }
            let off = (2.0 * off).sqrt();
            let square = limit * limit;
            if most + off <= square * (least - off) {
                return true;
            }
            if most - off > square * (least + off) || off <= 1e-7 * most {
                return most <= square * least;
            }
            sweep(&mut a);
        }
        false
    }

    /// RᵀR.
    fn gram(&self) -> [[f64; N]; N] {
        let r = self.even_triangle();
        std::array::from_fn(|i| {
            std::array::from_fn(|j| (0..=i.min(j)).map(|k| r[k][i] * r[k][j]).sum())
        })
    }

    /// Weights of the derivatives, a row a neighbour.
    pub(super) fn functionals(&self) -> impl Iterator<Item = [f64; N]> + '_ {
        self.rows.iter().copied()
    }

    /// Derivatives of a vector-valued function with these differences to its centre.
    pub(super) fn derivatives(&self, differences: impl Iterator<Item = DVec3>) -> [DVec3; N] {
        let mut sums = [DVec3::ZERO; N];
        for (row, difference) in self.rows.iter().zip(differences) {
            for (sum, weight) in sums.iter_mut().zip(row) {
                *sum += *weight * difference;
            }
        }
        sums
    }
}

/// Jacobi rotations of a symmetric matrix, one for each pair of rows.
fn sweep(a: &mut [[f64; N]; N]) {
    for p in 0..N {
        for q in p + 1..N {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = 1f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
            let c = 1.0 / (t * t + 1.0).sqrt();
            let s = t * c;
            for row in a.iter_mut() {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            let (first, second) = (a[p], a[q]);
            a[p] = std::array::from_fn(|k| c * first[k] - s * second[k]);
            a[q] = std::array::from_fn(|k| s * first[k] + c * second[k]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scattered(m: usize) -> Vec<DVec2> {
        let angle = |k: usize| 1.1 * k as f64 + 0.3 * (k as f64).sin();
        let radius = |k: usize| 0.02 * (1.0 + 0.3 * (2.0 * k as f64).cos());
        (0..m)
            .map(|k| radius(k) * DVec2::from_angle(angle(k)))
            .collect()
    }

    #[test]
    fn quadratics_are_reproduced() {
        let wanted = [0.7, -1.3, 2.0, 0.4, -3.0];
        for (m, power) in [(5, 1), (6, 1), (9, 2)] {
            let parameters = scattered(m);
            let mut fit = Fit::default();
            fit.compute(&parameters, power).expect("a fit");
            let values = parameters.iter().map(|p| {
                let (u, v) = (p.x, p.y);
                let f = wanted[0] * u + wanted[1] * v + 0.5 * wanted[2] * u * u;
                DVec3::splat(f + wanted[3] * u * v + 0.5 * wanted[4] * v * v)
            });
            for (found, wanted) in fit.derivatives(values).iter().zip(wanted) {
                assert!((found.x - wanted).abs() < 1e-11, "{m}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn weights_are_those_of_the_normal_equations() {
        let (parameters, power) = (scattered(8), 2);
        let mut fit = Fit::default();
        fit.compute(&parameters, power).expect("a fit");
        // Residuals of least squares are orthogonal to the columns, in the weights' metric.
        let values: Vec<f64> = (0..8).map(|k| f64::from(k % 3) - 1.0).collect();
        let d = fit.derivatives(values.iter().map(|&v| DVec3::splat(v)));
        let columns = |p: DVec2| [p.x, p.y, 0.5 * p.x * p.x, p.x * p.y, 0.5 * p.y * p.y];
        for k in 0..N {
            let (mut sum, mut size) = (0.0, 0.0);
            for (p, v) in parameters.iter().zip(&values) {
                let c = columns(*p);
                let fitted: f64 = (0..N).map(|i| c[i] * d[i].x).sum();
                let weight = p.length().powi(-2 * power);
                sum += weight * (v - fitted) * c[k];
                size += (weight * c[k]).abs();
            }
            assert!(sum.abs() < 1e-11 * size, "{k}: {sum:e} of {size:e}");
        }
    }

    #[test]
    fn the_condition_is_that_of_the_singular_values() {
        let mut fit = Fit::default();
        // A regular hexagon's columns are orthogonal but for u²/2 and v²/2, whose Gram matrix
        // is 3/16·[[3, 1], [1, 3]]: singular values √3, √3, √(3/4), √(3/8), √(3/8).
        let hexagon: Vec<DVec2> = (0..6)
            .map(|k| 3.0 * DVec2::from_angle(std::f64::consts::FRAC_PI_3 * f64::from(k)))
            .collect();
        fit.compute(&hexagon, 1).expect("a fit");
        assert!(fit.is_ratio_within(8f64.sqrt() * (1.0 + 1e-12)));
        assert!(!fit.is_ratio_within(8f64.sqrt() * (1.0 - 1e-12)));
        let bound = (7.5 * 22.0 / 3.0f64).sqrt();
        assert!((fit.condition_bound() - bound).abs() < 1e-12);
        for m in [6, 7, 9] {
            fit.compute(&scattered(m), 1).expect("a fit");
            let eigenvalues = eigenvalues(fit.gram());
            let least = eigenvalues.iter().fold(f64::INFINITY, |a, b| a.min(*b));
            let most = eigenvalues.iter().fold(0.0, |a: f64, b| a.max(*b));
            let (condition, bound) = ((most / least).sqrt(), fit.condition_bound());
            assert!(bound > condition && bound < 5.0 * condition);
            assert!(fit.is_conditioned((1.0 + 1e-9) * condition));
            assert!(!fit.is_conditioned((1.0 - 1e-9) * condition));
        }
    }

    /// Which neighbours a vertex is fitted to must not depend on the axes there.
    #[test]
    fn the_condition_does_not_depend_on_the_axes() {
        let mut fit = Fit::default();
        for m in [5, 6, 7, 9] {
            let mut bounds = (0..12).map(|k| {
                let turn = DVec2::from_angle(0.3 * f64::from(k));
                let turned: Vec<DVec2> = scattered(m).iter().map(|p| turn.rotate(*p)).collect();
                fit.compute(&turned, 1).expect("a fit");
                fit.condition_bound()
            });
            let first = bounds.next().expect("a bound");
            assert!(
                bounds.all(|bound| (bound / first - 1.0).abs() < 1e-9),
                "{m}"
            );
        }
    }

    /// By faer's own decomposition.
    fn eigenvalues(matrix: [[f64; N]; N]) -> Vec<f64> {
        let matrix = faer::Mat::from_fn(N, N, |i, j| matrix[i][j]);
        let found = matrix.self_adjoint_eigenvalues(faer::Side::Lower);
        found.expect("eigenvalues")
    }

    #[test]
    fn neighbours_in_special_position_are_refused() {
        let mut fit = Fit::default();
        let line: Vec<DVec2> = (1..9).map(|k| DVec2::new(f64::from(k), 0.0)).collect();
        assert!(fit.compute(&line, 1).is_none());
        // All but collinear; all but on two lines, where uv vanishes with v² and u².
        let bent = |k: usize, p: &DVec2| DVec2::new(p.x, 1e-12 * (k as f64).sin());
        let nearly: Vec<DVec2> = line.iter().enumerate().map(|(k, p)| bent(k, p)).collect();
        assert!(fit.compute(&nearly, 1).is_none());
        let cross = |k: usize| {
            let along = [DVec2::X, DVec2::Y][k % 2] * (k as f64 - 3.3);
            along + 1e-12 * DVec2::from_angle(k as f64)
        };
        let cross: Vec<DVec2> = (0..8).map(cross).collect();
        assert!(fit.compute(&cross, 1).is_none());
        assert!(fit.compute(&scattered(4), 1).is_none());
        let mut touching = scattered(6);
        touching[2] = DVec2::ZERO;
        assert!(fit.compute(&touching, 1).is_none());
    }
}
