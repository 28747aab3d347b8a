//! What the page shows at once: everything that a picture and the readings beside it need, in
//! one answer.

use super::fault::Fault;
use super::field::{Field, FieldName};
use super::history::Timeline;
use super::lineage::Lineage;
use super::look::{Look, LookOptions};
use super::pane::{Curves, Pane, pictures};
use super::plot_point::PlotPoint;
use super::readings::State;
use super::runner::{Configured, Runner};
use super::segment::Segment;
use super::{Session, as_f32};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::StepReport;
use crate::flow::options::FlowOptions;
use serde::Serialize;
use std::mem::take;
use std::rc::Rc;

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
    /// Three corners each, where remeshing or edge flips made others than were loaded.
    pub triangles: Option<TypedArray<u32>>,
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
    pub(super) look: Option<LookOptions>,
    /// Of the mesh on which a vertex was picked.
    pub(super) picked_on: Rc<Lineage>,
    /// The flow whose options were told.
    pub(super) flow: Option<Rc<Segment>>,
    reports: Vec<PlotPoint>,
}

deferred! {
    fn looked(runner: &Runner, view: &mut View) -> Look {
        view.carry_pick(runner);
        runner.look(view.look.unwrap_or_default(), &runner.x)
    }
}

impl View {
    /// What is looked at from now on, on the mesh that there is.
    pub(super) fn look_at(&mut self, options: LookOptions, runner: &Runner) {
        self.look = (options != LookOptions::default()).then_some(options);
        self.picked_on = Rc::clone(runner.lineage());
    }

    /// What is picked on another mesh is picked where it lies on the present one.
    fn carry_pick(&mut self, runner: &Runner) {
        let now = runner.lineage();
        if let Some(LookOptions { probe, .. }) = &mut self.look {
            *probe = probe.and_then(|vertex| Lineage::carried(&self.picked_on, now, vertex));
        }
        self.picked_on = Rc::clone(now);
    }

    /// A step was taken that frames have not told of.
    pub(super) fn add(&mut self, report: &StepReport) {
        self.reports.push(PlotPoint::of(report, &report.warnings));
    }

    /// Steps not told of by now are of a run that is no more.
    pub(super) fn forget_steps(&mut self) {
        self.reports.clear();
    }

    /// Tells of the steps after `step` up to the one that is shown again.
    pub(super) fn repeat_after(&mut self, step: usize, runner: &Runner) {
        let reports = runner.history.reports();
        let first = reports.partition_point(|report| report.step <= step);
        let samples = reports[first..]
            .iter()
            .map(|report| PlotPoint::of(report, &[]));
        self.reports.extend(samples);
    }
}

impl Session {
    /// Whoever chose the flow knows it: no frame need tell.
    pub(super) fn tell_flow(&mut self) {
        self.view.flow = self
            .runner
            .as_ref()
            .map(|runner| Rc::clone(&runner.segment));
    }

    /// Whoever watches frames may not know the steps after this one any more.
    pub(super) fn tell_steps_after(&mut self, step: usize) {
        if let Some(runner) = &self.runner {
            self.view.repeat_after(step, runner);
        }
    }

    /// Everything to be shown now.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn frame(&mut self) -> Result<Frame, Fault> {
        let view = &mut self.view;
        let runner = self.runner.as_ref().ok_or_else(Fault::no_mesh)?;
        let panes = pictures(runner, &self.panes, view.field);
        let field = view.field.filter(|_| panes.is_empty());
        let is_flips = runner.state.flips.is_some();
        let is_told = view
            .flow
            .as_ref()
            .is_some_and(|flow| Rc::ptr_eq(flow, &runner.segment));
        let flow = runner
            .configured()
            .filter(|_| !is_told)
            .map(|configured| ChosenFlow {
                options: runner.as_given(runner.options()),
                configured,
            });
        if flow.is_some() {
            view.flow = Some(Rc::clone(&runner.segment));
        }
        Ok(Frame {
            state: runner.state.clone(),
            reports: take(&mut view.reports),
            positions: as_f32(&runner.x).into(),
            exact: runner.x.iter().flat_map(|p| p.to_array()).collect(),
            triangles: (runner.own_triangles()).map(|mesh| mesh.triangle_indices().into()),
            field: field.map(|name| runner.field(name)).transpose()?,
            flipped_triangles: runner.folded().to_vec().into(),
            panes,
            curves: is_flips.then(|| runner.curves()),
            jump: runner.curvature_jump().filter(|_| !is_flips),
            look: view.look.is_some().then(|| looked(runner, view)),
            timeline: runner.history.timeline(runner.state.step),
            flow,
        })
    }
}
