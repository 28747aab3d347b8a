//! p-Willmore flow of Gruber & Aulisa: gradient flow of W^p = ∫|Y|^p dA on closed surfaces,
//! p = 0 being mean-curvature flow; with area and volume kept, the terms of Canham and
//! Helfrich, and conformal regularisation after each step.
//!
//! The step solves (M/τ + L diag(c) L) d = −P∇W^p with one scalar matrix: L the cotangent
//! Laplacian, c_i ≈ p max(1, p − 1) |Y_i|^(p−2)/m_i, P the projection onto vertex normals.
//! W^p is that of the mixed mass ([`Mass`]), to which a crumpled mesh is no cheaper.
//! The gradient is exact and local; without P linear elements would lower their energy by
//! sliding vertices, below the minimum of smooth surfaces. τ has the unit length^(p+2).
//! The paper's own scheme, centred and nonlinear, is there to be compared with.

mod centred;
mod paper;
mod step;
mod system;
mod verdict;

use super::constraint::Kept;
use super::options::{FlowOptions, Scheme};
use super::stop::Verdict;
use super::{FlowError, Progress as Callback, Refusal, StepReport};
use crate::energy::p_willmore::{Evaluation, Helfrich, Integrals, PWillmore};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::operator::Mass;
use crate::remesh::{Mode, Regulariser};
use glam::DVec3;
use std::f64::consts::PI;
use std::rc::Rc;
use system::System;
use web_time::Instant;

/// The first τ of an automatic run, in units of L^(p+2).
const FIRST_TAU: f64 = 1e-3;

/// The flow on one closed mesh with one set of options.
pub struct PWillmoreFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    functional: PWillmore,
    system: System,
    /// Made when first needed: its matrix has three times the rows.
    regulariser: Option<Regulariser>,
    start: Vec<DVec3>,
    /// L = √(A/4π) at the start, the unit of length.
    scale: f64,
    /// Mean edge length and smallest angle at the start.
    h: f64,
    start_angle: f64,
    /// Area of the largest face at the start over the mean.
    start_face: f64,
    pace: Pace,
    /// Integrals and derivatives at the present positions.
    evaluation: Evaluation,
    is_evaluated: bool,
    scratch: Evaluation,
    flipped: Vec<u32>,
    refusal: Option<Refusal>,
    on_progress: Option<Callback>,
}

/// The small state that a step back restores along with the positions.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    dt: f64,
    time: f64,
    step: usize,
    first_step: usize,
    /// Wanted area, if it is kept.
    area: Option<f64>,
    /// Wanted volume, if it is kept; falls or rises step by step towards `last_volume`.
    volume: Option<f64>,
    last_volume: Option<f64>,
    stop: verdict::Window,
    warned: verdict::Warned,
}

