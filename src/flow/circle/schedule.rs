//! The angle smoothing ε from step to step.

use crate::energy::circle::angle::Smoothing;
use crate::flow::options::{FlowOptions, Goal, Integrator, Scheme};

/// The steps in which ε falls when the objective hardly falls any more.
const LEVELS: [f64; 4] = [0.03, 0.01, 0.003, 0.0];
/// A relative decrease per step below this is slow …
const SLOW: f64 = 1e-3;
/// … and so many slow steps in a row are the sign to sharpen: one alone may only mean
/// that the step size has just been cut.
const PATIENCE: u32 = 5;
/// With less exact energy per free vertex than this the surface is nearly spherical: as a
/// rule no cone β = 0 is in the way, and smoothed angles would slow the last digits down.
const NEARLY_SPHERICAL: f64 = 1e-3;
/// Where cones are in the way all the same, as on a latitude–longitude mesh, exact steps
/// shrink without end: below this share of h² they are taken for that.
const FROZEN: f64 = 1e-3;
/// ε from there on: a larger one would first carry the surface far from the sphere.
const GENTLE: f64 = 0.01;

/// ε of the current step: at first the user's, 0 close to a sphere, falling towards 0 at
/// the end if sharpening is on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct EpsilonSchedule {
    /// ε away from spheres.
    level: f64,
    sharpens: bool,
    exact: bool,
    /// Whether closeness to a sphere switches to the exact energy.
    trusts_spheres: bool,
    /// The paper's scheme: always exact.
    always_exact: bool,
    slow_steps: u32,
}

impl EpsilonSchedule {
    pub(super) fn new(options: &FlowOptions) -> Self {
        let always_exact = options.scheme == Scheme::Paper || options.epsilon == 0.0;
        // The note's best ε for a quasi-Newton method is smaller: it has no step size
        // that would stall on the rim of a cone.
        let level = match options.integrator {
            Integrator::Lbfgs => options.epsilon.min(0.01),
            _ => options.epsilon,
        };
        Self {
            level,
            sharpens: options.sharpen && options.goal == Goal::Relax,
            exact: always_exact,
            trusts_spheres: true,
            always_exact,
            slow_steps: 0,
        }
    }

    pub(super) fn current(&self) -> Smoothing {
        if self.exact {
            Smoothing::EXACT
        } else {
            Smoothing {
                epsilon: self.level,
            }
        }
    }

    /// Switches to the exact energy close to a sphere and back away from it, going by
    /// the exact `energy` of `n_free` vertices; whether it did.
    pub(super) fn adapt(&mut self, energy: f64, n_free: usize) -> bool {
        let exact = self.always_exact
            || self.level == 0.0
            || (self.sharpens && self.trusts_spheres && energy < NEARLY_SPHERICAL * n_free as f64);
        std::mem::replace(&mut self.exact, exact) != exact
    }

    /// After steps of `tau` = dt/h² that gain nothing: gives up the exact energy chosen for
    /// closeness to a sphere, for the rest of the run; whether it did.
    pub(super) fn retreat(&mut self, tau: f64) -> bool {
        let frozen = self.exact && !self.always_exact && self.level > 0.0 && tau < FROZEN;
        if frozen && self.trusts_spheres {
            self.trusts_spheres = false;
            self.level = self.level.min(GENTLE);
            self.exact = false;
            self.slow_steps = 0;
            return true;
        }
        false
    }

    /// Notes a step; whether the last few gained so little that a smaller ε is due.
    pub(super) fn should_sharpen(&mut self, before: f64, after: f64) -> bool {
        let slow = before - after < SLOW * before.abs();
        self.slow_steps = if slow { self.slow_steps + 1 } else { 0 };
        !self.exact && self.slow_steps >= PATIENCE
    }

    /// Goes to the next smaller ε; `false` if there is none.
    pub(super) fn sharpen(&mut self) -> bool {
        if self.exact || !self.sharpens {
            return false;
        }
        self.slow_steps = 0;
        match LEVELS.into_iter().find(|&l| l < self.level) {
            Some(level) => {
                self.level = level;
                self.exact = level == 0.0;
                true
            }
            None => false,
        }
    }
}
