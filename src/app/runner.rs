//! A document with its flow: what a session does once a mesh is loaded.
//!
//! What is shown moves along the history, the engine stays where it last computed: whoever looks
//! back and returns goes on as if he had not. Only a step from elsewhere makes the engine anew
//! there.

mod continuation;
mod remeshing;
mod restoration;
mod return_point;
mod viewing;

use super::arrangement::Arrangement;
use super::crossing::count_after_step;
use super::document::Document;
use super::engine::{Checkpoint, Engine};
use super::fault::Fault;
use super::field::{Field, FieldName};
use super::history::{Event, History, Snapshot, SnapshotId, Transition};
use super::message::AppError;
use super::provenance::EditRecord;
use super::readings::{Info, State};
use super::segment::{Remade, Segment};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::{CurvatureJump, curvature_jump};
use crate::flow::flips::EdgeFlips;
use crate::flow::options::FlowOptions;
use crate::flow::spec::{self, Family};
use crate::flow::{Decision, FlowError, Pass, Status, StepReport, p_willmore};
use crate::geometry::measure;
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use crate::message::Say;
use crate::operator::Elements;
use crate::remesh::Regulariser;
use crate::remesh::static_pass::{self, RegulariseOptions, Regularised};
use glam::DVec3;
use serde::Serialize;
use std::rc::Rc;

/// What a configuration amounts to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Configured {
    /// Number of vertices that move.
    pub free_vertices: usize,
    /// h, the mean edge length.
    pub mean_edge_length: f64,
    /// The first step's raw size.
    pub dt: f64,
    /// The same without a unit.
    pub tau: f64,
    /// Readings at the start.
    pub state: State,
    /// 1 for each vertex that is held, 0 for each that moves.
    pub held_vertices: TypedArray<u8>,
}

/// Where what is shown stands.
enum Position {
    /// Where the engine does.
    Live,
    /// At a stored snapshot.
    Viewing(Viewed),
}

/// What belongs to a snapshot that is shown, besides its positions and readings.
#[derive(Clone)]
struct Viewed {
    checkpoint: Checkpoint,
    /// Faces that folded over in the step that led to it.
    folded: Vec<u32>,
    /// The snapshot at which the engine stands; `None` where it is to be made anew.
    engine_at: Option<SnapshotId>,
}

/// A document with its flow.
pub(super) struct Runner {
    pub(super) document: Document,
    /// The segment that the run began with.
    pub(super) first: Rc<Segment>,
    /// Segments so far.
    segments: u32,
    /// That of the snapshot which is shown.
    pub(super) segment: Rc<Segment>,
    pub(super) engine: Option<Engine>,
    /// The segment that the engine is of.
    engine_segment: Rc<Segment>,
    pub(super) x: Vec<DVec3>,
    pub(super) state: State,
    pub(super) history: History,
    /// Why the last step failed, if it did.
    pub(super) failure: Option<FlowError>,
    position: Position,
    /// Whether the engine was made anew since the last step.
    restarted: bool,
    /// What a pass of remeshing has put another in place of, until the step after it is taken.
    aside: Option<Engine>,
    /// Whether positions came from outside since the start.
    pub(super) is_restored: bool,
    /// How the document was made of what was loaded; `None` where that cannot be told.
    pub(super) origin: Option<Vec<EditRecord>>,
    pub(super) arrangement: Arrangement,
    /// Whether the surface passed through itself when it was opened.
    pub(super) crosses: bool,
}

impl Runner {
    pub(super) fn new(document: Document, x: Vec<DVec3>) -> Self {
        Self {
            document,
            first: Rc::default(),
            segments: 0,
            segment: Rc::default(),
            engine: None,
            engine_segment: Rc::default(),
            x,
            state: State::default(),
            history: History::default(),
            failure: None,
            position: Position::Live,
            restarted: false,
            aside: None,
            is_restored: false,
            origin: Some(Vec::new()),
            arrangement: Arrangement::default(),
            crosses: false,
        }
    }

