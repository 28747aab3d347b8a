//! What may be asked of the application, and what it answers: the one seam to JavaScript
//! beside [`Frame`](super::Frame).

use super::bench::{BenchOptions, BenchReport};
use super::conjecture::{ConjectureReport, LabReport, QuadReport};
use super::crossing::SelfIntersections;
use super::diagnosis::Diagnosis;
use super::edit::fill::{FillOutcome, LoopInfo};
use super::edit::invert::{InversionReport, Inverted};
use super::edit::options::{
    FillOptions, FlipOptions, RemeshOptions, RepairOptions, SubdivideOptions,
};
use super::fault::Fault;
use super::field::{Field, FieldName};
use super::history::Timeline;
use super::link::{LinkCheck, LinkScene, PageScene, WrittenLink};
use super::look::{Look, LookOptions};
use super::outcome::Outcome;
use super::phases::Phase;
use super::readings::{EnergyOptions, EnergyReadings, Info, State};
use super::recipe::{Origin, RecipeCard, ReplayProgress, ReplayReport, ScriptText};
use super::runner::Configured;
use super::study::{StudyOptions, StudyReport};
use super::{FlipOutcome, Loaded, RegulariseOptions, Regularised, RemeshOutcome, Session};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::StepReport;
use crate::flow::option::{Values, options_of};
use crate::interrupt;
use crate::message::Message;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// A request by name, with its fields.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(
    rename_all = "camelCase",
    rename_all_fields = "camelCase",
    deny_unknown_fields
)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Command {
    /// Loads a mesh file; the format is found from its content.
    Load {
        /// The file.
        bytes: TypedArray<u8>,
        /// Its name.
        name: String,
        /// How it is repaired; null for a file that is a surface.
        #[serde(default)]
        repair: Option<RepairOptions>,
    },
    /// Loads a sample shape.
    Sample {
        /// Its name.
        name: String,
        /// Parameters that are not the usual ones.
        #[serde(default)]
        parameters: BTreeMap<String, f64>,
    },
    /// The mesh as it is now.
    Loaded {},
    /// Diagnosis card.
    Info {},
    /// Energies of the surface as it is now.
    Energy(EnergyOptions),
    /// Chooses flow and parameters, and goes back to the start.
    Configure {
        /// Those that are not the usual ones.
        #[cfg_attr(test, ts(as = "crate::flow::options::FlowOptions"))]
        options: Values,
    },
    /// Goes on from the surface as it is with other options.
    ContinueWith {
        /// All of them.
        #[cfg_attr(test, ts(as = "crate::flow::options::FlowOptions"))]
        options: Values,
    },
    /// Takes a step, if there is one to take.
    Step {},
    /// Where the session stands.
    State {},
    /// One stored step back.
    Back {},
    /// Back to the start.
    Reset {},
    /// Shows a stored step, the nearest at or before this one.
    Seek {
        /// Its number.
        step: usize,
    },
    /// Goes to the end of a branch.
    Branch {
        /// Its number.
        branch: u32,
    },
    /// Goes over to the other half of a film.
    Turn {
        /// The figure that it is of, by its id.
        figure: String,
    },
    /// The steps that can be shown.
    Timeline {},
    /// Puts positions from outside in place, as after a crash.
    Restore {
        /// Three coordinates a vertex.
        exact: TypedArray<f64>,
        /// Three corners each, where those of the frame were its own; null or none else.
        #[serde(default)]
        triangles: Option<TypedArray<u32>>,
        /// The step they belong to.
        step: usize,
        /// Its time.
        time: f64,
    },
    /// Conformal regularisation.
    Regularise {
        /// How.
        #[serde(default)]
        options: RegulariseOptions,
    },
    /// Edge flips to the end.
    Flip {
        /// Which, and how many.
        #[serde(default)]
        options: FlipOptions,
    },
    /// Fills holes or connects boundary loops.
    Fill {
        /// Which, and how.
        #[serde(default)]
        options: FillOptions,
    },
    /// Repairs the surface as it is now.
    Repair {
        /// How.
        #[serde(default)]
        options: RepairOptions,
    },
    /// Divides each triangle into four.
    Subdivide {
        /// By which scheme.
        #[serde(default)]
        options: SubdivideOptions,
    },
    /// Gives the surface other triangles.
    Remesh {
        /// Which, and how many.
        #[serde(default)]
        options: RemeshOptions,
    },
    /// Makes the surface inverted in a sphere the start.
    Invert {
        /// From the middle of the bounding box, in diagonals of it.
        centre: [f64; 3],
    },
    /// Makes the surface as it is the start.
    Adopt {},
    /// Undoes the last edit.
    Undo {},
    /// The boundary loops of the surface as it is now.
    Loops {},
    /// How edge flips, or flows side by side, are shown.
    Arrange {
        /// All of it.
        #[cfg_attr(test, ts(as = "super::arrangement::Arrangement"))]
        arrangement: Values,
    },
    /// What frames are coloured by from now on.
    Colour {
        /// A field by name, or `none`.
        field: String,
    },
    /// What frames look at more closely from now on.
    Look {
        /// All of it.
        options: LookOptions,
    },
    /// The surface inverted, without changing it.
    PreviewInversion {
        /// As for `invert`.
        centre: [f64; 3],
    },
    /// f_a against f_l on the surface as it is now.
    Conjecture {},
    /// The numbers of a quadrilateral.
    Quadrilateral {
        /// Vertices i, j, k, l.
        corners: [u32; 4],
    },
    /// Draws more random quadrilaterals; 0 begins anew.
    Lab {
        /// So many of each kind.
        pairs: usize,
    },
    /// Why the flow stands as it does.
    Why {},
    /// Where the surface passes through itself.
    SelfIntersections {},
    /// One more resolution of a refinement study; with options it begins anew.
    Study {
        /// Of what.
        #[serde(default)]
        options: Option<StudyOptions>,
    },
    /// A shape of the phase diagram of vesicles, in the place of the surface.
    Phase {
        /// From 0.
        number: usize,
    },
    /// The next row of a table of measurements; with options it begins anew.
    Bench {
        /// Of what.
        #[serde(default)]
        options: Option<BenchOptions>,
    },
    /// How the run of the present flow ended.
    Outcome {},
    /// The jump of H across the boundary of what moves.
    CurvatureJump {},
    /// What is known of a recipe.
    ReadRecipe {
        /// The recipe.
        text: String,
    },
    /// How the present surface came about, as a recipe.
    WriteRecipe {
        /// What it was made of; null where that is not known.
        origin: Option<Origin>,
    },
    /// How the present surface compares with what a recipe promised.
    CompareRecipe {
        /// The recipe.
        text: String,
    },
    /// The scene of a link.
    ReadLink {
        /// Its words.
        text: String,
        /// Whether none of them is of others, as there may be in the query of an address.
        is_own: bool,
    },
    /// The scene as a link.
    WriteLink {
        /// What the page knows of it.
        scene: PageScene,
    },
    /// How the scene of a link, at rest, compares with what the link says.
    CheckLink {
        /// The energy, as the link has it.
        sent: String,
        /// Its step.
        step: usize,
    },
    /// Begins to make the mesh of a recipe or a link, with its edits.
    Prepare {
        /// Of which.
        script: ScriptText,
        /// The file it begins with, if it does.
        #[serde(default)]
        bytes: Option<TypedArray<u8>>,
        /// Its name.
        #[serde(default)]
        name: String,
    },
    /// Begins to do what a recipe or a link says after its edits.
    Follow {
        /// Which.
        script: ScriptText,
    },
    /// Does the next thing of what was begun, of a run one step.
    Advance {},
    /// Gives up what was begun.
    CancelReplay {},
    /// The surface as a file.
    Export {
        /// Its format by name.
        format: String,
    },
    /// What such a file does not hold as the surface is.
    Losses {
        /// Its format by name.
        format: String,
    },
    /// The history as CSV.
    History {},
}

