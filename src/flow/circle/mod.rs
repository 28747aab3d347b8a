//! Bobenko & Schröder's discrete Willmore flow: gradient flow of the circle-angle
//! energy W (Section 4 of the paper).
//!
//! The semi-implicit step solves (M/dt + K) Δx = −∇E with one scalar matrix for the
//! three coordinates. Two schemes share it: the recommended one smooths the angles,
//! projects K star by star and accepts only descent; the paper's takes constant steps
//! with the exact energy and the plain K. Other integrators reuse the same parts.

mod backward_euler;
mod direction;
mod lbfgs;
mod problem;
mod schedule;
mod verdict;

use super::options::{FlowOptions, Goal, Integrator, MassChoice, Scheme};
use super::step_size::StepSize;
use super::stop::{Progress, Verdict};
use super::{Flow, FlowError, Progress as Callback, Refusal, StepReport, boundary, prefill};
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{CircleEnergy, Evaluation};
use crate::geometry::survey::survey;
use crate::geometry::{measure, quality};
use crate::mesh::{Face, HalfedgeMesh};
use glam::DVec3;
use problem::{Cost, Problem};
use schedule::EpsilonSchedule;
use std::rc::Rc;
use web_time::Instant;

/// The flow on one mesh with one set of options.
pub struct CircleFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    problem: Problem,
    start: Vec<DVec3>,
    start_quality: f64,
    start_area: f64,
    /// W below which a handle must be pinching.
    smooth_minimum: f64,
    pace: Pace,
    /// Energy, gradient and weights at the current positions, under `evaluated` ε.
    evaluation: Evaluation,
    evaluated: Option<Smoothing>,
    /// The same at a trial, kept from one to the next.
    trial: Evaluation,
    lbfgs: lbfgs::Memory,
    newton: Option<backward_euler::NewtonSystem>,
    flipped: Vec<u32>,
    refusal: Option<Refusal>,
    on_progress: Option<Callback>,
}

/// The small state that a step back restores along with the positions.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    step_size: StepSize,
    schedule: EpsilonSchedule,
    progress: Progress,
    time: f64,
    step: usize,
    /// The step the budget counts from.
    first_step: usize,
    warned: verdict::Warned,
}

/// A trial that was accepted.
struct Accepted {
    x: Vec<DVec3>,
    objective: f64,
    dt: f64,
    rejected: usize,
    /// Whether `trial` was evaluated there.
    is_evaluated: bool,
}

/// What an integrator made of a step.
enum Outcome {
    Accepted(Accepted),
    /// No step that decreases the objective is left.
    Stuck,
}

impl CircleFlow {
    /// Prepares the flow at positions `x`, which a harmonic pre-fill may change.
    ///
    /// # Errors
    /// See [`FlowError`].
    pub fn new(
        mesh: Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: FlowOptions,
    ) -> Result<Self, FlowError> {
        options.check()?;
        check_mesh(&mesh, x)?;
        let free = boundary::free_vertices(
            &mesh,
            options.boundary.unwrap_or_default(),
            options.free.as_deref(),
            options.fixed.as_deref(),
        )?;
        let h = measure::mean_edge_length(&mesh, x);
        if options.prefill {
            prefill::harmonic(&mesh, &free, x)?;
        }
        let energy = CircleEnergy::new(&mesh, options.boundary.unwrap_or_default());
        let problem = Problem::new(energy, &free, x, h)?;
        let dt = options.dt.unwrap_or_else(|| options.first_tau() * h * h);
        let adaptive = options.scheme == Scheme::Auto && options.goal == Goal::Relax;
        let pace = Pace {
            step_size: if adaptive {
                StepSize::adaptive(dt, h)
            } else {
                StepSize::constant(dt)
            },
            schedule: EpsilonSchedule::new(&options),
            progress: Progress::default(),
            time: 0.0,
            step: 0,
            first_step: 0,
            warned: verdict::Warned::default(),
        };
        let start_area = measure::area(&mesh, x);
        let smooth_minimum = verdict::smooth_minimum(&mesh);
        let start_quality = quality::worst_triangle(&mesh, x).map_or(0.0, |(_, q)| q);
        Ok(Self {
            mesh,
            options,
            problem,
            start: x.to_vec(),
            start_quality,
            start_area,
            smooth_minimum,
            pace,
            evaluation: Evaluation::default(),
            evaluated: None,
            trial: Evaluation::default(),
            lbfgs: lbfgs::Memory::default(),
            newton: None,
            flipped: Vec::new(),
            refusal: None,
            on_progress: None,
        })
    }

