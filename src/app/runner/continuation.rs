//! Going on from the surface as it is with another flow, or the same with other parameters:
//! the steps so far stay, and what was stored to come becomes a branch.

use super::{Configured, Runner};
use crate::app::Session;
use crate::app::engine::Engine;
use crate::app::fault::Fault;
use crate::app::history::Event;
use crate::app::message::AppError;
use crate::app::readings::State;
use crate::app::segment::Segment;
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;
use crate::flow::{FlowError, StepReport};
use std::rc::Rc;

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
        let runner = self.runner()?;
        if runner.engine.is_none() || !runner.history.has_snapshots() {
            return self.configure(options);
        }
        // What stands beside it goes from the mesh itself.
        if !self.panes.others().is_empty() {
            return Err(AppError::FixedStart.into());
        }
        self.runner_mut()?.continue_with(options)
    }

    /// The options in force at the snapshot that is shown, as they were given; `None` before a
    /// flow is chosen.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn options(&self) -> Result<Option<FlowOptions>, Fault> {
        let runner = self.runner()?;
        let told = || runner.as_given(&runner.segment.options);
        Ok(runner.engine.is_some().then(told))
    }

    /// Which of the flows chosen since the mesh was loaded stood at the snapshot that is shown.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn flow_number(&self) -> Result<u32, Fault> {
        Ok(self.runner()?.segment.number)
    }

    /// What the configuration in force at the snapshot that is shown amounts to; `None` before
    /// a flow is chosen.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn configured(&self) -> Result<Option<Configured>, Fault> {
        Ok(self.runner()?.configured())
    }
}

impl Runner {
    pub(in crate::app) fn options(&self) -> &FlowOptions {
        &self.segment.options
    }

    /// Of the steps that the present flow took: of two flows, energies mean nothing to each other.
    pub(in crate::app) fn segment_reports(&self) -> &[StepReport] {
        let reports = self.history.reports();
        let first = reports.partition_point(|report| report.step <= self.segment.from);
        &reports[first..]
    }

    /// A selection of the mesh's own, unless the options have one.
    pub(in crate::app) fn with_selection(&self, mut options: FlowOptions) -> FlowOptions {
        if options.free.is_none() && options.fixed.is_none() {
            options.free.clone_from(&self.document.free);
            options.fixed.clone_from(&self.document.fixed);
        }
        options
    }

    /// The options; a selection that the mesh itself suggests is left out.
    pub(in crate::app) fn as_given(&self, options: &FlowOptions) -> FlowOptions {
        let mut options = options.clone();
        if options.free == self.document.free && options.fixed == self.document.fixed {
            (options.free, options.fixed) = (None, None);
        }
        options
    }

    /// The flow of the present segment as it started.
    pub(in crate::app) fn started(&self) -> Result<Engine, FlowError> {
        let segment = &self.segment;
        let start = segment.start.as_ref().unwrap_or(&self.document.start);
        let options = self.effective(&segment.options, segment.is_pass);
        let [triangles, polygons] = self.meshes();
        Engine::start(triangles, polygons, &mut start.clone(), options)
    }

    pub(in crate::app) fn configured(&self) -> Option<Configured> {
        let flow = self.engine.as_ref()?;
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

    pub(super) fn next_number(&mut self) -> u32 {
        self.segments += 1;
        self.segments
    }

    /// Makes `options` those of a segment that starts from the mesh itself.
    pub(in crate::app) fn begin_segment(&mut self, options: FlowOptions) {
        let number = self.next_number();
        self.first = Rc::new(Segment {
            options,
            number,
            ..Segment::default()
        });
        self.segment = Rc::clone(&self.first);
        self.engine_segment = Rc::clone(&self.first);
    }

    pub(in crate::app) fn continue_with(
        &mut self,
        options: FlowOptions,
    ) -> Result<Configured, Fault> {
        let is_flips = |options: &FlowOptions| options.flow == FlowName::Flips;
        if is_flips(self.options()) || is_flips(&options) {
            return Err(AppError::FixedStart.into());
        }
        let options = self.with_selection(options);
        if options == *self.options() {
            return self.configured().ok_or_else(Fault::no_mesh);
        }
        // A change that nothing came of is not worth a snapshot of its own.
        let is_second_thought = self.history.ends_with_new_flow();
        if is_second_thought {
            self.back();
            if options == *self.options() {
                self.history.drop_future();
                return self.configured().ok_or_else(Fault::no_mesh);
            }
        }
        let mut x = self.x.clone();
        let segment = Segment {
            options: options.clone(),
            number: self.next_number(),
            from: self.state.step,
            start: Some(x.clone()),
            remade: self.segment.remade.clone(),
            is_pass: false,
        };
        let [triangles, polygons] = self.meshes();
        let options = self.effective(&options, false);
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
        if is_second_thought {
            self.history.drop_future();
        }
        let before = self.copied();
        let given = self.as_given(&segment.options);
        self.x = x;
        self.engine = Some(flow);
        self.segment = Rc::new(segment);
        self.engine_segment = Rc::clone(&self.segment);
        self.failure = None;
        self.restarted = false;
        self.state = State {
            step: self.state.step,
            time: self.state.time,
            ..State::default()
        };
        self.follow(before, Event::Flow(Rc::new(given)), None);
        self.read_state();
        self.configured().ok_or_else(Fault::no_mesh)
    }
}
