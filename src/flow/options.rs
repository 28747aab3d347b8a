//! What a user may choose about a flow; every field has a default.

use super::constraint::Kept;
use super::spec::FlowName;
use crate::energy::circle::Boundary;
use crate::remesh::Mode;
use crate::remesh::flips::reduction::Criterion;
use serde::{Deserialize, Serialize};

/// Recommended treatment or the paper's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Scheme {
    /// Smoothed angles, semi-definite K, automatic step size: needs no tuning.
    #[default]
    Auto,
    /// Constant dt, exact energy, K as it is, uniform mass, no test for descent.
    Paper,
}

/// How time is discretised.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Integrator {
    /// (M/dt + K) Δx = −∇E, the paper's choice.
    #[default]
    SemiImplicit,
    /// Δx = −dt M⁻¹ ∇E.
    ForwardEuler,
    /// M Δx/dt = −∇E(x + Δx), by Newton's method with the full Hessian.
    BackwardEuler,
    /// No flow but the fastest way to its end: L-BFGS preconditioned by M/dt + K.
    #[serde(rename = "l-bfgs")]
    Lbfgs,
}

/// What the run is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Goal {
    /// As far down as possible, with growing steps.
    #[default]
    Relax,
    /// A set amount of smoothing, in equal steps.
    Smooth,
}

/// The metric the gradient is taken in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum MassChoice {
    /// Uniform for relaxing, area for smoothing.
    #[default]
    Auto,
    /// Every vertex weighs 1: the paper's metric; the rate depends on vertex density.
    Uniform,
    /// Vertex area over mean vertex area: the rate does not depend on vertex density.
    Area,
}

/// Passes of remeshing between the steps of a flow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Remeshing {
    /// Triangles as small as the surface bends.
    #[default]
    Adaptive,
    /// Triangles of one size.
    Isotropic,
    /// None.
    Off,
}

/// Options of a flow; what each may be, and which flows read it, is in [`option`](super::option).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct FlowOptions {
    /// Which flow.
    pub flow: FlowName,
    /// Recommended or the paper's.
    pub scheme: Scheme,
    /// Time discretisation.
    pub integrator: Integrator,
    /// What happens at the boundary; by default as usual of the flow ([`spec`](crate::flow::spec)).
    pub boundary: Option<Boundary>,
    /// Relax or smooth.
    pub goal: Goal,
    /// Smoothing: wavelengths below this many mean edge lengths are at least halved.
    pub detail: f64,
    /// Smoothing: in so many steps.
    pub smooth_steps: usize,
    /// Raw step size; overrides `tau` and `detail`.
    pub dt: Option<f64>,
    /// Step size over h², h the mean edge length at the start; overrides `detail`. Under the
    /// flows by mean curvature and its derivatives, over L^k, k the order of the flow and L²
    /// the area of a free patch.
    pub tau: Option<f64>,
    /// Metric.
    pub mass: MassChoice,
    /// ε of the angle smoothing, in radians.
    pub epsilon: f64,
    /// Whether ε goes to 0 at the end of relaxing.
    pub sharpen: bool,
    /// Pre-fill of the free vertices before the first step: harmonic under the circle flow,
    /// smooth under the flows by mean curvature and its derivatives.
    pub prefill: bool,
    /// Only these vertices move.
    pub free: Option<Vec<u32>>,
    /// These vertices never move.
    pub fixed: Option<Vec<u32>>,
    /// Budget of steps, for a set number of them.
    pub max_steps: Option<usize>,
    /// Budget of seconds of computing, counted anew each time a run is asked to go on; it
    /// holds only where no number of steps is set, as a set amount of smoothing does.
    pub max_seconds: Option<f64>,
    /// Closed surfaces: the start is pushed along its normals by up to so many mean edge lengths, so
    /// that a symmetric one can leave a shape that is unstable.
    pub perturbation: f64,
    /// p-Willmore: the exponent; 0 (mean-curvature flow) or at least 1.
    pub p: f64,
    /// p-Willmore: what is kept.
    pub keep: Vec<Kept>,
    /// p-Willmore, recommended scheme: passes of remeshing where a closed triangle mesh has become
    /// bad, in place of its regularisation.
    pub remesh: Remeshing,
    /// Closed surfaces: conformal regularisation after each step.
    pub regularise: Mode,
    /// Closed surfaces: ε of the regularisation, a pure number.
    pub regularise_epsilon: f64,
    /// Closed surfaces, paper's scheme: factor on the step size after each step.
    pub tau_growth: f64,
    /// Closed surfaces, paper's scheme: largest τ.
    pub tau_max: Option<f64>,
    /// p-Willmore: the volume is led to this share of the volume of the ball of the same
    /// area; needs area and volume kept.
    pub reduced_volume: Option<f64>,
    /// p-Willmore, p = 2: spontaneous curvature H₀ in ∫(H − H₀)² dA, times L.
    pub spontaneous_curvature: f64,
    /// p-Willmore, p = 2: tension σ in ∫|Y|² dA + σA, times L².
    pub tension: f64,
    /// p-Willmore, p = 2: pressure P in ∫|Y|² dA − PV, times L³.
    pub pressure: f64,
    /// Edge flips: what is to become small.
    pub criterion: Criterion,
    /// Edge flips: no flip may turn a face over.
    pub guard_folds: bool,
    /// Mean-curvature variation: steps of surface diffusion taken first; by default some
    /// where the start is rough.
    pub rungs: Option<usize>,
}

