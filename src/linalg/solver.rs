//! Solves directly, or by conjugate gradients with a multigrid preconditioner where that costs
//! less.

use super::entry::Entry;
use super::error::LinalgError;
use super::ldlt::Ldlt;
use super::multigrid::Multigrid;
use super::pattern::Pattern;
use super::pcg::{LinearSystem, Workspace, conjugate_gradients, refine};
use super::symbolic::Symbolic;
use crate::interrupt;
use glam::DVec3;
use std::sync::Arc;
use web_time::Instant;

/// Number of rows from which multigrid is considered. Below, a factorisation takes a fifth of a
/// second at most, and a direct solve is more accurate and knows the inertia.
const MULTIGRID_FROM: usize = 30_000;

/// Number of rows from which it is taken without a look at the factor, whose analysis would
/// take time and memory: on all triangle meshes it costs more.
const MULTIGRID_SURE: usize = 100_000;

/// Operations of a factorisation that take as long as one multiplication of a cycle or a Galerkin
/// product: 1.2 ns natively and about 2 ns in wasm, where a factorisation does 17 and 7
/// operations a nanosecond.
const FLOPS_PER_OPERATION: f64 = 16.0;

/// Operations of a factorisation that take as long as a solve spends on one entry of a factor.
///
/// From timings in wasm: a factorisation does 6 to 8 operations a nanosecond, a solve takes 4 to
/// 5 ns an entry.
const FLOPS_PER_ENTRY: f64 = 32.0;

/// What an iteration with multigrid leaves of the residual, on meshes as they come.
const CONTRACTION: f64 = 0.55;

/// Iterations beyond those expected after which multigrid has failed: with slivers or very long
/// time steps a factor is better.
const PATIENCE: usize = 32;

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

/// How a system is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// By a factorisation; asked for, it is exact.
    #[default]
    Direct,
    /// By conjugate gradients with multigrid; asked for, it is used where it costs less.
    Multigrid,
}

/// What a solve did.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SolveInfo {
    /// How the system was solved in the end.
    pub method: Method,
    /// Iterations; of a direct solve, steps of iterative refinement.
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
/// The choice of the method counts operations, not seconds, and is the same on every machine.
/// It depends on nothing but the mesh and the tolerance, so that a flow can be repeated from
/// any of its steps. Analysis and hierarchy are made when they are first needed.
pub struct Solver {
    pattern: Pattern,
    points: Option<Vec<DVec3>>,
    /// Between the rows, where they are vertices of a mesh.
    edges: Option<Pattern>,
    multigrid: Option<Box<Multigrid>>,
    symbolic: Option<Arc<Symbolic>>,
    factor: Option<Ldlt>,
    prefers_multigrid: bool,
    factor_limit: usize,
    workspace: Workspace<DVec3>,
}

impl Solver {
    /// For direct solves only; `points`, one a row, help the order of elimination.
    pub fn new(pattern: Pattern, points: Option<&[DVec3]>) -> Self {
        Self {
            pattern,
            points: points.map(<[DVec3]>::to_vec),
            edges: None,
            multigrid: None,
            symbolic: None,
            factor: None,
            prefers_multigrid: false,
            factor_limit: FACTOR_LIMIT,
            workspace: Workspace::default(),
        }
    }

    /// For rows that are vertices of a mesh at `points`, some with `edges` between them.
    pub fn on_mesh(pattern: Pattern, points: &[DVec3], edges: Pattern) -> Self {
        Self {
            edges: Some(edges),
            ..Self::new(pattern, Some(points))
        }
    }

    /// Takes multigrid where it is asked for, whatever it costs.
    pub fn prefer_multigrid(&mut self) {
        self.prefers_multigrid = true;
    }

    /// Sets the bytes a factor may take.
    pub fn set_factor_limit(&mut self, bytes: usize) {
        self.factor_limit = bytes;
    }

    /// Lets go of analysis, factor and hierarchy, which the next solve makes again as they were.
    pub fn release(&mut self) {
        (self.multigrid, self.symbolic, self.factor) = (None, None, None);
        self.workspace = Workspace::default();
    }

    /// Whether a factor, as far as it was looked at, would take more memory than it may: every
    /// solve then iterates, and the solution is the best of a thousand iterations.
    pub fn is_too_large_to_factor(&self) -> bool {
        let symbolic = self.symbolic.as_ref();
        let bytes = symbolic.map(|s| s.factor_len().saturating_mul(size_of::<f64>()));
        bytes.is_some_and(|bytes| bytes > self.factor_limit)
    }

