//! Solving a step's system by GMRES, preconditioned by a factor of the matrix itself, which is kept
//! from step to step as long as it serves; for very many unknowns by one of what is like it.

use crate::flow::{Cost, FlowError};
use crate::interrupt;
use crate::linalg::{LinalgError, Lu, Pattern, Symbolic, Unsymmetric, gmres};
use glam::DVec3;
use std::rc::Rc;
use std::sync::Arc;
use web_time::Instant;

/// Residual at which a solution by a factor of the matrix is one, relative to the velocity.
const ACCURACY: f64 = 1e-8;
/// Most iterations with a factor of an earlier step, each of which takes some fifteenth of the time of
/// a new factor. Steps towards a rest need 4 to 7 with the factor of the first of them.
pub(super) const MAX_KEPT: usize = 10;
/// Most with a factor of this very matrix: one or two are enough, unless elimination without pivoting
/// has lost digits.
const MAX_OWN: usize = 8;

/// Entries of L and U, 8 bytes each, up to which a matrix is factored: those of some
/// 150,000 unknowns of the sixth-order flow. Far beyond, double precision does not
/// suffice for it.
const MAX_FACTOR: usize = 120_000_000;
/// Of an iterative solution, relative to the velocity.
const TOLERANCE: f64 = 1e-6;
const MAX_ITERATIONS: usize = 300;
/// The residual that the iteration keeps drifts off; it starts again from the true one …
const RESTARTS: usize = 3;
/// … while that is larger than this.
const SUFFICIENT: f64 = 1e-5;
/// A solution with a larger residual is none.
const WORTHLESS: f64 = 0.1;

/// What a system's solution is worth.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Quality {
    /// Norm of the residual of φ over that of the velocity.
    pub(super) residual: f64,
    /// Iterations, where the matrix is not factored.
    pub(super) iterations: usize,
    pub(super) is_iterative: bool,
    /// Seconds.
    pub(super) assemble: f64,
    pub(super) factor: f64,
    pub(super) solve: f64,
}

impl Quality {
    /// Adds it to what a step costs.
    pub(super) fn tell(&self, cost: &mut Cost) {
        cost.assemble += self.assemble;
        cost.factor += self.factor;
        cost.solve += self.solve;
        cost.iterations += self.iterations;
        cost.residual = Some(self.residual);
    }
}

/// A step's matrix, and what is like it.
pub(super) struct Equations<'a> {
    pub(super) pattern: &'a Pattern,
    pub(super) matrix: &'a Unsymmetric,
    /// Makes Δ among the unknowns.
    pub(super) laplacian: &'a dyn Fn() -> (Pattern, Unsymmetric),
    /// Half the order of the flow.
    pub(super) power: i32,
    pub(super) dt: f64,
}

/// Positions and step size of a matrix that was factored. A checkpoint has them in place of the factor,
/// which is large: the same factor can be made again from them.
#[derive(Debug)]
pub(super) struct Reference {
    pub(super) x: Vec<DVec3>,
    pub(super) dt: f64,
}

/// What is kept from step to step.
pub(super) enum LinearSolver {
    Direct {
        lu: Lu,
        /// Of which matrix `lu` is the factor, if it is one.
        of: Option<Rc<Reference>>,
    },
    Iterative(Vec<DVec3>),
}

impl LinearSolver {
    /// Analyses a pattern; one point a row.
    pub(super) fn new(pattern: &Pattern, points: &[DVec3]) -> Result<Self, LinalgError> {
        Self::limited(pattern, points, MAX_FACTOR)
    }

    /// The same with a limit on the entries of L and U.
    fn limited(
        pattern: &Pattern,
        points: &[DVec3],
        max_factor: usize,
    ) -> Result<Self, LinalgError> {
        let symbolic = Symbolic::analyse(pattern, Some(points))?;
        if 2 * symbolic.factor_len() > max_factor {
            return Ok(Self::Iterative(points.to_vec()));
        }
        let lu = Lu::new(Arc::new(symbolic))?;
        Ok(Self::Direct { lu, of: None })
    }

