//! The angle smoothing ε from step to step, and who takes the steps.
//!
//! The semi-implicit step is a good one near spheres, where its matrix is the Hessian. Away
//! from them it is not, and in the end gains next to nothing with ever smaller steps: then
//! L-BFGS goes on in rounds, each from a smoothed energy to the exact one, and hands back near
//! a sphere. A sphere whose smoothed steps gain little tries the exact energy before that, which
//! is kept for as long as it gains. W has cones, at whose tips its gradient says nothing of rest: a
//! surface is at rest where a whole round lowers W by next to nothing.

use crate::energy::circle::CircleEnergy;
use crate::energy::circle::angle::Smoothing;
use crate::flow::Warning;
use crate::flow::options::{FlowOptions, Goal, Integrator, Scheme};
use crate::flow::rules::NEGLIGIBLE;
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
/// A sphere below this energy per free vertex may do without smoothed angles too: the exact
/// energy is tried where smoothed steps gain little, for what is left may be the smoothing …
const PERHAPS_SPHERICAL: f64 = 1e-2;
/// … which is so many steps in a row that gain less than this share of W. As many such steps of
/// the exact energy that had to be shortened end the attempt; where they are whole, the step size
/// is still growing.
const LITTLE: f64 = 5e-2;
const LITTLE_STEPS: u32 = 3;
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
const REFUTED: f64 = 5e-3;
/// Of the exact energy, on whose cones every step of L-BFGS gains a little for as long as the mesh
/// lasts, a round is over where ten steps gain less than this share.
const CREEPING: f64 = 1e-4;
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

