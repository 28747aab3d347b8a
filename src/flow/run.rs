//! Where a run stands: what it started from, its budget, and what a step back restores.

use super::step_size::StepSize;
use super::termination::Window;
use super::warning::WarningsGiven;
use super::{Learnt, Memory, Refusal};
use glam::DVec3;

/// What a run is compared with.
pub(super) struct Start {
    pub(super) x: Vec<DVec3>,
    pub(super) area: f64,
    pub(super) angle: f64,
    /// Area of the largest face over the mean.
    pub(super) largest_face: f64,
}

/// Where a run stands, but for the positions and what the flow itself remembers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Run {
    pub(super) step_size: StepSize,
    pub(super) time: f64,
    pub(super) step: usize,
    /// Area and diagonal of the surface at its very first, whatever meshes it has had since.
    pub(super) first_area: f64,
    pub(super) first_size: f64,
    /// The step the budget counts from, and the seconds used since.
    pub(super) first_step: usize,
    pub(super) seconds: f64,
    pub(super) window: Window,
    pub(super) given: WarningsGiven,
    /// The least energy since then, and the step that had it.
    pub(super) least: (f64, usize),
    /// Whether the next step is to end the run, as it gains nothing.
    pub(super) is_exhausted: bool,
}

/// All that a step may change of a driver.
pub struct Mark {
    pub(super) run: Run,
    pub(super) learnt: Learnt,
    pub(super) refusal: Option<Refusal>,
    pub(super) flipped: Vec<u32>,
}

/// What a step back restores along with the positions.
#[derive(Clone, Debug)]
pub struct Checkpoint {
    pub(super) run: Run,
    pub(super) memory: Memory,
}
