//! When a run is over, and why.
//!
//! *Idle* is a functional that has fallen by less than a share of itself over the last `WINDOW`
//! steps; which share, [`Rules::idle`](super::Rules) says. An idle run has converged if the surface
//! is at rest by its flow's own test, which does not depend on the step size
//! ([`Flow::stationarity`](super::Flow)); a step too small to move anything proves nothing. If it is
//! not at rest it has stalled, unless the step size was asked for, or steps are taken without trouble
//! and may yet grow.

use super::{Advice, Cause, Functional, Refusal, Status};
use crate::message::messages;
use glam::DVec3;

/// Steps looked back at.
const WINDOW: usize = 10;
/// With so many trials refused in those steps, or a step size that has shrunk to this share of
/// the largest, a run that gains nothing is stuck.
const MANY_REFUSED: usize = 8;
const VANISHING: f64 = 1e-3;
/// So many idle windows one after the other are no accident either.
const PATIENCE: usize = 4;

/// What to do after a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Decision {
    /// Take the next step.
    GoOn,
    /// The step was [given up](crate::interrupt): it can be taken again.
    GivenUp,
    /// The run is over for this reason.
    Stop(Status, Reason),
}

messages! {
    /// What a time is counted by: flows by mean curvature differ in it by a factor.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Clock as "clock" {
        /// That of the flow's own law.
        Own,
        /// The normal velocity is −H.
        MeanCurvature,
        /// It is −2H, the gradient of the area.
        AreaGradient,
    }
}

messages! {
    /// Why a run is over, beside what its status says.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum Reason as "reason" {
        /// The surface is at rest by the flow's own test.
        AtRest,
        /// No vertex moves any more.
        Still,
        /// The energy is zero up to roundoff.
        ZeroEnergy,
        /// The amount of smoothing asked for is done.
        Smoothed {
            /// In so many steps.
            steps: usize,
        },
        /// The limit of steps is reached.
        StepLimit {
            /// That limit.
            steps: usize,
        },
        /// The seconds of computing are used up.
        TimeLimit {
            /// So many.
            seconds: f64,
        },
        /// A face has grown so large that the mesh no longer resolves the surface.
        LargeFace {
            /// Which.
            face: u32,
            /// Its area over the mean.
            times: f64,
        },
        /// Every step tried was refused.
        Refused {
            /// The last one.
            cause: Cause,
            /// What helps.
            advice: Advice,
        },
        /// No first step could be taken from faces that have no area.
        FlatFace {
            /// How many.
            count: usize,
            /// The first.
            face: u32,
        },
        /// Only ever smaller steps lower the energy, which is not at rest.
        Creeping {
            /// What helps.
            advice: Advice,
        },
        /// The surface is so large already, and a larger one always has less energy.
        GrowsOn {
            /// Its area over that at first.
            times: f64,
        },
        /// Steps of a set size lead to more and more energy.
        Rises {
            /// The energy over the least of the run.
            times: f64,
        },
        /// Steps that the flow itself chooses do.
        RisesOn {
            /// The energy over the least of the run.
            times: f64,
            /// What helps.
            advice: Advice,
        },
        /// The flow ends with more energy than it had on the way.
        WorseRest {
            /// What helps.
            advice: Advice,
        },
        /// Any further step would have less energy than smooth surfaces of this topology can.
        BelowBound,
        /// Before the first step already, so that the mesh does not show the surface.
        Unresolved,
        /// The surface shrinks to a point.
        Vanishes {
            /// When.
            time: f64,
            /// By which clock.
            clock: Clock,
            /// Where.
            place: [f64; 3],
        },
        /// The surface shrinks to a curve, as a thin torus does.
        VanishesToCurve {
            /// When.
            time: f64,
            /// By which clock.
            clock: Clock,
        },
        /// A part that hangs together with no other shrinks to a point.
        PartVanishes {
            /// When.
            time: f64,
            /// By which clock.
            clock: Clock,
            /// Where.
            place: [f64; 3],
        },
        /// A neck pinches off.
        PinchedNeck {
            /// When.
            time: f64,
            /// By which clock.
            clock: Clock,
            /// The vertex of the sharpest bend.
            vertex: u32,
            /// Where it lies.
            place: [f64; 3],
            /// What helps.
            advice: Advice,
        },
        /// The surface bends more than its triangles can show, and is no neck there.
        SharpTip {
            /// The vertex of the sharpest bend.
            vertex: u32,
            /// Where it lies.
            place: [f64; 3],
            /// What helps.
            advice: Advice,
        },
        /// No edge flip lowers the cost any more.
        NoFlips {
            /// `area`, `willmore` or `localised`; `all` of the three.
            criterion: &'static str,
        },
    }
}

