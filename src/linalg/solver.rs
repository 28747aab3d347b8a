//! Solves with the cheapest preconditioner that will do: the diagonal, the factor of an
//! earlier matrix or a new one.

use super::amortised_cost::{AmortisedCost, FLOPS_PER_ENTRY};
use super::backoff::Backoff;
use super::entry::Entry;
use super::error::LinalgError;
use super::ldlt::Ldlt;
use super::pattern::Pattern;
use super::pcg::{Limit, LinearSystem, Workspace, conjugate_gradients, refine};
use super::symbolic::Symbolic;
use glam::DVec3;
use std::sync::Arc;
use web_time::Instant;

/// Number of rows from which iterations are tried before a factorisation. Below, a
/// factorisation takes a fifth of a second at most, and a direct solve is more accurate
/// and knows the inertia.
const ITERATIVE_FROM: usize = 30_000;

/// Operations of a factorisation that take as long as an iteration with the diagonal
/// spends on one row: 35 ns in wasm.
const FLOPS_PER_ROW: f64 = 250.0;

/// Bytes a factor may take: in a browser memory ends at 4 GiB, of which a flow needs some,
/// and never shrinks again.
const FACTOR_LIMIT: usize = if cfg!(target_arch = "wasm32") {
    1_600_000_000
} else {
    usize::MAX
};

/// Iterations of a solve where the matrix may not be factored.
const MAX_ITERATIONS: usize = 1000;

/// Steps of iterative refinement with a new factor, at most.
const REFINEMENTS: usize = 3;

/// When a new matrix is factored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Refactor {
    /// In every solve.
    Always,
    /// When conjugate gradients with what is at hand would cost more; on meshes below
    /// 30,000 vertices, unless [set otherwise](Solver::set_iterative_from), in every
    /// solve.
    #[default]
    WhenCheaper,
}

/// What conjugate gradients were preconditioned with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preconditioner {
    /// The diagonal of the matrix: enough when it outweighs the rest, as with short steps.
    Diagonal,
    /// The factor of an earlier matrix.
    KeptFactor,
    /// The factor of this matrix: a direct solve.
    #[default]
    NewFactor,
}

/// What a solve did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolveInfo {
    /// How the matrix was met; it was factored if this is a new factor.
    pub preconditioner: Preconditioner,
    /// Iterations after the preconditioner was applied for the first time. With a new
    /// factor: steps of iterative refinement.
    pub iterations: usize,
    /// Number of negative eigenvalues if the matrix was factored, else 0: conjugate
    /// gradients usually fail on an indefinite matrix, which is then factored, but they
    /// prove nothing.
    pub negative_pivots: usize,
    /// Seconds spent on the factorisation.
    pub factor_seconds: f64,
    /// Seconds spent on everything else.
    pub solve_seconds: f64,
    /// Largest `‖b − A x‖ / ‖b‖` of a field, computed from the solution returned.
    pub relative_residual: f64,
}

/// Solver for matrices of one pattern that change from call to call.
///
/// The choice of preconditioner counts operations, not seconds, and is the same on every
/// machine. Cheaper ones are tried first and given up as soon as their rate of
/// convergence shows that they would cost more than the next. A factor is replaced once
/// a solve costs more than the average one since it was made, its own cost included:
/// that is when the average is least.
///
/// The diagonal is not only cheaper where it does: the factor of a matrix it dominates
/// decays so fast that on large meshes its entries become subnormal numbers, which slow
/// some processors down tenfold.
pub struct Solver {
    pattern: Pattern,
    symbolic: Arc<Symbolic>,
    iterative_from: usize,
    factor_limit: usize,
    factor: Option<Ldlt>,
    cost: AmortisedCost,
    diagonal: Backoff,
    kept: Backoff,
    workspace: Workspace<DVec3>,
}

impl Solver {
    /// Analyses the pattern; `points`, one a row, help the order of elimination.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`].
    pub fn new(pattern: Pattern, points: Option<&[DVec3]>) -> Result<Self, LinalgError> {
        let symbolic = Symbolic::analyse(&pattern, points)?;
        Ok(Self::of(pattern, Arc::new(symbolic)))
    }