/// What a command of the same name is answered with.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
#[allow(missing_docs, reason = "each is described at the command of its name")]
pub enum Answer {
    Load(Loaded),
    Sample(Loaded),
    Loaded(Loaded),
    Info(Info),
    Energy(EnergyReadings),
    Configure(Configured),
    ContinueWith(Configured),
    /// None where there was none to take; the state says why.
    Step(Option<Box<StepReport>>),
    State(State),
    Back(State),
    Reset(State),
    Seek(State),
    Branch(State),
    Turn(State),
    Timeline(Timeline),
    Restore(State),
    Regularise(Regularised),
    Flip(FlipOutcome),
    Fill(FillOutcome),
    Repair(Loaded),
    Subdivide(Loaded),
    /// The mesh is loaded anew with `loaded`.
    Remesh(RemeshOutcome),
    Invert(InversionReport),
    Adopt(Loaded),
    Undo(Loaded),
    Loops(Vec<LoopInfo>),
    Arrange(State),
    Colour(Option<Field>),
    Look(Look),
    PreviewInversion(Inverted),
    Conjecture(ConjectureReport),
    Quadrilateral(QuadReport),
    Lab(LabReport),
    Why(Option<Diagnosis>),
    /// None where there are too many triangles near each other.
    SelfIntersections(Option<SelfIntersections>),
    Study(StudyReport),
    /// None after the last.
    Phase(Option<Phase>),
    Bench(BenchReport),
    Outcome(Box<Outcome>),
    CurvatureJump(Option<CurvatureJump>),
    ReadRecipe(RecipeCard),
    WriteRecipe(String),
    CompareRecipe(ReplayReport),
    ReadLink(LinkScene),
    WriteLink(WrittenLink),
    CheckLink(Option<LinkCheck>),
    Prepare(()),
    Follow(()),
    Advance(ReplayProgress),
    CancelReplay(()),
    Export(TypedArray<u8>),
    Losses(Vec<Message>),
    History(String),
}

