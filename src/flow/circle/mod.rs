//! Bobenko & Schröder's discrete Willmore flow: gradient flow of the circle-angle energy W
//! (Section 4 of [BS05](crate::bibliography#bs05)).
//!
//! The semi-implicit step solves
//!
//! ```math
//! \Bigl( \frac{M}{dt} + K \Bigr) \Delta x = -\nabla E
//! ```
//!
//! with one scalar matrix for the three coordinates. Two schemes share it: the recommended one
//! smooths the angles, projects K star by star and accepts only descent; the paper's takes constant
//! steps with the exact energy and the plain K. Other integrators reuse the same parts.
//!
//! What must not rise is
//!
//! ```math
//! U_\epsilon = \sum 2 \sqrt{\beta^2 + \epsilon^2} - 2 \pi N.
//! ```
//!
//! It has the gradient of the smoothed energy W_ε = U_ε − 2εE, lies above W and meets it at ε = 0,
//! and falls when ε is made smaller. W itself, which is what people see, may rise by the angles
//! that a step opens, but not from where a run has passed to its end.

mod backward_euler;
mod direction;
mod lbfgs;
mod least;
mod problem;
mod schedule;
mod warning;

use super::bounds::lower_bounds;
use super::options::{FlowOptions, Goal, Integrator, MassChoice, Scheme};
use super::rules::{Ceiling, Folds};
use super::step_size::StepSize;
use super::warning::WarningsGiven;
use super::{
    Advice, Cause, Cost, Flow, FlowError, Functional, Monitored, Move, Occasion, Phase, Proposal,
    Reading, Refusal, Rules, StepReport, Warning, boundary, prefill,
};
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{CircleEnergy, Evaluation};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use problem::Problem;
use schedule::{Schedule, Stage};
use std::rc::Rc;

/// Energy per vertex below which nothing but roundoff is left.
const FLOOR_PER_VERTEX: f64 = 1e-12;
/// Energy per vertex of a surface that is round to all eyes.
const ROUND_PER_VERTEX: f64 = 1e-6;
/// Roundoff of the energy per vertex: no decrease smaller than it can be seen.
const ROUNDOFF_PER_VERTEX: f64 = 1e-15;
/// Share of the smooth minimum that no healthy mesh goes below: aligned lattices come to
/// 0.98 of it on 16 × 16 vertices.
const LEAST: f64 = 0.95;
/// Smallest angle, in degrees, that a step may leave: a surface under way to its rest may have
/// slivers for a while.
const LEAST_ANGLE: f64 = 1.0;
/// W as printed may jump up by this share of itself in a step whose smoothed energy falls …
const JUMP: f64 = 0.05;
/// The first τ near a sphere, where the step is nearly one of Newton's method.
const FIRST_TAU_NEAR_SPHERE: f64 = 64.0;
/// At rest a step of this τ would lower the energy …
const REFERENCE_TAU: f64 = 1.0;
/// … by this share of it at most, with angles smoothed by this ε: at the tip of a cone the
/// exact gradient says nothing of rest.
const AT_REST: f64 = 1e-4;
const REST_EPSILON: f64 = 0.003;

/// The flow on one mesh with one set of options.
pub struct CircleFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    problem: Problem,
    /// Half the area at the start is held by this share of the faces.
    start_balance: f64,
    start_area: f64,
    /// ∫H² there, where it is watched.
    start_bend: f64,
    /// W of the best smooth surface with the same handles.
    smooth_minimum: f64,
    schedule: Schedule,
    /// Whether the last move was taken whole.
    was_whole: bool,
    /// Energy, gradient and weights at the current positions, under `evaluated` ε.
    evaluation: Evaluation,
    evaluated: Option<Smoothing>,
    /// Whether K was assembled there.
    is_assembled: bool,
    /// The same at a trial, kept from one to the next.
    trial: Evaluation,
    /// Where W was least.
    passed: least::Passed,
    quasi_newton: lbfgs::QuasiNewton,
    newton: Option<backward_euler::NewtonSystem>,
}

/// What the flow must remember beside the positions.
#[derive(Clone, Debug)]
pub struct Memory(Schedule, Option<least::Surface>);