/// Whether the exact energy is tried before the surface is nearly spherical.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Attempt {
    /// On no other surfaces than spheres, or not any more.
    Never,
    /// Not yet.
    Later,
    Now,
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
    attempt: Attempt,
    /// Energy below which it may begin, and steps in a row that speak for it or against it.
    attempt_below: f64,
    little_steps: u32,
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
    /// At the start of a run from `x`, with so many vertices that move, of a sphere or not.
    pub(super) fn new(
        options: &FlowOptions,
        energy: &CircleEnergy,
        x: &[DVec3],
        n_free: usize,
        is_sphere: bool,
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
        let can_finish = options.integrator == Integrator::SemiImplicit
            && options.scheme == Scheme::Auto
            && relaxes;
        Self {
            integrator: options.integrator,
            level,
            first_level: level,
            asked,
            sharpens,
            exact: always_exact || sharpens && start_energy < nearly_spherical(n_free),
            trusts_spheres: true,
            attempt: if is_sphere && can_finish && sharpens {
                Attempt::Later
            } else {
                Attempt::Never
            },
            attempt_below: PERHAPS_SPHERICAL * n_free as f64,
            little_steps: 0,
            always_exact,
            can_finish,
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

    /// The share of the functional that ten steps must gain for a round to go on.
    pub(super) fn idle(&self) -> f64 {
        let is_last = self.is_finishing && self.exact && self.sharpens && !self.always_exact;
        if is_last { CREEPING } else { NEGLIGIBLE }
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
        let tries = is_spherical || self.attempt == Attempt::Now && !self.is_finishing;
        let exact = self.always_exact
            || self.level == 0.0
            || (self.sharpens && self.trusts_spheres && tries);
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
        is_whole: bool,
    ) -> Stage {
        self.steps += 1;
        let hardly_falls = self.least_energy - energy < SLOW * energy.abs();
        self.least_energy = self.least_energy.min(energy);
        let gained = self.last_energy - energy;
        let (is_weak, is_little) = (gained < WEAK * energy, gained < LITTLE * energy);
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
        if !is_spherical && self.ends_attempt(energy, is_little, is_whole) {
            return Stage::Other(Warning::AwayFromSphere);
        }
        if !self.is_finishing
            && self.attempt != Attempt::Now
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

    /// Lets the attempt at the exact energy begin or end, after a step away from spheres; whether
    /// it ends.
    fn ends_attempt(&mut self, energy: f64, is_little: bool, is_whole: bool) -> bool {
        if !is_little {
            self.little_steps = 0;
        } else if !(is_whole && self.attempt == Attempt::Now) {
            self.little_steps += 1;
        }
        if self.little_steps < LITTLE_STEPS || self.is_finishing {
            return false;
        }
        if self.attempt == Attempt::Later && energy < self.attempt_below {
            self.attempt = Attempt::Now;
            self.little_steps = 0;
            return false;
        }
        self.give_up_attempt()
    }

    /// Ends the attempt at the exact energy, if there is one.
    fn give_up_attempt(&mut self) -> bool {
        if self.attempt != Attempt::Now {
            return false;
        }
        self.attempt = Attempt::Never;
        self.exact = false;
        (self.slow_steps, self.weak_steps) = (0, 0);
        true
    }

    /// After steps of `tau` = dt/h² that gain nothing, or none: what is left to be tried.
    pub(super) fn at_end(
        &mut self,
        tau: f64,
        energy: f64,
        is_spherical: bool,
        is_guarded: bool,
    ) -> Stage {
        if !is_spherical && self.give_up_attempt() {
            return Stage::Other(Warning::AwayFromSphere);
        }
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

    /// Goes on by L-BFGS and the exact energy, from a surface of this W, and says whether that may
    /// be: where the user asked for smoothed angles to the end, it may not.
    pub(super) fn goes_exact(&mut self, energy: f64) -> bool {
        let may = self.is_finishing && !self.always_exact && self.sharpens;
        if may {
            self.begin_round(energy);
            (self.level, self.exact) = (0.0, true);
        }
        may
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::circle::Boundary;
    use crate::mesh::{build, shape};

    const FREE: usize = 1000;

    fn schedule(is_sphere: bool) -> Schedule {
        let ball = shape::make("ellipsoid", &[]).expect("a shape");
        let built = build(&ball.soup).expect("a surface");
        let energy = CircleEnergy::new(&built.mesh, Boundary::Clamped);
        let options = FlowOptions::default();
        let mut schedule = Schedule::new(&options, &energy, &built.positions, FREE, is_sphere);
        assert_eq!(schedule.before_step(false), Stage::Same);
        assert!(!schedule.exact);
        schedule
    }

    /// Steps to these energies, whole or not; the first stage that is not the same.
    fn steps(schedule: &mut Schedule, energies: &[f64], is_whole: bool) -> Option<Stage> {
        let mut stages = energies.iter().flat_map(|&energy| {
            let after = schedule.after_step(10.0 * energy, 9.0 * energy, energy, false, is_whole);
            [after, schedule.before_step(false)]
        });
        stages.find(|stage| *stage != Stage::Same)
    }

    #[test]
    fn spheres_try_the_exact_energy_where_little_is_gained() {
        let little = [8.0, 7.9, 7.8, 7.7];
        for (is_sphere, share, is_due) in
            [(true, 1.0, true), (true, 2.0, false), (false, 1.0, false)]
        {
            let mut schedule = schedule(is_sphere);
            let stage = steps(&mut schedule, &little.map(|w| share * w), true);
            assert_eq!(stage, is_due.then_some(Stage::Spherical));
            assert_eq!(schedule.is_near_sphere(), is_due);
        }
        assert_eq!(
            steps(&mut schedule(true), &[8.0, 7.0, 6.0, 5.0, 4.0], true),
            None
        );
    }

    #[test]
    fn an_attempt_ends_where_shortened_steps_gain_little_and_is_the_only_one() {
        let mut schedule = schedule(true);
        steps(&mut schedule, &[8.0, 7.9, 7.8, 7.7], false);
        assert!(schedule.exact);
        assert_eq!(steps(&mut schedule, &[7.6, 7.5, 7.4, 7.3, 7.2], true), None);
        assert_eq!(steps(&mut schedule, &[7.1, 7.0], false), None);
        assert_eq!(steps(&mut schedule, &[6.0], false), None);
        assert_eq!(steps(&mut schedule, &[5.9, 5.8], false), None);
        let ended = Stage::Other(Warning::AwayFromSphere);
        assert_eq!(steps(&mut schedule, &[5.7], false), Some(ended));
        assert!(!schedule.exact);
        assert_eq!(steps(&mut schedule, &[5.5, 5.4, 5.3, 5.2], false), None);
    }

    #[test]
    fn an_attempt_that_is_stuck_is_given_up_before_spheres_are() {
        let mut schedule = schedule(true);
        steps(&mut schedule, &[8.0, 7.9, 7.8, 7.7], false);
        let ended = Stage::Other(Warning::AwayFromSphere);
        assert_eq!(schedule.at_end(1e-9, 7.7, false, false), ended);
        assert!(!schedule.exact && schedule.trusts_spheres);
    }
}
