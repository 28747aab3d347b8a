//! What the readings of these flows cannot tell.

use super::CurvatureFlow;
use crate::flow::warning::WarningsGiven;
use crate::flow::{StepReport, Warning};
use crate::geometry::measure;
use crate::mesh::Vertex;

/// A residual of the linear system above this is worth a warning.
const INACCURATE: f64 = 1e-4;

/// The area of a plain surface that grows by this share is a sign that its boundary lets it.
const GROWN: f64 = 0.02;

impl CurvatureFlow {
    /// Whether a vertex moves that has a neighbour on the boundary.
    fn is_open_beside(&self) -> bool {
        let mesh = &self.mesh;
        let is_beside = |v: &u32| {
            mesh.neighbours(Vertex(*v))
                .any(|w| mesh.is_boundary_vertex(w))
        };
        self.region.free.iter().any(is_beside)
    }

    pub(super) fn warn_of(&self, report: &mut StepReport, given: &mut WarningsGiven) {
        let depth = self.law.depth();
        let warnings = &mut report.warnings;
        // The boundary of the patch and `depth` rings outside it carry the derivatives.
        if depth > 0 && self.region.margin <= depth {
            given.give_once(Warning::Margin { rings: depth }, warnings);
        }
        if self.law.order() > 2 && self.is_open_beside() {
            let grown = report.area / measure::area(&self.mesh, &self.start) - 1.0;
            if grown > GROWN {
                let percent = (100.0 * grown).round();
                given.give_once(Warning::OpenBoundary { percent }, warnings);
            }
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