    /// The faces as they are now: edge flips and passes of remeshing change them.
    pub(super) fn polygons(&self) -> &HalfedgeMesh {
        let flips = self.engine.as_ref().and_then(|flow| flow.flips());
        flips.map_or(self.meshes()[1], |flips| flips.runs()[0].mesh())
    }

    /// The same cut into triangles.
    pub(super) fn triangles(&self) -> &HalfedgeMesh {
        let flips = self.engine.as_ref().and_then(|flow| flow.flips());
        flips.map_or(self.meshes()[0], |flips| flips.runs()[0].mesh())
    }

    /// Triangles and faces that the present segment moves.
    pub(super) fn meshes(&self) -> [&Rc<HalfedgeMesh>; 2] {
        match &self.segment.remade {
            Some(Remade { mesh, .. }) => [mesh, mesh],
            None => [&self.document.triangles, &self.document.polygons],
        }
    }

    /// Lets go of the flow, whose factors are large, but not of what it takes to go on.
    pub(super) fn suspend(mut self) -> Suspended {
        let checkpoint = self.checkpoint();
        self.engine = None;
        Suspended {
            runner: self,
            checkpoint,
        }
    }

    pub(super) fn configure(&mut self, options: FlowOptions) -> Result<Configured, Fault> {
        let options = self.with_selection(options);
        let mut x = self.document.start.clone();
        let (triangles, polygons) = (&self.document.triangles, &self.document.polygons);
        // Kept until the new one is sure; gone before its factor is allocated, in the first
        // step: wasm memory never shrinks.
        let old = self.engine.take();
        let effective = self.effective(&options, false);
        let flow = match Engine::start(triangles, polygons, &mut x, effective) {
            Ok(flow) => flow,
            Err(error) => {
                self.engine = old;
                return Err(error.into());
            }
        };
        drop(old);
        self.begin_segment(options);
        self.x = x;
        self.begin_history();
        self.failure = None;
        self.engine = Some(flow);
        self.state = State::default();
        self.arrange(self.arrangement);
        self.read_state();
        self.configured().ok_or_else(Fault::no_mesh)
    }

    pub(super) fn info(&self) -> Info {
        let document = self.present();
        document.info()
    }

    pub(super) fn field(&self, name: FieldName) -> Result<Field, Fault> {
        self.field_at(name, &self.x)
    }

    /// The field of the surface with its vertices at `x`.
    pub(super) fn field_at(&self, name: FieldName, x: &[DVec3]) -> Result<Field, Fault> {
        let Some(flow) = &self.engine else {
            return Err(AppError::NotConfigured.into());
        };
        let start = match &self.segment.remade {
            // Vertices that a pass made have no place at the start.
            Some(_) => self.segment.start.as_ref(),
            None => None,
        };
        let start = start.unwrap_or(&self.document.start);
        let measured = |name| match name {
            FieldName::MeanCurvature => flow.mean_curvature(x),
            FieldName::Gradient => Some(flow.gradient(x).iter().map(|g| g.length()).collect()),
            FieldName::Displacement => {
                Some(x.iter().zip(start).map(|(p, q)| p.distance(*q)).collect())
            }
            _ => None,
        };
        let boundary = self.options().boundary.unwrap_or_default();
        Ok(Field::compute(
            name,
            self.triangles(),
            boundary,
            x,
            measured,
        ))
    }

    /// Forgets every snapshot but the present one.
    fn begin_history(&mut self) {
        self.history = History::default();
        self.position = Position::Live;
        self.restarted = false;
        self.is_restored = false;
    }

    /// Takes note that `event` led from `before` to what is there now.
    pub(super) fn follow(
        &mut self,
        before: Option<Snapshot>,
        event: Event,
        report: Option<&StepReport>,
    ) {
        let Some(before) = before else { return };
        let transition = Transition {
            event,
            // At the start there is nothing yet that it could have known.
            restarted: std::mem::take(&mut self.restarted) && self.history.can_go_back(),
        };
        let x = before.x.is_some().then_some(&*self.x);
        self.history
            .follow(before, transition, report.cloned(), x, &self.state);
        self.position = Position::Live;
    }

