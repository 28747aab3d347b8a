//! What a step tells.

use super::flips::FlipReading;
use super::warning::Warning;
use crate::remesh::adaptive::Soundness;
use serde::{Deserialize, Serialize};

/// Where a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, Default)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Status {
    /// Steps can be taken.
    #[default]
    Ready,
    /// Nothing is left to gain.
    Converged,
    /// The budget of steps or of time is used up.
    StepLimit,
    /// No step was accepted, or only ever smaller ones, although the surface is not at rest.
    Stalled,
    /// The surface pinches off or vanishes: the flow has no solution from there on.
    Singular,
    /// A step would go below what a theorem leaves to smooth surfaces of this topology.
    Collapsed,
    /// A step failed; the last good state is kept.
    Failed,
}

impl Status {
    /// Whether the run is over.
    pub fn is_final(self) -> bool {
        self != Self::Ready
    }

    /// Whether the surface could not be kept good any longer.
    pub fn is_breakdown(self) -> bool {
        matches!(self, Self::Singular | Self::Collapsed | Self::Failed)
    }
}

/// The functional that does not rise on an accepted step of the recommended scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Default)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Monitored {
    /// U_ε = Σ 2√(β² + ε²) − 2πN, which is W = Σ W_i as printed at ε = 0 and never below it.
    #[default]
    SmoothedCircle,
    /// Total area.
    Area,
    /// ∫H² dA.
    Willmore,
    /// ∫|H|^p dA.
    PWillmore,
    /// ∫(H − H₀)² dA + (σA − PV)/4.
    Helfrich,
    /// ∫|∇H|² dA.
    CurvatureVariation,
}

/// What a flow says of positions that it has not just stepped to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// The flow's own energy, as in [`StepReport::energy`].
    pub energy: f64,
    /// See [`StepReport::energy_normalised`].
    pub energy_normalised: f64,
    /// Which functional a step must not raise, and what it is here.
    pub monitored: Monitored,
    /// See [`StepReport::objective`].
    pub objective: f64,
    /// See [`StepReport::gradient_norm`].
    pub gradient_norm: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume of a closed, oriented surface.
    pub volume: Option<f64>,
    /// See [`StepReport::reduced_volume`].
    pub reduced_volume: Option<f64>,
}

/// One accepted step. Keys in JSON are the field names in camel case.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct StepReport {
    /// Number of the step, from 1.
    pub step: usize,
    /// Flow time after it, Σ dt, or what the flow's law takes for as much where steps are longer; for the circle flow with uniform mass unit length².
    pub time: f64,
    /// Raw step size.
    pub dt: f64,
    /// The flow's own reading: W = Σ W_i as printed, or ∫|H|^p dA, or with the terms of
    /// Helfrich ∫(H − H₀)² dA + (σA − PV)/4; the area under the flow by mean curvature and
    /// surface diffusion, ∫H² dA under the Willmore flow, ∫|∇H|² dA under mean-curvature
    /// variation, within two edges of the free vertices.
    pub energy: f64,
    /// The same made comparable: W/2, or ∫|H|^p dA over its value on the round sphere of
    /// the same area.
    pub energy_normalised: f64,
    /// Which functional the step must not raise.
    pub monitored: Monitored,
    /// Whether the step only prepares a rough start for the flow, and so may raise it.
    pub prepares: bool,
    /// That functional before the step.
    pub objective_before: f64,
    /// The same after.
    pub objective: f64,
    /// Circle flow: Frobenius norm of the objective's gradient over the free vertices, after.
    /// p-Willmore flow: its normal, constrained part, scale-free. Flows by mean curvature and
    /// its derivatives: root mean square of the velocity, scale-free; it need not vanish at
    /// rest on irregular meshes.
    pub gradient_norm: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume of a closed oriented surface.
    pub volume: Option<f64>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Trial steps refused before this one.
    pub rejected: usize,
    /// Whether any of them was refused for what it would make of the mesh, or for a theorem's
    /// bound.
    pub is_guarded: bool,
    /// Inner iterations: of the linear solver, or of Newton's method.
    pub iterations: usize,
    /// Wall-clock time of the step.
    pub milliseconds: f64,
    /// dt without a unit: dt/h², h the mean edge length at the start, or dt/L^(p+2), L the
    /// radius of the sphere with the area at the start.
    pub tau: f64,
    /// Angle smoothing ε.
    pub epsilon: f64,
    /// Negative eigenvalues of the system matrix, where it was factored.
    pub negative_pivots: usize,
    /// Angles left out of the gradient.
    pub skipped_angles: usize,
    /// Faces that folded over in this step: turned by more than a right angle, against
    /// their neighbours.
    pub flipped_faces: usize,
    /// Largest displacement of a vertex from the start, in units of h.
    pub max_displacement: f64,
    /// What keeps area and volume, where they are kept.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub multipliers: Option<Multipliers>,
    /// 6√π V / A^(3/2), 1 for a sphere; of closed surfaces under the p-Willmore flow.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub reduced_volume: Option<f64>,
    /// Edge flips: where each criterion stands, the chosen one first.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub flips: Option<Vec<FlipReading>>,
    /// Largest distance a vertex was to move, in mean edge lengths; under the flows by mean
    /// curvature and its derivatives, where it tells convergence.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub update: Option<f64>,
    /// Norm of the residual of the linear system over that of its right-hand side, under the
    /// same flows.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub linear_residual: Option<f64>,
    /// Time for energy, gradient and matrix where the step begins and ends.
    pub assemble_milliseconds: f64,
    /// Time for factorisations.
    pub factor_milliseconds: f64,
    /// Time for triangular solves and iterations.
    pub solve_milliseconds: f64,
    /// Time for trials: the functional at each, and what the mesh would be.
    pub search_milliseconds: f64,
    /// Time for sliding vertices along the surface.
    pub regularise_milliseconds: f64,
    /// Time for the pass of remeshing before the step, which is no part of `milliseconds`.
    pub remesh_milliseconds: f64,
    /// The pass of remeshing that came before the step, where there was one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub pass: Option<Pass>,
    /// Whether readings can be believed, looked at in every tenth step of the p-Willmore flow.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub soundness: Option<Soundness>,
    /// Worth telling the user.
    pub warnings: Vec<Warning>,
}

/// A pass of remeshing between two steps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Pass {
    /// The step before it.
    pub after_step: usize,
    /// Vertices after it.
    pub vertices: usize,
    /// Edges split.
    pub splits: usize,
    /// Edges collapsed.
    pub collapses: usize,
    /// Edges flipped.
    pub flips: usize,
    /// Smallest corner angle before and after, in degrees.
    pub angles: [f64; 2],
    /// The monitored functional before and after: what it jumps by is the error of the meshes.
    pub objective: [f64; 2],
}

/// Lagrange multipliers of a step: ∇∫|H|^p + tension ∇A − pressure ∇V would vanish at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Multipliers {
    /// Of the area.
    pub tension: Option<f64>,
    /// Of the volume; positive pushes outwards.
    pub pressure: Option<f64>,
}
