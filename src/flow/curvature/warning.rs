//! What the readings of these flows cannot tell.

use super::CurvatureFlow;
use crate::flow::warning::WarningsGiven;
use crate::flow::{StepReport, Warning};

/// A residual of the linear system above this is worth a warning.
const INACCURATE: f64 = 1e-4;

impl CurvatureFlow {
    pub(super) fn warn_of(&self, report: &mut StepReport, given: &mut WarningsGiven) {
        let depth = self.law.depth();
        let warnings = &mut report.warnings;
        // The boundary of the patch and `depth` rings outside it carry the derivatives.
        if depth > 0 && self.region.margin <= depth {
            given.give_once(Warning::Margin { rings: depth }, warnings);
        }
        if self.is_iterative {
            given.give_once(Warning::IterativePatch, warnings);
        }
        let residual = report.linear_residual.unwrap_or_default();
        if residual > INACCURATE {
            given.give_once(Warning::Inaccurate { residual }, warnings);
        }
        if report.flipped_faces > 0 && self.is_paper() {
            warnings.push(Warning::FarMoves);
        }
    }
}