    /// Regularises the mesh as it is now, as a move that a step back undoes.
    pub(super) fn regularise(
        &mut self,
        settings: &RegulariseOptions,
    ) -> Result<Regularised, Fault> {
        let flow = self.engine.as_ref().ok_or_else(Fault::no_mesh)?;
        if flow.flips().is_some() {
            return Err(AppError::HeldPositions.into());
        }
        let [triangles, polygons] = self.meshes();
        p_willmore::check_mesh(polygons)?;
        let (mesh, elements) = match Elements::convex(polygons, &self.x) {
            Some(elements) => (polygons, elements),
            None => {
                let elements = Elements::of(triangles).ok_or(FlowError::MixedFaces)?;
                (triangles, elements)
            }
        };
        let mut regulariser = Regulariser::new(elements, &self.x).map_err(FlowError::from)?;
        let mut y = self.x.clone();
        let outcome = static_pass::regularise(&mut regulariser, mesh, &mut y, settings)?;
        interrupt::commit()?;
        let before = self.copied();
        self.stand_here()?;
        self.x = y;
        if let Some(flow) = &mut self.engine {
            // What the flow knows of the old positions no longer holds.
            let checkpoint = flow.checkpoint();
            flow.restore(checkpoint);
            flow.extend_budget();
        }
        self.state.status = Status::Ready;
        self.state.message = None;
        self.follow(before, Event::Regularise(*settings), None);
        self.read_state();
        Ok(outcome)
    }

    /// Takes a step; where that is [given up](interrupt), everything is as before it.
    ///
    /// # Errors
    /// As [`Session::step`](super::Session::step).
    pub(super) fn step(&mut self) -> Result<Option<StepReport>, Fault> {
        let here = self.return_point();
        let outcome = self.try_step();
        if interrupt::is_interrupted() && !matches!(outcome, Ok(Some(_))) {
            self.go_back(here);
            return Ok(None);
        }
        self.aside = None;
        outcome
    }

    /// Takes a step, after a pass of remeshing where one is due, or where without one the flow
    /// would be at an end.
    fn try_step(&mut self) -> Result<Option<StepReport>, Fault> {
        // Asked to go on after the end: the budget starts anew.
        let extends = self.state.status.is_final();
        let before = self.copied();
        self.stand_here()?;
        if let Some(kind) = self.is_pass_due()
            && let Some(pass) = self.pass(kind, self.copied())?
        {
            return self.step_after(pass, extends);
        }
        let (report, decision) = self.flow_step(before, None, extends)?;
        if let Some(kind) = self.can_pass_at(&decision) {
            // The next step begins with the pass, or says that the run is over.
            if report.is_some() {
                if let Some(flow) = &mut self.engine {
                    flow.exhaust();
                }
                return Ok(report);
            }
            if let Some(pass) = self.pass(kind, self.copied())? {
                return self.step_after(pass, false);
            }
        }
        self.end(decision);
        Ok(report)
    }

    fn end(&mut self, decision: Decision) {
        if let Decision::Stop(status, why) = decision {
            let is_read = match spec::of(self.options().flow).family {
                Family::PWillmore => self.polygons().is_triangular(),
                // What fits say on a coarse mesh says nothing of the surface. What has become a point
                // or a neck is told as that.
                Family::Curvature => status != Status::Singular,
                Family::Circle | Family::Flips => false,
            };
            if is_read {
                self.state.soundness = self.soundness();
            }
            self.state.status = status;
            self.state.message = Some(why.moved(self.document.frame.shift).into());
        }
    }

