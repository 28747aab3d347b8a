//! What a step is reported as, and whether there is a next one.

use super::curvatures::Curvatures;
use super::law::Law;
use super::{CurvatureFlow, RUNG_REST, Update};
use crate::flow::options::Scheme;
use crate::flow::stop::Verdict;
use crate::flow::{Status, StepReport};
use crate::geometry::quality;
use crate::geometry::survey::survey;
use crate::mesh::counted;
use glam::DVec3;

/// The run has converged once no vertex is to move by more than this share of an edge.
const AT_REST: f64 = 1e-6;
/// A residual of the linear system above this is worth a warning.
const INACCURATE: f64 = 1e-4;

/// Warnings already given in a run.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Warned {
    margin: bool,
    iterative: bool,
    inaccurate: bool,
}

impl CurvatureFlow {
    pub(super) fn done_before_step(&self) -> Option<Verdict> {
        let steps = self.pace.step - self.pace.first_step;
        (steps >= self.options.max_steps).then(|| {
            let advice = match self.law {
                Law::CurvatureVariation => {
                    "; from a rough start a smooth pre-fill or steps of surface diffusion help"
                }
                _ => "",
            };
            let why = format!("Stopped at the step limit of {steps} steps{advice}");
            Verdict::Stop(Status::StepLimit, why)
        })
    }

    /// Takes a step over: report, warnings, verdict.
    pub(super) fn conclude(
        &mut self,
        x: &mut Vec<DVec3>,
        y: Vec<DVec3>,
        update: &Update,
        share: f64,
        next: Curvatures,
        before: f64,
    ) -> (StepReport, Verdict) {
        self.tell("finish", 0.9);
        let law = self.present_law();
        let survey = survey(&self.mesh, x, &y);
        let turned = survey.turned.iter();
        self.flipped = turned
            .filter(|&&f| quality::is_folded(&self.mesh, &y, f))
            .map(|f| f.0)
            .collect();
        *x = y;
        let taken = share * update.dt;
        self.pace.step += 1;
        self.pace.time += taken;
        let energy = self.law.energy(&next, survey.area);
        let moved = x.iter().zip(&self.start);
        let moved = moved.map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
        let quality = update.quality;
        let unit = self.region.length.powi(law.order());
        let mut report = StepReport {
            step: self.pace.step,
            time: self.pace.time,
            dt: taken,
            energy,
            energy_normalised: self.law.normalised(energy, self.region.length),
            objective_before: before,
            objective: law.energy(&next, survey.area),
            gradient_norm: self.speed(&next),
            area: survey.area,
            volume: survey.volume,
            min_angle_degrees: survey.min_angle_degrees,
            iterations: quality.iterations,
            tau: taken / unit,
            flipped_faces: self.flipped.len(),
            max_displacement: moved / self.region.h,
            update: Some(update.size),
            linear_residual: Some(quality.residual),
            assemble_milliseconds: quality.assemble * 1e3,
            factor_milliseconds: quality.factor * 1e3,
            solve_milliseconds: quality.solve * 1e3,
            ..StepReport::default()
        };
        self.curvatures = Some(next);
        self.warn(&mut report, quality.is_iterative);
        (report, self.verdict(update.size))
    }

    fn verdict(&mut self, size: f64) -> Verdict {
        if self.pace.rungs > 0 {
            self.pace.rungs -= 1;
            if size < RUNG_REST {
                self.pace.rungs = 0;
            }
            return self.done_before_step().unwrap_or(Verdict::GoOn);
        }
        self.pace.own_steps += 1;
        if size < AT_REST {
            let steps = self.pace.step;
            let why = format!("Converged after {steps} steps: no vertex moves any more");
            return Verdict::Stop(Status::Converged, why);
        }
        self.done_before_step().unwrap_or(Verdict::GoOn)
    }

    /// What the reading cannot tell; each is told once a run but for folded faces.
    fn warn(&mut self, report: &mut StepReport, is_iterative: bool) {
        let depth = self.law.depth();
        let warned = &mut self.pace.warned;
        let warnings = &mut report.warnings;
        // The boundary of the patch and `depth` rings outside it carry the derivatives.
        if depth > 0 && self.region.margin <= depth && !warned.margin {
            warned.margin = true;
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
        if is_iterative && !warned.iterative {
            warned.iterative = true;
            warnings.push(
                "The patch is too large to factor its matrix in memory: it is solved iteratively, \
                 and steps take longer."
                    .into(),
            );
        }
        let residual = report.linear_residual.unwrap_or_default();
        if residual > INACCURATE && !warned.inaccurate {
            warned.inaccurate = true;
            warnings.push(format!(
                "The linear system was solved to a residual of {residual:.0e} only."
            ));
        }
        if report.flipped_faces > 0 {
            let count = counted(report.flipped_faces, "face", "faces");
            let advice = match self.options.scheme {
                Scheme::Auto => "",
                Scheme::Paper => " The recommended scheme limits how far vertices move.",
            };
            warnings.push(format!("{count} folded over in this step.{advice}"));
        }
    }
}