impl PWillmoreFlow {
    /// Prepares the flow at positions `x`.
    ///
    /// # Errors
    /// [`FlowError::NotClosed`], [`FlowError::NotOriented`], [`FlowError::MixedFaces`],
    /// [`FlowError::BadOption`], [`FlowError::Linear`].
    pub fn new(
        mesh: Rc<HalfedgeMesh>,
        x: &[DVec3],
        options: FlowOptions,
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
        mesh: Rc<HalfedgeMesh>,
        x: &[DVec3],
        options: FlowOptions,
        mass: Mass,
    ) -> Result<Self, FlowError> {
        options.check()?;
        check_mesh(&mesh)?;
        let area = measure::area(&mesh, x);
        let scale = (area / (4.0 * PI)).sqrt();
        let helfrich = helfrich(&options, scale, mesh.is_triangular())?;
        let functional = PWillmore::new(Rc::clone(&mesh), x, options.p, helfrich, mass)
            .ok_or(FlowError::MixedFaces)?;
        if options.scheme == Scheme::Paper {
            check_paper(&options, x.len())?;
        }
        let system = System::new(functional.elements(), x, options.p == 0.0)?;
        let mut evaluation = Evaluation::default();
        let integrals = functional.integrals(x, &mut evaluation);
        let keeps = |kept| options.keep.contains(&kept);
        let volume = keeps(Kept::Volume).then_some(integrals.volume);
        let last_volume = match options.reduced_volume {
            None => volume,
            Some(reduced) => {
                if !(keeps(Kept::Area) && keeps(Kept::Volume)) {
                    return Err(FlowError::BadOption {
                        name: "the reduced volume",
                        value: reduced.to_string(),
                        allowed: "given only where both area and volume are kept",
                    });
                }
                Some(reduced * ball_volume(integrals.area) * integrals.volume.signum())
            }
        };
        let power = scale.powf(options.p + 2.0);
        let first_tau = match options.scheme {
            Scheme::Auto => FIRST_TAU,
            Scheme::Paper => paper::schedule(options.p).0,
        };
        let dt = options
            .dt
            .unwrap_or_else(|| options.tau.unwrap_or(first_tau) * power);
        let pace = Pace {
            dt,
            time: 0.0,
            step: 0,
            first_step: 0,
            area: keeps(Kept::Area).then_some(integrals.area),
            volume,
            last_volume,
            stop: verdict::Window::default(),
            warned: verdict::Warned::default(),
        };
        let mut flow = Self {
            start_face: 1.0,
            h: measure::mean_edge_length(&mesh, x),
            start_angle: measure::min_angle_degrees(&mesh, x),
            mesh,
            options,
            functional,
            system,
            regulariser: None,
            start: x.to_vec(),
            scale,
            pace,
            evaluation,
            is_evaluated: false,
            scratch: Evaluation::default(),
            flipped: Vec::new(),
            refusal: None,
            on_progress: None,
        };
        flow.start_face = flow.element_range(x).1;
        Ok(flow)
    }

    fn tell(&self, stage: &str, share: f64) {
        if let Some(callback) = &self.on_progress {
            callback(stage, share);
        }
    }

    fn evaluate(&mut self, x: &[DVec3]) {
        if !self.is_evaluated {
            self.functional.evaluate(x, &mut self.evaluation);
            self.is_evaluated = true;
        }
    }

    /// L^(p+2), the unit of τ.
    fn time_scale(&self) -> f64 {
        self.scale.powf(self.options.p + 2.0)
    }

    /// |P(∇J − Σ λ∇C)| in the metric of M⁻¹, over J/L²: scale-free; 0 at a critical point. On a mesh
    /// it comes to rest at the size of the discretisation error, not at 0.
    fn residual(&self, multipliers: &[f64]) -> f64 {
        let e = &self.evaluation;
        let kept = [
            self.pace.area.map(|_| &e.area_gradient),
            self.pace.volume.map(|_| &e.volume_gradient),
        ];
        let kept: Vec<_> = kept.into_iter().flatten().collect();
        let mut sum = 0.0;
        for (i, n) in e.volume_gradient.iter().enumerate() {
            let mut g = e.gradient[i];
            for (lambda, gradient) in multipliers.iter().zip(&kept) {
                g -= *lambda * gradient[i];
            }
            sum += g.dot(n.normalize_or_zero()).powi(2) / e.mass[i].max(f64::MIN_POSITIVE);
        }
        sum.sqrt() * self.scale.powi(2) / e.integrals.energy.abs().max(f64::MIN_POSITIVE)
    }
}

impl super::Flow for PWillmoreFlow {
    fn set_progress(&mut self, callback: Option<Callback>) {
        self.on_progress = callback;
    }

    fn mean_edge_length(&self) -> f64 {
        self.h
    }

    fn n_free(&self) -> usize {
        self.start.len()
    }

    fn is_free(&self, _v: usize) -> bool {
        true
    }

