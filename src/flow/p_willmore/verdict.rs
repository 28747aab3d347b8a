//! What a step is reported as, and whether there is a next one.

use super::PWillmoreFlow;
use super::step::{Accepted, Cost};
use crate::flow::options::Scheme;
use crate::flow::stop::Verdict;
use crate::flow::{Multipliers, Status, StepReport};
use crate::geometry::survey::survey;
use crate::geometry::{measure, quality};
use crate::mesh::counted;
use crate::remesh::{Mode, Regulariser};
use glam::DVec3;
use std::f64::consts::PI;

/// The run has converged once the energy has fallen by less than this share …
const NEGLIGIBLE: f64 = 1e-5;
/// … over so many accepted steps.
const WINDOW: usize = 10;
/// W² of a sphere and of the Clifford torus are least among closed surfaces without and
/// with handles (Willmore; Marques & Neves). Coarse meshes come to 1.8 % below; more than
/// this is a mesh that cheats.
const IMPOSSIBLE: f64 = 0.03;
/// |Y|h from which a mesh no longer resolves its surface, and from which, with τ falling,
/// the surface is about to become singular.
const UNDER_RESOLVED: f64 = 3.0;
const SINGULAR: f64 = 8.0;

/// Where no step is accepted, a last gain below this share was the last there was to have.
const AT_REST: f64 = 1e-6;
/// With so many trials refused in those steps the energy has not come to rest, it is stuck.
const STUCK: usize = 8;
/// A smallest angle below this, in degrees, that was much larger at the start is a mesh
/// that degenerates.
const SLIVER: f64 = 25.0;
/// The same where regularisation sees to it that it need not get worse.
const SHARP: f64 = 8.0;

/// With faces of so many times the mean, and four times what there was at the start, the
/// surface's curvature sits in a few tiny faces and the rest is not resolved; with so many
/// more there is no sense in going on.
const COARSE_FACE: f64 = 40.0;
const HOPELESS_FACE: f64 = 200.0;

/// The last few energies, and how many trials were refused on the way.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Window {
    energies: [f64; WINDOW + 1],
    refused: [usize; WINDOW],
    count: usize,
    largest_dt: f64,
}

/// Steps that have shrunk to this share of the largest before them lead nowhere.
const VANISHING: f64 = 1e-3;

impl Window {
    fn is_stuck(&self, dt: f64) -> bool {
        self.refused.iter().sum::<usize>() >= STUCK || dt < VANISHING * self.largest_dt
    }

    /// Whether the last step gained nothing worth speaking of.
    fn is_at_rest(&self) -> bool {
        let [.., before, last] = self.energies;
        self.count > 1 && before - last < AT_REST * last.abs()
    }

    /// Notes an energy; whether it has stopped falling.
    fn is_idle(&mut self, energy: f64, dt: f64, refused: usize) -> bool {
        self.largest_dt = self.largest_dt.max(dt);
        self.refused.rotate_left(1);
        self.refused[WINDOW - 1] = refused;
        self.energies.rotate_left(1);
        self.energies[WINDOW] = energy;
        self.count += 1;
        let drop = self.energies[0] - energy;
        self.count > WINDOW && drop < NEGLIGIBLE * energy.abs()
    }
}

/// Warnings already given in a run.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Warned {
    impossible: bool,
    coarse: bool,
    slivers: bool,
    iterative: bool,
    growth: bool,
}

impl PWillmoreFlow {
    pub(super) fn done_before_step(&self) -> Option<Verdict> {
        let steps = self.pace.step - self.pace.first_step;
        (steps >= self.options.max_steps).then(|| {
            let why = format!("Stopped at the step limit of {steps} steps");
            Verdict::Stop(Status::StepLimit, why)
        })
    }

