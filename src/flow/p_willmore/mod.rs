//! p-Willmore flow of Gruber & Aulisa [GA20](crate::bibliography#ga20): gradient flow of W^p =
//! ∫|Y|^p dA on closed surfaces, p = 0 being mean-curvature flow; with area and volume kept, the
//! terms of Canham and Helfrich, and conformal regularisation after each step.
//!
//! The step solves
//!
//! ```math
//! \Bigl( \frac{M}{\tau} + L \operatorname{diag}(c) L \Bigr) d = -P \nabla W^p, \qquad
//! c_i \approx p \max(1, p - 1) \frac{|Y_i|^{p-2}}{m_i},
//! ```
//!
//! with one scalar matrix: L the cotangent Laplacian, P the projection onto vertex normals.
//! W^p is that of the mixed mass ([`Mass`]), to which a crumpled mesh is no cheaper.
//! The gradient is exact and local; without P linear elements would lower their energy by
//! sliding vertices, below the minimum of smooth surfaces. τ has the unit length^(p+2).
//! The paper's own scheme, centred and nonlinear, is there to be compared with.
//!
//! With p = 0 and the volume kept it is the volume-preserving mean-curvature flow of Huisken,
//!
//! ```math
//! \frac{dx}{dt} = 2 (\bar H - H) n, \quad \bar H = \int H \, dA \Big/ \int dA: \qquad
//! M \frac{dx}{dt} = -\nabla A + \lambda \nabla V, \quad \lambda = 2 \bar H.
//! ```
//!
//! Area falls in every step; the volume is that of the start to 1e-11 of it, as a step ends with Newton's
//! iteration onto it. Embedded convex surfaces become round (Huisken
//! [H87](crate::bibliography#h87)), which is to say that 36πV²/A³, the square of the reduced
//! volume, rises to 1; others may pinch.
//!
//! What is monitored and shown is W^p/2^p = ∫|H|^p dA with the terms in force.

mod centred;
mod decay;
mod gauge;
mod growth;
mod kept;
mod paper;
mod regularise;
mod step;
mod system;
mod warning;

use super::bounds::lower_bounds;
use super::option::Allowed;
use super::options::{FlowOptions, Scheme};
use super::rules::{Ceiling, Folds, NEGLIGIBLE};
use super::step_size::StepSize;
use super::warning::{Warning, WarningsGiven};
use super::{
    Advice, Clock, Cost, Flow, FlowError, Functional, Monitored, Move, Multipliers, Occasion,
    Phase, Proposal, Reading, Refusal, Rules, StepReport, vesicle,
};
use crate::energy::p_willmore::{Evaluation, Helfrich, Integrals, PWillmore};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::operator::Mass;
use crate::remesh::{Mode, Regulariser};
use glam::DVec3;
use kept::{Kept, ball_volume};
use std::f64::consts::PI;
use std::rc::Rc;
use system::PWillmoreSystem;

/// The first τ of an automatic run, in units of L^(p+2); below the smallest no step is tried,
/// beyond the largest the mass term is lost in the roundoff of the stiffness.
const FIRST_TAU: f64 = 1e-3;
const SMALLEST_TAU: f64 = 1e-16;
const LARGEST_TAU: f64 = 1e4;
/// Factors on τ after a step accepted at once, and after one refused.
const GROWTH: f64 = 1.5;
const SHRINK: f64 = 0.3;
/// A vertex moves at most this share of its edges in a trial.
const REACH: f64 = 0.5;
/// Smallest angle, in degrees, that a step may leave: linear elements need good triangles.
const LEAST_ANGLE: f64 = 5.0;
/// A normal turns by at most 60° in a step.
const LEAST_TURN: f64 = 0.5;
/// Share of the smooth minimum of ∫H² that no healthy mesh goes below: coarse ones come to
/// 1.8 % below it.
const LEAST: f64 = 0.97;
/// At rest a step of this τ/L^(p+2) would lower the energy …
const REFERENCE_TAU: f64 = 0.1;
/// … by this share of it at most.
const AT_REST: f64 = 1e-4;
/// Gains in steps of more than this τ/L^(p+2) count by so much only.
const LONG_TAU: f64 = 10.0;
/// Roundoff of the energy, as a share of it.
const ROUNDOFF: f64 = 1e-15;