    fn reading(&mut self, x: &[DVec3]) -> super::Reading {
        self.is_evaluated = false;
        self.evaluate(x);
        let integrals = self.evaluation.integrals;
        let Integrals { area, volume, .. } = integrals;
        super::Reading {
            energy: self.functional.reading(&integrals),
            energy_normalised: self.normalised(&integrals),
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

    fn pace(&self) -> super::Pace {
        super::Pace::PWillmore(self.pace)
    }

    fn set_pace(&mut self, pace: super::Pace) {
        if let super::Pace::PWillmore(pace) = pace {
            self.pace = pace;
        }
        self.is_evaluated = false;
        self.flipped.clear();
        self.refusal = None;
    }

    fn set_clock(&mut self, step: usize, time: f64) {
        self.pace.step = step;
        self.pace.time = time;
        self.is_evaluated = false;
        self.flipped.clear();
    }

    fn extend_budget(&mut self) {
        self.pace.first_step = self.pace.step;
        self.pace.stop = verdict::Window::default();
    }

    fn dt(&self) -> f64 {
        self.pace.dt
    }

    fn tau(&self) -> f64 {
        self.pace.dt / self.time_scale()
    }

    fn flipped_faces(&self) -> &[u32] {
        &self.flipped
    }

    fn refusal(&self) -> Option<Refusal> {
        self.refusal
    }

    fn step(&mut self, x: &mut Vec<DVec3>) -> Result<(Option<StepReport>, Verdict), FlowError> {
        let start = Instant::now();
        self.tell("assemble", 0.0);
        self.evaluate(x);
        if !self.evaluation.integrals.objective.is_finite() {
            return Err(FlowError::NonFiniteEnergy {
                step: self.pace.step + 1,
            });
        }
        if let Some(verdict) = self.done_before_step() {
            return Ok((None, verdict));
        }
        let mut cost = step::Cost::default();
        let advanced = match self.options.scheme {
            Scheme::Auto => self.advance(x, &mut cost)?,
            Scheme::Paper => self.paper_advance(x, &mut cost)?,
        };
        self.refusal = cost.refusal;
        let Some(accepted) = advanced else {
            return Ok((None, self.stuck_verdict(&cost)));
        };
        let (mut report, verdict) = self.conclude(x, accepted, cost);
        report.milliseconds = start.elapsed().as_secs_f64() * 1e3;
        Ok((Some(report), verdict))
    }
}

impl PWillmoreFlow {
    /// ∫|H|^p dA over its value on the round sphere of the same area, 4π L^(2−p).
    fn normalised(&self, integrals: &Integrals) -> f64 {
        let p = self.options.p;
        let scale = (integrals.area / (4.0 * PI)).sqrt();
        integrals.energy / 2f64.powf(p) / (4.0 * PI * scale.powf(2.0 - p))
    }

    fn mode(&self) -> Mode {
        self.options.regularise
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
        return Err(FlowError::BadOption {
            name: "the exponent p",
            value: options.p.to_string(),
            allowed: "only 2 with spontaneous curvature, tension or pressure",
        });
    }
    if helfrich.spontaneous != 0.0 && !triangles {
        return Err(FlowError::BadOption {
            name: "the spontaneous curvature",
            value: options.spontaneous_curvature.to_string(),
            allowed: "0 on quadrilaterals; triangulate the mesh for others",
        });
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
        ("the spontaneous curvature", options.spontaneous_curvature),
        ("the tension", options.tension),
        ("the pressure", options.pressure),
    ];
    match terms.into_iter().find(|(_, value)| *value != 0.0) {
        Some((name, value)) => Err(FlowError::BadOption {
            name,
            value: value.to_string(),
            allowed: "only 0 in the paper's scheme",
        }),
        None => Ok(()),
    }
}

/// Volume of the ball with that much surface: A^(3/2) / (6√π).
fn ball_volume(area: f64) -> f64 {
    area.powf(1.5) / (6.0 * PI.sqrt())
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