    fn of(pattern: Pattern, symbolic: Arc<Symbolic>) -> Self {
        Self {
            pattern,
            iterative_from: ITERATIVE_FROM,
            factor_limit: FACTOR_LIMIT,
            factor: None,
            cost: AmortisedCost::new(&symbolic),
            symbolic,
            diagonal: Backoff::default(),
            kept: Backoff::default(),
            workspace: Workspace::default(),
        }
    }

    /// Sets the number of rows from which [`Refactor::WhenCheaper`] tries iterations.
    pub fn set_iterative_from(&mut self, n: usize) {
        self.iterative_from = n;
    }

    /// Sets the bytes a factor may take.
    pub fn set_factor_limit(&mut self, bytes: usize) {
        self.factor_limit = bytes;
    }

    /// Whether a factor would take more memory than it may: every solve then iterates with
    /// the diagonal, and the solution is the best of a thousand iterations.
    pub fn is_too_large_to_factor(&self) -> bool {
        self.symbolic.factor_len().saturating_mul(size_of::<f64>()) > self.factor_limit
    }

    /// Iterations with the diagonal that cost as much as a factorisation and a solve with it:
    /// where there is no factor at hand, no attempt goes on for longer.
    pub fn iteration_limit(&self) -> usize {
        self.iterations_for(self.cost.factorisation + 1.0)
    }

    /// Iterations with the diagonal that cost as much as so many with a factor.
    fn iterations_for(&self, iterations: f64) -> usize {
        let entries_per_row = self.symbolic.factor_len() as f64 / self.pattern.n() as f64;
        (iterations * entries_per_row * FLOPS_PER_ENTRY / FLOPS_PER_ROW) as usize
    }

    /// Pattern of the matrices.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Order of elimination and structure of the factor.
    pub fn symbolic(&self) -> &Arc<Symbolic> {
        &self.symbolic
    }

    /// Solves `A X = B` for one or more fields stored end to end.
    ///
    /// `values` has one value a slot of the pattern; `x` receives the solution. Several
    /// fields in one call cost less than one call each. `tolerance` bounds the relative
    /// residual aimed at. With a matrix too ill-conditioned for it the solution is the
    /// best that was found, and [`SolveInfo::relative_residual`] tells.
    ///
    /// # Errors
    /// [`LinalgError::ZeroPivot`], [`LinalgError::NonFiniteEntry`],
    /// [`LinalgError::NonFiniteRightHandSide`], [`LinalgError::OutOfMemory`]; `x` is then
    /// of no use.
    ///
    /// # Panics
    /// If a slice has the wrong length.
    pub fn solve(
        &mut self,
        values: &[f64],
        rhs: &[DVec3],
        x: &mut [DVec3],
        tolerance: f64,
        policy: Refactor,
    ) -> Result<SolveInfo, LinalgError> {
        let n = self.pattern.n();
        assert!(
            rhs.len() == x.len() && rhs.len().is_multiple_of(n.max(1)),
            "whole fields"
        );
        if let Some(row) = rhs.iter().position(|b| !b.is_finite()) {
            return Err(LinalgError::NonFiniteRightHandSide { row: row % n });
        }
        let start = Instant::now();
        self.workspace.resize(rhs.len());
        if self.is_too_large_to_factor() {
            let system = LinearSystem {
                pattern: &self.pattern,
                values,
                rhs,
            };
            let workspace = &mut self.workspace;
            let precondition = by_diagonal(&self.pattern, values);
            let limit = Limit::Whatever(MAX_ITERATIONS);
            let reached = conjugate_gradients(system, x, precondition, tolerance, limit, workspace);
            return Ok(SolveInfo {
                preconditioner: Preconditioner::Diagonal,
                iterations: reached.iterations,
                solve_seconds: start.elapsed().as_secs_f64(),
                relative_residual: reached.relative_residual,
                ..SolveInfo::default()
            });
        }
        let may_iterate = policy == Refactor::WhenCheaper && n >= self.iterative_from.max(1);
        let iterated = if may_iterate {
            self.iterate(values, rhs, x, tolerance)
        } else {
            None
        };
        let mut info = match iterated {
            Some(info) => info,
            None => self.solve_directly(values, rhs, x, tolerance)?,
        };
        // The residual the iteration keeps is only updated, and drifts.
        let system = LinearSystem {
            pattern: &self.pattern,
            values,
            rhs,
        };
        info.relative_residual = system.residual(x, &mut self.workspace.residual);
        info.solve_seconds = start.elapsed().as_secs_f64() - info.factor_seconds;
        Ok(info)
    }

