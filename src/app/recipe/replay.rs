//! Doing again what was done to a surface, a piece at a time, so that it can be watched and
//! cancelled.

use super::error::RecipeError;
use super::file::{Recipe, sha256};
use super::script::{Script, Start};
use crate::app::arrangement::{Arrangement, Compare};
use crate::app::edit::options::RepairOptions;
use crate::app::fault::Fault;
use crate::app::link::Link;
use crate::app::provenance::{Action, Edit, EditRecord};
use crate::app::{Session, library};
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;

/// Changes of the flow, times vertices, at most: each keeps the surface that it starts from.
const MAX_KEPT: usize = 16 << 20;

/// A text that tells what is to be done to a surface.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum ScriptText {
    /// A recipe.
    Recipe(String),
    /// The words of a link.
    Link(String),
}

/// How far it is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ReplayProgress {
    /// From 0 to 1.
    pub share: f64,
    /// Whether that was all.
    pub is_done: bool,
}

/// A mesh with its name, from a file.
type File = (Vec<u8>, String);

/// One thing to do.
enum Task {
    /// A mesh, repaired where it is a file that need not be a surface.
    Open(Start, Option<RepairOptions>),
    Configure(Box<FlowOptions>),
    Act(Action),
    /// What is left of [`Action::Steps`]: to this step; whether the flow has said that it is over.
    Steps {
        goal: usize,
        is_over: bool,
    },
    Edit(Edit),
}

impl Task {
    /// How long it takes, in steps.
    fn weight(&self) -> u64 {
        match self {
            Self::Act(Action::Steps(count)) => *count as u64,
            _ => 1,
        }
    }
}

/// Something being done again.
pub(in crate::app) struct Replay {
    /// A session of its own, which takes the place of the one at hand at the end; else that one
    /// itself goes on.
    made: Option<Box<Session>>,
    file: Option<File>,
    tasks: VecDeque<Task>,
    total: u64,
    done: u64,
    /// Changes of the flow on the present mesh.
    flows: usize,
    /// To be put back at the end.
    arrangement: Option<Arrangement>,
}

impl Replay {
    fn new(tasks: VecDeque<Task>) -> Self {
        let total = tasks.iter().map(Task::weight).sum();
        Self {
            made: None,
            file: None,
            tasks,
            total,
            done: 0,
            flows: 0,
            arrangement: None,
        }
    }

    /// Does the next thing, of a run one step.
    fn advance(&mut self, session: &mut Session) -> Result<(), Fault> {
        let Some(task) = self.tasks.pop_front() else {
            return Ok(());
        };
        match task {
            Task::Open(start, repair) => self.open(session, start, repair)?,
            Task::Configure(options) => {
                session.configure(*options)?;
            }
            Task::Act(Action::Steps(count)) => {
                self.arrange_flips(session, count)?;
                let goal = session.state()?.step + count;
                let is_over = false;
                self.tasks.push_front(Task::Steps { goal, is_over });
                return Ok(());
            }
            Task::Act(Action::Anew) => session.renew()?,
            Task::Act(Action::Regularise(settings)) => {
                session.regularise(&settings)?;
            }
            Task::Act(Action::Flow(options)) => {
                let vertices = session.runner()?.x.len();
                self.flows += 1;
                let count = self.flows;
                if count * vertices > MAX_KEPT {
                    return Err(RecipeError::TooManyFlows { count, vertices }.into());
                }
                session.continue_with(*options)?;
            }
            Task::Steps { goal, is_over } => return self.step(session, goal, is_over),
            Task::Edit(edit) => {
                edited(session, edit)?;
                // Nobody has seen what was before, and nobody goes back to it.
                session.edits.clear();
                self.flows = 0;
            }
        }
        self.done += 1;
        Ok(())
    }

    fn open(
        &mut self,
        session: &mut Session,
        start: Start,
        repair: Option<RepairOptions>,
    ) -> Result<(), Fault> {
        let (name, asked) = match start {
            Start::Shape { name, parameters } => {
                session.sample(&name, &parameters)?;
                return Ok(());
            }
            Start::File { name, sha256 } => (name, sha256),
        };
        let Some((bytes, found)) = self.file.take() else {
            let name = name.unwrap_or_default();
            return Err(RecipeError::MeshMissing { name }.into());
        };
        let name = name.unwrap_or(found);
        if let Some(asked) = asked {
            let digest = sha256(&bytes);
            if !digest.starts_with(&asked) {
                let short = |digits: &str| digits.chars().take(12).collect();
                let (asked, found) = (short(&asked), short(&digest));
                return Err(RecipeError::AnotherMesh { name, asked, found }.into());
            }
        }
        match repair {
            Some(options) => session.load_repaired(&bytes, &name, options)?,
            None => session.load(&bytes, &name)?,
        };
        Ok(())
    }

    /// One by one or all at once, flips are the same.
    fn arrange_flips(&mut self, session: &mut Session, count: usize) -> Result<(), Fault> {
        let runner = session.runner()?;
        if runner.engine.is_none() || runner.options().flow != FlowName::Flips {
            return Ok(());
        }
        self.arrangement.get_or_insert(runner.arrangement);
        session.arrange(Arrangement {
            compare: Compare::None,
            subdivide: 0,
            flips_per_step: Some(count.max(1)),
        })
    }