/// What a step may change beside that.
pub struct Learnt {
    memory: Memory,
    model: lbfgs::Model,
}

impl CircleFlow {
    /// Prepares the flow at positions `x`, which a harmonic pre-fill may change.
    ///
    /// # Errors
    /// See [`FlowError`].
    pub fn new(
        mesh: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: &FlowOptions,
    ) -> Result<Self, FlowError> {
        check_mesh(mesh, x)?;
        let free = boundary::free_vertices(
            mesh,
            options.boundary(),
            options.free.as_deref(),
            options.fixed.as_deref(),
        )?;
        let h = measure::mean_edge_length(mesh, x);
        if options.prefill {
            prefill::harmonic(mesh, &free, x)?;
        }
        let energy = CircleEnergy::new(mesh, options.boundary());
        let n_free = free.iter().filter(|is_free| **is_free).count();
        let bounds = lower_bounds(mesh);
        let is_sphere = bounds.is_some_and(|bounds| bounds.circle == 0.0);
        let schedule = Schedule::new(options, &energy, x, n_free, is_sphere);
        Ok(Self {
            mesh: Rc::clone(mesh),
            options: options.clone(),
            problem: Problem::new(mesh, energy, &free, x, h)?,
            start_balance: warning::balance(mesh, x),
            start_area: measure::area(mesh, x),
            start_bend: match options.goal {
                Goal::Smooth => warning::bend(mesh, x),
                Goal::Relax => 0.0,
            },
            smooth_minimum: bounds.map_or(0.0, |bounds| bounds.circle),
            schedule,
            was_whole: false,
            evaluation: Evaluation::default(),
            evaluated: None,
            is_assembled: false,
            trial: Evaluation::default(),
            passed: least::Passed::default(),
            quasi_newton: lbfgs::QuasiNewton::default(),
            newton: None,
        })
    }

    /// U_ε of an evaluation under the present ε.
    fn monitored_value(&self, at: &Evaluation) -> f64 {
        let epsilon = self.schedule.smoothing().epsilon;
        at.value + epsilon * self.problem.energy.angle_count()
    }

    fn forget(&mut self) {
        self.evaluated = None;
        self.is_assembled = false;
    }

    fn evaluate_at(&mut self, x: &[DVec3], smoothing: Smoothing) {
        if self.evaluated != Some(smoothing) {
            let energy = &self.problem.energy;
            energy.evaluate(x, smoothing, &mut self.evaluation);
            self.evaluated = Some(smoothing);
            self.is_assembled = false;
        }
    }

    fn is_paper(&self) -> bool {
        self.options.scheme == Scheme::Paper
    }

    fn is_area_mass(&self) -> bool {
        match (self.options.mass, self.options.scheme, self.options.goal) {
            (MassChoice::Uniform, ..) | (_, Scheme::Paper, _) => false,
            (MassChoice::Area, ..) => true,
            (MassChoice::Auto, _, goal) => goal == Goal::Smooth,
        }
    }

    fn nearly_spherical(&self) -> f64 {
        schedule::nearly_spherical(self.n_free())
    }

    /// An energy so small that gains are not worth comparing with it.
    fn round_enough(&self) -> f64 {
        ROUND_PER_VERTEX * self.n_free() as f64
    }

    fn own_memory(&self) -> Memory {
        Memory(self.schedule, self.passed.least.clone())
    }

    /// A phase that begins with the schedule's change.
    fn began(&mut self, event: Option<Warning>) -> Phase {
        self.forget();
        self.quasi_newton = lbfgs::QuasiNewton::default();
        Phase {
            resets_step_size: true,
            event,
            ..Phase::default()
        }
    }
}

impl Flow for CircleFlow {
    fn monitored(&self) -> Monitored {
        Monitored::SmoothedCircle
    }

