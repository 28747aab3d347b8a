//! GMRES for systems that are known by their action only.

use super::convergence::Convergence;
use crate::interrupt;

/// Solves `A x = b` by GMRES without restart, preconditioned from the right: the Krylov space of
/// A P⁻¹, with modified Gram–Schmidt and Givens rotations (Saad & Schultz
/// [SS86](crate::bibliography#ss86)).
///
/// `apply` writes A v for a v; `precondition` replaces v by P⁻¹ v. Ends at `tolerance`
/// relative to ‖b‖, after `max_iterations`, which bounds the memory, a vector an iteration, or when
/// the work is [given up](crate::interrupt).
/// Preconditioning from the right leaves the residual that of the system itself.
pub fn gmres(
    mut apply: impl FnMut(&[f64], &mut [f64]),
    mut precondition: impl FnMut(&mut [f64]),
    b: &[f64],
    tolerance: f64,
    max_iterations: usize,
) -> (Vec<f64>, Convergence) {
    let size = norm(b);
    let mut x = vec![0.0; b.len()];
    let mut info = Convergence {
        iterations: 0,
        relative_residual: 0.0,
    };
    if size == 0.0 {
        return (x, info);
    }
    let mut basis = vec![b.iter().map(|v| v / size).collect::<Vec<f64>>()];
    // Columns of the triangular factor of the Hessenberg matrix, its rotations, and the
    // rotated right-hand side.
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut rotations: Vec<(f64, f64)> = Vec::new();
    let mut rhs = vec![size];
    info.relative_residual = 1.0;
    while info.relative_residual > tolerance && info.iterations < max_iterations {
        if interrupt::check().is_err() {
            break;
        }
        let k = info.iterations;
        let mut z = basis[k].clone();
        precondition(&mut z);
        let mut w = vec![0.0; b.len()];
        apply(&z, &mut w);
        let mut column: Vec<f64> = Vec::with_capacity(k + 2);
        for v in &basis {
            let h = dot(v, &w);
            w.iter_mut().zip(v).for_each(|(w, v)| *w -= h * v);
            column.push(h);
        }
        let h = norm(&w);
        for (j, (c, s)) in rotations.iter().enumerate() {
            let (p, q) = (column[j], column[j + 1]);
            (column[j], column[j + 1]) = (c * p + s * q, c * q - s * p);
        }
        let length = column[k].hypot(h);
        if length == 0.0 || !length.is_finite() {
            break;
        }
        let (c, s) = (column[k] / length, h / length);
        column[k] = length;
        columns.push(column);
        rotations.push((c, s));
        rhs.push(-s * rhs[k]);
        rhs[k] *= c;
        info.iterations += 1;
        info.relative_residual = rhs[k + 1].abs() / size;
        if h == 0.0 {
            break;
        }
        basis.push(w.iter().map(|v| v / h).collect());
    }
    // Back substitution, then one preconditioned combination of the basis.
    let n = columns.len();
    let mut y = rhs[..n].to_vec();
    for i in (0..n).rev() {
        for j in i + 1..n {
            y[i] -= columns[j][i] * y[j];
        }
        y[i] /= columns[i][i];
    }
    for (y, v) in y.iter().zip(&basis) {
        x.iter_mut().zip(v).for_each(|(x, v)| *x += y * v);
    }
    precondition(&mut x);
    (x, info)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1-D convection and diffusion: unsymmetric, well-conditioned after its diagonal.
    fn apply(v: &[f64], w: &mut [f64]) {
        for i in 0..v.len() {
            let left = if i > 0 { v[i - 1] } else { 0.0 };
            let right = v.get(i + 1).copied().unwrap_or(0.0);
            w[i] = (3.0 + i as f64) * v[i] - 1.4 * left - 0.3 * right;
        }
    }

    #[test]
    fn the_residual_is_what_it_says() {
        let b: Vec<f64> = (0..80).map(|i| (0.7 * f64::from(i)).sin()).collect();
        let diagonal = |v: &mut [f64]| {
            for (i, v) in v.iter_mut().enumerate() {
                *v /= 3.0 + i as f64;
            }
        };
        for tolerance in [1e-3, 1e-10] {
            let (x, info) = gmres(apply, diagonal, &b, tolerance, 80);
            let mut ax = vec![0.0; b.len()];
            apply(&x, &mut ax);
            let r: Vec<f64> = ax.iter().zip(&b).map(|(a, b)| a - b).collect();
            let found = norm(&r) / norm(&b);
            assert!(found <= 1.01 * tolerance, "{found}");
            assert!((found - info.relative_residual).abs() < 1e-12);
            assert!(info.iterations < 25, "{}", info.iterations);
        }
    }

    #[test]
    fn nothing_is_done_for_nothing_and_limits_are_kept() {
        let (x, info) = gmres(apply, |_| (), &[0.0; 5], 1e-9, 9);
        assert_eq!((x, info.iterations), (vec![0.0; 5], 0));
        let b = vec![1.0; 60];
        let (_, info) = gmres(apply, |_| (), &b, 1e-14, 4);
        assert_eq!(info.iterations, 4);
        assert!(info.relative_residual > 1e-14);
        // The identity is solved at once.
        let (x, info) = gmres(|v, w| w.copy_from_slice(v), |_| (), &b, 1e-12, 9);
        assert_eq!(info.iterations, 1);
        assert!(x.iter().all(|x| (x - 1.0).abs() < 1e-13));
    }
}
