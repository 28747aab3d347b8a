//! What the circle-angle energy cannot tell: it has no barrier against collapsing handles, and
//! is Möbius invariant, so that it does not mind balloons.

use super::CircleFlow;
use crate::flow::signs::BUBBLE;
use crate::flow::warning::WarningsGiven;
use crate::flow::{StepReport, Warning};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// Half of the area in so much smaller a share of the faces than at the start is a balloon.
const BALLOON: f64 = 0.5;
/// W that rises by this share in a step is told of.
const ROSE: f64 = 0.01;

/// The smallest share of the faces that has half of the area.
pub(super) fn balance(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let area = |f| measure::face_vector_area(mesh, x, f).length();
    let mut areas: Vec<f64> = mesh.faces().map(area).collect();
    areas.sort_unstable_by(|a, b| b.total_cmp(a));
    let half = 0.5 * areas.iter().sum::<f64>();
    let mut sum = 0.0;
    let most = areas.iter().take_while(|&&area| {
        sum += area;
        sum < half
    });
    (most.count() + 1) as f64 / areas.len() as f64
}

impl CircleFlow {
    pub(super) fn warn_of(&self, x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        if self.is_paper() {
            return;
        }
        let before = self.trial.exact;
        let rose = report.energy > (1.0 + ROSE) * before && report.energy > self.nearly_spherical();
        let warnings = &mut report.warnings;
        if rose {
            let after = report.energy;
            given.give_once(Warning::ReadingRose { before, after }, warnings);
        }
        if report.area > BUBBLE * self.start_area {
            given.give_once(Warning::Growth, warnings);
        }
        let is_closed = self.mesh.is_closed() && self.mesh.is_oriented();
        if is_closed && balance(&self.mesh, x) < BALLOON * self.start_balance {
            given.give_once(Warning::Balloon, warnings);
        }
    }
}
