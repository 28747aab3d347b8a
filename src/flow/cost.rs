//! What a step costs, told apart.

use super::{StepReport, Warning};
use crate::linalg::SolveInfo;
use web_time::Instant;

/// Where the time of a step goes, and what its solvers meet.
#[derive(Clone, Default)]
pub struct Cost {
    /// Seconds for energies, gradients and matrices.
    pub assemble: f64,
    /// Seconds for factorisations.
    pub factor: f64,
    /// Seconds for triangular solves and iterations.
    pub solve: f64,
    /// Seconds for trials of a move: the functional there, and what the mesh would be.
    pub search: f64,
    /// Seconds for sliding vertices along the surface.
    pub regularise: f64,
    /// Inner iterations: of the linear solver, or of Newton's method.
    pub iterations: usize,
    /// Negative eigenvalues of the system matrix, where it was factored.
    pub negative_pivots: usize,
    /// Norm of the residual of the linear system over that of its right-hand side, where it
    /// is watched.
    pub residual: Option<f64>,
    /// Worth telling the user.
    pub warnings: Vec<Warning>,
}

impl Cost {
    /// Takes over what a linear solve says of itself.
    pub fn add(&mut self, info: &SolveInfo) {
        self.factor += info.factor_seconds;
        self.solve += info.solve_seconds;
        self.iterations += info.iterations;
        self.negative_pivots = info.negative_pivots;
    }

    /// Enters everything into the report of the step, and hands it the warnings.
    pub(super) fn enter(&mut self, report: &mut StepReport) {
        report.iterations = self.iterations;
        report.negative_pivots = self.negative_pivots;
        report.linear_residual = self.residual;
        report.assemble_milliseconds = self.assemble * 1e3;
        report.factor_milliseconds = self.factor * 1e3;
        report.solve_milliseconds = self.solve * 1e3;
        report.search_milliseconds = self.search * 1e3;
        report.regularise_milliseconds = self.regularise * 1e3;
        report.warnings.append(&mut self.warnings);
    }

    /// Counts the seconds of `work` as assembly.
    pub fn assembling<T>(&mut self, work: impl FnOnce() -> T) -> T {
        let watch = Instant::now();
        let result = work();
        self.assemble += watch.elapsed().as_secs_f64();
        result
    }
}
