//! What distinguishes the flows: a velocity law with its linearisation.

use super::curvatures::Curvatures;
use super::velocity::Velocity;
use super::{curvature_variation, mean_curvature, surface_diffusion, willmore};
use crate::flow::FlowError;
use crate::flow::option::Allowed;
use crate::flow::spec::FlowName;

/// Which velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Law {
    MeanCurvature,
    SurfaceDiffusion,
    Willmore,
    CurvatureVariation,
}

impl Law {
    /// That of a flow.
    pub(super) fn of(flow: FlowName) -> Result<Self, FlowError> {
        match flow {
            FlowName::MeanCurvature => Ok(Self::MeanCurvature),
            FlowName::SurfaceDiffusion => Ok(Self::SurfaceDiffusion),
            FlowName::Willmore => Ok(Self::Willmore),
            FlowName::Mmcv => Ok(Self::CurvatureVariation),
            _ => {
                let allowed = Allowed::CurvatureFlow;
                Err(FlowError::option("flow", flow.id(), allowed))
            }
        }
    }

    /// Order of the equation in space, k: dt has the unit length^k.
    pub(super) fn order(self) -> i32 {
        match self {
            Self::MeanCurvature => 2,
            Self::SurfaceDiffusion | Self::Willmore => 4,
            Self::CurvatureVariation => 6,
        }
    }

    /// Stencils between a vertex and the curvatures its velocity depends on; also the rings
    /// of held vertices that carry the derivatives of the surface beyond a patch.
    pub(super) fn depth(self) -> usize {
        self.order() as usize / 2 - 1
    }

    /// The velocity of vertex `i`, written so that it can be taken implicitly.
    pub(super) fn linearise(
        self,
        at: &Curvatures,
        i: usize,
        velocity: &mut Velocity,
    ) -> Result<(), FlowError> {
        velocity.clear();
        match self {
            Self::MeanCurvature => mean_curvature::linearise(i, velocity),
            Self::SurfaceDiffusion => surface_diffusion::linearise(at, i, velocity)?,
            Self::Willmore => willmore::linearise(at, i, velocity)?,
            Self::CurvatureVariation => curvature_variation::linearise(at, i, velocity)?,
        }
        Ok(())
    }

    /// What the flow decreases: the area under the flow by mean curvature and surface
    /// diffusion, ∫H² dA, ∫|∇H|² dA; see [`Curvatures::integrate`] for the part of the
    /// surface that counts.
    pub(super) fn energy(self, at: &Curvatures, area: impl FnOnce() -> f64) -> f64 {
        match self {
            Self::MeanCurvature | Self::SurfaceDiffusion => area(),
            Self::Willmore => at.integrate(willmore::density),
            Self::CurvatureVariation => at.integrate(curvature_variation::density),
        }
    }

    /// By how much the area falls in a unit of the flow's time, −dA/dt = 2∫H² or 2∫|∇H|² over the
    /// vertices that move; `None` of the other laws.
    pub(super) fn rate(self, at: &Curvatures, is_free: &[bool]) -> Option<f64> {
        let density = match self {
            Self::MeanCurvature => willmore::density,
            Self::SurfaceDiffusion => curvature_variation::density,
            Self::Willmore | Self::CurvatureVariation => return None,
        };
        let of = |at: &Curvatures, row, i: usize| f64::from(is_free[i]) * density(at, row, i);
        Some(2.0 * at.integrate(of))
    }

    /// The energy without a unit, for surfaces of size `length`.
    pub(super) fn normalised(self, energy: f64, length: f64) -> f64 {
        match self {
            Self::MeanCurvature | Self::SurfaceDiffusion => energy / (length * length),
            Self::Willmore => energy,
            Self::CurvatureVariation => energy * length * length,
        }
    }
}
