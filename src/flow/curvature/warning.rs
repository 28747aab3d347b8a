//! What the readings of these flows cannot tell.

use super::CurvatureFlow;
use super::law::Law;
use crate::flow::StepReport;
use crate::flow::report::{Warning, WarningsGiven};

/// A residual of the linear system above this is worth a warning.
const INACCURATE: f64 = 1e-4;

impl CurvatureFlow {
    pub(super) fn warn_of(&self, report: &mut StepReport, given: &mut WarningsGiven) {
        let depth = self.law.depth();
        let warnings = &mut report.warnings;
        // The boundary of the patch and `depth` rings outside it carry the derivatives.
        if depth > 0 && self.region.margin <= depth && given.is_first(Warning::Margin) {
            let (rings, joins) = match self.law {
                Law::CurvatureVariation => ("two rings", "curvature"),
                _ => ("one ring", "tangent plane"),
            };
            warnings.push(format!(
                "Fewer than {rings} of held vertices lie between the free patch's boundary and \
                 the mesh's: there the surface is fitted from one side, and only positions are \
                 given, not the {joins}."
            ));
        }
        if self.is_iterative && given.is_first(Warning::Iterative) {
            warnings.push(
                "The patch is too large to factor its matrix in memory: it is solved iteratively, \
                 and steps take longer."
                    .into(),
            );
        }
        let residual = report.linear_residual.unwrap_or_default();
        if residual > INACCURATE && given.is_first(Warning::Inaccurate) {
            warnings.push(format!(
                "The linear system was solved to a residual of {residual:.0e} only."
            ));
        }
        if report.flipped_faces > 0 && self.is_paper() {
            warnings.push("The recommended scheme limits how far vertices move.".into());
        }
    }
}
