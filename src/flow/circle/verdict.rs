//! What a step is reported as, and whether there is a next one.

use super::problem::Cost;
use super::{Accepted, CircleFlow};
use crate::flow::options::{Goal, Scheme};
use crate::flow::stop::Verdict;
use crate::flow::{Flow, Status, StepReport};
use crate::geometry::survey::Survey;
use crate::mesh::{HalfedgeMesh, counted};
use glam::DVec3;
use std::f64::consts::PI;

/// Energy per vertex below which nothing but roundoff is left.
const FLOOR_PER_VERTEX: f64 = 1e-12;
/// h |∇E| of a surface that is critical up to roundoff.
const FLAT: f64 = 1e-6;
/// A triangle of this quality that was a good one at the start ends the run.
const WORST_QUALITY: f64 = 1e-3;
/// Share of the smooth minimum that no healthy mesh goes below: aligned lattices come to
/// 0.98 of it on 16 × 16 vertices.
const PINCHED: f64 = 0.9;
/// Growth of the area that is a sign of a bubble.
const BUBBLE: f64 = 4.0;

/// Warnings already given in a run.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Warned {
    pinch: bool,
    bubble: bool,
}

impl CircleFlow {
    pub(super) fn report(
        &self,
        x: &[DVec3],
        survey: &Survey,
        accepted: &Accepted,
        before: f64,
        cost: Cost,
    ) -> StepReport {
        let (problem, h) = (&self.problem, self.problem.h);
        let displacement = x
            .iter()
            .zip(&self.start)
            .map(|(p, q)| p.distance_squared(*q))
            .fold(0.0, f64::max);
        StepReport {
            step: self.pace.step,
            time: self.pace.time,
            dt: accepted.dt,
            energy: self.evaluation.exact,
            energy_normalised: 0.5 * self.evaluation.exact,
            objective_before: before,
            objective: accepted.objective,
            gradient_norm: problem.gradient_norm(&self.evaluation.gradient),
            area: survey.area,
            volume: survey.volume,
            min_angle_degrees: survey.min_angle_degrees,
            rejected: accepted.rejected,
            iterations: cost.iterations,
            milliseconds: 0.0,
            tau: accepted.dt / (h * h),
            epsilon: self.pace.schedule.current().epsilon,
            negative_pivots: cost.negative_pivots,
            skipped_angles: self.evaluation.skipped,
            flipped_faces: self.flipped.len(),
            max_displacement: displacement.sqrt() / h,
            assemble_milliseconds: cost.assemble * 1e3,
            factor_milliseconds: cost.factor * 1e3,
            solve_milliseconds: cost.solve * 1e3,
            warnings: cost.warnings,
            ..StepReport::default()
        }
    }

    /// Reasons to stop that are known before a step.
    pub(super) fn done_before_step(&self) -> Option<Verdict> {
        let stop = |status, text: String| Some(Verdict::Stop(status, text));
        let steps = self.pace.step - self.pace.first_step;
        if steps >= self.options.max_steps {
            return stop(
                Status::StepLimit,
                format!("Stopped at the step limit of {steps} steps"),
            );
        }
        if self.options.goal == Goal::Smooth && steps >= self.options.smooth_steps {
            return stop(Status::Converged, format!("Smoothed in {steps} steps"));
        }
        None
    }

    pub(super) fn stuck_verdict(&self) -> Verdict {
        let steps = self.pace.step;
        let norm = self.problem.gradient_norm(&self.evaluation.gradient);
        if steps == 0 && norm * self.problem.h > FLAT {
            let why = "Stalled at the start: no step decreases the energy (many angles are exactly 0); \
                       a larger angle smoothing or the harmonic pre-fill helps";
            return Verdict::Stop(Status::Stalled, why.into());
        }
        let why = format!("Converged after {steps} steps: no smaller energy along any step");
        Verdict::Stop(Status::Converged, why)
    }

