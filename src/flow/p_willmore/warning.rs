//! What the p-Willmore functional cannot tell.

use super::PWillmoreFlow;
use super::kept::Kept;
use crate::flow::report::{Warning, WarningsGiven};
use crate::flow::{StepReport, vesicle};
use crate::remesh::Regulariser;
use glam::DVec3;

/// |Y|h from which a mesh no longer resolves its surface, and from which the surface is about
/// to become singular.
const UNDER_RESOLVED: f64 = 3.0;
const SINGULAR: f64 = 8.0;
/// With a functional so near the smooth minimum the mesh may cheat.
const NEAR_MINIMUM: f64 = 0.985;
/// Two masses whose ∫H² part by so many per cent tell of a mesh that is too coarse or crumpled;
/// looked at every so many steps, as it costs about a trial.
const DISAGREEING: f64 = 5.0;
const LOOK_EVERY: usize = 10;

impl PWillmoreFlow {
    pub(super) fn warn_of(&self, x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        let is_iterative = self.system.is_iterative()
            || self
                .regulariser
                .as_ref()
                .is_some_and(Regulariser::is_iterative);
        if is_iterative && given.is_first(Warning::Iterative) {
            report.warnings.push(
                "The mesh is too large to factor its matrices in memory: they are solved \
                 iteratively, and steps take longer."
                    .into(),
            );
        }
        let bending = self.shown(self.evaluation.integrals.energy);
        let is_near = |least: f64| bending < NEAR_MINIMUM * least;
        if self.smooth_minimum.is_some_and(is_near) && given.is_first(Warning::NearBound) {
            report.warnings.push(
                "∫H² is below that of every smooth surface with these handles: the mesh no \
                 longer resolves the surface."
                    .into(),
            );
        }
        let is_time = self.options.p == 2.0 && report.step.is_multiple_of(LOOK_EVERY);
        if is_time && !given.was_given(Warning::Disagreement) {
            let percent = 100.0 * self.functional.disagreement(x);
            if percent > DISAGREEING && given.is_first(Warning::Disagreement) {
                report.warnings.push(format!(
                    "Two readings of ∫H², with a lumped and with a consistent mass, part by \
                     {percent:.0} %: the mesh does not resolve its curvature well."
                ));
            }
        }
        let curvatures = self.evaluation.curvature.iter().zip(&self.evaluation.mass);
        let (at, sharpest) = curvatures
            .map(|(y, m)| y.length() * m.sqrt())
            .enumerate()
            .fold(
                (0, 0.0),
                |best, (i, y)| if y > best.1 { (i, y) } else { best },
            );
        if sharpest > UNDER_RESOLVED && given.is_first(Warning::Coarse) {
            let what = if sharpest > SINGULAR {
                "the surface is about to become singular, as a neck that pinches off"
            } else {
                "edges are too long for the curvature"
            };
            report
                .warnings
                .push(format!("At vertex {at} {what}: use a finer mesh."));
        }
        if Kept::leads(&self.options) && self.kept.has_arrived() && given.is_first(Warning::Branch)
        {
            report.warnings.push(vesicle::branch(&self.mesh, x));
        }
    }
}