    fn tell(&self, stage: &str, share: f64) {
        if let Some(callback) = &self.on_progress {
            callback(stage, share);
        }
    }

    fn evaluate(&mut self, x: &[DVec3], smoothing: Smoothing) {
        if self.evaluated != Some(smoothing) {
            self.problem
                .energy
                .evaluate(x, smoothing, &mut self.evaluation);
            self.evaluated = Some(smoothing);
        }
    }

    /// Picks ε for this step and evaluates there.
    fn choose_smoothing(&mut self, x: &[DVec3]) -> Smoothing {
        self.evaluate(x, self.pace.schedule.current());
        let energy = self.evaluation.exact;
        if self.pace.schedule.adapt(energy, self.n_free()) {
            self.pace.progress.restart();
        }
        let smoothing = self.pace.schedule.current();
        self.evaluate(x, smoothing);
        smoothing
    }

    /// One step of the chosen integrator from `x`, where `evaluation` holds.
    fn advance(
        &mut self,
        x: &[DVec3],
        smoothing: Smoothing,
        cost: &mut Cost,
    ) -> Result<Outcome, FlowError> {
        match (self.options.integrator, self.options.scheme) {
            (Integrator::SemiImplicit, Scheme::Auto) => self.semi_implicit(x, smoothing, cost),
            (Integrator::SemiImplicit, Scheme::Paper) => self.paper_step(x, cost),
            (Integrator::ForwardEuler, _) => self.forward_euler(x, smoothing),
            (Integrator::BackwardEuler, _) => self.backward_euler(x, smoothing, cost),
            (Integrator::Lbfgs, _) => self.lbfgs_step(x, smoothing, cost),
        }
    }

    fn is_area_mass(&self) -> bool {
        match (self.options.mass, self.options.scheme, self.options.goal) {
            (MassChoice::Uniform, ..) | (_, Scheme::Paper, _) => false,
            (MassChoice::Area, ..) => true,
            (MassChoice::Auto, _, goal) => goal == Goal::Smooth,
        }
    }

    fn reset_step_size(&mut self) {
        let h = self.problem.h;
        let dt = self
            .options
            .dt
            .unwrap_or_else(|| self.options.first_tau() * h * h);
        self.pace.step_size.dt = dt;
        self.pace.progress.restart();
    }
}

impl Flow for CircleFlow {
    fn step(&mut self, x: &mut Vec<DVec3>) -> Result<(Option<StepReport>, Verdict), FlowError> {
        let start = Instant::now();
        let mut cost = Cost::default();
        self.refusal = None;
        let before;
        let mut accepted = loop {
            self.tell("assemble", 0.0);
            let watch = Instant::now();
            let smoothing = self.choose_smoothing(x);
            cost.assemble += watch.elapsed().as_secs_f64();
            if !self.evaluation.value.is_finite() {
                return Err(FlowError::NonFiniteEnergy {
                    step: self.pace.step + 1,
                });
            }
            if let Some(verdict) = self.done_before_step() {
                return Ok((None, verdict));
            }
            match self.advance(x, smoothing, &mut cost)? {
                Outcome::Accepted(accepted) => {
                    before = self.evaluation.value;
                    break accepted;
                }
                Outcome::Stuck => {
                    let tau = self.tau();
                    let schedule = &mut self.pace.schedule;
                    if !schedule.retreat(tau) && !schedule.sharpen() {
                        return Ok((None, self.stuck_verdict()));
                    }
                    self.reset_step_size();
                }
            }
        };
        let smoothing = self.pace.schedule.current();
        let survey = survey(&self.mesh, x, &accepted.x);
        let folded = |f: &&Face| quality::is_folded(&self.mesh, &accepted.x, **f);
        self.flipped = survey.turned.iter().filter(folded).map(|f| f.0).collect();
        *x = std::mem::take(&mut accepted.x);
        self.pace.time += accepted.dt;
        self.pace.step += 1;
        self.tell("finish", 0.9);
        let watch = Instant::now();
        self.evaluated = None;
        if accepted.is_evaluated {
            std::mem::swap(&mut self.evaluation, &mut self.trial);
            self.evaluated = Some(smoothing);
        }
        self.evaluate(x, smoothing);
        cost.assemble += watch.elapsed().as_secs_f64();
        let mut report = self.report(x, &survey, &accepted, before, cost);
        let verdict = self.verdict(&survey, before, accepted.objective, &mut report);
        report.milliseconds = start.elapsed().as_secs_f64() * 1e3;
        Ok((Some(report), verdict))
    }