    /// No trial was accepted.
    pub(super) fn stuck_verdict(&self, cost: &Cost) -> Verdict {
        if self.pace.stop.is_at_rest() {
            let steps = self.pace.step;
            let why = format!("Converged after {steps} steps: no smaller energy along any step");
            return Verdict::Stop(Status::Converged, why);
        }
        let last = cost
            .refusal
            .map(|refusal| format!(", the last because {}", refusal.cause));
        let why = format!(
            "Stalled after {} steps: every step tried was refused{}; {}",
            self.pace.step,
            last.unwrap_or_default(),
            self.remedy()
        );
        Verdict::Stop(Status::Stalled, why)
    }

    /// Takes over an accepted step: report, warnings, verdict.
    pub(super) fn conclude(
        &mut self,
        x: &mut Vec<DVec3>,
        accepted: Accepted,
        cost: Cost,
    ) -> (StepReport, Verdict) {
        self.tell("finish", 0.9);
        let before = self.evaluation.integrals.objective;
        let survey = self
            .mesh
            .is_triangular()
            .then(|| survey(&self.mesh, x, &accepted.x));
        self.flipped = match &survey {
            Some(survey) => survey
                .turned
                .iter()
                .filter(|&&f| quality::is_folded(&self.mesh, &accepted.x, f))
                .map(|f| f.0)
                .collect(),
            None => Vec::new(),
        };
        *x = accepted.x;
        self.pace.time += accepted.dt;
        self.pace.step += 1;
        self.is_evaluated = false;
        self.evaluate(x);
        let integrals = self.evaluation.integrals;
        let scale = 2f64.powf(self.options.p);
        let moved = x
            .iter()
            .zip(&self.start)
            .map(|(p, q)| p.distance_squared(*q));
        let mut multipliers = accepted.multipliers.iter().map(|m| m / scale);
        // At rest ∇J = λ_A ∇A + λ_V ∇V.
        let tension = self.pace.area.and_then(|_| multipliers.next());
        let tension = tension.map(|m| -m);
        let pressure = self.pace.volume.and_then(|_| multipliers.next());
        let mut report = StepReport {
            step: self.pace.step,
            time: self.pace.time,
            dt: accepted.dt,
            energy: self.functional.reading(&integrals),
            energy_normalised: self.normalised(&integrals),
            objective_before: before,
            objective: integrals.objective,
            gradient_norm: self.residual(&accepted.multipliers),
            area: integrals.area,
            volume: Some(integrals.volume),
            min_angle_degrees: measure::min_angle_degrees(&self.mesh, x),
            rejected: cost.rejected,
            iterations: cost.iterations,
            tau: accepted.dt / self.time_scale(),
            negative_pivots: cost.negative_pivots,
            flipped_faces: self.flipped.len(),
            max_displacement: moved.fold(0.0, f64::max).sqrt() / self.h,
            assemble_milliseconds: cost.assemble * 1e3,
            factor_milliseconds: cost.factor * 1e3,
            solve_milliseconds: cost.solve * 1e3,
            multipliers: Some(Multipliers { tension, pressure }),
            reduced_volume: Some(integrals.volume.abs() / super::ball_volume(integrals.area)),
            warnings: cost.warnings,
            ..StepReport::default()
        };
        let largest = self.element_range(x).1;
        self.warn(&mut report, largest);
        let verdict = self.verdict(&report, largest, accepted.is_ramping);
        (report, verdict)
    }

    fn verdict(&mut self, report: &StepReport, largest: f64, is_ramping: bool) -> Verdict {
        let steps = self.pace.step;
        if largest > HOPELESS_FACE.max(4.0 * self.start_face) && self.options.scheme == Scheme::Auto
        {
            let why = format!(
                "Stopped after {steps} steps: the largest face is {largest:.0} times the mean, and \
                 the mesh no longer resolves the surface. Go back a few steps; a finer mesh helps"
            );
            return Verdict::Stop(Status::Stalled, why);
        }
        if is_ramping {
            // A window that spans the ramp would see a fall that is none.
            self.pace.stop = Window::default();
        } else if self
            .pace
            .stop
            .is_idle(report.objective, report.dt, report.rejected)
        {
            return if self.pace.stop.is_stuck(report.dt) {
                let why = format!(
                    "Stalled after {steps} steps: only ever smaller steps lower the energy, \
                     which is not at rest; {}",
                    self.remedy()
                );
                Verdict::Stop(Status::Stalled, why)
            } else {
                let why = format!("Converged after {steps} steps: the energy no longer falls");
                Verdict::Stop(Status::Converged, why)
            };
        }
        self.done_before_step().unwrap_or(Verdict::GoOn)
    }

