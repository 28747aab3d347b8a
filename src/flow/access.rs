//! What others may ask of a driver, and set.

use super::driver::Driver;
use super::run::{Checkpoint, Mark, Run};
use super::termination::Window;
use super::{Flow, Reading, Refusal};
use glam::DVec3;

impl Driver {
    /// Readings at positions that come from elsewhere.
    pub fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.flow.reading(x)
    }

    /// The flow itself.
    pub fn flow(&self) -> &dyn Flow {
        &*self.flow
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

    /// All that a step may change, but for the positions: going back to it, the same step follows
    /// to the last bit.
    pub fn mark(&self) -> Mark {
        Mark {
            run: self.run,
            learnt: self.flow.learnt(),
            refusal: self.refusal,
            flipped: self.flipped.clone(),
        }
    }

    /// Goes back to where the driver stood, before a step that is given up.
    pub fn go_back(&mut self, mark: Mark) {
        (self.run, self.refusal, self.flipped) = (mark.run, mark.refusal, mark.flipped);
        self.flow.relearn(mark.learnt);
    }

    /// Takes no step of this phase any more: the next one says that the run is over.
    pub fn exhaust(&mut self) {
        self.run.is_exhausted = true;
    }

    /// Lets go of what is large and can be made again, as it was, from what is kept.
    pub fn release(&mut self) {
        self.flow.release();
    }

    /// Goes on from a checkpoint of the same run on another mesh of the same surface: what is kept
    /// and the budget stay, what was learnt of the old mesh does not.
    pub fn go_on_after_pass(&mut self, checkpoint: Checkpoint) {
        self.restore(checkpoint);
        self.run.window = Window::default();
        self.run.is_exhausted = false;
        self.run.step_size.restart();
    }

    /// Counts work between steps to the budget of time.
    pub fn spend(&mut self, seconds: f64) {
        self.run.seconds += seconds;
    }

    /// Sets the step count and time, after positions came from outside.
    pub fn set_clock(&mut self, step: usize, time: f64) {
        self.restore(self.checkpoint());
        self.run = Run {
            step,
            time,
            ..self.run
        };
    }

    /// Grants the budget of steps and time once more, counted from here.
    pub fn extend_budget(&mut self) {
        // After a mere limit a run goes on as if there had been none.
        if self.out_of_budget().is_none() {
            self.run.window = Window::default();
            self.run.least = (f64::INFINITY, self.run.step);
            self.run.is_exhausted = false;
        }
        self.run.first_step = self.run.step;
        self.run.seconds = 0.0;
    }
}