    /// Pattern of the matrices.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Order of elimination and structure of the factor.
    ///
    /// # Errors
    /// [`LinalgError::OutOfMemory`], [`LinalgError::IndexOverflow`].
    pub fn symbolic(&mut self) -> Result<&Arc<Symbolic>, LinalgError> {
        let symbolic = match self.symbolic.take() {
            Some(symbolic) => symbolic,
            None => Arc::new(Symbolic::analyse(&self.pattern, self.points.as_deref())?),
        };
        Ok(self.symbolic.insert(symbolic))
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
    /// [`LinalgError::NonFiniteRightHandSide`], [`LinalgError::OutOfMemory`],
    /// [`LinalgError::IndexOverflow`], [`LinalgError::Interrupted`]; `x` is then of no use.
    ///
    /// # Panics
    /// If a slice has the wrong length.
    pub fn solve(
        &mut self,
        values: &[f64],
        rhs: &[DVec3],
        x: &mut [DVec3],
        tolerance: f64,
        method: Method,
    ) -> Result<SolveInfo, LinalgError> {
        let n = self.pattern.n();
        assert!(
            rhs.len() == x.len() && rhs.len().is_multiple_of(n.max(1)),
            "whole fields"
        );
        if let Some(row) = rhs.iter().position(|b| !b.is_finite()) {
            return Err(LinalgError::NonFiniteRightHandSide { row: row % n });
        }
        interrupt::check()?;
        let start = Instant::now();
        self.workspace.resize(rhs.len());
        let mut info = SolveInfo::default();
        let is_solved = method == Method::Multigrid && self.is_multigrid_cheaper(tolerance)? && {
            let limit = PATIENCE + expected_iterations(tolerance) as usize;
            self.iterate(values, rhs, x, tolerance, limit, &mut info)?
        };
        if !is_solved {
            interrupt::check()?;
            self.symbolic()?;
            if self.is_too_large_to_factor() {
                self.iterate(values, rhs, x, tolerance, MAX_ITERATIONS, &mut info)?;
                if info.method != Method::Multigrid {
                    return Err(LinalgError::OutOfMemory { n });
                }
            } else {
                info = self.solve_directly(values, rhs, x, tolerance)?;
            }
        }
        interrupt::check()?;
        // The residual an iteration keeps is only updated, and drifts.
        let system = LinearSystem {
            pattern: &self.pattern,
            values,
            rhs,
        };
        info.relative_residual = system.residual(x, &mut self.workspace.residual);
        info.solve_seconds = start.elapsed().as_secs_f64() - info.factor_seconds;
        Ok(info)
    }

    /// Whether a solve with multigrid takes fewer operations than a direct one. Makes the
    /// hierarchy, and drops it if not.
    fn is_multigrid_cheaper(&mut self, tolerance: f64) -> Result<bool, LinalgError> {
        let n = self.pattern.n();
        let is_small = n < MULTIGRID_FROM && !self.prefers_multigrid;
        if self.edges.is_none() || n == 0 || is_small {
            return Ok(false);
        }
        let is_new = self.multigrid.is_none();
        let is_preferred = n >= MULTIGRID_SURE || self.prefers_multigrid;
        let multigrid = self.multigrid()?;
        if !is_new || is_preferred {
            return Ok(true);
        }
        let cycles = expected_iterations(tolerance) * multigrid.cycle_operations() as f64;
        let by_multigrid = FLOPS_PER_OPERATION * (multigrid.update_operations() as f64 + cycles);
        // Looked at but half it would be taken for the choice.
        let multigrid = self.multigrid.take();
        let symbolic = self.symbolic()?;
        let directly = symbolic.flops() + FLOPS_PER_ENTRY * symbolic.factor_len() as f64;
        let is_cheaper = by_multigrid < directly || self.is_too_large_to_factor();
        if is_cheaper {
            self.multigrid = multigrid;
        } else {
            self.edges = None;
        }
        Ok(is_cheaper)
    }

    /// The hierarchy, made if need be.
    fn multigrid(&mut self) -> Result<&mut Multigrid, LinalgError> {
        let multigrid = match (self.multigrid.take(), &self.edges, &self.points) {
            (Some(multigrid), ..) => multigrid,
            (None, Some(edges), Some(points)) => {
                Box::new(Multigrid::new(&self.pattern, edges, points)?)
            }
            _ => {
                return Err(LinalgError::OutOfMemory {
                    n: self.pattern.n(),
                });
            }
        };
        Ok(self.multigrid.insert(multigrid))
    }

    /// Conjugate gradients with multigrid; answers whether they reach the tolerance.
    fn iterate(
        &mut self,
        values: &[f64],
        rhs: &[DVec3],
        x: &mut [DVec3],
        tolerance: f64,
        limit: usize,
        info: &mut SolveInfo,
    ) -> Result<bool, LinalgError> {
        let n = self.pattern.n();
        // Of a matrix that is at fault the factorisation tells in the caller's numbering.
        let is_definite = matches!(self.multigrid()?.update(values), Ok(true));
        interrupt::check()?;
        if !is_definite {
            return Ok(false);
        }
        let Self {
            pattern,
            multigrid: Some(multigrid),
            workspace,
            ..
        } = self
        else {
            return Ok(false);
        };
        let system = LinearSystem {
            pattern,
            values,
            rhs,
        };
        let precondition = |fields: &mut [DVec3]| {
            fields
                .chunks_exact_mut(n)
                .for_each(|field| multigrid.apply(field));
        };
        let reached = conjugate_gradients(system, x, precondition, tolerance, limit, workspace);
        info.method = Method::Multigrid;
        info.iterations = reached.iterations;
        Ok(reached.relative_residual <= tolerance)
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
        let mut factor = match self.factor.take() {
            Some(factor) => factor,
            None => Ldlt::new(Arc::clone(self.symbolic()?))?,
        };
        let n_fields = rhs.len() / self.pattern.n().max(1);
        factor.reserve_columns(DVec3::COLUMNS * n_fields.max(1))?;
        let inertia = factor.factor(values)?;
        interrupt::check()?;
        let factor_seconds = start.elapsed().as_secs_f64();
        let system = LinearSystem {
            pattern: &self.pattern,
            values,
            rhs,
        };
        let precondition = |fields: &mut [DVec3]| factor.solve_in_place(fields);
        let workspace = &mut self.workspace;
        let iterations = refine(system, x, precondition, tolerance, REFINEMENTS, workspace);
        self.factor = Some(factor);
        Ok(SolveInfo {
            method: Method::Direct,
            iterations,
            negative_pivots: inertia.negative,
            factor_seconds,
            ..SolveInfo::default()
        })
    }
}

/// Iterations with multigrid to that residual.
fn expected_iterations(tolerance: f64) -> f64 {
    (tolerance.ln() / CONTRACTION.ln()).max(1.0)
}
