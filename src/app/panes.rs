//! Documents side by side: the same surface under other options, each a runner of its own that
//! is kept level with the first. Whatever is compared, flows, parameters, then and now, is told
//! by its differences from the first; the flows by mean curvature and its derivatives at once
//! (Xu & Zhang, figures 5.5 and 5.6) are one such set.

use super::arrangement::Compare;
use super::comparison::{Comparison, Lockstep, PaneChange, options_with, times_agree};
use super::fault::Fault;
use super::message::AppError;
use super::plot_point::PlotPoint;
use super::runner::Runner;
use super::segment::Segment;
use crate::flow::option::{Values, find};
use crate::flow::options::{FlowName, FlowOptions};
use crate::flow::spec::{self, Family};
use std::rc::Rc;

/// Steps that the others still take after the first has come to rest.
const FURTHER: usize = 60;

/// Times that differ by no more than this, relative to each other, are the same: sums of steps.
const ROUNDING: f64 = 1e-9;

/// A runner beside the first.
pub(super) struct Other {
    /// What it does otherwise.
    pub(super) change: Values,
    /// The step at which it is held, where it is.
    held_at: Option<usize>,
    pub(super) runner: Runner,
    /// The last step that a frame has told of.
    told: usize,
}

/// Those beside the first.
#[derive(Default)]
pub(super) struct Panes {
    /// What was asked for; without panes, what the arrangement says.
    comparison: Comparison,
    /// The start of the run that the others were made for, and what was asked for then.
    made: Option<(Rc<Segment>, Vec<PaneChange>)>,
    others: Vec<Other>,
}

/// The flows that the arrangement shows beside that of `options`: all by mean curvature and its
/// derivatives, where it is one of them.
fn flows_beside(options: &FlowOptions) -> Vec<PaneChange> {
    let is_one = |flow: FlowName| spec::of(flow).family == Family::Curvature;
    if !is_one(options.flow) {
        return Vec::new();
    }
    let others = FlowName::all().filter(|flow| *flow != options.flow && is_one(*flow));
    let pane = |flow: FlowName| {
        let other = FlowOptions {
            boundary: options.boundary,
            ..options.with_flow(flow)
        };
        // What means nothing to another flow is at its default there; the boundary is not.
        let rows = ["flow", "boundary"].map(|name| find::<FlowOptions>(name).ok());
        let values = rows.into_iter().flatten();
        PaneChange {
            change: values
                .map(|row| (row.name.into(), (row.get)(&other)))
                .collect(),
            step: None,
        }
    };
    others.map(pane).collect()
}

impl Panes {
    /// Those beside the first.
    pub(super) fn others(&self) -> &[Other] {
        &self.others
    }

    /// Whether others were asked for by their differences, and not by the arrangement.
    pub(super) fn are_chosen(&self) -> bool {
        !self.comparison.panes.is_empty()
    }

    /// Forgets all but what was asked for, as the mesh is another.
    pub(super) fn clear(&mut self) {
        self.others.clear();
        self.made = None;
    }

    fn wanted(&self, first: &Runner) -> Vec<PaneChange> {
        if self.are_chosen() {
            return self.comparison.panes.clone();
        }
        match first.arrangement.compare {
            Compare::Flows => flows_beside(first.options()),
            _ => Vec::new(),
        }
    }

    /// Chooses what stands beside `first`; where it cannot be, nothing has changed.
    ///
    /// # Errors
    /// `FixedStart` beside edge flips, which change the mesh; options that a flow refuses.
    pub(super) fn choose(&mut self, comparison: Comparison, first: &Runner) -> Result<(), Fault> {
        let mut options = vec![first.options().clone()];
        for pane in &comparison.panes {
            options.push(options_with(first.options(), &pane.change)?);
        }
        let has_flips = options.iter().any(|one| one.flow == FlowName::Flips);
        if has_flips && options.len() > 1 {
            return Err(AppError::FixedStart.into());
        }
        let mut others = Vec::new();
        for pane in &comparison.panes {
            others.push(Other::start(first, pane)?);
        }
        let lockstep = match times_agree(&options) {
            true => comparison.lockstep,
            false => Lockstep::Step,
        };
        self.others = others;
        self.made = Some((Rc::clone(&first.first), comparison.panes.clone()));
        self.comparison = Comparison {
            lockstep,
            ..comparison
        };
        Ok(())
    }

    /// Takes the others to where the first is now; makes those that are missing.
    pub(super) fn settle(&mut self, first: &Runner) {
        if first.engine.is_none() {
            return self.clear();
        }
        let wanted = self.wanted(first);
        let is_made = (self.made.as_ref())
            .is_some_and(|(run, panes)| Rc::ptr_eq(run, &first.first) && *panes == wanted);
        if !is_made {
            self.others.clear();
            let is_alone = first.options().flow == FlowName::Flips;
            // What the first takes, the others take, or they are not there.
            let others = wanted.iter().filter(|_| !is_alone);
            let others = others.map(|pane| Other::start(first, pane));
            self.others = others.filter_map(Result::ok).collect();
            self.made = Some((Rc::clone(&first.first), wanted));
        }
        let lockstep = self.comparison.lockstep;
        for other in &mut self.others {
            other.bring_to(first, lockstep);
        }
    }

    /// The steps of each that no frame has told of, oldest first.
    pub(super) fn take_reports(&mut self) -> Vec<Vec<PlotPoint>> {
        let untold = |other: &mut Other| {
            let reports = other.runner.history.reports();
            let first = reports.partition_point(|report| report.step <= other.told);
            let points = reports[first..].iter();
            let points = points.map(|r| PlotPoint::of(r, &r.warnings)).collect();
            other.told = other.runner.state.step;
            points
        };
        self.others.iter_mut().map(untold).collect()
    }
}

impl Other {
    fn start(first: &Runner, pane: &PaneChange) -> Result<Self, Fault> {
        let document = first.document.clone();
        let start = document.start.clone();
        let mut runner = Runner::new(document, start);
        runner.configure(options_with(first.options(), &pane.change)?, None)?;
        Ok(Self {
            change: pane.change.clone(),
            held_at: pane.step,
            runner,
            told: 0,
        })
    }

    fn step_to(&mut self, is_there: impl Fn(&Runner) -> bool) {
        while !is_there(&self.runner) && !self.runner.state.status.is_final() {
            // A failure ends it, and its state says so.
            if !matches!(self.runner.step(), Ok(Some(_))) {
                break;
            }
        }
    }

    fn bring_to(&mut self, first: &Runner, lockstep: Lockstep) {
        let is_over = first.state.status.is_final();
        // To its rest when the first is at its own.
        let goal = first.state.step + if is_over { FURTHER } else { 0 };
        if let (Lockstep::Time, None) = (lockstep, self.held_at) {
            let time = first.state.time * (1.0 - ROUNDING);
            self.runner.seek_time(time);
            self.step_to(|runner| runner.state.time >= time);
            if !is_over {
                return;
            }
            return self.step_to(|runner| runner.state.step >= goal);
        }
        let goal = self.held_at.unwrap_or(goal);
        self.runner.seek(goal);
        self.step_to(|runner| runner.state.step >= goal);
    }
}