/// The flow on one closed mesh with one set of options.
pub struct PWillmoreFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    functional: PWillmore,
    system: PWillmoreSystem,
    /// Made when first needed: its matrix has three times the rows.
    regulariser: Option<Regulariser>,
    /// L = √(A/4π) at the start, the unit of length.
    scale: f64,
    /// Mean edge length at the start.
    h: f64,
    /// ∫H² of the best smooth surface of the topology, where that bounds the functional.
    smooth_minimum: Option<f64>,
    /// Whether the start is not below it already, as on a mesh too coarse to be judged by it.
    is_resolved: bool,
    kept: Kept,
    /// Whether moves are along the normals alone, as the gradient that they follow is.
    is_normal: bool,
    /// Integrals and derivatives at the present positions.
    evaluation: Evaluation,
    is_evaluated: bool,
    /// Whether the stiffness was assembled there.
    is_assembled: bool,
    /// u_k = H⁻¹∇C_k of the constraints in force, end to end, and λ of the last proposal.
    directions: Vec<DVec3>,
    multipliers: Vec<f64>,
    /// The volume that the last proposal leads to.
    next_volume: Option<f64>,
    scratch: Evaluation,
}

/// What the flow must remember beside the positions.
#[derive(Clone, Copy, Debug)]
pub struct Memory {
    kept: Kept,
    is_normal: bool,
}

impl PWillmoreFlow {
    /// Prepares the flow at positions `x`, which a perturbation may change.
    ///
    /// # Errors
    /// [`FlowError::NotClosed`], [`FlowError::NotOriented`], [`FlowError::MixedFaces`],
    /// [`FlowError::Option`], [`FlowError::Linear`].
    pub fn new(
        mesh: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: &FlowOptions,
    ) -> Result<Self, FlowError> {
        let mass = match options.scheme {
            Scheme::Auto => Mass::Mixed,
            Scheme::Paper => Mass::Lumped,
        };
        Self::with_mass(mesh, x, options, mass)
    }

    /// The same for another mass than the scheme's own: what two schemes do to one functional
    /// can then be compared. The paper's scheme follows the gradient of the lumped one only.
    ///
    /// # Errors
    /// See [`new`](Self::new).
    pub fn with_mass(
        mesh: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: &FlowOptions,
        mass: Mass,
    ) -> Result<Self, FlowError> {
        check_mesh(mesh)?;
        let h = measure::mean_edge_length(mesh, x);
        vesicle::perturb(mesh, x, options.perturbation * h);
        let scale = (measure::area(mesh, x) / (4.0 * PI)).sqrt();
        let helfrich = helfrich(options, scale, mesh.is_triangular())?;
        let functional = PWillmore::new(Rc::clone(mesh), x, options.p, helfrich, mass)
            .ok_or(FlowError::MixedFaces)?;
        if options.scheme == Scheme::Paper {
            check_paper(options, x.len())?;
        }
        let system = PWillmoreSystem::new(functional.elements(), x, options.p == 0.0)?;
        let mut evaluation = Evaluation::default();
        let integrals = functional.integrals(x, &mut evaluation);
        let is_bounded = options.p == 2.0 && helfrich.is_zero();
        let smooth_minimum = lower_bounds(mesh)
            .map(|bounds| bounds.willmore)
            .filter(|_| is_bounded);
        Ok(Self {
            kept: Kept::new(options, &integrals)?,
            h,
            scale,
            is_resolved: smooth_minimum
                .is_some_and(|least| 0.25 * integrals.energy >= LEAST * least),
            smooth_minimum,
            mesh: Rc::clone(mesh),
            options: options.clone(),
            functional,
            system,
            regulariser: None,
            is_normal: false,
            evaluation,
            is_evaluated: false,
            is_assembled: false,
            directions: Vec::new(),
            multipliers: Vec::new(),
            next_volume: None,
            scratch: Evaluation::default(),
        })
    }

    fn forget(&mut self) {
        self.is_evaluated = false;
        self.is_assembled = false;
    }

    fn ensure_evaluated(&mut self, x: &[DVec3]) {
        if !self.is_evaluated {
            self.functional.evaluate(x, &mut self.evaluation);
            self.is_evaluated = true;
            self.is_assembled = false;
        }
    }

    fn is_paper(&self) -> bool {
        self.options.scheme == Scheme::Paper
    }

    fn mode(&self) -> Mode {
        self.options.regularise
    }

    /// The functional as it is shown: W^p/2^p and the terms in force.
    fn shown(&self, objective: f64) -> f64 {
        objective / 2f64.powf(self.options.p)
    }

    /// ∫|H|^p dA over its value on the round sphere of the same area, 4π L^(2−p).
    fn normalised(&self, integrals: &Integrals) -> f64 {
        let p = self.options.p;
        let scale = (integrals.area / (4.0 * PI)).sqrt();
        integrals.energy / 2f64.powf(p) / (4.0 * PI * scale.powf(2.0 - p))
    }
}

impl Flow for PWillmoreFlow {
    fn monitored(&self) -> Monitored {
        match self.options.p {
            _ if !self.functional.helfrich().is_zero() => Monitored::Helfrich,
            0.0 => Monitored::Area,
            2.0 => Monitored::Willmore,
            _ => Monitored::PWillmore,
        }
    }