impl Command {
    /// Whether it makes another mesh of the one at hand, which can be given up.
    fn is_edit(&self) -> bool {
        matches!(
            self,
            Self::Regularise { .. }
                | Self::Flip { .. }
                | Self::Fill { .. }
                | Self::Repair { .. }
                | Self::Remesh { .. }
                | Self::Subdivide { .. }
                | Self::Invert { .. }
                | Self::Adopt {}
        )
    }
}

impl Session {
    /// Does what a command asks for. An edit is [given up](interrupt) where who is told of its
    /// progress wants that.
    ///
    /// # Errors
    /// Those of the method it stands for, and `Cancelled`; nothing has changed then.
    pub fn perform(&mut self, command: Command) -> Result<Answer, Fault> {
        let opens = matches!(command, Command::Load { .. });
        // Steps are observed one by one: what is given up is a step.
        let steps = matches!(command, Command::Step {} | Command::Advance {});
        let progress = self.progress.clone().filter(|_| !steps);
        let is_edit = command.is_edit();
        let outcome = interrupt::observed(progress, || {
            if !is_edit {
                interrupt::commit()?;
            }
            let outcome = self.carried_out(command);
            interrupt::check()?;
            outcome
        });
        outcome.map_err(|fault| if opens { fault } else { self.offering(fault) })
    }

