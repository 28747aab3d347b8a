//! The application without a browser: load, configure, step, go back, export, report.
//!
//! Knows no wasm; `web::session` only converts. A failed request changes nothing: the
//! mesh, its positions and its history stay as they were.

mod arrangement;
mod bench;
mod colours;
mod command;
mod comparison;
mod conjecture;
mod crossing;
mod diagnosis;
mod document;
mod edit;
mod engine;
mod fault;
mod field;
mod frame;
mod given;
mod halves;
mod history;
mod json;
pub mod library;
mod lineage;
mod link;
mod look;
mod message;
mod numbers;
mod options;
mod outcome;
mod pane;
mod panes;
mod phases;
mod plot_point;
mod probe;
mod provenance;
mod readings;
mod recipe;
mod repairs;
mod runner;
mod segment;
mod study;
mod unpacked;

pub use crate::interrupt::Progress;
pub use crate::remesh::static_pass::{MeshQuality, RegulariseOptions, Regularised};
pub use arrangement::{Arrangement, Compare};
pub use bench::{Bench, BenchOptions, BenchReport, TableName};
pub use command::{RunAnswer, RunCommand, ToolAnswer, ToolCommand};
pub use comparison::{Comparison, Lockstep, PaneChange};
pub use conjecture::{ConjectureReport, LabReport, QuadReport};
pub use crossing::SelfIntersections;
pub use diagnosis::{Change, Diagnosis, Label, Remedy, RemedyId, Symptom};
pub use edit::fill::{FillOutcome, LoopInfo};
pub use edit::flip::{Costs, FlipOutcome};
pub use edit::invert::{InversionReadings, InversionReport, Inverted};
pub use edit::options::{
    FillOptions, FlipOptions, Loops, RemeshOptions, RepairOptions, SubdivideOptions,
    SubdivisionScheme,
};
pub use edit::remesh::{MeshReadings, RemeshOutcome};
pub use fault::Fault;
pub use field::{Field, FieldName};
pub use frame::{ChosenFlow, Frame};
pub use given::{read_flags, unknown_flag};
pub use history::{BranchInfo, Timeline};
pub use link::{
    Check, Lack, LinkCheck, LinkError, LinkScene, LinkValue, LinkView, PageScene, Scale, Shading,
    WrittenLink,
};
pub use look::{
    ALIGNED_DEGREES, Alignment, Drawn, Look, LookOptions, MAX_CIRCLES, MAX_CROSSES, SegmentKind,
};
pub use message::{AppError, Notice};
pub use numbers::Numbers;
pub use outcome::{Outcome, RunNotice};
pub use pane::{Curve, Curves, Pane};
pub use phases::{Branch, Phase, crossing};
pub use plot_point::PlotPoint;
pub use probe::{Probe, ProbedEdge, edge_angle};
pub use provenance::{Action, Edit, EditRecord, Provenance};
pub use readings::{EnergyOptions, EnergyReadings, Info, State};
pub use recipe::{
    Estimate, MustBe, Origin, RecipeCard, RecipeError, RecipeMesh, ReplayProgress, ReplayReport,
    ReplayResult, ScriptText,
};
pub use repairs::RepairItem;
pub use runner::Configured;
pub use study::{Limits, RefinedBy, Resolution, Study, StudyOptions, StudyReport, Tendency, Trend};
pub use unpacked::{OpenedFile, Unpacked};

use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::options::FlowOptions;
use crate::flow::{StepReport, boundary};
use crate::interrupt;
use crate::io::{Format, Loss};
use crate::mesh::shape;
use crate::message::Message;
use crate::remesh::adaptive::Soundness;
use crate::remesh::fill::FillProgress;
use crate::remesh::flips::lab::Lab;
use colours::Colours;
use document::{Document, Opened};
use edit::Edits;
use edit::repair::Offered;
use frame::View;
use glam::DVec3;
use halves::OtherHalf;
use panes::Panes;
use recipe::Replay;
use runner::Runner;
use serde::Serialize;