impl Default for FlowOptions {
    fn default() -> Self {
        Self {
            flow: FlowName::default(),
            scheme: Scheme::default(),
            integrator: Integrator::default(),
            boundary: None,
            goal: Goal::default(),
            detail: 4.0,
            smooth_steps: 10,
            dt: None,
            tau: None,
            mass: MassChoice::default(),
            epsilon: 0.1,
            sharpen: true,
            prefill: false,
            free: None,
            fixed: None,
            max_steps: None,
            max_seconds: Some(DEFAULT_SECONDS),
            perturbation: 0.0,
            p: 2.0,
            keep: Vec::new(),
            remesh: Remeshing::default(),
            regularise: Mode::default(),
            regularise_epsilon: 1e-2,
            tau_growth: 1.2,
            tau_max: None,
            reduced_volume: None,
            spontaneous_curvature: 0.0,
            tension: 0.0,
            pressure: 0.0,
            criterion: Criterion::default(),
            guard_folds: false,
            rungs: None,
        }
    }
}

/// Most surfaces come to rest in this time; longer, and one would rather be asked.
const DEFAULT_SECONDS: f64 = 120.0;

/// Wavelength in edge lengths that a unit of total τ halves: λ h² ≈ 2025 (h/L)⁴ on an
/// equilateral mesh, so Nτ λh² = ln 2 gives L ≈ 6.7 (Nτ)^¼, less 9 % for many steps.
const HALVED_WAVELENGTH: f64 = 6.7;

impl FlowOptions {
    /// τ = (L/6.7)⁴/N: N steps of it halve the wavelength of L mean edge lengths.
    pub fn tau_for_detail(detail: f64, steps: usize) -> f64 {
        (detail / HALVED_WAVELENGTH).powi(4) / steps.max(1) as f64
    }

    /// The passes there are: none where terms of Helfrich have a length for their unit that no
    /// kept area gives, as that would change with the mesh.
    pub fn remeshing(&self) -> Remeshing {
        let terms = [self.spontaneous_curvature, self.tension, self.pressure];
        let has_unit = terms != [0.0; 3] && !self.keep.contains(&Kept::Area);
        let is_read = self.flow == FlowName::PWillmore && self.scheme == Scheme::Auto;
        if is_read && !has_unit {
            self.remesh
        } else {
            Remeshing::Off
        }
    }

    /// The first step's τ: given, or from the detail to remove, or the scheme's own.
    pub fn first_tau(&self) -> f64 {
        match (self.tau, self.goal, self.scheme) {
            (Some(tau), ..) => tau,
            (None, Goal::Smooth, _) => Self::tau_for_detail(self.detail, self.smooth_steps),
            (None, Goal::Relax, Scheme::Auto) => 1.0,
            (None, Goal::Relax, Scheme::Paper) => 0.01,
        }
    }
}