    fn rules(&self) -> Rules {
        let counted = self.problem.energy.n_counted() as f64;
        if self.is_paper() {
            return Rules {
                zero: FLOOR_PER_VERTEX * counted,
                ends_at_rest: self.options.goal == Goal::Relax,
                ..Rules::unseen()
            };
        }
        Rules {
            ceiling: Ceiling::Descent,
            reach: None,
            turn: None,
            folds: Folds::Few,
            least_angle: Some(LEAST_ANGLE),
            bound: (self.smooth_minimum > 0.0).then_some(self.smooth_minimum),
            bound_share: LEAST,
            roundoff: ROUNDOFF_PER_VERTEX * counted,
            zero: FLOOR_PER_VERTEX * counted,
            can_vanish: false,
            grows: false,
            ends_at_rest: self.options.goal == Goal::Relax,
            idle: (self.options.goal == Goal::Relax).then(|| self.schedule.idle()),
            long_dt: f64::INFINITY,
        }
    }

    /// Beyond 1e6 h² the mass term is lost in the roundoff of the stiffness, whose largest
    /// eigenvalue is about 60/h².
    fn step_size(&self) -> StepSize {
        let unit = self.time_unit();
        let dt = self.options.dt;
        let is_chosen = self.options.tau.is_some() || self.options.goal == Goal::Smooth;
        let tau = if self.schedule.is_near_sphere() && !is_chosen {
            FIRST_TAU_NEAR_SPHERE
        } else {
            self.options.first_tau()
        };
        let dt = dt.unwrap_or(tau * unit);
        if !self.is_paper() && self.options.goal == Goal::Relax {
            // Between held vertices there is more than one rest, and long steps miss the nearest.
            let is_free = self.mesh.is_closed() && self.n_free() == self.mesh.n_vertices();
            StepSize::adaptive(dt, 1e-12 * unit, 1e6 * unit).quickening(is_free)
        } else {
            StepSize::constant(dt, 1e-9 * dt)
        }
    }

    fn time_unit(&self) -> f64 {
        self.problem.h * self.problem.h
    }