/// What is known after a mesh was loaded, and everything a viewer needs to draw it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Loaded {
    /// Base name without extension, for downloads.
    pub name: String,
    /// Diagnosis card.
    pub info: Info,
    /// Three coordinates a vertex, relative to the mesh's frame.
    pub positions: TypedArray<f32>,
    /// What is added to positions for the file's coordinates; zero unless those lie far from the
    /// origin.
    pub shift: [f64; 3],
    /// Red, green, blue and opacity of each vertex, from 0 to 1; null where the file has none.
    pub colours: Option<TypedArray<f32>>,
    /// How the file numbers what sentences name.
    pub numbers: Numbers,
    /// Three corners a triangle.
    pub triangles: TypedArray<u32>,
    /// Two ends an edge of the file's own faces.
    pub wire_edges: TypedArray<u32>,
    /// Two ends a boundary edge.
    pub boundary_edges: TypedArray<u32>,
    /// Whether the file has triangles only.
    pub triangles_only: bool,
    /// Vertices a sample suggests to hold.
    pub fixed: Option<TypedArray<u32>>,
    /// Vertices a sample suggests to move.
    pub free: Option<TypedArray<u32>>,
    /// What a repair changed to make this of what was there before.
    pub repaired: Vec<RepairItem>,
    /// Which way up it is looked at.
    pub up: shape::Up,
}

impl Loaded {
    fn of(document: &Document) -> Self {
        Self {
            name: document.name.clone(),
            info: document.info(),
            positions: as_f32(&document.start).into(),
            shift: document.frame.shift.to_array(),
            colours: document.colours.numbers(),
            numbers: document.numbers.clone(),
            triangles: document.triangles.triangle_indices().into(),
            wire_edges: document.polygons.edge_indices(false).into(),
            boundary_edges: document.polygons.edge_indices(true).into(),
            triangles_only: document.polygons.is_triangular(),
            fixed: document.fixed.clone().map(TypedArray),
            free: document.free.clone().map(TypedArray),
            repaired: document.repaired.clone(),
            up: document.up,
        }
    }
}

/// One mesh, one flow, its history.
#[derive(Default)]
pub struct Session {
    runner: Option<Runner>,
    lab: Option<Lab>,
    edits: Edits,
    panes: Panes,
    study: Option<Study>,
    bench: Option<Bench>,
    view: View,
    progress: Option<Progress>,
    /// Whether the last step was given up.
    is_given_up: bool,
    replay: Option<Replay>,
    other_half: OtherHalf,
    offered: Option<Offered>,
}

impl Session {
    /// A session without a mesh.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets or clears who is told the progress of long work, and may have a step given up.
    pub fn set_progress(&mut self, progress: Option<Progress>) {
        self.progress = progress;
    }

    fn runner(&self) -> Result<&Runner, Fault> {
        self.runner.as_ref().ok_or_else(Fault::no_mesh)
    }

    fn runner_mut(&mut self) -> Result<&mut Runner, Fault> {
        self.runner.as_mut().ok_or_else(Fault::no_mesh)
    }

    /// Loads a mesh file; the format is found from its content.
    ///
    /// # Errors
    /// What is wrong with the file and where; the mesh loaded before stays.
    pub fn load(&mut self, bytes: &[u8], file_name: &str) -> Result<Loaded, Fault> {
        match Opened::of(bytes, file_name)? {
            Opened::Surface(document) => self.open(document),
            Opened::Broken(read, fault) => Err(self.offer_repair(bytes, file_name, read, fault)),
        }
    }

    /// Loads a sample shape by name; parameters not given take their defaults.
    ///
    /// # Errors
    /// Unknown names and values out of range; the mesh loaded before stays.
    pub fn sample(&mut self, name: &str, values: &[(String, f64)]) -> Result<Loaded, Fault> {
        let document = Document::from_sample(name, shape::make(name, values)?)?;
        self.open(document)
    }

    fn open(&mut self, document: Document) -> Result<Loaded, Fault> {
        let x = document.start.clone();
        let arrangement = self.runner.as_ref().map(|runner| runner.arrangement);
        let mut runner = Runner::new(document, x);
        runner.arrangement = arrangement.unwrap_or_default();
        self.runner = Some(runner);
        self.edits.clear();
        self.panes.clear();
        self.other_half = OtherHalf::default();
        self.offered = None;
        let loaded = self.loaded()?;
        let crossings = loaded.info.self_intersections;
        self.runner_mut()?.crosses = crossings.is_some_and(|count| count > 0);
        Ok(loaded)
    }

