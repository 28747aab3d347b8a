//! What the p-Willmore functional cannot tell.

use super::PWillmoreFlow;
use crate::energy::p_willmore::integrated_power;
use crate::flow::signs::UNDER_RESOLVED;
use crate::flow::warning::WarningsGiven;
use crate::flow::{StepReport, Warning};
use crate::remesh::adaptive::Soundness;
use glam::DVec3;

/// The bend, here |Y|h, from which the surface is about to become singular.
const SINGULAR: f64 = 8.0;
/// With a functional so near the smooth minimum the mesh may cheat.
const NEAR_MINIMUM: f64 = 0.985;
/// Two masses whose ∫H² part by so many per cent tell of a mesh that is too coarse or crumpled;
/// looked at every so many steps, as it costs about a trial; so do the readings of the mesh.
const DISAGREEING: f64 = 5.0;
const LOOK_EVERY: usize = 10;

impl PWillmoreFlow {
    pub(super) fn warn_of(&self, x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        let is_iterative = self.system.is_iterative();
        let warnings = &mut report.warnings;
        if is_iterative {
            given.give_once(Warning::IterativeMesh, warnings);
        }
        let bending = self.shown(self.evaluation.integrals.energy);
        let is_near = |least: f64| bending < NEAR_MINIMUM * least;
        if self.smooth_minimum.is_some_and(is_near) {
            given.give_once(Warning::NearBound, warnings);
        }
        let is_time = self.options.p == 2.0 && report.step.is_multiple_of(LOOK_EVERY);
        if is_time && !given.was_given(&Warning::Disagreement { percent: 0.0 }) {
            let percent = 100.0 * self.functional.disagreement(x);
            if percent > DISAGREEING {
                given.give_once(Warning::Disagreement { percent }, warnings);
            }
        }
        if report.step.is_multiple_of(LOOK_EVERY) && self.mesh.is_triangular() {
            let readings = Soundness::of(&self.mesh, x, integrated_power(&self.mesh, x, 2.0));
            report.soundness = Some(readings);
            // A rough start is given the time to become smooth.
            if report.step > LOOK_EVERY
                && let Some(warning) = Warning::of_unsound(&readings)
            {
                given.give_once(warning, warnings);
            }
        }
        let curvatures = self.evaluation.curvature.iter().zip(&self.evaluation.mass);
        let (vertex, sharpest) = curvatures
            .map(|(y, m)| y.length() * m.sqrt())
            .enumerate()
            .fold(
                (0, 0.0),
                |best, (i, y)| if y > best.1 { (i, y) } else { best },
            );
        if sharpest > SINGULAR {
            given.give_once(Warning::NearlySingular { vertex }, warnings);
        } else if sharpest > UNDER_RESOLVED {
            given.give_once(Warning::Coarse { vertex }, warnings);
        }
    }
}