    /// What helps a run that is stuck.
    fn remedy(&self) -> &'static str {
        if self.mode() == Mode::Off {
            "conformal regularisation or a finer mesh helps"
        } else if self.options.p < 2.0 {
            "where it thins out the surface becomes singular; keeping the volume prevents that"
        } else if self.options.p > 2.0 {
            "smooth with p = 2 first, or use a finer mesh"
        } else {
            "a finer mesh helps"
        }
    }

    /// What the energy cannot tell; each is told once a run.
    fn warn(&mut self, report: &mut StepReport, largest: f64) {
        if report.flipped_faces > 0 {
            let count = counted(report.flipped_faces, "face", "faces");
            report
                .warnings
                .push(format!("{count} folded over in this step."));
        }
        let is_iterative = self.system.is_iterative()
            || self
                .regulariser
                .as_ref()
                .is_some_and(Regulariser::is_iterative);
        if is_iterative && !self.pace.warned.iterative {
            self.pace.warned.iterative = true;
            report.warnings.push(
                "The mesh is too large to factor its matrices in memory: they are solved \
                 iteratively, and steps take longer."
                    .into(),
            );
        }
        if largest > COARSE_FACE.max(4.0 * self.start_face) && !self.pace.warned.growth {
            self.pace.warned.growth = true;
            report.warnings.push(format!(
                "The largest face has grown to {largest:.0} times the mean: one part of the surface \
                 inflates, and the energy shown is too low. A finer mesh helps."
            ));
        }
        let angle = report.min_angle_degrees;
        let tolerated = if self.mode() == Mode::Off {
            SLIVER
        } else {
            SHARP
        };
        let degenerates = angle < tolerated && angle < 0.6 * self.start_angle;
        if degenerates && !self.pace.warned.slivers {
            self.pace.warned.slivers = true;
            report.warnings.push(format!(
                "The mesh degenerates: its smallest angle is {angle:.0}°, {:.0}° at the start; {}.",
                self.start_angle,
                self.remedy()
            ));
        }
        let handles = self.mesh.genus().unwrap_or_default() > 0;
        let least = if handles { 2.0 * PI * PI } else { 4.0 * PI };
        let bending = self.evaluation.integrals.energy / 4.0;
        let cheats = self.options.p == 2.0 && bending < (1.0 - IMPOSSIBLE) * least;
        if cheats && !self.pace.warned.impossible {
            self.pace.warned.impossible = true;
            report.warnings.push(
                "∫H² is below that of every smooth surface with these handles: the mesh no \
                 longer resolves the surface."
                    .into(),
            );
        }
        let curvatures = self.evaluation.curvature.iter().zip(&self.evaluation.mass);
        let (at, sharpest) = curvatures
            .map(|(y, m)| y.length() * m.sqrt())
            .enumerate()
            .fold(
                (0, 0.0),
                |best, (i, y)| if y > best.1 { (i, y) } else { best },
            );
        if sharpest > UNDER_RESOLVED && !self.pace.warned.coarse {
            self.pace.warned.coarse = true;
            let what = if sharpest > SINGULAR {
                "the surface is about to become singular, as a neck that pinches off"
            } else {
                "edges are too long for the curvature"
            };
            report
                .warnings
                .push(format!("At vertex {at} {what}: use a finer mesh."));
        }
    }
}