    /// The mesh as it is now, as after loading it.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn loaded(&self) -> Result<Loaded, Fault> {
        Ok(Loaded::of(&self.runner()?.present()))
    }

    /// Chooses flow and parameters and goes back to the start.
    ///
    /// A sample's own selection is used unless `options` has one.
    ///
    /// # Errors
    /// See [`crate::flow::FlowError`]; the flow configured before stays.
    pub fn configure(&mut self, options: FlowOptions) -> Result<Configured, Fault> {
        let configured = self.runner_mut()?.configure(options)?;
        self.other_half = OtherHalf::default();
        self.settle_panes();
        Ok(configured)
    }

    /// Takes what stands beside the surface to where that is now.
    fn settle_panes(&mut self) {
        if let Some(runner) = &self.runner {
            self.panes.settle(runner);
        }
    }

    fn ensure_configured(&mut self) -> Result<&mut Runner, Fault> {
        if self.runner()?.engine.is_none() {
            self.configure(FlowOptions::default())?;
        }
        self.runner_mut()
    }

    /// Takes one step; `None` if there was none to take, and then the state says why, or if the one
    /// at hand was [given up](interrupt): then everything is as before, and the next is the same.
    ///
    /// # Errors
    /// Numerical failures; the state is that before the step, with status `failed`.
    pub fn step(&mut self) -> Result<Option<StepReport>, Fault> {
        self.ensure_configured()?;
        let progress = self.progress.clone();
        let (outcome, is_given_up) = interrupt::observed(progress, || {
            let outcome = self.runner_mut().and_then(Runner::step);
            let is_given_up = interrupt::is_interrupted() && matches!(outcome, Ok(None));
            (outcome, is_given_up)
        });
        self.is_given_up = is_given_up;
        let report = outcome?;
        self.settle_panes();
        Ok(report)
    }

    /// Steps until the run is over or `limit` steps were taken; answers their number.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn run(&mut self, limit: usize) -> Result<usize, Fault> {
        for taken in 0..limit {
            if self.step()?.is_none() {
                return Ok(taken);
            }
            if self.state()?.status.is_final() {
                return Ok(taken + 1);
            }
        }
        Ok(limit)
    }

    /// Conformal regularisation of the mesh as it is now; a step back undoes it.
    ///
    /// # Errors
    /// Open and one-sided surfaces, and those that could only be bettered by changing their
    /// shape; the mesh stays as it was.
    pub fn regularise(&mut self, settings: &RegulariseOptions) -> Result<Regularised, Fault> {
        let outcome = self.ensure_configured()?.regularise(settings)?;
        self.settle_panes();
        Ok(outcome)
    }

    /// Optimises the connectivity by edge flips; the surface as it is now becomes the start.
    /// [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// Meshes with faces other than triangles; the mesh stays as it was.
    pub fn flip(&mut self, options: &FlipOptions) -> Result<FlipOutcome, Fault> {
        self.edit(Edit::Flip(*options), |runner| runner.flipped(options))
    }

    /// The boundary loops of the surface as it is now, in the order of their numbers.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn boundary_loops(&self) -> Result<Vec<LoopInfo>, Fault> {
        Ok(self.runner()?.boundary_loops())
    }

    /// Fills holes, or connects boundary loops by one patch. The surface as it is now, with
    /// the patches, becomes the start, and the new vertices are those that the next flow
    /// moves. [`undo_edit`](Self::undo_edit) undoes it. `progress` is told a stage and the
    /// share done; breaking cancels.
    ///
    /// # Errors
    /// See [`crate::remesh::fill::FillError`]; the mesh stays as it was.
    pub fn fill(
        &mut self,
        options: &FillOptions,
        progress: FillProgress<'_>,
    ) -> Result<FillOutcome, Fault> {
        let options = options.named();
        self.edit(Edit::Fill(options.clone()), |runner| {
            runner.filled(&options, progress)
        })
    }

    /// Shows the snapshot before, if one is stored; see [`seek`](Self::seek).
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn back(&mut self) -> Result<State, Fault> {
        let state = self.runner_mut()?.back();
        self.settle_panes();
        Ok(state)
    }

    /// Goes back to the start with the options in force. The steps stay stored, so that
    /// [`seek`](Self::seek) undoes it.
    ///
    /// # Errors
    /// As [`configure`](Self::configure).
    pub fn reset(&mut self) -> Result<State, Fault> {
        let runner = self.runner_mut()?;
        // Of positions from outside there is no way back to the start.
        if runner.history.has_snapshots() && !runner.is_restored {
            let state = runner.rewind()?;
            self.settle_panes();
            return Ok(state);
        }
        let options = runner.options().clone();
        Ok(self.configure(options)?.state)
    }

    /// Where the session stands.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn state(&self) -> Result<State, Fault> {
        Ok(self.runner()?.state.clone())
    }

    /// Positions for drawing, relative to the mesh's frame.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn positions(&self) -> Result<Vec<f32>, Fault> {
        Ok(as_f32(&self.runner()?.x))
    }

    /// Triangles that folded over in the last step.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn flipped_triangles(&self) -> Result<Vec<u32>, Fault> {
        Ok(self.runner()?.folded().to_vec())
    }

    /// Which vertices are held: 1, or 0 where they move. Empty before `configure`.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn held_vertices(&self) -> Result<Vec<u8>, Fault> {
        let runner = self.runner()?;
        let Some(flow) = &runner.engine else {
            return Ok(Vec::new());
        };
        Ok((0..runner.x.len())
            .map(|v| u8::from(!flow.is_free(v)))
            .collect())
    }

    /// The jump of H across the boundary of what moves; `None` where nothing is held next to a
    /// vertex that moves, or before `configure`.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn curvature_jump(&self) -> Result<Option<CurvatureJump>, Fault> {
        Ok(self.runner()?.curvature_jump())
    }

    /// A field to colour by; `None` for the name `none`.
    ///
    /// # Errors
    /// Unknown names.
    pub fn field(&self, name: &str) -> Result<Option<Field>, Fault> {
        let runner = self.runner()?;
        if name == "none" {
            return Ok(None);
        }
        runner.field(FieldName::parse(name)?).map(Some)
    }

    /// Whether readings of the surface as it is now can be believed; `None` of open and one-sided
    /// ones.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn soundness(&self) -> Result<Option<Soundness>, Fault> {
        Ok(self.runner()?.soundness())
    }

    /// Diagnosis of the surface as it is now.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn info(&self) -> Result<Info, Fault> {
        let runner = self.runner()?;
        Ok(runner.info())
    }

    /// All energies of the surface as it is now, with ∫|H|^p also for `powers`.
    ///
    /// # Errors
    /// [`Fault::no_mesh`]. Where no vertex is free the gradient norm is 0.
    pub fn energy(
        &self,
        boundary: crate::energy::circle::Boundary,
        powers: &[f64],
    ) -> Result<EnergyReadings, Fault> {
        let runner = self.runner()?;
        let mesh = runner.triangles();
        let free = boundary::free_vertices(mesh, boundary, None, None)
            .unwrap_or_else(|_| vec![false; mesh.n_vertices()]);
        // Of the file's own faces only quadrilaterals have readings of their own.
        let polygons = &runner.document.polygons;
        Ok(EnergyReadings::of(
            mesh, polygons, &runner.x, boundary, &free, powers,
        ))
    }

    /// The surface as a file, with the faces of the original.
    ///
    /// # Errors
    /// If the format cannot hold it.
    pub fn export(&self, format: Format) -> Result<Vec<u8>, Fault> {
        let runner = self.runner()?;
        let comment = format!(
            "Umbilic: {}, step {}",
            runner.document.name, runner.state.step
        );
        Ok(crate::io::write(&runner.soup(), format, &comment)?)
    }

    /// What such a file does not hold as the surface is.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn losses(&self, format: Format) -> Result<Vec<Message>, Fault> {
        let runner = self.runner()?;
        let mut losses = crate::io::losses(&runner.soup(), format);
        if matches!(runner.colours(), Colours::Dropped) {
            losses.push(Loss::ColoursLost);
        }
        Ok(losses.into_iter().map(Message::from).collect())
    }

    /// Reports of the steps taken, oldest first.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn reports(&self) -> Result<&[StepReport], Fault> {
        Ok(self.runner()?.history.reports())
    }

    /// The history as CSV.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn history_csv(&self) -> Result<String, Fault> {
        Ok(readings::history_csv(self.runner()?.history.reports()))
    }
}

fn as_f32(x: &[DVec3]) -> Vec<f32> {
    x.iter().flat_map(|p| p.as_vec3().to_array()).collect()
}
