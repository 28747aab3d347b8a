//! What a user may choose about a flow; every field has a default.

use super::FlowError;
use super::constraint::Kept;
use super::error::Allowed;
use crate::energy::circle::Boundary;
use crate::remesh::Mode;
use crate::remesh::flips::reduction::Criterion;
use serde::{Deserialize, Serialize};

/// Which flow runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum FlowName {
    /// Bobenko & Schröder's circle-angle Willmore flow.
    #[default]
    Circle,
    /// Gruber & Aulisa's p-Willmore flow.
    PWillmore,
    /// Brink & Alboul's edge flips.
    Flips,
    /// Flow by mean curvature.
    MeanCurvature,
    /// Surface diffusion.
    SurfaceDiffusion,
    /// Willmore flow by fitted operators.
    Willmore,
    /// Xu & Zhang's minimal mean-curvature-variation flow.
    Mmcv,
}

/// Recommended treatment or the paper's own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
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

/// Options of a flow. Unknown names are refused.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct FlowOptions {
    /// Which flow.
    pub flow: FlowName,
    /// Recommended or the paper's.
    pub scheme: Scheme,
    /// Time discretisation.
    pub integrator: Integrator,
    /// What happens at the boundary; by default it is clamped under the circle flow and
    /// fixed under the flows by mean curvature and its derivatives.
    pub boundary: Option<Boundary>,
    /// Relax or smooth.
    pub goal: Goal,
    /// Smoothing: wavelengths below this many mean edge lengths are at least halved.
    pub detail: Option<f64>,
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
    /// p-Willmore: the start is pushed along its normals by up to so many mean edge lengths, so
    /// that a symmetric one can leave a shape that is unstable.
    pub perturbation: f64,
    /// p-Willmore: the exponent; 0 (mean-curvature flow) or at least 1.
    pub p: f64,
    /// p-Willmore: what is kept.
    pub keep: Vec<Kept>,
    /// p-Willmore: conformal regularisation after each step.
    pub regularise: Mode,
    /// p-Willmore: ε of the regularisation, a pure number.
    pub regularise_epsilon: f64,
    /// p-Willmore, paper's scheme: factor on the step size after each step.
    pub tau_growth: f64,
    /// p-Willmore, paper's scheme: largest τ.
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
            detail: None,
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

/// A larger perturbation folds faces.
const MAX_PERTURBATION: f64 = 0.3;

/// |Y|^p and its derivatives stay within double precision.
const MAX_EXPONENT: f64 = 16.0;

/// Wavelength in edge lengths that a unit of total τ halves: λ h² ≈ 2025 (h/L)⁴ on an
/// equilateral mesh, so Nτ λh² = ln 2 gives L ≈ 6.7 (Nτ)^¼, less 9 % for many steps.
const HALVED_WAVELENGTH: f64 = 6.7;

impl FlowOptions {
    /// τ = (L/6.7)⁴/N: N steps of it halve the wavelength of L mean edge lengths.
    pub fn tau_for_detail(detail: f64, steps: usize) -> f64 {
        (detail / HALVED_WAVELENGTH).powi(4) / steps.max(1) as f64
    }

    /// Refuses values that make no sense.
    ///
    /// # Errors
    /// [`FlowError::BadOption`] naming the option.
    pub fn check(&self) -> Result<(), FlowError> {
        let bad = |name, value: String, allowed| {
            Err(FlowError::BadOption {
                name,
                value,
                allowed,
            })
        };
        let positive = [
            ("dt", self.dt),
            ("tau", self.tau),
            ("detail", self.detail),
            ("tauMax", self.tau_max),
            ("tauGrowth", Some(self.tau_growth)),
            ("regulariseEpsilon", Some(self.regularise_epsilon)),
            ("maxSeconds", self.max_seconds),
        ];
        for (name, value) in positive {
            if let Some(value) = value.filter(|v| !(v.is_finite() && *v > 0.0)) {
                return bad(name, value.to_string(), Allowed::Positive);
            }
        }
        if !(0.0..=1.0).contains(&self.epsilon) {
            let allowed = Allowed::Range {
                low: 0.0,
                high: 1.0,
            };
            return bad("epsilon", self.epsilon.to_string(), allowed);
        }
        if !(0.0..=MAX_PERTURBATION).contains(&self.perturbation) {
            let value = self.perturbation.to_string();
            let allowed = Allowed::Range {
                low: 0.0,
                high: MAX_PERTURBATION,
            };
            return bad("perturbation", value, allowed);
        }
        if self.smooth_steps == 0 {
            return bad("smoothSteps", "0".into(), Allowed::WholeFrom { low: 1 });
        }
        if self.p != 0.0 && !(1.0..=MAX_EXPONENT).contains(&self.p) {
            let allowed = Allowed::ZeroOrRange {
                low: 1.0,
                high: MAX_EXPONENT,
            };
            return bad("p", self.p.to_string(), allowed);
        }
        if let Some(v) = self.reduced_volume.filter(|v| !(*v > 0.0 && *v <= 1.0)) {
            return bad("reducedVolume", v.to_string(), Allowed::UpTo { high: 1.0 });
        }
        let terms = [
            ("spontaneousCurvature", self.spontaneous_curvature),
            ("tension", self.tension),
            ("pressure", self.pressure),
        ];
        match terms.into_iter().find(|(_, value)| !value.is_finite()) {
            Some((name, value)) => bad(name, value.to_string(), Allowed::Finite),
            None => Ok(()),
        }
    }

    /// The first step's τ: given, or from the detail to remove, or the scheme's own.
    pub fn first_tau(&self) -> f64 {
        match (self.tau, self.detail, self.goal, self.scheme) {
            (Some(tau), ..) => tau,
            (None, Some(detail), Goal::Smooth, _) => {
                Self::tau_for_detail(detail, self.smooth_steps)
            }
            (None, _, Goal::Relax, Scheme::Auto) => 1.0,
            _ => 0.01,
        }
    }
}