    fn rules(&self) -> Rules {
        let can_vanish = self.options.p < 2.0 && !self.kept.any();
        if self.is_paper() {
            return Rules {
                can_vanish,
                zero: f64::NEG_INFINITY,
                idle: Some(NEGLIGIBLE),
                ..Rules::unseen()
            };
        }
        Rules {
            ceiling: Ceiling::Descent,
            reach: Some(REACH),
            turn: Some(LEAST_TURN),
            folds: Folds::None,
            least_angle: Some(LEAST_ANGLE),
            bound: self.smooth_minimum.filter(|_| self.is_resolved),
            bound_share: LEAST,
            roundoff: ROUNDOFF * self.shown(self.evaluation.integrals.objective).abs(),
            // The terms of Helfrich may make it less than nothing.
            zero: if self.functional.helfrich().is_zero() {
                0.0
            } else {
                f64::NEG_INFINITY
            },
            can_vanish,
            grows: self.grows() || self.is_unbounded(),
            ends_at_rest: true,
            idle: (!self.grows()).then_some(NEGLIGIBLE),
            long_dt: LONG_TAU * self.time_unit(),
        }
    }

    fn step_size(&self) -> StepSize {
        let unit = self.time_unit();
        if self.is_paper() {
            return paper::step_size(&self.options, unit);
        }
        let (dt, tau) = (self.options.dt, self.options.tau);
        let smallest = SMALLEST_TAU * unit;
        let size = match dt.or(tau.map(|tau| tau * unit)) {
            Some(asked) => StepSize::constant(asked, smallest.min(1e-9 * asked)),
            None => StepSize::adaptive(FIRST_TAU * unit, smallest, LARGEST_TAU * unit),
        };
        size.with_factors(GROWTH, SHRINK)
    }

    /// L^(p+2).
    fn time_unit(&self) -> f64 {
        self.scale.powf(self.options.p + 2.0)
    }

    fn evaluate(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<Functional, FlowError> {
        let watch = web_time::Instant::now();
        self.ensure_evaluated(x);
        cost.assemble += watch.elapsed().as_secs_f64();
        let value = self.shown(self.evaluation.integrals.objective);
        let scale = self.excess(value);
        let rate = self.rate();
        Ok(Functional { value, scale, rate })
    }

    fn propose(&mut self, x: &[DVec3], dt: f64, cost: &mut Cost) -> Result<Proposal, FlowError> {
        self.ensure_evaluated(x);
        if self.is_paper() {
            self.centred(x, dt, cost)
        } else {
            self.semi_implicit(x, dt, cost)
        }
    }

    fn measure(&mut self, _x: &[DVec3], y: &mut [DVec3]) -> Result<f64, Refusal> {
        self.constrained(y)
    }

    fn bounded(&self) -> f64 {
        self.shown(self.scratch.integrals.energy)
    }

    fn accept(&mut self, _step: &Move, _share: f64) {
        self.kept.lead_to(self.next_volume);
        self.forget();
    }

    fn slide(
        &mut self,
        x: &[DVec3],
        y: &[DVec3],
        limit: f64,
        _cost: &mut Cost,
    ) -> Result<Option<Vec<DVec3>>, FlowError> {
        self.regularised(x, y, limit)
    }

    /// While a volume is led, steps are short: given time, an oblate vesicle would turn over
    /// into a prolate one. Where moves have ceased to descend, those along the normals follow.
    fn next_phase(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        if let Some(phase) = self.along_normals(x, occasion, cost)? {
            return Ok(Some(phase));
        }
        let arrives = matches!(occasion, Occasion::Accepted { .. }) && self.kept.has_arrived();
        Ok(arrives.then(Phase::default))
    }

    /// The share of the energy that a step of τ = 0.1 would gain, over what it may.
    fn stationarity(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError> {
        if self.grows() {
            return Ok(f64::INFINITY);
        }
        self.ensure_evaluated(x);
        let slope = match self.semi_implicit(x, REFERENCE_TAU * self.time_unit(), cost)? {
            Proposal::Move(step) => step.slope,
            Proposal::Refused(_) | Proposal::Nothing => 0.0,
        };
        let energy = self.shown(self.evaluation.integrals.objective);
        Ok(-slope / (AT_REST * self.excess(energy)))
    }

    fn describe(&mut self, _x: &[DVec3], report: &mut StepReport) {
        let integrals = self.evaluation.integrals;
        report.energy = self.functional.reading(&integrals);
        report.energy_normalised = self.normalised(&integrals);
        report.gradient_norm = self.residual(&self.multipliers);
        report.area = integrals.area;
        report.volume = Some(integrals.volume);
        report.reduced_volume = Some(integrals.volume.abs() / ball_volume(integrals.area));
        // At rest ∇J = λ_A ∇A + λ_V ∇V.
        let [area, volume] = self.kept.sorted(&self.multipliers);
        report.multipliers = Some(Multipliers {
            tension: area.map(|m| -self.shown(m)),
            pressure: volume.map(|m| self.shown(m)),
        });
    }

    fn warn(&self, x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        self.warn_of(x, report, given);
    }

    fn clock(&self) -> Clock {
        match self.options.p == 0.0 && !self.kept.any() {
            true => Clock::AreaGradient,
            false => Clock::Own,
        }
    }

    fn rested(&self, x: &[DVec3]) -> Option<Warning> {
        let is_led = Kept::leads(&self.options) && self.kept.has_arrived();
        is_led.then(|| vesicle::branch(&self.mesh, x))
    }

    fn advice(&self) -> Advice {
        if self.mode() == Mode::Off {
            Advice::RegularOrFiner
        } else if self.options.p < 2.0 && self.kept.volume.is_none() {
            Advice::KeepVolume
        } else if self.options.p > 2.0 {
            Advice::SmoothFirst
        } else {
            Advice::FinerMesh
        }
    }

    fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.forget();
        self.ensure_evaluated(x);
        let integrals = self.evaluation.integrals;
        let Integrals { area, volume, .. } = integrals;
        Reading {
            energy: self.functional.reading(&integrals),
            energy_normalised: self.normalised(&integrals),
            monitored: self.monitored(),
            objective: self.shown(integrals.objective),
            gradient_norm: self.residual(&[]),
            area,
            volume: Some(volume),
            reduced_volume: Some(volume.abs() / ball_volume(area)),
        }
    }

    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        let mut at = Evaluation::default();
        self.functional.evaluate(x, &mut at);
        step::normal_part(&at)
    }

