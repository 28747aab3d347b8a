//! Going on from the surface as it is with another flow, or the same with other parameters:
//! the steps so far stay, and what was stored to come becomes a branch.

use super::Session;
use super::engine::Engine;
use super::fault::Fault;
use super::history::Deed;
use super::message::AppError;
use super::readings::State;
use super::work::{Configured, Work};
use crate::flow::options::{FlowName, FlowOptions};
use crate::flow::{FlowError, StepReport};
use glam::DVec3;
use std::rc::Rc;

/// A flow as it was started; the moments it led through share it.
#[derive(Debug, Default)]
pub(super) struct Course {
    pub(super) options: FlowOptions,
    /// No other of the same mesh has it.
    number: u32,
    /// The step from which it goes.
    pub(super) from: usize,
    /// What it started from, a quantity of which it may keep; `None` is the mesh itself.
    start: Option<Vec<DVec3>>,
}

impl Session {
    /// Goes on from the surface as it is with other options, as after
    /// [`adopt`](Self::adopt), but step, time and history go on too: a step back shows the
    /// surface under the options before, and what was stored to come becomes a branch. Before
    /// any step the same as [`configure`](Self::configure).
    ///
    /// # Errors
    /// As [`configure`](Self::configure), and `WrongFlow` where edge flips are or were chosen,
    /// or flows run beside each other: these go from the mesh itself. Nothing has changed then.
    pub fn continue_with(&mut self, options: FlowOptions) -> Result<Configured, Fault> {
        let progress = self.progress.clone();
        let work = self.work_mut()?;
        if work.flow.is_none() || !work.history.has_moments() {
            return work.configure(options, progress);
        }
        work.continue_with(options)
    }

    /// The options in force at the moment that is shown, as they were given; `None` before a
    /// flow is chosen.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn options(&self) -> Result<Option<FlowOptions>, Fault> {
        let work = self.work()?;
        let told = || work.as_given(&work.course.options);
        Ok(work.flow.is_some().then(told))
    }

    /// Which of the flows chosen since the mesh was loaded stood at the moment that is shown.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn flow_number(&self) -> Result<u32, Fault> {
        Ok(self.work()?.course.number)
    }

    /// What the configuration in force at the moment that is shown amounts to; `None` before
    /// a flow is chosen.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn configured(&self) -> Result<Option<Configured>, Fault> {
        Ok(self.work()?.configured())
    }
}

impl Work {
    pub(super) fn options(&self) -> &FlowOptions {
        &self.course.options
    }

    /// Of the steps that the present flow took: of two flows, energies mean nothing to each other.
    pub(super) fn course_reports(&self) -> &[StepReport] {
        let reports = self.history.reports();
        let first = reports.partition_point(|report| report.step <= self.course.from);
        &reports[first..]
    }

    /// A selection of the mesh's own, unless the options have one.
    pub(super) fn with_selection(&self, mut options: FlowOptions) -> FlowOptions {
        if options.free.is_none() && options.fixed.is_none() {
            options.free.clone_from(&self.document.free);
            options.fixed.clone_from(&self.document.fixed);
        }
        options
    }

    /// The options; a selection that the mesh itself suggests is left out.
    pub(super) fn as_given(&self, options: &FlowOptions) -> FlowOptions {
        let mut options = options.clone();
        if options.free == self.document.free && options.fixed == self.document.fixed {
            (options.free, options.fixed) = (None, None);
        }
        options
    }

    /// The flow of the present course as it started.
    pub(super) fn started(&self) -> Result<Engine, FlowError> {
        let (document, course) = (&self.document, &self.course);
        let mut start = course.start.as_ref().unwrap_or(&document.start).clone();
        let options = course.options.clone();
        let mut flow = Engine::start(&document.triangles, &document.polygons, &mut start, options)?;
        flow.set_progress(self.progress.clone());
        Ok(flow)
    }

    pub(super) fn configured(&self) -> Option<Configured> {
        let flow = self.flow.as_ref()?;
        Some(Configured {
            free_vertices: flow.n_free(),
            mean_edge_length: flow.mean_edge_length(),
            dt: self.state.dt,
            tau: self.state.tau,
            state: self.state.clone(),
            held_vertices: (0..self.x.len())
                .map(|v| u8::from(!flow.is_free(v)))
                .collect(),
        })
    }

    fn next_number(&mut self) -> u32 {
        self.flows += 1;
        self.flows
    }

    /// Makes `options` those of a course that starts from the mesh itself.
    pub(super) fn begin_course(&mut self, options: FlowOptions) {
        let number = self.next_number();
        self.first = Rc::new(Course {
            options,
            number,
            ..Course::default()
        });
        self.course = Rc::clone(&self.first);
        self.flow_of = Rc::clone(&self.first);
    }

    pub(super) fn continue_with(&mut self, options: FlowOptions) -> Result<Configured, Fault> {
        let is_flips = |options: &FlowOptions| options.flow == FlowName::Flips;
        if is_flips(self.options()) || is_flips(&options) || !self.beside.is_empty() {
            return Err(AppError::FixedStart.into());
        }
        let options = self.with_selection(options);
        if options == *self.options() {
            return self.configured().ok_or_else(Fault::no_mesh);
        }
        // A change that nothing came of is not worth a moment of its own.
        let is_second_thought = self.history.ends_with_new_flow();
        if is_second_thought {
            self.back();
            if options == *self.options() {
                self.history.drop_future();
                return self.configured().ok_or_else(Fault::no_mesh);
            }
        }
        let mut x = self.x.clone();
        let course = Course {
            options: options.clone(),
            number: self.next_number(),
            from: self.state.step,
            start: Some(x.clone()),
        };
        let (triangles, polygons) = (&self.document.triangles, &self.document.polygons);
        let mut flow = match Engine::start(triangles, polygons, &mut x, options) {
            Ok(flow) => flow,
            Err(error) => {
                if is_second_thought {
                    self.forth();
                }
                return Err(error.into());
            }
        };
        flow.set_clock(self.state.step, self.state.time);
        flow.extend_budget();
        flow.set_progress(self.progress.clone());
        if is_second_thought {
            self.history.drop_future();
        }
        let before = self.copied();
        let given = self.as_given(&course.options);
        self.x = x;
        self.flow = Some(flow);
        self.course = Rc::new(course);
        self.flow_of = Rc::clone(&self.course);
        self.failure = None;
        self.anew = false;
        self.state = State {
            step: self.state.step,
            time: self.state.time,
            ..State::default()
        };
        self.follow(before, Deed::Flow(Rc::new(given)), None);
        self.read_state();
        self.configured().ok_or_else(Fault::no_mesh)
    }
}
