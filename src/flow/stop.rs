//! When a run is over, and why.

use super::Status;

/// Relative decrease of the objective below which a step gains nothing.
const NEGLIGIBLE: f64 = 1e-6;
/// So many such steps in a row end the run.
const PATIENCE: usize = 5;

/// Counts steps that gain nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Progress {
    idle: usize,
}

/// What to do after a step.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Take the next step.
    GoOn,
    /// The run is over for this reason.
    Stop(Status, String),
}

impl Progress {
    /// Notes one accepted step; whether the objective has stopped falling.
    pub fn is_idle(&mut self, before: f64, after: f64) -> bool {
        let gained = before - after > NEGLIGIBLE * before.abs();
        self.idle = if gained { 0 } else { self.idle + 1 };
        self.idle >= PATIENCE
    }

    /// Forgets what it has seen, after the objective changed.
    pub fn restart(&mut self) {
        self.idle = 0;
    }
}