    fn evaluate(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<Functional, FlowError> {
        let smoothing = self.schedule.smoothing();
        cost.assembling(|| self.evaluate_at(x, smoothing));
        Ok(Functional {
            value: self.monitored_value(&self.evaluation),
            scale: self.evaluation.exact.max(self.round_enough()),
            rate: None,
        })
    }

    fn propose(&mut self, x: &[DVec3], dt: f64, cost: &mut Cost) -> Result<Proposal, FlowError> {
        match (self.schedule.integrator(), self.options.scheme) {
            (Integrator::SemiImplicit, Scheme::Auto) => self.semi_implicit(x, dt, cost),
            (Integrator::SemiImplicit, Scheme::Paper) => self.printed(x, dt, cost),
            (Integrator::ForwardEuler, _) => Ok(self.forward_euler(x, dt)),
            (Integrator::BackwardEuler, _) => self.backward_euler(x, dt, cost),
            (Integrator::Lbfgs, _) => self.quasi_newton_move(x, cost),
        }
    }

    fn measure(&mut self, _x: &[DVec3], y: &mut [DVec3]) -> Result<f64, Refusal> {
        let smoothing = self.schedule.smoothing();
        self.problem.energy.evaluate(y, smoothing, &mut self.trial);
        let jumped = self.trial.exact > (1.0 + JUMP) * self.evaluation.exact
            && self.trial.exact > self.nearly_spherical();
        if jumped && !self.is_paper() {
            return Err(Refusal::of(Cause::ReadingJump));
        }
        Ok(self.monitored_value(&self.trial))
    }

    fn trial_slope(&self, d: &[DVec3]) -> f64 {
        self.problem.dot(&self.trial.gradient, d)
    }

    fn bounded(&self) -> f64 {
        self.trial.exact
    }

    fn accept(&mut self, step: &Move, share: f64) {
        self.was_whole = share >= 1.0;
        self.remember(step, share);
        std::mem::swap(&mut self.evaluation, &mut self.trial);
        self.evaluated = Some(self.schedule.smoothing());
        self.is_assembled = false;
    }

    fn next_phase(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        if self.is_paper() || self.options.goal == Goal::Smooth && *occasion != Occasion::Before {
            return Ok(None);
        }
        let smoothing = self.schedule.smoothing();
        cost.assembling(|| self.evaluate_at(x, smoothing));
        let exact = self.evaluation.exact;
        let is_spherical = exact < self.nearly_spherical();
        let stage = match *occasion {
            Occasion::Before => {
                self.passed.begin(exact, x);
                self.schedule.before_step(is_spherical)
            }
            Occasion::Accepted { before, after } => {
                self.passed.note(exact);
                let is_whole = self.was_whole;
                self.schedule
                    .after_step(before, after, exact, is_spherical, is_whole)
            }
            Occasion::Idle { dt, is_guarded } | Occasion::Stuck { dt, is_guarded } => {
                let tau = dt / self.time_unit();
                self.schedule.at_end(tau, exact, is_spherical, is_guarded)
            }
            Occasion::Ending { .. } => return Ok(self.back_to_least()),
        };
        Ok(match stage {
            Stage::Same => None,
            Stage::Sharper { restarts } => {
                let mut phase = self.began(None);
                phase.resets_step_size = restarts;
                Some(phase)
            }
            Stage::Spherical => {
                let mut phase = self.began(None);
                (phase.resets_step_size, phase.raises_step_size) = (false, true);
                Some(phase)
            }
            Stage::Other(event) => Some(self.began(Some(event))),
        })
    }

    /// The share of the energy that a step of τ = 1 would gain, over what it may; away from
    /// spheres the finisher knows better.
    fn stationarity(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError> {
        if self.schedule.is_at_rest() {
            return Ok(0.0);
        }
        let present = self.schedule.smoothing();
        self.forget();
        self.evaluate_at(x, present);
        if self.evaluation.exact > self.nearly_spherical() {
            let epsilon = present.epsilon.max(REST_EPSILON);
            self.evaluate_at(x, Smoothing { epsilon });
        }
        let slope = match self.semi_implicit(x, REFERENCE_TAU * self.time_unit(), cost)? {
            Proposal::Move(step) => step.slope,
            Proposal::Refused(_) | Proposal::Nothing => 0.0,
        };
        let exact = self.evaluation.exact.max(self.round_enough());
        self.forget();
        Ok(-slope / (AT_REST * exact))
    }

    fn describe(&mut self, _x: &[DVec3], report: &mut StepReport) {
        report.energy = self.evaluation.exact;
        report.energy_normalised = 0.5 * self.evaluation.exact;
        report.gradient_norm = self.problem.gradient_norm(&self.evaluation.gradient);
        report.epsilon = self.schedule.smoothing().epsilon;
        report.skipped_angles = self.evaluation.skipped;
    }

    fn warn(&self, x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        self.warn_of(x, report, given);
    }

    fn advice(&self) -> Advice {
        Advice::BetterMesh
    }

    fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.forget();
        let smoothing = self.schedule.smoothing();
        self.evaluate_at(x, smoothing);
        let objective = self.monitored_value(&self.evaluation);
        self.evaluate_at(x, Smoothing::EXACT);
        let energy = self.evaluation.value;
        Reading {
            energy,
            energy_normalised: 0.5 * energy,
            monitored: self.monitored(),
            objective,
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

    fn mean_edge_length(&self) -> f64 {
        self.problem.h
    }

    fn n_free(&self) -> usize {
        self.problem.vertex_of_row.len()
    }

    fn is_free(&self, v: usize) -> bool {
        self.problem.matrix.row_of_vertex()[v] != u32::MAX
    }

    fn memory(&self) -> super::Memory {
        super::Memory::Circle(self.own_memory())
    }

    fn recall(&mut self, memory: super::Memory) {
        if let super::Memory::Circle(Memory(schedule, least)) = memory {
            (self.schedule, self.passed.least) = (schedule, least);
        }
        self.forget();
        self.quasi_newton = lbfgs::QuasiNewton::default();
    }

    fn learnt(&self) -> super::Learnt {
        super::Learnt::Circle(Learnt {
            memory: self.own_memory(),
            model: self.quasi_newton.model.clone(),
        })
    }

    fn relearn(&mut self, learnt: super::Learnt) {
        if let super::Learnt::Circle(Learnt { memory, model }) = learnt {
            self.recall(super::Memory::Circle(memory));
            self.quasi_newton.model = model;
        }
    }

    fn release(&mut self) {
        self.problem.solver.release();
        self.quasi_newton.preconditioner = None;
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