    fn mean_edge_length(&self) -> f64 {
        self.h
    }

    fn n_free(&self) -> usize {
        self.mesh.n_vertices()
    }

    fn is_free(&self, _v: usize) -> bool {
        true
    }

    fn memory(&self) -> super::Memory {
        super::Memory::PWillmore(Memory {
            kept: self.kept,
            is_normal: self.is_normal,
        })
    }

    fn recall(&mut self, memory: super::Memory) {
        if let super::Memory::PWillmore(Memory { kept, is_normal }) = memory {
            (self.kept, self.is_normal) = (kept, is_normal);
        }
        self.forget();
    }

    fn release(&mut self) {
        self.system.release();
        self.regulariser = None;
    }
}

/// The terms of Helfrich in the mesh's units, from options without a unit.
fn helfrich(options: &FlowOptions, scale: f64, triangles: bool) -> Result<Helfrich, FlowError> {
    let helfrich = Helfrich {
        spontaneous: 2.0 * options.spontaneous_curvature / scale,
        tension: options.tension / scale.powi(2),
        pressure: options.pressure / scale.powi(3),
    };
    if helfrich != Helfrich::default() && options.p != 2.0 {
        return Err(FlowError::option("p", options.p, Allowed::HelfrichTwo));
    }
    if helfrich.spontaneous != 0.0 && !triangles {
        let (name, value) = ("spontaneousCurvature", options.spontaneous_curvature);
        let allowed = Allowed::ZeroOnQuadrilaterals;
        return Err(FlowError::option(name, value, allowed));
    }
    Ok(helfrich)
}

/// What the paper's scheme does not take.
fn check_paper(options: &FlowOptions, vertices: usize) -> Result<(), FlowError> {
    if vertices > paper::LARGEST {
        return Err(FlowError::TooLarge {
            vertices,
            limit: paper::LARGEST,
        });
    }
    let terms = [
        ("spontaneousCurvature", options.spontaneous_curvature),
        ("tension", options.tension),
        ("pressure", options.pressure),
    ];
    match terms.into_iter().find(|(_, value)| *value != 0.0) {
        Some((name, value)) => Err(FlowError::option(name, value, Allowed::ZeroInPaper)),
        None => Ok(()),
    }
}

/// The preconditions on a mesh, of the flow and of conformal regularisation.
///
/// # Errors
/// [`FlowError::NotClosed`], [`FlowError::NotOriented`].
pub fn check_mesh(mesh: &HalfedgeMesh) -> Result<(), FlowError> {
    if !mesh.is_closed() {
        return Err(FlowError::NotClosed {
            loops: mesh.n_boundary_loops(),
        });
    }
    if !mesh.is_oriented() {
        return Err(FlowError::NotOriented);
    }
    Ok(())
}