    /// Reasons to stop that a step brings about; also decides on sharpening.
    pub(super) fn verdict(
        &mut self,
        survey: &Survey,
        before: f64,
        after: f64,
        report: &mut StepReport,
    ) -> Verdict {
        let steps = self.pace.step;
        if self.options.goal == Goal::Relax
            && report.energy.abs() < FLOOR_PER_VERTEX * self.problem.energy.n_counted() as f64
        {
            let why = format!("Converged after {steps} steps: the energy is zero up to roundoff");
            return Verdict::Stop(Status::Converged, why);
        }
        if let Some((face, worst)) = survey.worst {
            let degenerated = worst < WORST_QUALITY && worst < 0.1 * self.start_quality;
            if degenerated && self.options.scheme == Scheme::Auto {
                let why = format!(
                    "Stopped after {steps} steps: triangle {} has degenerated; \
                     a neck may be pinching off or a bubble forming. Go back a few steps.",
                    face.0
                );
                return Verdict::Stop(Status::Stalled, why);
            }
        }
        self.warn(report);
        if self.options.scheme == Scheme::Auto && self.options.goal == Goal::Relax {
            if self.pace.schedule.should_sharpen(before, after) && self.pace.schedule.sharpen() {
                self.pace.progress.restart();
            }
            let is_idle = self.pace.progress.is_idle(before, after);
            if is_idle && self.pace.schedule.retreat(self.tau()) {
                self.reset_step_size();
            } else if is_idle && !self.pace.schedule.sharpen() {
                let why = format!("Converged after {steps} steps: the energy no longer falls");
                return Verdict::Stop(Status::Converged, why);
            }
        }
        self.done_before_step().unwrap_or(Verdict::GoOn)
    }

    /// What the energy cannot tell: it has no barrier against pinched handles, bubbles and
    /// bad triangles. Each is told once a run.
    fn warn(&mut self, report: &mut StepReport) {
        if report.flipped_faces > 0 {
            let count = counted(report.flipped_faces, "face", "faces");
            report
                .warnings
                .push(format!("{count} folded over in this step."));
        }
        let warned = &mut self.pace.warned;
        if report.energy < PINCHED * self.smooth_minimum && !warned.pinch {
            warned.pinch = true;
            report.warnings.push(
                "The energy is below that of every smooth surface with these handles: a handle \
                 is pinching off between coarse triangles."
                    .into(),
            );
        }
        if report.area > BUBBLE * self.start_area && !warned.bubble {
            warned.bubble = true;
            report.warnings.push(
                "The area has grown several times over: a bubble, round and thus cheap, may be \
                 forming. From a rough start, smooth a little first."
                    .into(),
            );
        }
    }
}

/// W of the best smooth surface with the same handles: at least 4π² for each closed
/// component that has any (Marques & Neves; W/2 ≥ 2π²), 0 otherwise.
pub(super) fn smooth_minimum(mesh: &HalfedgeMesh) -> f64 {
    if !mesh.is_closed() || !mesh.is_oriented() {
        return 0.0;
    }
    let (component, count) = mesh.components();
    let mut characteristic = vec![0i64; count];
    for v in mesh.vertices() {
        characteristic[component[v.index()] as usize] += 1;
    }
    for e in mesh.edges() {
        characteristic[component[mesh.ends(e)[0].index()] as usize] -= 1;
    }
    for f in mesh.faces() {
        characteristic[component[mesh.triangle(f)[0].index()] as usize] += 1;
    }
    4.0 * PI * PI * characteristic.iter().filter(|&&c| c <= 0).count() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn handles_have_a_smooth_minimum() {
        let of = |name: &str| {
            let sample = shape::make(name, &[]).expect("a shape");
            smooth_minimum(&build(&sample.soup).expect("a surface").mesh)
        };
        let one = 4.0 * PI * PI;
        for (name, expected) in [
            ("icosphere", 0.0),
            ("torus", one),
            ("double-torus", one),
            ("klein-bottle", 0.0),
            ("pipe", 0.0),
        ] {
            assert_eq!(of(name), expected, "{name}");
        }
    }
}
