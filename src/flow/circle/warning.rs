//! What the circle-angle energy cannot tell: it has no barrier against collapsing handles, and
//! is Möbius invariant, so that it does not mind balloons.

use super::CircleFlow;
use crate::energy::p_willmore::integrated_power;
use crate::flow::options::Goal;
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
/// The same of ∫H² over a run that is to smooth.
const ROUGHENED: f64 = 0.05;

/// Areas of the faces.
fn areas_of(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let area = |f| measure::face_vector_area(mesh, x, f).length();
    mesh.faces().map(area).collect()
}

/// Whether this share of the faces, and fewer, has half of the area; in linear time.
fn is_unbalanced(mesh: &HalfedgeMesh, x: &[DVec3], share: f64) -> bool {
    let mut areas = areas_of(mesh, x);
    let fewer = ((share * areas.len() as f64).ceil() as usize).saturating_sub(1);
    if fewer >= areas.len() {
        return false;
    }
    let half = 0.5 * areas.iter().sum::<f64>();
    let (largest, ..) = areas.select_nth_unstable_by(fewer, |a, b| b.total_cmp(a));
    largest.iter().sum::<f64>() >= half
}

/// The smallest share of the faces that has half of the area.
pub(super) fn balance(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let mut areas = areas_of(mesh, x);
    areas.sort_unstable_by(|a, b| b.total_cmp(a));
    let half = 0.5 * areas.iter().sum::<f64>();
    let mut sum = 0.0;
    let most = areas.iter().take_while(|&&area| {
        sum += area;
        sum < half
    });
    (most.count() + 1) as f64 / areas.len() as f64
}

/// ∫H².
pub(super) fn bend(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    integrated_power(mesh, x, 2.0)
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
        // W tells of the mesh as well, and falls where edges turn towards the lines of curvature; of a
        // closed surface that only becomes smoother, ∫H² falls too.
        if is_closed && self.options.goal == Goal::Smooth {
            let (before, after) = (self.start_bend, bend(&self.mesh, x));
            if after > (1.0 + ROUGHENED) * before {
                given.give_once(Warning::Roughened { before, after }, warnings);
            }
        }
        if is_closed && is_unbalanced(&self.mesh, x, BALLOON * self.start_balance) {
            given.give_once(Warning::Balloon, warnings);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn a_share_is_unbalanced_from_the_balance_on() {
        let torus = shape::make("torus", &[]).expect("a shape");
        let built = build(&torus.soup).expect("a surface");
        let (mesh, mut x) = (built.mesh, built.positions);
        for p in &mut x {
            p.x *= 1.0 + 0.3 * p.y;
        }
        let balance = balance(&mesh, &x);
        let face = 1.0 / mesh.n_faces() as f64;
        assert!(balance > 0.3 && balance < 0.5, "{balance}");
        for k in -5..=5 {
            let share = balance + (f64::from(k) - 0.5) * face;
            assert_eq!(is_unbalanced(&mesh, &x, share), k > 0, "{k}");
        }
        assert!(!is_unbalanced(&mesh, &x, 0.0));
        assert!(is_unbalanced(&mesh, &x, 1.0));
    }
}
