//! The angle smoothing ε from step to step, and who takes the steps.
//!
//! The semi-implicit step is a good one near spheres, where its matrix is the Hessian. Away
//! from them it is not, and in the end gains next to nothing with ever smaller steps: then
//! L-BFGS goes on in rounds, each from a smoothed energy to the exact one, and hands back near
//! a sphere. W has cones, at whose tips its gradient says nothing of rest: a surface is at rest
//! where a whole round lowers W by next to nothing.

use crate::energy::circle::CircleEnergy;
use crate::energy::circle::angle::Smoothing;
use crate::flow::Warning;
use crate::flow::options::{FlowOptions, Goal, Integrator, Scheme};
use glam::DVec3;

/// The steps in which ε falls when the objective hardly falls any more.
const LEVELS: [f64; 4] = [0.03, 0.01, 0.003, 0.0];
/// The same for L-BFGS, which each smaller ε leads on from the last.
const FINE_LEVELS: [f64; 4] = [0.01, 0.003, 0.001, 0.0];
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
/// So many semi-implicit steps in a row that gain less than this share of W, after so many at
/// least, and L-BFGS takes over. With less, runs are handed over that soon would have come to
/// rest; with more, they crawl for hundreds of steps.
const WEAK: f64 = 1e-2;
const WEAK_STEPS: u32 = 5;
const FIRST_STEPS: u32 = 10;
/// ε at most for L-BFGS: it has no step size that would stall on the rim of a cone.
const FINISHING: f64 = 0.01;
/// A decrease per step below this is slow for L-BFGS.
const SLOW_FINISHING: f64 = 1e-4;
/// A round of L-BFGS that lowers W by less than this share of it was the last.
const REFUTED: f64 = 1e-3;
/// At the start the smoothing of angles below ε may lift the energy by this share of it at
/// most: with more, steps would lower hardly anything but the smoothing; with less, rough tori
/// come to rest at a higher W.
const LIFT: f64 = 2.0;
/// Choices for ε at the start where the one asked for lifts the energy by more.
const GENTLER: [f64; 4] = [0.03, 0.01, 0.003, 0.001];

/// The energy below which a surface with so many free vertices is nearly spherical.
pub(super) fn nearly_spherical(n_free: usize) -> f64 {
    NEARLY_SPHERICAL * n_free as f64
}

/// What a change of the schedule is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stage {
    /// None.
    Same,
    /// A smaller ε; the step size may begin anew.
    Sharper { restarts: bool },
    /// Close to a sphere: no ε, and longer steps.
    Spherical,
    /// A larger ε, or another integrator.
    Other(Warning),
}

/// ε of the current step: at first the user's, 0 close to a sphere, falling towards 0 at
/// the end if sharpening is on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Schedule {
    integrator: Integrator,
    /// ε away from spheres, what it was at the start, and what was asked for.
    level: f64,
    first_level: f64,
    asked: f64,
    sharpens: bool,
    exact: bool,
    /// Whether closeness to a sphere switches to the exact energy.
    trusts_spheres: bool,
    /// The paper's scheme: always exact.
    always_exact: bool,
    /// Whether L-BFGS may take over, whether it has, and W at the start of its round.
    can_finish: bool,
    is_finishing: bool,
    round_energy: f64,
    /// Whether its last round found nothing to gain.
    is_at_rest: bool,
    slow_steps: u32,
    weak_steps: u32,
    steps: u32,
    last_energy: f64,
    least_energy: f64,
}

impl Schedule {
    /// At the start of a run from `x`, with so many vertices that move.
    pub(super) fn new(
        options: &FlowOptions,
        energy: &CircleEnergy,
        x: &[DVec3],
        n_free: usize,
    ) -> Self {
        let always_exact = options.scheme == Scheme::Paper || options.epsilon == 0.0;
        let relaxes = options.goal == Goal::Relax;
        let asked = match options.integrator {
            Integrator::Lbfgs => options.epsilon.min(FINISHING),
            _ => options.epsilon,
        };
        let sharpens = options.sharpen && relaxes;
        let start_energy = energy.value(x, Smoothing::EXACT);
        let level = if always_exact || !relaxes {
            asked
        } else {
            bearable(asked, energy, x)
        };
        Self {
            integrator: options.integrator,
            level,
            first_level: level,
            asked,
            sharpens,
            exact: always_exact || sharpens && start_energy < nearly_spherical(n_free),
            trusts_spheres: true,
            always_exact,
            can_finish: options.integrator == Integrator::SemiImplicit
                && options.scheme == Scheme::Auto
                && relaxes,
            is_finishing: options.integrator == Integrator::Lbfgs,
            round_energy: start_energy,
            is_at_rest: false,
            slow_steps: 0,
            weak_steps: 0,
            steps: 0,
            last_energy: f64::INFINITY,
            least_energy: f64::INFINITY,
        }
    }

    pub(super) fn smoothing(&self) -> Smoothing {
        if self.exact {
            Smoothing::EXACT
        } else {
            Smoothing {
                epsilon: self.level,
            }
        }
    }

    /// Whether the energy is exact for closeness to a sphere, and its matrix the Hessian.
    pub(super) fn is_near_sphere(&self) -> bool {
        self.exact && !self.always_exact && self.level > 0.0 && !self.is_finishing
    }

    pub(super) fn integrator(&self) -> Integrator {
        if self.is_finishing {
            Integrator::Lbfgs
        } else {
            self.integrator
        }
    }