impl Reason {
    /// Whether the surface, or a part of it, is no more.
    pub fn is_of_vanishing(&self) -> bool {
        matches!(
            self,
            Self::Vanishes { .. } | Self::VanishesToCurve { .. } | Self::PartVanishes { .. }
        )
    }

    /// With its place, if it has one, moved as the surface is.
    #[must_use]
    pub fn moved(mut self, shift: DVec3) -> Self {
        if let Self::Vanishes { place, .. }
        | Self::PartVanishes { place, .. }
        | Self::PinchedNeck { place, .. }
        | Self::SharpTip { place, .. } = &mut self
        {
            *place = (DVec3::from_array(*place) + shift).to_array();
        }
        self
    }
}

/// The last few steps of a phase.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Window {
    gains: [f64; WINDOW],
    refused: [usize; WINDOW],
    guarded: [bool; WINDOW],
    count: usize,
    largest_dt: f64,
    idle_windows: usize,
    /// Whether a trial of theirs was refused as a theorem's bound lies above it.
    met_bound: bool,
}

/// An accepted step, as far as it tells whether a run is at its end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gain {
    pub(super) before: f64,
    pub(super) after: f64,
    pub(super) scale: f64,
    pub(super) dt: f64,
    /// See [`Rules::long_dt`](super::Rules).
    pub(super) long_dt: f64,
    /// See [`Rules::idle`](super::Rules).
    pub(super) idle: Option<f64>,
    pub(super) refused: usize,
    pub(super) is_guarded: bool,
    pub(super) met_bound: bool,
}

/// What a step brought about.
pub(super) struct Ending {
    pub(super) before: Functional,
    pub(super) after: Functional,
    pub(super) gain: Gain,
    /// Whether the step was so small that the surface is at rest.
    pub(super) rests: bool,
    /// Whether a constraint is led, so that a fall of the functional means nothing.
    pub(super) is_leading: bool,
}

impl Window {
    /// Notes an accepted step; whether the functional has stopped falling.
    pub(super) fn is_idle(&mut self, gain: Gain) -> bool {
        let slot = self.count % WINDOW;
        let counted = (gain.long_dt / gain.dt).min(1.0);
        self.gains[slot] = (gain.before - gain.after) * counted;
        self.refused[slot] = gain.refused;
        self.guarded[slot] = gain.is_guarded;
        self.count += 1;
        self.largest_dt = self.largest_dt.max(gain.dt);
        self.met_bound |= gain.met_bound;
        let fall: f64 = self.gains.iter().sum();
        let is_less = |share| fall < share * gain.scale.abs();
        self.count >= WINDOW && gain.idle.is_some_and(is_less)
    }

    /// Whether a run that is idle with steps of `dt`, and not at rest, can be given up.
    pub(super) fn is_stuck(&self, dt: f64) -> bool {
        self.refused.iter().sum::<usize>() >= MANY_REFUSED
            || dt < VANISHING * self.largest_dt
            || self.idle_windows + 1 >= PATIENCE
    }

    /// Whether a trial of the last steps was refused for the mesh or for a bound.
    pub(super) fn is_guarded(&self) -> bool {
        self.guarded.contains(&true)
    }

    /// Whether a trial was refused for a theorem's bound.
    pub(super) fn met_bound(&self) -> bool {
        self.met_bound
    }

    /// Looks at the next steps only.
    pub(super) fn next_window(&mut self) {
        *self = Self {
            largest_dt: self.largest_dt,
            idle_windows: self.idle_windows + 1,
            met_bound: self.met_bound,
            ..Self::default()
        };
    }
}

