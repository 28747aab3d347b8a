//! Flows: an energy plus an integrator.
//!
//! Step-size control, stopping rules, selections and reports are written once here and
//! shared; a flow's own folder holds only its system.

pub mod boundary;
pub mod circle;
pub mod constraint;
pub mod curvature;
pub mod error;
pub mod flips;
pub mod options;
pub mod p_willmore;
pub mod prefill;
pub mod refusal;
pub mod report;
pub mod step_size;
pub mod stop;

pub use error::FlowError;
pub use refusal::Refusal;
pub use report::{Multipliers, Status, StepReport};

use crate::mesh::HalfedgeMesh;
use crate::operator::Elements;
use circle::CircleFlow;
use curvature::CurvatureFlow;
use flips::FlipFlow;
use glam::DVec3;
use options::{FlowName, FlowOptions};
use p_willmore::PWillmoreFlow;
use std::rc::Rc;
use stop::Verdict;

/// A callback for progress within long steps: the stage's name and the share done.
pub type Progress = Rc<dyn Fn(&str, f64)>;

/// The flow that the options ask for, on a triangle mesh; on `polygons`, the same surface
/// before it was cut into triangles, where the flow takes its faces. A pre-fill
/// may change `x`.
///
/// # Errors
/// See [`FlowError`].
pub fn start(
    triangles: &Rc<HalfedgeMesh>,
    polygons: &Rc<HalfedgeMesh>,
    x: &mut [DVec3],
    options: FlowOptions,
) -> Result<Box<dyn Flow>, FlowError> {
    Ok(match options.flow {
        FlowName::Circle => Box::new(CircleFlow::new(Rc::clone(triangles), x, options)?),
        FlowName::Flips => Box::new(FlipFlow::new(Rc::clone(polygons), x, &options)?),
        FlowName::PWillmore => {
            let is_one_kind = Elements::of(polygons).is_some();
            let mesh = if is_one_kind { polygons } else { triangles };
            Box::new(PWillmoreFlow::new(Rc::clone(mesh), x, options)?)
        }
        FlowName::MeanCurvature
        | FlowName::SurfaceDiffusion
        | FlowName::Willmore
        | FlowName::Mmcv => Box::new(CurvatureFlow::new(Rc::clone(triangles), x, options)?),
    })
}

/// What of a flow's state a step back restores along with the positions.
#[derive(Clone, Copy, Debug)]
pub enum Pace {
    /// Of the circle-angle flow.
    Circle(circle::Pace),
    /// Of the p-Willmore flow.
    PWillmore(p_willmore::Pace),
    /// Number of edge flips made.
    Flips(usize),
    /// Of the flows by mean curvature and its derivatives.
    Curvature(curvature::Pace),
}

/// What a flow says of positions that it has not just stepped to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// The flow's own energy, as in [`StepReport::energy`].
    pub energy: f64,
    /// See [`StepReport::energy_normalised`].
    pub energy_normalised: f64,
    /// See [`StepReport::gradient_norm`].
    pub gradient_norm: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume of a closed, oriented surface.
    pub volume: Option<f64>,
    /// See [`StepReport::reduced_volume`].
    pub reduced_volume: Option<f64>,
}

/// A flow on one mesh with one set of options; positions are the caller's.
pub trait Flow {
    /// Takes one step: `x` becomes the next state, or is left as it is with a verdict.
    ///
    /// # Errors
    /// Numerical failures; `x` is unchanged.
    fn step(&mut self, x: &mut Vec<DVec3>) -> Result<(Option<StepReport>, Verdict), FlowError>;

    /// Readings at positions that come from elsewhere.
    fn reading(&mut self, x: &[DVec3]) -> Reading;

    /// What moves the surface, a vector a vertex, zero where it is held.
    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3>;

    /// Pointwise H as the flow measures it, a value a vertex, where that is not the usual
    /// [`pointwise_mean_curvature`](crate::geometry::curvature::pointwise_mean_curvature).
    fn mean_curvature(&self, _x: &[DVec3]) -> Option<Vec<f64>> {
        None
    }

    /// Called with a stage's name and the share of the step done, within long steps.
    fn set_progress(&mut self, callback: Option<Progress>);

    /// Mean edge length at the start.
    fn mean_edge_length(&self) -> f64;

    /// Number of vertices that move.
    fn n_free(&self) -> usize;

    /// Whether a vertex moves.
    fn is_free(&self, v: usize) -> bool;

    /// The next step's size, in the flow's unit of time.
    fn dt(&self) -> f64;

    /// The same without a unit.
    fn tau(&self) -> f64;

    /// Faces that folded over in the last step.
    fn flipped_faces(&self) -> &[u32];

    /// The last trial that was refused on the way to the present state.
    fn refusal(&self) -> Option<Refusal> {
        None
    }

    /// What a step back must restore beside the positions.
    fn pace(&self) -> Pace;

    /// Goes back to an earlier pace of the same flow.
    fn set_pace(&mut self, pace: Pace);

    /// Sets the step count and time, after positions came from outside.
    fn set_clock(&mut self, step: usize, time: f64);

    /// Grants the budget of steps once more, counted from here.
    fn extend_budget(&mut self);

    /// The edge flips, where the flow consists of them: it changes the connectivity and
    /// leaves the positions.
    fn flips(&self) -> Option<&FlipFlow> {
        None
    }

    /// The same, to be changed.
    fn flips_mut(&mut self) -> Option<&mut FlipFlow> {
        None
    }
}
