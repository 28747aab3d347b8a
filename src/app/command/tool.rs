//! Files, edits, questions, recipes: whatever else can be done with a surface.

use crate::app::bench::{BenchOptions, BenchReport};
use crate::app::conjecture::{ConjectureReport, LabReport, QuadReport};
use crate::app::crossing::SelfIntersections;
use crate::app::diagnosis::Diagnosis;
use crate::app::edit::fill::{FillOutcome, LoopInfo};
use crate::app::edit::invert::{InversionReport, Inverted};
use crate::app::edit::options::{
    FillOptions, FlipOptions, RemeshOptions, RepairOptions, SubdivideOptions,
};
use crate::app::fault::Fault;
use crate::app::link::{LinkCheck, LinkScene, PageScene, WrittenLink};
use crate::app::look::{Look, LookOptions};
use crate::app::outcome::Outcome;
use crate::app::phases::Phase;
use crate::app::readings::{EnergyOptions, EnergyReadings, State};
use crate::app::recipe::{Origin, RecipeCard, ReplayProgress, ReplayReport, ScriptText};
use crate::app::study::{StudyOptions, StudyReport};
use crate::app::unpacked::{OpenedFile, Unpacked, unpacked};
use crate::app::{FlipOutcome, Loaded, RegulariseOptions, Regularised, RemeshOutcome, Session};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::interrupt;
use crate::message::Message;
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;

/// A request by name, with its fields.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(
    rename_all = "camelCase",
    rename_all_fields = "camelCase",
    deny_unknown_fields
)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ToolCommand {
    /// Finds the mesh among files that are opened together, out of gzip and ZIP.
    Unpack {
        /// At least one.
        files: Vec<OpenedFile>,
    },
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
    /// Energies of the surface as it is now.
    Energy(EnergyOptions),
    /// Goes over to the other half of a film.
    Turn {
        /// The figure that it is of, by its id.
        figure: String,
    },
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
    /// The vertices that the file gives these numbers, as selections in files have them.
    Numbered {
        /// All of them.
        numbers: Vec<u32>,
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
        step: i32,
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
pub enum ToolAnswer {
    Unpack(Unpacked),
    Load(Loaded),
    Energy(EnergyReadings),
    Turn(State),
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
    Numbered(Vec<u32>),
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

impl ToolCommand {
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
    pub fn perform_tool(&mut self, command: ToolCommand) -> Result<ToolAnswer, Fault> {
        let opens = matches!(
            command,
            ToolCommand::Load { .. } | ToolCommand::Unpack { .. }
        );
        // Steps are observed one by one: what is given up is a step.
        let steps = matches!(command, ToolCommand::Advance {});
        let progress = self.progress.clone().filter(|_| !steps);
        let is_edit = command.is_edit();
        let outcome = interrupt::observed(progress, || {
            if !is_edit {
                interrupt::commit()?;
            }
            let outcome = self.tool_command(command);
            interrupt::check()?;
            outcome
        });
        outcome.map_err(|fault| if opens { fault } else { self.offering(fault) })
    }

    fn tool_command(&mut self, command: ToolCommand) -> Result<ToolAnswer, Fault> {
        use {ToolAnswer as A, ToolCommand as C};
        if matches!(command, C::Restore { .. } | C::Turn { .. } | C::Undo {}) {
            self.view.forget_steps();
        }
        Ok(match command {
            C::Unpack { files } => A::Unpack(unpacked(&files)?),
            C::Load {
                bytes,
                name,
                repair,
            } => A::Load(match repair {
                Some(options) => self.load_repaired(&bytes, &name, options)?,
                None => self.load(&bytes, &name)?,
            }),
            C::Energy(options) => A::Energy(self.energy(options.boundary, &options.p)?),
            C::Turn { figure } => A::Turn(self.turn(&figure)?),
            C::Restore {
                exact,
                triangles,
                step,
                time,
            } => {
                let triangles = triangles.as_deref().map(Vec::as_slice);
                A::Restore(self.restore(&exact, triangles, step, time)?)
            }
            C::Regularise { options } => A::Regularise(self.regularise(&options)?),
            C::Flip { options } => A::Flip(self.flip(&options)?),
            C::Fill { options } => A::Fill(self.fill_telling(&options)?),
            C::Repair { options } => A::Repair(self.repair(options)?),
            C::Remesh { options } => A::Remesh(self.remesh(&options)?),
            C::Subdivide { options } => A::Subdivide(self.subdivide(options)?),
            C::Invert { centre } => A::Invert(self.invert(centre)?.1),
            C::Adopt {} => A::Adopt(self.adopt()?),
            C::Undo {} => A::Undo(self.undo_edit()?),
            C::Loops {} => A::Loops(self.boundary_loops()?),
            C::Numbered { numbers } => A::Numbered(self.numbered(&numbers)?),
            C::Look { options } => A::Look(self.look_at(options)?),
            C::PreviewInversion { centre } => {
                let (field, look) = (self.view.field, self.view.look.unwrap_or_default());
                A::PreviewInversion(self.preview_inversion(centre, field, look)?)
            }
            C::Conjecture {} => A::Conjecture(self.conjecture()?),
            C::Quadrilateral { corners } => A::Quadrilateral(self.quadrilateral(corners)?),
            C::Lab { pairs } => A::Lab(self.lab(pairs)),
            C::Why {} => A::Why(self.why()?),
            C::SelfIntersections {} => A::SelfIntersections(self.self_intersections()?),
            C::Study { options } => A::Study(self.study(options.as_ref())?),
            C::Phase { number } => A::Phase(self.phase(number)?),
            C::Bench { options } => A::Bench(self.bench(options.as_ref())?),
            C::Outcome {} => A::Outcome(Box::new(self.outcome()?)),
            C::CurvatureJump {} => A::CurvatureJump(self.curvature_jump()?),
            C::ReadRecipe { text } => A::ReadRecipe(self.read_recipe(&text)?),
            C::WriteRecipe { origin } => A::WriteRecipe(self.write_recipe(origin.as_ref())?),
            C::CompareRecipe { text } => A::CompareRecipe(self.compare_recipe(&text)?),
            C::ReadLink { text, is_own } => A::ReadLink(self.read_link(&text, is_own)?),
            C::WriteLink { scene } => A::WriteLink(self.write_link(&scene)?),
            C::CheckLink { sent, step } => A::CheckLink(self.check_link(&sent, step)?),
            C::Prepare {
                script,
                bytes,
                name,
            } => {
                let file = bytes.map(|bytes| (bytes.0, name));
                A::Prepare(self.prepare(&script, file)?)
            }
            C::Follow { script } => A::Follow(self.follow(&script)?),
            C::Advance {} => A::Advance(self.advance()?),
            C::CancelReplay {} => A::CancelReplay(self.cancel_replay()?),
            C::Export { format } => A::Export(self.export(Fault::format_named(&format)?)?.into()),
            C::Losses { format } => A::Losses(self.losses(Fault::format_named(&format)?)?),
            C::History {} => A::History(self.history_csv()?),
        })
    }

    /// A fill that tells its progress to whom steps tell theirs.
    pub(in crate::app) fn fill_telling(
        &mut self,
        options: &FillOptions,
    ) -> Result<FillOutcome, Fault> {
        let mut tell = |stage: &'static str, share: f64| {
            interrupt::tell(stage, share);
            ControlFlow::Continue(())
        };
        self.fill(options, &mut tell)
    }
}