    /// Whether what is kept is a factor, and of that matrix.
    pub(super) fn has_factor_of(&self, reference: &Rc<Reference>) -> bool {
        match self {
            Self::Direct { of, .. } => of.as_ref().is_some_and(|of| Rc::ptr_eq(of, reference)),
            Self::Iterative(_) => false,
        }
    }

    /// Makes the factor of a matrix, where matrices are factored.
    pub(super) fn factor(
        &mut self,
        matrix: &Unsymmetric,
        reference: &Rc<Reference>,
    ) -> Result<(), LinalgError> {
        if let Self::Direct { lu, of } = self {
            *of = None;
            lu.factor(matrix)?;
            *of = Some(Rc::clone(reference));
        }
        Ok(())
    }

    /// The solution, whose residual is measured against the right-hand side: positions
    /// would hide it. `reference` says whose factor is at hand, and is `here` afterwards where that
    /// did not serve any more.
    pub(super) fn solve(
        &mut self,
        system: &Equations<'_>,
        here: Reference,
        reference: &mut Option<Rc<Reference>>,
        rhs: &[f64],
        quality: &mut Quality,
    ) -> Result<Vec<f64>, FlowError> {
        if let Some(row) = rhs.iter().position(|v| !v.is_finite()) {
            return Err(LinalgError::NonFiniteRightHandSide { row }.into());
        }
        let watch = Instant::now();
        let factored = quality.factor;
        let phi = match self {
            Self::Direct { lu, of } => {
                let (mut phi, mut residual) = (Vec::new(), f64::INFINITY);
                if reference.is_some() {
                    (phi, residual) = by_factor(system, lu, rhs, MAX_KEPT, quality)?;
                }
                if residual > ACCURACY {
                    let watch = Instant::now();
                    (*of, *reference) = (None, None);
                    lu.factor(system.matrix)?;
                    *reference = Some(Rc::new(here));
                    of.clone_from(reference);
                    quality.factor += watch.elapsed().as_secs_f64();
                    (phi, _) = by_factor(system, lu, rhs, MAX_OWN, quality)?;
                }
                phi
            }
            Self::Iterative(points) => {
                quality.is_iterative = true;
                let lu = preconditioner(system, points)?;
                quality.factor += watch.elapsed().as_secs_f64();
                let mut phi = vec![0.0; rhs.len()];
                let mut rest = rhs.to_vec();
                for _ in 0..RESTARTS {
                    let (correction, info) = gmres(
                        |v, w| system.matrix.multiply(system.pattern, v, w),
                        |v| (0..system.power).for_each(|_| lu.solve_in_place(v)),
                        &rest,
                        TOLERANCE,
                        MAX_ITERATIONS,
                    );
                    interrupt::check()?;
                    quality.iterations += info.iterations;
                    phi.iter_mut().zip(correction).for_each(|(p, c)| *p += c);
                    rest = residual(system, &phi, rhs);
                    if norm(&rest) <= SUFFICIENT * norm(rhs) {
                        break;
                    }
                }
                phi
            }
        };
        let size = norm(rhs);
        if size > 0.0 {
            quality.residual = norm(&residual(system, &phi, rhs)) / size;
        }
        quality.solve = watch.elapsed().as_secs_f64() - (quality.factor - factored);
        if quality.residual <= WORTHLESS {
            Ok(phi)
        } else {
            Err(FlowError::Inaccurate {
                residual: quality.residual,
            })
        }
    }
}

