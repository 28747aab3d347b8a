//! Preconditioned conjugate gradients and iterative refinement.
//!
//! faer's conjugate gradients bound one residual for all columns, where ours meets the tolerance
//! in each field.

use super::convergence::Convergence;
use super::entry::Entry;
use super::pattern::Pattern;
use crate::interrupt;

/// A system `A X = B` for one or more fields.
#[derive(Clone, Copy)]
pub struct LinearSystem<'a, T> {
    /// Where A may be non-zero.
    pub pattern: &'a Pattern,
    /// One value a slot of the pattern.
    pub values: &'a [f64],
    /// B, fields end to end.
    pub rhs: &'a [T],
}

impl<T: Entry> LinearSystem<'_, T> {
    /// Writes `B − A X` and returns its size relative to B: the largest `‖b − A x‖ / ‖b‖`
    /// of a field, all its coordinates together.
    pub(super) fn residual(&self, x: &[T], residual: &mut [T]) -> f64 {
        self.pattern.multiply(self.values, x, residual);
        for (r, b) in residual.iter_mut().zip(self.rhs) {
            *r = *b - *r;
        }
        largest(&self.relative_sizes(residual))
    }

    /// Size of each field of a residual relative to the right-hand side; that of a
    /// field whose right-hand side is zero, and so its solution, is zero.
    fn relative_sizes(&self, residual: &[T]) -> Vec<f64> {
        let n = self.pattern.n().max(1);
        let fields = residual.chunks_exact(n).zip(self.rhs.chunks_exact(n));
        fields
            .map(|(r, b)| {
                let (r, b) = (dot(r, r), dot(b, b));
                if r == 0.0 { 0.0 } else { (r / b).sqrt() }
            })
            .collect()
    }
}

/// Vectors the iteration works in, kept from one solve to the next.
pub struct Workspace<T> {
    pub(super) residual: Vec<T>,
    /// The preconditioned residual, then the image `A p` of the direction.
    pub(super) image: Vec<T>,
    direction: Vec<T>,
}

impl<T> Default for Workspace<T> {
    fn default() -> Self {
        Self {
            residual: Vec::new(),
            image: Vec::new(),
            direction: Vec::new(),
        }
    }
}

impl<T: Entry> Workspace<T> {
    /// Makes every vector that long.
    pub fn resize(&mut self, len: usize) {
        for vector in [&mut self.residual, &mut self.image, &mut self.direction] {
            vector.resize(len, T::ZERO);
        }
    }
}

/// Conjugate gradients for `A X = B` from zero: with A and P positive definite ⟨x, b⟩ > 0 for
/// every iterate, so that with b = −∇E each is a direction of descent whatever the tolerance.
///
/// The coordinates of a field are one system with the matrix `A ⊗ I₃`, so the iteration
/// commutes with rotations; fields have steps of their own. Costs one preconditioning
/// and one product with A an iteration.
///
/// Ends when the relative residual of every field is at most `tolerance`, after
/// `max_iterations`, when A or P turns out not to be positive definite, or when the work is
/// [given up](crate::interrupt). The caller compares the
/// residual with the tolerance.
pub fn conjugate_gradients<T: Entry>(
    system: LinearSystem<'_, T>,
    x: &mut [T],
    mut precondition: impl FnMut(&mut [T]),
    tolerance: f64,
    max_iterations: usize,
    workspace: &mut Workspace<T>,
) -> Convergence {
    let n = system.pattern.n().max(1);
    let Workspace {
        residual,
        image,
        direction,
    } = workspace;
    x.fill(T::ZERO);
    residual.copy_from_slice(system.rhs);
    direction.fill(T::ZERO);
    let mut rho = vec![1.0; x.len() / n];

    let mut reached = Convergence {
        iterations: 0,
        relative_residual: largest(&system.relative_sizes(residual)),
    };
    loop {
        let size = reached.relative_residual;
        let is_done = size <= tolerance || !size.is_finite();
        let is_over = is_done || reached.iterations == max_iterations;
        if is_over || interrupt::check().is_err() {
            return reached;
        }

        let sizes = system.relative_sizes(residual);
        image.copy_from_slice(residual);
        precondition(image);
        let preconditioned = residual.chunks_exact(n).zip(image.chunks_exact(n));
        for ((p, rho), (r, z)) in direction
            .chunks_exact_mut(n)
            .zip(&mut rho)
            .zip(preconditioned)
        {
            let rho_before = std::mem::replace(rho, dot(r, z));
            let beta = *rho / rho_before;
            p.iter_mut().zip(z).for_each(|(p, z)| {
                *p = *p * beta;
                *p += *z;
            });
        }
        system.pattern.multiply(system.values, direction, image);
        for (f, (x, r)) in x
            .chunks_exact_mut(n)
            .zip(residual.chunks_exact_mut(n))
            .enumerate()
        {
            // A field that is done would go on to divide zero by zero.
            if sizes[f] <= tolerance {
                continue;
            }
            let range = f * n..(f + 1) * n;
            let (p, q) = (&direction[range.clone()], &image[range]);
            let curvature = dot(p, q);
            if !(curvature > 0.0 && rho[f] > 0.0) {
                return reached;
            }
            let alpha = rho[f] / curvature;
            for (((x, r), p), q) in x.iter_mut().zip(r).zip(p).zip(q) {
                *x += *p * alpha;
                *r -= *q * alpha;
            }
        }
        reached.iterations += 1;
        reached.relative_residual = largest(&system.relative_sizes(residual));
    }
}

