//! Flows: a system each, and one driver for all of them.
//!
//! A [`Flow`] says what it monitors, proposes a move for a step size and measures a trial.
//! The [`Driver`] owns the rest: which trials are accepted, the step size, the budget, folds
//! and quality, collapse and extinction, warnings, how a run ends, and the report. Edge flips
//! change connectivity and no position; they stand beside the flows ([`flips`]).

mod accepted;
mod access;
pub mod boundary;
pub mod bounds;
pub mod circle;
mod conformal_fields;
pub mod constraint;
pub mod cost;
pub mod curvature;
pub mod driver;
mod ending;
pub mod equation;
pub mod error;
pub mod flips;
mod guard;
pub mod option;
pub mod options;
pub mod p_willmore;
pub mod phase;
pub mod prefill;
pub mod proposal;
pub mod refusal;
pub mod report;
pub mod rules;
mod run;
#[cfg(test)]
mod scripted;
mod search;
mod settled;
pub mod signs;
pub mod spec;
pub mod step_size;
pub mod termination;
pub mod vesicle;
pub mod warning;

pub use cost::Cost;
pub use driver::Driver;
pub use error::FlowError;
pub use phase::{Learnt, Memory, Occasion, Phase};
pub use proposal::{Move, Proposal, Search};
pub use refusal::{Cause, Refusal};
pub use report::{Monitored, Multipliers, Pass, Reading, Status, StepReport};
pub use rules::Rules;
pub use run::{Checkpoint, Mark};
pub use termination::{Clock, Decision, Reason};
pub use warning::{Advice, Warning};

use glam::DVec3;
use step_size::StepSize;
use warning::WarningsGiven;

/// The monitored functional at a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Functional {
    /// Its value.
    pub value: f64,
    /// What gains are compared with: the value, less a part that no step can change.
    pub scale: f64,
    /// By how much the smooth flow would lower it here in a unit of its time, −dF/dt, where that is
    /// known: then it tells the time of steps that are longer than the flow's law holds.
    pub rate: Option<f64>,
}

impl Functional {
    /// All of whose value can change.
    pub fn plain(value: f64) -> Self {
        Self {
            value,
            scale: value.abs(),
            rate: None,
        }
    }

    /// How long the smooth flow takes from this to a lower value; `None` where that is not known.
    ///
    /// Towards a rest it is their difference over the logarithmic mean of the rates, which is exact
    /// where it decays exponentially. Where it can vanish the rate is taken for a power of the value, as
    /// it is of spheres (constant) and of thin tubes (the reciprocal), r = r₀(v/v₀)ᵏ:
    ///
    /// ```math
    /// t = \frac{v_0}{r_0} \, \frac{1 - (v_1/v_0)^{1-k}}{1 - k}.
    /// ```
    fn time_to(&self, lower: &Self, can_vanish: bool) -> Option<f64> {
        let (a, b) = (self.rate?, lower.rate?);
        let ratio = a / b;
        let fall = (lower.value / self.value).ln();
        if can_vanish && fall < -1e-6 {
            let power = fall + ratio.ln();
            let time = self.value / a
                * if power == 0.0 {
                    -fall
                } else {
                    -power.exp_m1() / (power / fall)
                };
            return (time.is_finite() && time >= 0.0).then_some(time);
        }
        let mean = if (ratio - 1.0).abs() < 1e-6 {
            a
        } else {
            (a - b) / ratio.ln()
        };
        let time = (self.value - lower.value) / mean;
        (time.is_finite() && time >= 0.0).then_some(time)
    }
}

/// A flow on one mesh with one set of options: its system, without a loop.
pub trait Flow {
    /// The functional that must not rise in the present phase.
    fn monitored(&self) -> Monitored;

    /// What the driver sees to in the present phase.
    fn rules(&self) -> Rules;

    /// The size of the first step, and how it may change.
    fn step_size(&self) -> StepSize;

    /// dt over this is τ, the step size without a unit.
    fn time_unit(&self) -> f64;