    /// Conjugate gradients with the diagonal or the kept factor; `None` if neither
    /// reaches the tolerance for less than a new factor costs.
    fn iterate(
        &mut self,
        values: &[f64],
        rhs: &[DVec3],
        x: &mut [DVec3],
        tolerance: f64,
    ) -> Option<SolveInfo> {
        let is_kept = self.factor.is_some() && self.cost.is_factor_worth_keeping();
        let most = if is_kept {
            self.iterations_for(self.cost.last)
        } else {
            self.iteration_limit()
        };
        let Self {
            pattern,
            cost,
            workspace,
            ..
        } = self;
        let system = LinearSystem {
            pattern,
            values,
            rhs,
        };
        if self.diagonal.is_due() {
            let limit = Limit::WhileHopeful(most);
            let precondition = by_diagonal(pattern, values);
            let reached = conjugate_gradients(system, x, precondition, tolerance, limit, workspace);
            if self.diagonal.record(reached.relative_residual <= tolerance) {
                let iterations = reached.iterations;
                let preconditioner = Preconditioner::Diagonal;
                return Some(SolveInfo {
                    preconditioner,
                    iterations,
                    ..SolveInfo::default()
                });
            }
        }
        if is_kept
            && let Some(factor) = &mut self.factor
            && self.kept.is_due()
        {
            let precondition = |fields: &mut [DVec3]| factor.solve_in_place(fields);
            let limit = Limit::WhileHopeful(cost.factorisation as usize + cost.first_iterations);
            let reached = conjugate_gradients(system, x, precondition, tolerance, limit, workspace);
            if self.kept.record(reached.relative_residual <= tolerance) {
                let iterations = reached.iterations;
                cost.add(iterations);
                let preconditioner = Preconditioner::KeptFactor;
                return Some(SolveInfo {
                    preconditioner,
                    iterations,
                    ..SolveInfo::default()
                });
            }
        }
        None
    }

    /// Factors the matrix, solves and refines.
    fn solve_directly(
        &mut self,
        values: &[f64],
        rhs: &[DVec3],
        x: &mut [DVec3],
        tolerance: f64,
    ) -> Result<SolveInfo, LinalgError> {
        let start = Instant::now();
        self.cost.clear();
        let factor = match &mut self.factor {
            Some(factor) => factor,
            None => self.factor.insert(Ldlt::new(self.symbolic.clone())?),
        };
        let n_fields = rhs.len() / self.pattern.n().max(1);
        factor.reserve_columns(DVec3::COLUMNS * n_fields.max(1))?;
        let inertia = factor.factor(values)?;
        let factor_seconds = start.elapsed().as_secs_f64();
        let system = LinearSystem {
            pattern: &self.pattern,
            values,
            rhs,
        };
        let precondition = |fields: &mut [DVec3]| factor.solve_in_place(fields);
        let iterations = refine(
            system,
            x,
            precondition,
            tolerance,
            REFINEMENTS,
            &mut self.workspace,
        );
        self.cost.restart(inertia, iterations);
        let negative_pivots = inertia.negative;
        Ok(SolveInfo {
            iterations,
            negative_pivots,
            factor_seconds,
            ..SolveInfo::default()
        })
    }
}

/// Division by the diagonal, field by field.
fn by_diagonal<T: Entry>(pattern: &Pattern, values: &[f64]) -> impl FnMut(&mut [T]) + use<T> {
    let slots = pattern.diagonal_slots();
    let inverse: Vec<f64> = slots.iter().map(|&s| values[s as usize].recip()).collect();
    move |fields| {
        for field in fields.chunks_exact_mut(inverse.len()) {
            field
                .iter_mut()
                .zip(&inverse)
                .for_each(|(v, d)| *v = *v * *d);
        }
    }
}