/// Iterative refinement `x ← x + P⁻¹ (b − A x)` from `x = P⁻¹ b`, for P = A but for
/// rounding; A may be indefinite. Returns the number of steps that helped.
pub(super) fn refine<T: Entry>(
    system: LinearSystem<'_, T>,
    x: &mut [T],
    mut precondition: impl FnMut(&mut [T]),
    tolerance: f64,
    max_steps: usize,
    workspace: &mut Workspace<T>,
) -> usize {
    let Workspace {
        residual,
        image: correction,
        ..
    } = workspace;
    x.copy_from_slice(system.rhs);
    precondition(x);
    let mut size = system.residual(x, residual);
    for step in 0..max_steps {
        if size <= tolerance || interrupt::check().is_err() {
            return step;
        }
        correction.copy_from_slice(residual);
        precondition(correction);
        x.iter_mut().zip(&*correction).for_each(|(x, d)| *x += *d);
        let refined = system.residual(x, residual);
        if refined.is_nan() || refined >= size {
            x.iter_mut().zip(&*correction).for_each(|(x, d)| *x -= *d);
            return step;
        }
        size = refined;
    }
    max_steps
}

/// Largest of the numbers, or NaN if one is.
fn largest(numbers: &[f64]) -> f64 {
    numbers
        .iter()
        .fold(0.0, |m: f64, &x| if x > m || x.is_nan() { x } else { m })
}

fn dot<T: Entry>(a: &[T], b: &[T]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn iterations_are_as_many_as_there_are_eigenvalues() {
        let n = 60;
        let pattern = Pattern::from_cliques(n, std::iter::empty::<[u32; 2]>());
        let values: Vec<f64> = (0..n)
            .map(|i| [2.0, 3.0, 10.0, 40.0, 99.0][i % 5])
            .collect();
        let rhs: Vec<DVec3> = (0..n).map(|i| DVec3::new(1.0, i as f64, -0.5)).collect();
        let system = LinearSystem {
            pattern: &pattern,
            values: &values,
            rhs: &rhs,
        };
        let (mut x, mut workspace) = (vec![DVec3::NAN; n], Workspace::default());
        workspace.resize(n);
        let mut run = |max| conjugate_gradients(system, &mut x, |_| (), 1e-9, max, &mut workspace);
        let reached = run(500);
        assert_eq!(reached.iterations, 5);
        assert!(reached.relative_residual < 1e-9);
        assert!(run(4).relative_residual > 1e-9);
        assert!(run(0).iterations == 0);
    }

    #[test]
    fn an_indefinite_matrix_is_noticed() {
        let pattern = Pattern::from_cliques(2, std::iter::empty::<[u32; 2]>());
        let (values, rhs) = ([1.0, -1.0], [DVec3::X, DVec3::X]);
        let system = LinearSystem {
            pattern: &pattern,
            values: &values,
            rhs: &rhs,
        };
        let (mut x, mut workspace) = ([DVec3::ZERO; 2], Workspace::default());
        workspace.resize(2);
        let reached = conjugate_gradients(system, &mut x, |_| (), 1e-12, 9, &mut workspace);
        assert!(reached.relative_residual > 0.1 && reached.iterations < 9);
    }

    #[test]
    fn refinement_keeps_only_steps_that_help() {
        let pattern = Pattern::from_cliques(1, std::iter::empty::<[u32; 2]>());
        let (values, rhs) = ([2.0], [DVec3::ONE]);
        let system = LinearSystem {
            pattern: &pattern,
            values: &values,
            rhs: &rhs,
        };
        let (mut x, mut workspace) = ([DVec3::ZERO], Workspace::default());
        workspace.resize(1);
        let mut run = |inverse: f64, x: &mut [DVec3]| {
            refine(
                system,
                x,
                |r: &mut [DVec3]| r[0] *= inverse,
                2e-3,
                9,
                &mut workspace,
            )
        };
        // The error shrinks to a tenth each step.
        assert_eq!(run(0.45, &mut x), 2);
        assert!((x[0] - 0.5).length() < 1e-3);
        // It doubles: the first solution stays.
        assert_eq!(run(1.5, &mut x), 0);
        assert!((x[0] - 1.5).length() < 1e-12);
    }
}