    /// A step of the flow itself, from the snapshot `before` and after a pass, if there was one.
    fn flow_step(
        &mut self,
        before: Option<Snapshot>,
        pass: Option<(Pass, f64)>,
        extends: bool,
    ) -> Result<(Option<StepReport>, Decision), Fault> {
        let (pass, milliseconds) = pass.unzip();
        let Some(flow) = &mut self.engine else {
            return Err(Fault::no_mesh());
        };
        if extends {
            flow.extend_budget();
        }
        let (mut report, decision) = match flow.step(&mut self.x) {
            // Readings that follow are no longer to be given up half.
            Ok((Some(_), _)) if interrupt::commit().is_err() => {
                return Ok((None, Decision::GivenUp));
            }
            Ok(outcome) => outcome,
            Err(error) => {
                self.state.status = Status::Failed;
                self.state.message = Some(error.message());
                self.failure = Some(error.clone());
                return Err(error.into());
            }
        };
        if let Some(report) = &mut report {
            report.pass = pass;
            report.remesh_milliseconds = milliseconds.unwrap_or_default();
            self.state = State {
                step: report.step,
                time: report.time,
                energy: report.energy,
                energy_normalised: report.energy_normalised,
                monitored: report.monitored,
                objective: report.objective,
                area: report.area,
                volume: report.volume,
                min_angle_degrees: report.min_angle_degrees,
                gradient_norm: report.gradient_norm,
                milliseconds: report.milliseconds,
                dt: flow.dt(),
                tau: flow.tau(),
                multipliers: report.multipliers,
                reduced_volume: report.reduced_volume,
                flips: report.flips.clone(),
                pass,
                soundness: report.soundness.or(self.state.soundness),
                can_step_back: true,
                ..State::default()
            };
            self.state.crossings = self.crossings();
            self.follow(before, Event::Step, Some(report));
        }
        Ok((report, decision))
    }

    /// The jump of H across the boundary of what moves.
    pub(super) fn curvature_jump(&self) -> Option<CurvatureJump> {
        let flow = self.engine.as_ref()?;
        let mesh = self.triangles();
        let free: Vec<bool> = (0..self.x.len()).map(|v| flow.is_free(v)).collect();
        if mesh.is_oriented() {
            curvature_jump(mesh, &self.x, &free)
        } else {
            None
        }
    }

    /// Readings and positions before the first step of the path that is shown.
    pub(super) fn beginning(&self) -> (&State, &[DVec3]) {
        match self.history.first() {
            None => (&self.state, &self.x),
            // Edge flips move no vertex and store none.
            Some(snapshot) => (&snapshot.state, snapshot.x.as_deref().unwrap_or(&self.x)),
        }
    }

    fn crossings(&self) -> Option<usize> {
        count_after_step(self.crosses, self.triangles(), &self.x)
    }

    /// Readings of the current positions, where no step has just told them.
    pub(super) fn read_state(&mut self) {
        let Some(flow) = &mut self.engine else { return };
        let reading = flow.reading(&self.x);
        self.state.energy = reading.energy;
        self.state.energy_normalised = reading.energy_normalised;
        self.state.monitored = reading.monitored;
        self.state.objective = reading.objective;
        self.state.gradient_norm = reading.gradient_norm;
        self.state.volume = reading.volume;
        self.state.area = reading.area;
        self.state.reduced_volume = reading.reduced_volume;
        self.state.flips = flow.flips().map(EdgeFlips::readings);
        self.state.min_angle_degrees = measure::min_angle_degrees(self.polygons(), &self.x);
        self.state.crossings = self.crossings();
        let Some(flow) = &self.engine else { return };
        self.state.dt = flow.dt();
        self.state.tau = flow.tau();
        self.state.can_step_back = self.history.can_go_back();
    }
}

/// A document whose flow can be started where it stood.
pub(super) struct Suspended {
    pub(super) runner: Runner,
    checkpoint: Option<Checkpoint>,
}

impl Suspended {
    /// Puts everything back as it was.
    pub(super) fn resume(self) -> Runner {
        let Self {
            mut runner,
            checkpoint,
        } = self;
        let Some(checkpoint) = checkpoint else {
            return runner;
        };
        // It started from here before; if memory is short now, the next step will say so.
        if let Ok(mut flow) = runner.started() {
            flow.restore(checkpoint);
            runner.engine_segment = Rc::clone(&runner.segment);
            runner.engine = Some(flow);
            runner.position = Position::Live;
            runner.restarted = true;
            runner.arrange(runner.arrangement);
        }
        runner
    }
}