/// Whether a refusal may be of a surface that becomes singular, and not of a functional that
/// would rise.
pub(super) fn is_geometric(refusal: Option<Refusal>) -> bool {
    refusal.is_some_and(|refusal| {
        matches!(
            refusal.cause,
            Cause::Fold
                | Cause::TooFar
                | Cause::Turn
                | Cause::Sliver
                | Cause::Unfit
                | Cause::NotFinite
                | Cause::Constraints
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flow::rules::NEGLIGIBLE;

    fn gain(before: f64, after: f64, refused: usize) -> Gain {
        Gain {
            before,
            after,
            scale: after,
            dt: 1.0,
            long_dt: f64::INFINITY,
            idle: Some(NEGLIGIBLE),
            refused,
            is_guarded: false,
            met_bound: false,
        }
    }

    #[test]
    fn it_takes_ten_steps_together_to_be_idle() {
        let mut window = Window::default();
        for _ in 0..9 {
            assert!(!window.is_idle(gain(1.0, 1.0, 0)));
        }
        assert!(window.is_idle(gain(1.0, 1.0, 0)));
        // One step that gains counts for the ten that follow.
        assert!(!window.is_idle(gain(1.0, 0.9, 0)));
        for _ in 0..9 {
            assert!(!window.is_idle(gain(0.9, 0.9, 0)));
        }
        assert!(window.is_idle(gain(0.9, 0.9, 0)));
    }

    /// A hundred-thousandth of the functional in ten steps is the least that counts as a fall.
    #[test]
    fn a_fall_counts_by_its_share_and_by_no_more_than_a_long_step() {
        let falls = |fall: f64, dt: f64| {
            let mut window = Window::default();
            let step = Gain {
                dt,
                long_dt: 10.0,
                scale: 5.0,
                ..gain(5.0, 5.0 - 0.1 * fall, 0)
            };
            (0..10).for_each(|_| {
                window.is_idle(step);
            });
            !window.is_idle(step)
        };
        assert!(falls(5.5e-5, 1.0) && !falls(4.5e-5, 1.0));
        // A flow may ask for more, or for none.
        let asked = |idle| {
            let mut window = Window::default();
            let step = Gain {
                idle,
                ..gain(5.0, 5.0 - 0.1 * 5.5e-4, 0)
            };
            (0..10).map(|_| window.is_idle(step)).last()
        };
        assert_eq!(
            [1e-4, 1.2e-4].map(|share| asked(Some(share))),
            [Some(false), Some(true)]
        );
        assert_eq!(asked(None), Some(false));
        // In steps of 1000 gains count by a hundredth.
        assert!(falls(5.5e-3, 1000.0) && !falls(4.5e-3, 1000.0));
        // A long step counts as it is up to there, a short one for what it is.
        assert!(falls(5.5e-5, 10.0) && falls(5.5e-5, 1e-6));
    }

    #[test]
    fn a_bound_that_was_met_stays_known_and_a_guard_for_ten_steps() {
        let mut window = Window::default();
        let guarded = Gain {
            is_guarded: true,
            met_bound: true,
            ..gain(1.0, 1.0, 1)
        };
        window.is_idle(guarded);
        for _ in 0..9 {
            assert!(window.is_guarded());
            window.is_idle(gain(1.0, 1.0, 0));
        }
        window.is_idle(gain(1.0, 1.0, 0));
        assert!(!window.is_guarded() && window.met_bound());
        window.next_window();
        assert!(window.met_bound());
    }

    #[test]
    fn only_some_refusals_are_of_the_shape() {
        let refusal = Some(Refusal::of(Cause::Sliver));
        assert!(is_geometric(refusal) && !is_geometric(None));
        assert!(!is_geometric(Some(Refusal::of(Cause::Rise))));
    }

    #[test]
    fn idle_is_stuck_only_where_steps_are_refused_or_vanish_or_time_and_again() {
        let mut window = Window::default();
        (0..10).for_each(|_| {
            window.is_idle(gain(1.0, 1.0, 0));
        });
        assert!(!window.is_stuck(1.0) && window.is_stuck(1e-4));
        (0..3).for_each(|_| window.next_window());
        assert!(window.is_stuck(1.0));
        let mut window = Window::default();
        (0..10).for_each(|_| {
            window.is_idle(gain(1.0, 1.0, 1));
        });
        assert!(window.is_stuck(1.0));
    }
}
