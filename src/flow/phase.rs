//! A run may have phases, which monitor or integrate differently: a smoothing that is taken
//! back, a finisher, a ladder of another flow.

use super::{Warning, circle, curvature, p_willmore};
use glam::DVec3;

/// When a flow is asked whether another phase is due.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Occasion {
    /// Before a step is proposed, at a state that was just evaluated.
    Before,
    /// A step was accepted.
    Accepted {
        /// The functional's scale before it, see [`Functional`](super::Functional).
        before: f64,
        /// The same after.
        after: f64,
    },
    /// The functional has stopped falling, with steps of this size.
    Idle {
        /// The step size now.
        dt: f64,
        /// Whether longer ones were refused for what they would make of the mesh, or for a
        /// theorem's bound.
        is_guarded: bool,
    },
    /// No step was accepted, down to this size.
    Stuck {
        /// The last step size tried.
        dt: f64,
        /// As for [`Idle`](Self::Idle).
        is_guarded: bool,
    },
    /// The run is about to end as stalled or at rest: the last chance to put something better
    /// in place.
    Ending {
        /// Whether the surface is at rest.
        is_at_rest: bool,
    },
}

/// A phase that begins.
#[derive(Clone, Debug, Default)]
pub struct Phase {
    /// Where it begins, if not at the surface as it is.
    pub from: Option<Vec<DVec3>>,
    /// Whether a run that was about to end goes on from there.
    pub goes_on: bool,
    /// Whether the step size begins anew.
    pub resets_step_size: bool,
    /// Whether it is from now on at least the one that a run would begin with here.
    pub raises_step_size: bool,
    /// Worth telling the user.
    pub event: Option<Warning>,
}

/// All that a flow has learnt and does not work out again from the positions.
pub enum Learnt {
    /// No more than it must remember.
    Memory(Memory),
    /// By the circle-angle flow.
    Circle(circle::Learnt),
    /// By the flows by mean curvature and its derivatives.
    Curvature(curvature::Learnt),
}

/// What a flow must remember beside the positions.
#[derive(Clone, Debug)]
pub enum Memory {
    /// Of the circle-angle flow.
    Circle(circle::Memory),
    /// Of the p-Willmore flow.
    PWillmore(p_willmore::Memory),
    /// Of the flows by mean curvature and its derivatives.
    Curvature(curvature::Memory),
}
