//! Where a run stands: what it started from, its budget, and what a step back restores.

use super::driver::Driver;
use super::step_size::StepSize;
use super::termination::Window;
use super::warning::WarningsGiven;
use super::{Flow, Memory, Progress, Reading, Refusal};
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
    /// The step the budget counts from, and the seconds used since.
    pub(super) first_step: usize,
    pub(super) seconds: f64,
    /// Least value of the functional in this phase.
    pub(super) least: f64,
    pub(super) window: Window,
    pub(super) given: WarningsGiven,
    /// Whether the next step is to end the run, as it gains nothing.
    pub(super) is_exhausted: bool,
}

/// What a step back restores along with the positions.
#[derive(Clone, Copy, Debug)]
pub struct Checkpoint {
    run: Run,
    memory: Memory,
}

impl Driver {
    /// Readings at positions that come from elsewhere.
    pub fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.flow.reading(x)
    }

    /// The flow itself.
    pub fn flow(&self) -> &dyn Flow {
        &*self.flow
    }

    /// Called with a stage's name and the share of the step done, within long steps.
    pub fn set_progress(&mut self, callback: Option<Progress>) {
        self.progress = callback;
    }

    /// The next step's size, in the flow's unit of time.
    pub fn dt(&self) -> f64 {
        self.run.step_size.dt
    }

    /// The same without a unit.
    pub fn tau(&self) -> f64 {
        self.dt() / self.flow.time_unit()
    }

    /// Faces that folded over in the last step.
    pub fn flipped_faces(&self) -> &[u32] {
        &self.flipped
    }

    /// The last trial that was refused on the way to the present state.
    pub fn refusal(&self) -> Option<Refusal> {
        self.refusal
    }

    /// What a step back must restore beside the positions.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            run: self.run,
            memory: self.flow.memory(),
        }
    }

    /// Goes back to an earlier checkpoint of the same run.
    pub fn restore(&mut self, checkpoint: Checkpoint) {
        self.run = checkpoint.run;
        self.flow.recall(checkpoint.memory);
        self.flipped.clear();
        self.refusal = None;
    }

    /// Sets the step count and time, after positions came from outside.
    pub fn set_clock(&mut self, step: usize, time: f64) {
        self.restore(self.checkpoint());
        self.run = Run {
            step,
            time,
            least: f64::INFINITY,
            ..self.run
        };
    }

    /// Grants the budget of steps and time once more, counted from here.
    pub fn extend_budget(&mut self) {
        // After a mere limit a run goes on as if there had been none.
        if self.out_of_budget().is_none() {
            self.run.window = Window::default();
            self.run.is_exhausted = false;
        }
        self.run.first_step = self.run.step;
        self.run.seconds = 0.0;
    }
}
