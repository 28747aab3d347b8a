//! What takes the steps: a flow, which moves vertices, or edge flips, which do not.

use crate::flow::flips::EdgeFlips;
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;
use crate::flow::{self, Decision, Driver, FlowError, Reading, Refusal, StepReport};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::rc::Rc;

/// One of the two, on one mesh with one set of options.
pub(super) enum Engine {
    Flow(Box<Driver>),
    Flips(Box<EdgeFlips>),
}

/// What a step back restores along with the positions.
#[derive(Clone, Debug)]
pub(super) enum Checkpoint {
    Flow(flow::Checkpoint),
    /// Number of edge flips made.
    Flips(usize),
}

impl Engine {
    /// See [`Driver::start`]; edge flips are of triangles.
    pub(super) fn start(
        triangles: &Rc<HalfedgeMesh>,
        polygons: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: FlowOptions,
    ) -> Result<Self, FlowError> {
        Ok(if options.flow == FlowName::Flips {
            let flips = EdgeFlips::new(Rc::clone(triangles), x, &options)?;
            Self::Flips(Box::new(flips))
        } else {
            Self::Flow(Box::new(Driver::start(triangles, polygons, x, options)?))
        })
    }

    pub(super) fn step(
        &mut self,
        x: &mut Vec<DVec3>,
    ) -> Result<(Option<StepReport>, Decision), FlowError> {
        match self {
            Self::Flow(driver) => driver.step(x),
            Self::Flips(flips) => Ok(flips.step(x)),
        }
    }

    pub(super) fn flips(&self) -> Option<&EdgeFlips> {
        match self {
            Self::Flow(_) => None,
            Self::Flips(flips) => Some(flips),
        }
    }

    pub(super) fn flips_mut(&mut self) -> Option<&mut EdgeFlips> {
        match self {
            Self::Flow(_) => None,
            Self::Flips(flips) => Some(flips),
        }
    }

    pub(super) fn reading(&mut self, x: &[DVec3]) -> Reading {
        match self {
            Self::Flow(driver) => driver.reading(x),
            Self::Flips(flips) => flips.reading(x),
        }
    }

    /// What moves the surface, a vector a vertex; flips do not.
    pub(super) fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        match self {
            Self::Flow(driver) => driver.flow().gradient(x),
            Self::Flips(_) => vec![DVec3::ZERO; x.len()],
        }
    }

    pub(super) fn mean_curvature(&self, x: &[DVec3]) -> Option<Vec<f64>> {
        match self {
            Self::Flow(driver) => driver.flow().mean_curvature(x),
            Self::Flips(_) => None,
        }
    }

    pub(super) fn mean_edge_length(&self) -> f64 {
        match self {
            Self::Flow(driver) => driver.flow().mean_edge_length(),
            Self::Flips(flips) => flips.mean_edge_length(),
        }
    }

    /// Number of vertices that move, or whose edges may be flipped.
    pub(super) fn n_free(&self) -> usize {
        match self {
            Self::Flow(driver) => driver.flow().n_free(),
            Self::Flips(flips) => flips.start().n_vertices(),
        }
    }

    pub(super) fn is_free(&self, v: usize) -> bool {
        match self {
            Self::Flow(driver) => driver.flow().is_free(v),
            Self::Flips(_) => true,
        }
    }

    /// The next step's size in the flow's unit of time, or in flips.
    pub(super) fn dt(&self) -> f64 {
        match self {
            Self::Flow(driver) => driver.dt(),
            Self::Flips(flips) => flips.per_step() as f64,
        }
    }

    /// The same without a unit.
    pub(super) fn tau(&self) -> f64 {
        match self {
            Self::Flow(driver) => driver.tau(),
            Self::Flips(flips) => flips.per_step() as f64,
        }
    }

    /// Faces that folded over in the last step.
    pub(super) fn flipped_faces(&self) -> &[u32] {
        match self {
            Self::Flow(driver) => driver.flipped_faces(),
            Self::Flips(_) => &[],
        }
    }

    pub(super) fn refusal(&self) -> Option<Refusal> {
        match self {
            Self::Flow(driver) => driver.refusal(),
            Self::Flips(_) => None,
        }
    }

    pub(super) fn checkpoint(&self) -> Checkpoint {
        match self {
            Self::Flow(driver) => Checkpoint::Flow(driver.checkpoint()),
            Self::Flips(flips) => Checkpoint::Flips(flips.clock()),
        }
    }

    /// Goes back to a checkpoint; one of the other kind is none of its own.
    pub(super) fn restore(&mut self, checkpoint: Checkpoint) {
        match (self, checkpoint) {
            (Self::Flow(driver), Checkpoint::Flow(checkpoint)) => driver.restore(checkpoint),
            (Self::Flips(flips), Checkpoint::Flips(clock)) => flips.seek(clock),
            _ => {}
        }
    }

    /// All that a step may change; flips take back what they did by themselves.
    pub(super) fn mark(&self) -> Option<flow::Mark> {
        match self {
            Self::Flow(driver) => Some(driver.mark()),
            Self::Flips(_) => None,
        }
    }

    /// Goes back there, before a step that was given up.
    pub(super) fn go_back(&mut self, mark: flow::Mark) {
        if let Self::Flow(driver) = self {
            driver.go_back(mark);
        }
    }

    /// See [`Driver::exhaust`].
    pub(super) fn exhaust(&mut self) {
        if let Self::Flow(driver) = self {
            driver.exhaust();
        }
    }

    /// Lets go of what is large and can be made again.
    pub(super) fn release(&mut self) {
        if let Self::Flow(driver) = self {
            driver.release();
        }
    }

    /// Goes on on another mesh of the surface that a flow stood at.
    pub(super) fn go_on_after_pass(&mut self, checkpoint: flow::Checkpoint) {
        if let Self::Flow(driver) = self {
            driver.go_on_after_pass(checkpoint);
        }
    }

    /// Counts work between steps to the budget of time.
    pub(super) fn spend(&mut self, seconds: f64) {
        if let Self::Flow(driver) = self {
            driver.spend(seconds);
        }
    }

    /// Sets the step count and time, after positions came from outside.
    pub(super) fn set_clock(&mut self, step: usize, time: f64) {
        match self {
            Self::Flow(driver) => driver.set_clock(step, time),
            Self::Flips(flips) => flips.seek(step),
        }
    }

    /// How a run ends whose budget is used up.
    pub(super) fn out_of_budget(&self) -> Option<Decision> {
        match self {
            Self::Flow(driver) => driver.out_of_budget(),
            Self::Flips(_) => None,
        }
    }

    pub(super) fn extend_budget(&mut self) {
        if let Self::Flow(driver) = self {
            driver.extend_budget();
        }
    }
}