    /// Switches to the exact energy close to a sphere and back away from it; there the
    /// semi-implicit steps are the best.
    pub(super) fn before_step(&mut self, is_spherical: bool) -> Stage {
        if self.is_finishing && self.can_finish && is_spherical && self.trusts_spheres {
            self.is_finishing = false;
            self.level = self.first_level;
            self.weak_steps = 0;
            self.exact = true;
            return Stage::Other(Warning::NearSphere);
        }
        let exact = self.always_exact
            || self.level == 0.0
            || (self.sharpens && self.trusts_spheres && is_spherical);
        match (std::mem::replace(&mut self.exact, exact), exact) {
            (false, true) => Stage::Spherical,
            (true, false) => Stage::Other(Warning::AwayFromSphere),
            _ => Stage::Same,
        }
    }

    /// Notes a step, by the scale of the functional and by W after it.
    pub(super) fn after_step(
        &mut self,
        before: f64,
        after: f64,
        energy: f64,
        is_spherical: bool,
    ) -> Stage {
        self.steps += 1;
        let hardly_falls = self.least_energy - energy < SLOW * energy.abs();
        self.least_energy = self.least_energy.min(energy);
        let is_weak = self.last_energy - energy < WEAK * energy.abs();
        self.last_energy = energy;
        self.weak_steps = if is_weak { self.weak_steps + 1 } else { 0 };
        let share = if self.is_finishing {
            SLOW_FINISHING
        } else {
            SLOW
        };
        // Near a sphere the smoothed energy goes on falling when W does not any more.
        let slow = before - after < share * before.abs() || is_spherical && hardly_falls;
        self.slow_steps = if slow { self.slow_steps + 1 } else { 0 };
        if !self.is_finishing
            && self.weak_steps >= WEAK_STEPS
            && self.steps >= FIRST_STEPS
            && self.finish(energy, is_spherical)
        {
            return Stage::Other(Warning::LittleGain);
        }
        if self.slow_steps >= PATIENCE && self.sharpen() {
            return Stage::Sharper { restarts: false };
        }
        Stage::Same
    }

    /// After steps of `tau` = dt/h² that gain nothing, or none: what is left to be tried.
    pub(super) fn at_end(
        &mut self,
        tau: f64,
        energy: f64,
        is_spherical: bool,
        is_guarded: bool,
    ) -> Stage {
        if self.retreats(tau) {
            return Stage::Other(Warning::ExactHalt);
        }
        if self.sharpen() {
            return Stage::Sharper { restarts: true };
        }
        if self.finish(energy, is_spherical) {
            return Stage::Other(Warning::NoGain);
        }
        if self.is_finishing && !self.always_exact && self.sharpens {
            if self.round_energy - energy > REFUTED * energy {
                self.begin_round(energy);
                return Stage::Other(Warning::AnotherRound);
            }
            self.is_at_rest = !is_guarded;
        }
        Stage::Same
    }

    /// Whether the last round of L-BFGS found nothing to gain.
    pub(super) fn is_at_rest(&self) -> bool {
        self.is_at_rest
    }

    fn begin_round(&mut self, energy: f64) {
        self.round_energy = energy;
        self.is_at_rest = false;
        self.slow_steps = 0;
        if !self.always_exact && self.sharpens {
            self.level = FINISHING.min(self.asked);
            self.exact = false;
        }
    }

    /// Gives up the exact energy chosen for closeness to a sphere, for the rest of the run.
    fn retreats(&mut self, tau: f64) -> bool {
        let frozen = self.exact && !self.always_exact && self.level > 0.0 && tau < FROZEN;
        if frozen && self.trusts_spheres {
            self.trusts_spheres = false;
            self.level = self.asked.min(GENTLE);
            self.exact = false;
            self.slow_steps = 0;
            return true;
        }
        false
    }

    /// Hands over to L-BFGS, once and away from spheres.
    fn finish(&mut self, energy: f64, is_spherical: bool) -> bool {
        if self.is_finishing || !self.can_finish || is_spherical {
            return false;
        }
        self.is_finishing = true;
        self.begin_round(energy);
        true
    }

    /// Goes to the next smaller ε; `false` if there is none.
    fn sharpen(&mut self) -> bool {
        if self.exact || !self.sharpens {
            return false;
        }
        self.slow_steps = 0;
        let levels = if self.is_finishing {
            FINE_LEVELS
        } else {
            LEVELS
        };
        match levels.into_iter().find(|&l| l < self.level) {
            Some(level) => {
                self.level = level;
                self.exact = level == 0.0;
                true
            }
            None => false,
        }
    }
}

/// The ε asked for, or the largest of some smaller ones by which angles below it lift the
/// energy by little: Σ (√(β² + ε²) − β) over the β < ε, against W.
fn bearable(asked: f64, energy: &CircleEnergy, x: &[DVec3]) -> f64 {
    let angles = energy.angles(x);
    let total = energy.value(x, Smoothing::EXACT);
    let lift = |epsilon: f64| -> f64 {
        let small = angles.iter().filter(|(beta, _)| *beta < epsilon);
        small
            .map(|(beta, count)| count * (beta.hypot(epsilon) - beta))
            .sum()
    };
    let choices = std::iter::once(asked).chain(GENTLER.into_iter().filter(|&e| e < asked));
    let mut last = asked;
    for epsilon in choices {
        last = epsilon;
        if lift(epsilon) <= LIFT * total {
            break;
        }
    }
    last
}