/// Factor of α − Δ, whose power k/2 is, but for the factor 2, like 1/dt plus the leading term
/// of a flow of order k: ½(α − Δ)^(k/2) with α^(k/2) = 2/dt.
fn preconditioner(system: &Equations<'_>, points: &[DVec3]) -> Result<Lu, LinalgError> {
    let (pattern, mut values) = (system.laplacian)();
    interrupt::check()?;
    let alpha = (2.0 / system.dt).powf(1.0 / f64::from(system.power));
    let all = values.lower.iter_mut().chain(&mut values.upper);
    all.for_each(|v| *v = -*v);
    for &slot in pattern.diagonal_slots() {
        values.lower[slot as usize] += alpha;
    }
    let mut lu = Lu::new(Arc::new(Symbolic::analyse(&pattern, Some(points))?))?;
    lu.factor(&values)?;
    Ok(lu)
}

/// A solution preconditioned by a factor of this matrix or an earlier one, with its residual.
fn by_factor(
    system: &Equations<'_>,
    lu: &Lu,
    rhs: &[f64],
    most: usize,
    quality: &mut Quality,
) -> Result<(Vec<f64>, f64), LinalgError> {
    let (phi, info) = gmres(
        |v, w| system.matrix.multiply(system.pattern, v, w),
        |v| lu.solve_in_place(v),
        rhs,
        ACCURACY,
        most,
    );
    interrupt::check()?;
    quality.iterations += info.iterations;
    Ok((phi, info.relative_residual))
}

fn residual(system: &Equations<'_>, phi: &[f64], rhs: &[f64]) -> Vec<f64> {
    let mut rest = vec![0.0; rhs.len()];
    system.matrix.multiply(system.pattern, phi, &mut rest);
    rest.iter_mut().zip(rhs).for_each(|(r, b)| *r = b - *r);
    rest
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_solve_the_system_is_no_solution() {
        // Ones on the diagonal but for a row that is zero.
        let pattern = Pattern::from_cliques(4, [[0, 1], [1, 2], [2, 3]].iter());
        let mut matrix = Unsymmetric::zeros(&pattern);
        let mut like = Unsymmetric::zeros(&pattern);
        for (k, &slot) in pattern.diagonal_slots().iter().enumerate() {
            matrix.lower[slot as usize] = if k == 2 { 0.0 } else { 1.0 };
            like.lower[slot as usize] = -1.0;
        }
        let system = Equations {
            pattern: &pattern,
            matrix: &matrix,
            laplacian: &|| (pattern.clone(), like.clone()),
            power: 1,
            dt: 1.0,
        };
        let points = vec![DVec3::ZERO; 4];
        let rhs = [1.0; 4];
        assert_eq!(residual(&system, &[0.25; 4], &rhs), [0.75, 0.75, 1.0, 0.75]);
        let mut quality = Quality::default();
        let mut solve = |mut solver: LinearSolver, rhs: &[f64]| {
            let (x, dt) = (points.clone(), 1.0);
            let here = Reference { x, dt };
            solver.solve(&system, here, &mut None, rhs, &mut quality)
        };
        let refused = solve(LinearSolver::Iterative(points.clone()), &rhs);
        assert!(
            matches!(refused, Err(FlowError::Inaccurate { residual }) if residual > 0.4),
            "{refused:?}"
        );
        let direct = || LinearSolver::new(&pattern, &points).expect("a structure");
        let refused = solve(direct(), &rhs);
        let zero = LinalgError::ZeroPivot { row: 2 };
        assert_eq!(refused, Err(FlowError::Linear(zero)));
        let refused = solve(direct(), &[f64::NAN; 4]);
        let first = LinalgError::NonFiniteRightHandSide { row: 0 };
        assert_eq!(refused, Err(FlowError::Linear(first)));
    }

    #[test]
    fn factors_above_the_limit_are_not_made() {
        let pattern = Pattern::from_cliques(3, [[0, 1], [1, 2]].iter());
        let points = vec![DVec3::ZERO; 3];
        let solver = |limit| LinearSolver::limited(&pattern, &points, limit).expect("a structure");
        assert!(matches!(solver(2), LinearSolver::Iterative(_)));
        assert!(matches!(solver(1000), LinearSolver::Direct { .. }));
    }
}