    fn carried_out(&mut self, command: Command) -> Result<Answer, Fault> {
        use Command as C;
        if matches!(
            command,
            C::Configure { .. }
                | C::ContinueWith { .. }
                | C::Back {}
                | C::Reset {}
                | C::Seek { .. }
                | C::Branch { .. }
                | C::Restore { .. }
                | C::Turn { .. }
                | C::Undo {}
        ) {
            self.view.forget_steps();
        }
        Ok(match command {
            C::Load {
                bytes,
                name,
                repair,
            } => Answer::Load(match repair {
                Some(options) => self.load_repaired(&bytes, &name, options)?,
                None => self.load(&bytes, &name)?,
            }),
            C::Sample { name, parameters } => {
                let values: Vec<(String, f64)> = parameters.into_iter().collect();
                Answer::Sample(self.sample(&name, &values)?)
            }
            C::Loaded {} => Answer::Loaded(self.loaded()?),
            C::Info {} => Answer::Info(self.info()?),
            C::Energy(options) => Answer::Energy(self.energy(options.boundary, &options.p)?),
            C::Configure { options } => {
                let configured = self.configure(options_of(&options)?)?;
                self.tell_flow();
                Answer::Configure(configured)
            }
            C::ContinueWith { options } => {
                let configured = self.continue_with(options_of(&options)?)?;
                self.tell_flow();
                Answer::ContinueWith(configured)
            }
            C::Turn { figure } => Answer::Turn(self.turn(&figure)?),
            C::Step {} => {
                let report = self.step()?;
                if let Some(report) = &report {
                    self.view.add(report);
                }
                Answer::Step(report.map(Box::new))
            }
            C::State {} => Answer::State(self.state()?),
            C::Back {} => Answer::Back(self.back()?),
            C::Reset {} => Answer::Reset(self.reset()?),
            C::Seek { step } => {
                let known = self.state()?.step;
                let state = self.seek(step)?;
                self.tell_steps_after(known);
                Answer::Seek(state)
            }
            C::Branch { branch } => {
                let known = self.timeline()?.start;
                let state = self.branch(branch)?;
                self.tell_steps_after(known);
                Answer::Branch(state)
            }
            C::Timeline {} => Answer::Timeline(self.timeline()?),
            C::Restore {
                exact,
                triangles,
                step,
                time,
            } => {
                let triangles = triangles.as_deref().map(Vec::as_slice);
                Answer::Restore(self.restore(&exact, triangles, step, time)?)
            }
            C::Regularise { options } => Answer::Regularise(self.regularise(&options)?),
            C::Flip { options } => Answer::Flip(self.flip(&options)?),
            C::Fill { options } => Answer::Fill(self.fill_telling(&options)?),
            C::Repair { options } => Answer::Repair(self.repair(options)?),
            C::Remesh { options } => Answer::Remesh(self.remesh(&options)?),
            C::Subdivide { options } => Answer::Subdivide(self.subdivide(options)?),
            C::Invert { centre } => Answer::Invert(self.invert(centre)?.1),
            C::Adopt {} => Answer::Adopt(self.adopt()?),
            C::Undo {} => Answer::Undo(self.undo_edit()?),
            C::Loops {} => Answer::Loops(self.boundary_loops()?),
            C::Arrange { arrangement } => {
                self.arrange(options_of(&arrangement)?)?;
                Answer::Arrange(self.state()?)
            }
            C::Colour { field } => {
                let answer = self.field(&field)?;
                let name = (field != "none").then(|| FieldName::parse(&field));
                self.view.field = name.transpose()?;
                Answer::Colour(answer)
            }
            C::Look { options } => {
                let look = self.look(options)?;
                self.view.look = (options != LookOptions::default()).then_some(options);
                Answer::Look(look)
            }
            C::PreviewInversion { centre } => {
                let (field, look) = (self.view.field, self.view.look.unwrap_or_default());
                Answer::PreviewInversion(self.preview_inversion(centre, field, look)?)
            }
            C::Conjecture {} => Answer::Conjecture(self.conjecture()?),
            C::Quadrilateral { corners } => Answer::Quadrilateral(self.quadrilateral(corners)?),
            C::Lab { pairs } => Answer::Lab(self.lab(pairs)),
            C::Why {} => Answer::Why(self.why()?),
            C::SelfIntersections {} => Answer::SelfIntersections(self.self_intersections()?),
            C::Study { options } => Answer::Study(self.study(options.as_ref())?),
            C::Phase { number } => Answer::Phase(self.phase(number)?),
            C::Bench { options } => Answer::Bench(self.bench(options.as_ref())?),
            C::Outcome {} => Answer::Outcome(Box::new(self.outcome()?)),
            C::CurvatureJump {} => Answer::CurvatureJump(self.curvature_jump()?),
            C::ReadRecipe { text } => Answer::ReadRecipe(self.read_recipe(&text)?),
            C::WriteRecipe { origin } => Answer::WriteRecipe(self.write_recipe(origin.as_ref())?),
            C::CompareRecipe { text } => Answer::CompareRecipe(self.compare_recipe(&text)?),
            C::ReadLink { text, is_own } => Answer::ReadLink(self.read_link(&text, is_own)?),
            C::WriteLink { scene } => Answer::WriteLink(self.write_link(&scene)?),
            C::CheckLink { sent, step } => Answer::CheckLink(self.check_link(&sent, step)?),
            C::Prepare {
                script,
                bytes,
                name,
            } => {
                let file = bytes.map(|bytes| (bytes.0, name));
                Answer::Prepare(self.prepare(&script, file)?)
            }
            C::Follow { script } => Answer::Follow(self.follow(&script)?),
            C::Advance {} => Answer::Advance(self.advance()?),
            C::CancelReplay {} => Answer::CancelReplay(self.cancel_replay()?),
            C::Export { format } => {
                Answer::Export(self.export(Fault::format_named(&format)?)?.into())
            }
            C::Losses { format } => Answer::Losses(self.losses(Fault::format_named(&format)?)?),
            C::History {} => Answer::History(self.history_csv()?),
        })
    }

    /// A fill that tells its progress to whom steps tell theirs.
    pub(super) fn fill_telling(&mut self, options: &FillOptions) -> Result<FillOutcome, Fault> {
        let mut tell = |stage: &'static str, share: f64| {
            interrupt::tell(stage, share);
            ControlFlow::Continue(())
        };
        self.fill(options, &mut tell)
    }
}
