//! What the page shows at once: everything that a picture and the readings beside it need, in
//! one answer.

use super::course::Course;
use super::fault::Fault;
use super::field::{Field, FieldName};
use super::history::Timeline;
use super::look::{Look, Wanted};
use super::pane::{Curves, Pane};
use super::readings::State;
use super::work::{Configured, Work};
use super::{Session, as_f32};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::options::FlowOptions;
use crate::flow::{StepReport, Warning};
use serde::Serialize;
use std::mem::take;
use std::rc::Rc;

/// What a plot has of a step, and what the step warns of.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PlotPoint {
    /// Number of the step.
    pub step: usize,
    /// Flow time after it.
    pub time: f64,
    /// Raw step size.
    pub dt: f64,
    /// See [`StepReport::energy`].
    pub energy: f64,
    /// See [`StepReport::objective`].
    pub objective: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume of a closed oriented surface.
    pub volume: Option<f64>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Worth telling the user; none where the step was told of before.
    pub warnings: Vec<Warning>,
}

impl PlotPoint {
    fn of(report: &StepReport, warnings: &[Warning]) -> Self {
        Self {
            step: report.step,
            time: report.time,
            dt: report.dt,
            energy: report.energy,
            objective: report.objective,
            area: report.area,
            volume: report.volume,
            min_angle_degrees: report.min_angle_degrees,
            warnings: warnings.to_vec(),
        }
    }
}

/// The flow that stands where the session does.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ChosenFlow {
    /// Its options.
    pub options: FlowOptions,
    /// What they amount to.
    pub configured: Configured,
}

/// A picture of the surface with everything that is shown beside it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Frame {
    /// Readings.
    pub state: State,
    /// The steps that no frame has told of yet, oldest first.
    pub reports: Vec<PlotPoint>,
    /// Three coordinates a vertex, relative to the mesh's frame, for drawing.
    pub positions: TypedArray<f32>,
    /// The same in full precision, to go on from after a crash.
    pub exact: TypedArray<f64>,
    /// Colours; null where there are none, or panes have their own.
    pub field: Option<Field>,
    /// Triangles that folded over in the last step.
    pub flipped_triangles: TypedArray<u32>,
    /// Pictures side by side; none of a single flow.
    pub panes: Vec<Pane>,
    /// Of edge flips.
    pub curves: Option<Curves>,
    /// Across the boundary of what moves.
    pub jump: Option<CurvatureJump>,
    /// Null where nothing is looked at more closely.
    pub look: Option<Look>,
    /// The steps that can be shown.
    pub timeline: Timeline,
    /// The flow that stands there, where no frame has told of it yet.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub flow: Option<ChosenFlow>,
}

/// What frames show, and what they have told so far.
#[derive(Clone, Debug, Default)]
pub(super) struct View {
    pub(super) field: Option<FieldName>,
    pub(super) look: Option<Wanted>,
    /// The flow whose options were told.
    pub(super) flow: Option<Rc<Course>>,
    reports: Vec<PlotPoint>,
}

impl View {
    /// A step was taken that frames have not told of.
    pub(super) fn add(&mut self, report: &StepReport) {
        self.reports.push(PlotPoint::of(report, &report.warnings));
    }

    /// Steps not told of by now are of a run that is no more.
    pub(super) fn forget_steps(&mut self) {
        self.reports.clear();
    }

    /// Tells of the steps after `step` up to the one that is shown again.
    pub(super) fn repeat_after(&mut self, step: usize, work: &Work) {
        let reports = work.history.reports();
        let first = reports.partition_point(|report| report.step <= step);
        let samples = reports[first..]
            .iter()
            .map(|report| PlotPoint::of(report, &[]));
        self.reports.extend(samples);
    }
}

impl Session {
    /// Everything to be shown now.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn frame(&mut self) -> Result<Frame, Fault> {
        let view = &mut self.view;
        let work = self.work.as_ref().ok_or_else(Fault::no_mesh)?;
        let panes = work.panes(view.field);
        let field = view.field.filter(|_| panes.is_empty());
        let is_flips = work.state.flips.is_some();
        let is_told = view
            .flow
            .as_ref()
            .is_some_and(|flow| Rc::ptr_eq(flow, &work.course));
        let flow = work
            .configured()
            .filter(|_| !is_told)
            .map(|configured| ChosenFlow {
                options: work.as_given(work.options()),
                configured,
            });
        if flow.is_some() {
            view.flow = Some(Rc::clone(&work.course));
        }
        Ok(Frame {
            state: work.state.clone(),
            reports: take(&mut view.reports),
            positions: as_f32(&work.x).into(),
            exact: work.x.iter().flat_map(|p| p.to_array()).collect(),
            field: field.map(|name| work.field(name)).transpose()?,
            flipped_triangles: work.folded().to_vec().into(),
            panes,
            curves: is_flips.then(|| work.curves()),
            jump: work.curvature_jump().filter(|_| !is_flips),
            look: view.look.map(|wanted| work.look(wanted, &work.x)),
            timeline: work.history.timeline(work.state.step),
            flow,
        })
    }
}