    fn step(&mut self, session: &mut Session, goal: usize, is_over: bool) -> Result<(), Fault> {
        let before = session.state()?.step;
        if before >= goal {
            return Ok(());
        }
        let report = session.step()?;
        if let Some(report) = &report {
            session.view.add(report);
        }
        if session.is_given_up {
            self.tasks.push_front(Task::Steps { goal, is_over });
            return Ok(());
        }
        let state = session.state()?;
        // At an end there is none to take; asked again, a flow goes on with its budget anew.
        if report.is_none() && is_over {
            let (step, reason) = (before, state.message);
            return Err(RecipeError::EndsEarly { step, goal, reason }.into());
        }
        self.done += (state.step.saturating_sub(before)) as u64;
        let is_over = report.is_none();
        if state.step < goal {
            self.tasks.push_front(Task::Steps { goal, is_over });
        }
        Ok(())
    }

    fn progress(&self) -> ReplayProgress {
        let is_done = self.tasks.is_empty();
        let share = self.done as f64 / self.total.max(1) as f64;
        ReplayProgress {
            share: if is_done { 1.0 } else { share.min(1.0) },
            is_done,
        }
    }
}

fn edited(session: &mut Session, edit: Edit) -> Result<(), Fault> {
    match edit {
        Edit::Adopt => drop(session.adopt()?),
        Edit::Fill(options) => drop(session.fill_telling(&options)?),
        Edit::Flip(options) => drop(session.flip(&options)?),
        Edit::Repair(options) => drop(session.repair(options)?),
        Edit::Subdivide(options) => drop(session.subdivide(options)?),
        Edit::Remesh(options) => drop(session.remesh(&options)?),
        Edit::Invert(centre) => drop(session.invert(centre)?),
    }
    Ok(())
}

impl ScriptText {
    fn script(&self) -> Result<Script, Fault> {
        match self {
            Self::Recipe(text) => Ok(Recipe::read(text)?.script()),
            Self::Link(text) => Ok(Link::read(text, true)?.script()),
        }
    }
}

impl Link {
    fn script(self) -> Script {
        let start = match &self.sample {
            Some(id) => library::sample(id).map(|sample| Start::Shape {
                name: sample.shape.name.into(),
                parameters: (sample.shape.parameters.iter())
                    .map(|(name, x)| ((*name).into(), *x))
                    .collect(),
            }),
            None => None,
        };
        Script {
            start: start.unwrap_or(Start::File {
                name: None,
                sha256: self.hash,
            }),
            edits: self.edits.unwrap_or_default(),
            path: self.path.unwrap_or_default(),
        }
    }
}

impl Session {
    /// Begins to make the mesh of a script, with its edits, of `file` where it begins with one;
    /// [`advance`](Self::advance) does it. The mesh at hand stays until it is done.
    ///
    /// # Errors
    /// What is wrong with the script.
    pub fn prepare(&mut self, text: &ScriptText, file: Option<File>) -> Result<(), Fault> {
        let Script { start, edits, .. } = text.script()?;
        let mut edits = edits.into_iter().peekable();
        let repair = edits.next_if(|first| start.is_file() && first.repair().is_some());
        let repair = repair.and_then(|first| first.repair());
        let mut tasks = VecDeque::from([Task::Open(start, repair)]);
        for EditRecord { flow, path, edit } in edits {
            tasks.extend(flow.map(|options| Task::Configure(Box::new(options))));
            tasks.extend(path.into_iter().map(Task::Act));
            tasks.push_back(Task::Edit(edit));
        }
        let mut made = Session::new();
        made.set_progress(self.progress.clone());
        self.replay = Some(Replay {
            made: Some(Box::new(made)),
            file,
            ..Replay::new(tasks)
        });
        Ok(())
    }

    /// Begins to do what a script says after its last edit; [`advance`](Self::advance) does it.
    ///
    /// # Errors
    /// What is wrong with the script; [`Fault::no_mesh`].
    pub fn follow(&mut self, text: &ScriptText) -> Result<(), Fault> {
        self.runner()?;
        let script = text.script()?;
        self.view.forget_steps();
        self.replay = Some(Replay::new(
            script.path.into_iter().map(Task::Act).collect(),
        ));
        Ok(())
    }

    /// Does the next thing of what was begun, of a run one step.
    ///
    /// # Errors
    /// What cannot be done; it is given up then, and the surface is as it has come to.
    pub fn advance(&mut self) -> Result<ReplayProgress, Fault> {
        let Some(mut replay) = self.replay.take() else {
            return Err(RecipeError::NotReplaying.into());
        };
        let done = match replay.made.take() {
            Some(mut made) => {
                let done = replay.advance(&mut made);
                replay.made = Some(made);
                done
            }
            None => replay.advance(self),
        };
        let progress = replay.progress();
        if done.is_ok() && !progress.is_done {
            self.replay = Some(replay);
            return Ok(progress);
        }
        if let Some(arrangement) = replay.arrangement.filter(|_| replay.made.is_none()) {
            self.arrange(arrangement)?;
        }
        done?;
        let before = self.runner.as_ref().map(|runner| runner.arrangement);
        if let Some(mut runner) = replay.made.and_then(|made| made.runner) {
            runner.arrangement = before.unwrap_or_default();
            self.runner = Some(runner);
            self.edits.clear();
            self.panes.clear();
        }
        Ok(progress)
    }

    /// Gives up what was begun; a run stays where it has come to.
    ///
    /// # Errors
    /// As [`arrange`](Self::arrange).
    pub fn cancel_replay(&mut self) -> Result<(), Fault> {
        let replay = self.replay.take().filter(|replay| replay.made.is_none());
        let arrangement = replay.and_then(|replay| replay.arrangement);
        arrangement.map_or(Ok(()), |arrangement| self.arrange(arrangement))
    }
}