    /// The monitored functional at `x`, with all that a proposal and a report need.
    ///
    /// # Errors
    /// [`FlowError::NonFiniteEnergy`], [`FlowError::Unfit`].
    fn evaluate(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<Functional, FlowError>;

    /// The move that a step size amounts to, from where [`evaluate`](Self::evaluate) was last
    /// called.
    ///
    /// # Errors
    /// Numerical failures.
    fn propose(&mut self, x: &[DVec3], dt: f64, cost: &mut Cost) -> Result<Proposal, FlowError>;

    /// The monitored functional at a trial `y` on the way from `x`; moves it onto constraints
    /// first, where there are any.
    ///
    /// # Errors
    /// What is wrong with the trial.
    fn measure(&mut self, x: &[DVec3], y: &mut [DVec3]) -> Result<f64, Refusal>;

    /// ⟨∇F, d⟩ at the trial that was measured last; asked for by [`Search::Wolfe`] only.
    fn trial_slope(&self, _d: &[DVec3]) -> f64 {
        f64::NAN
    }

    /// At the trial that was measured last, what a theorem bounds; see [`Rules::bound`].
    fn bounded(&self) -> f64 {
        f64::INFINITY
    }

    /// The trial that was measured last is taken: `share` of the move that was proposed last.
    fn accept(&mut self, _step: &Move, _share: f64) {}

    /// Slides vertices along the surface `y` that a step from `x` led to, to make its mesh
    /// better without raising the functional above `limit`; `None` where nothing was done.
    /// Measured where it is left.
    ///
    /// # Errors
    /// Numerical failures.
    fn slide(
        &mut self,
        _x: &[DVec3],
        _y: &[DVec3],
        _limit: f64,
        _cost: &mut Cost,
    ) -> Result<Option<Vec<DVec3>>, FlowError> {
        Ok(None)
    }

    /// What changes at an occasion, if anything: a phase monitors or integrates differently.
    ///
    /// # Errors
    /// Numerical failures.
    fn next_phase(
        &mut self,
        _x: &[DVec3],
        _occasion: &Occasion,
        _cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        Ok(None)
    }

    /// How far `x` is from rest, by a test without a unit that does not depend on the step
    /// size; at most 1 is at rest.
    ///
    /// # Errors
    /// Numerical failures.
    fn stationarity(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError>;

    /// What of the report is the flow's own, at the state evaluated last.
    fn describe(&mut self, x: &[DVec3], report: &mut StepReport);

    /// What the numbers cannot tell; each is said once a run.
    fn warn(&self, _x: &[DVec3], _report: &mut StepReport, _given: &mut WarningsGiven) {}

    /// What there is to say of a surface at rest.
    fn rested(&self, _x: &[DVec3]) -> Option<Warning> {
        None
    }

    /// What its time is counted by.
    fn clock(&self) -> Clock {
        Clock::Own
    }

    /// What helps a run that can go no further.
    fn advice(&self) -> Advice {
        Advice::FinerMesh
    }

    /// Readings at positions that come from elsewhere.
    fn reading(&mut self, x: &[DVec3]) -> Reading;

    /// What moves the surface, a vector a vertex, zero where it is held.
    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3>;

    /// Pointwise H as the flow measures it, a value a vertex, where that is not the usual
    /// [`pointwise_mean_curvature`](crate::geometry::curvature::pointwise_mean_curvature).
    fn mean_curvature(&self, _x: &[DVec3]) -> Option<Vec<f64>> {
        None
    }

    /// Mean edge length of what moves at the start.
    fn mean_edge_length(&self) -> f64;

    /// Number of vertices that move.
    fn n_free(&self) -> usize;

    /// Whether a vertex moves.
    fn is_free(&self, v: usize) -> bool;

    /// What the flow must remember to go on from here as if nothing had been between.
    fn memory(&self) -> Memory;

    /// Goes back to that; what is known of other positions is forgotten.
    fn recall(&mut self, memory: Memory);

    /// All that a step may change of what the flow goes on with.
    fn learnt(&self) -> Learnt {
        Learnt::Memory(self.memory())
    }

    /// Goes back to that, as if no step had been begun since.
    fn relearn(&mut self, learnt: Learnt) {
        if let Learnt::Memory(memory) = learnt {
            self.recall(memory);
        }
    }

    /// Lets go of what is large and can be made again, as it was, from what is kept.
    fn release(&mut self) {}
}

#[cfg(test)]
mod time {
    use super::Functional;

    /// Of v with dv/dt = −r: a sphere whose area falls at a constant rate, a thin tube whose rate is
    /// the reciprocal of its area, and a decay to nothing, whose rate is the area itself.
    #[test]
    fn the_time_of_a_step_is_exact_for_powers() {
        let at = |value: f64, power: i32| Functional {
            rate: Some(2.0 * value.powi(power)),
            ..Functional::plain(value)
        };
        let (first, last) = (3.0_f64, 0.2_f64);
        for (power, time) in [
            (0, 0.5 * (first - last)),
            (-1, 0.25 * (first * first - last * last)),
            (1, 0.5 * (first / last).ln()),
        ] {
            let found = at(first, power).time_to(&at(last, power), true);
            let found = found.expect("known rates");
            assert!(
                (found / time - 1.0_f64).abs() < 1e-12,
                "{power}: {found} {time}"
            );
        }
        // Towards a rest the rate is what is left.
        let rest = |left: f64| Functional {
            rate: Some(2.0 * left),
            ..Functional::plain(1.0 + left)
        };
        let found = rest(3.0).time_to(&rest(0.2), false).expect("known rates");
        assert!(
            (found / (0.5 * 15.0_f64.ln()) - 1.0).abs() < 1e-12,
            "{found}"
        );
    }
}