    fn reading(&mut self, x: &[DVec3]) -> super::Reading {
        self.evaluated = None;
        self.evaluate(x, Smoothing::EXACT);
        let energy = self.evaluation.value;
        super::Reading {
            energy,
            energy_normalised: 0.5 * energy,
            gradient_norm: self.problem.gradient_norm(&self.evaluation.gradient),
            area: measure::area(&self.mesh, x),
            volume: measure::volume(&self.mesh, x),
            reduced_volume: None,
        }
    }

    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        let mut at = Evaluation::default();
        self.problem.energy.evaluate(x, Smoothing::EXACT, &mut at);
        at.gradient
    }

    fn set_progress(&mut self, callback: Option<Callback>) {
        self.on_progress = callback;
    }

    fn mean_edge_length(&self) -> f64 {
        self.problem.h
    }

    fn n_free(&self) -> usize {
        self.problem.vertex_of_row.len()
    }

    fn is_free(&self, v: usize) -> bool {
        self.problem.matrix.row_of_vertex()[v] != u32::MAX
    }

    fn dt(&self) -> f64 {
        self.pace.step_size.dt
    }

    fn tau(&self) -> f64 {
        self.dt() / (self.problem.h * self.problem.h)
    }

    fn flipped_faces(&self) -> &[u32] {
        &self.flipped
    }

    fn refusal(&self) -> Option<Refusal> {
        self.refusal
    }

    fn pace(&self) -> super::Pace {
        super::Pace::Circle(self.pace)
    }

    fn set_pace(&mut self, pace: super::Pace) {
        if let super::Pace::Circle(pace) = pace {
            self.pace = pace;
        }
        self.evaluated = None;
        self.lbfgs = lbfgs::Memory::default();
        self.flipped.clear();
        self.refusal = None;
    }

    fn set_clock(&mut self, step: usize, time: f64) {
        let pace = Pace {
            step,
            time,
            ..self.pace
        };
        self.set_pace(super::Pace::Circle(pace));
    }

    fn extend_budget(&mut self) {
        self.pace.first_step = self.pace.step;
        self.pace.progress.restart();
    }
}

/// The flow's preconditions on a mesh.
fn check_mesh(mesh: &HalfedgeMesh, x: &[DVec3]) -> Result<(), FlowError> {
    for f in mesh.faces() {
        let corners = mesh.face_vertices(f).count();
        if corners != 3 {
            return Err(FlowError::NotTriangular { face: f.0, corners });
        }
    }
    let shortest = 1e-12 * measure::bounding_diagonal(x);
    let collapsed = || {
        mesh.edges()
            .filter(|&e| measure::edge_length(mesh, x, e) <= shortest)
    };
    if let Some(e) = collapsed().next() {
        let [a, b] = mesh.ends(e);
        return Err(FlowError::ZeroLengthEdge {
            a: a.0,
            b: b.0,
            others: collapsed().count() - 1,
        });
    }
    Ok(())
}
