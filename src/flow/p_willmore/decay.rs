//! How much there is to be lowered, and how fast it is.

use super::PWillmoreFlow;
use std::f64::consts::PI;

/// A mesh adds to the area of a ball, so that what there is to be lowered is no less than this share.
const LEAST_EXCESS: f64 = 1e-6;

impl PWillmoreFlow {
    /// Whether what falls is the area alone.
    fn is_area(&self) -> bool {
        self.options.p == 0.0 && self.functional.helfrich().is_zero()
    }

    /// What gains are compared with: the functional; of an area while the volume is kept what a ball
    /// leaves of it to be lowered, A³ ≥ 36πV², on meshes too. Near a round sphere that is little: bumps
    /// of a hundredth of the radius add a ten-thousandth to the area, and are no rest.
    pub(super) fn excess(&self, value: f64) -> f64 {
        if !self.is_area() || self.kept.volume.is_none() {
            return value.abs();
        }
        let volume = self.evaluation.integrals.volume;
        let ball = (36.0 * PI * volume.powi(2)).cbrt();
        (value - self.shown(ball)).max(LEAST_EXCESS * value)
    }

    /// |P(∇J − Σ λ∇C)| in the metric of M⁻¹, over J/L²: scale-free; 0 at a critical point. On
    /// a mesh it comes to rest at the size of the discretisation error, not at 0.
    pub(super) fn residual(&self, multipliers: &[f64]) -> f64 {
        let energy = self.evaluation.integrals.energy.abs();
        let size = energy.max(f64::MIN_POSITIVE) / self.scale.powi(2);
        self.squared_gradient(multipliers).sqrt() / size
    }

    /// The square of the same without its scale: −dJ/dt under the smooth flow.
    fn squared_gradient(&self, multipliers: &[f64]) -> f64 {
        let e = &self.evaluation;
        let kept = self.kept.gradients(e);
        let mut sum = 0.0;
        for (i, n) in e.volume_gradient.iter().enumerate() {
            let mut g = e.gradient[i];
            for (lambda, gradient) in multipliers.iter().zip(&kept) {
                g -= *lambda * gradient[i];
            }
            sum += g.dot(n.normalize_or_zero()).powi(2) / e.mass[i].max(f64::MIN_POSITIVE);
        }
        sum
    }

    /// How fast the smooth flow lowers the area, where that is all it does.
    pub(super) fn rate(&self) -> Option<f64> {
        let has_law = self.is_area() && !self.kept.any();
        has_law.then(|| self.squared_gradient(&[]))
    }
}
