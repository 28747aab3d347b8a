//! How the present surface came about from the mesh that was loaded, as something that can
//! be done again.

mod error;
mod file;
mod read;
mod replay;

pub use file::{RecipeCard, RecipeMesh, ReplayReport, ReplayResult};
pub use replay::{Estimate, ReplayProgress, ScriptText};

pub use error::{MustBe, RecipeError};
pub(super) use file::{is_near, is_plain};
pub(super) use read::{Node, Reader};
pub(super) use replay::{Replay, steps_in};

use super::Session;
use super::fault::Fault;
use super::fill::{FillOptions, Loops};
use super::flip::FlipOptions;
use super::history::Deed;
use super::message::AppError;
use super::subdivide::SubdivideOptions;
use super::work::Work;
use crate::flow::options::FlowOptions;
use crate::remesh::static_pass::RegulariseOptions;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What was done to a surface, in turn.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Action {
    /// So many steps.
    Steps(usize),
    /// A conformal regularisation of the mesh at rest.
    Regularise(RegulariseOptions),
    /// The flow is made anew where it stands: it knows nothing of earlier steps.
    Anew,
    /// From here on another flow, or the same with other parameters.
    Flow(Box<FlowOptions>),
}

/// What made another mesh of the one at hand.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Edit {
    /// The surface as it was became the start.
    Adopt,
    /// Holes were filled.
    Fill(FillOptions),
    /// Connectivity was optimised.
    Flip(FlipOptions),
    /// Faces were divided into four.
    Subdivide(SubdivideOptions),
    /// The surface was inverted in a sphere: its centre, in the units of [`Session::invert`].
    Invert([f64; 3]),
}

/// A run, and the edit that ended it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct EditRecord {
    /// Options of the flow; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done.
    pub path: Vec<Action>,
    /// The edit.
    pub edit: Edit,
}

/// How the present surface came about.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Provenance {
    /// What made the mesh of the one that was loaded, oldest first.
    pub edits: Vec<EditRecord>,
    /// Options of the flow it began with; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done since.
    pub path: Vec<Action>,
}

/// What the open mesh was made of, before any edits; as the page tells it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Origin {
    /// A sample.
    Sample {
        /// Its id.
        id: String,
    },
    /// A file.
    File {
        /// What people call it.
        name: String,
        /// Its own name, where it was opened here.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        file: Option<String>,
        /// Its digest; empty or left out where that is not known.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        sha256: Option<String>,
        /// Its length.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        bytes: Option<usize>,
    },
    /// A shape that is no sample.
    Shape {
        /// Its name.
        shape: String,
        /// Parameters that are not the usual ones.
        parameters: BTreeMap<String, f64>,
    },
}

impl Session {
    /// How the present surface came about, forgotten steps included.
    ///
    /// # Errors
    /// `NoRecipe` after positions came from outside.
    pub fn provenance(&self) -> Result<Provenance, Fault> {
        let work = self.work()?;
        let Some(edits) = work.origin.clone().filter(|_| !work.is_restored) else {
            return Err(AppError::NoRecipe.into());
        };
        Ok(Provenance {
            edits,
            flow: work.first_options(),
            path: work.actions(),
        })
    }
}

impl Work {
    /// The options that the run began with.
    fn first_options(&self) -> Option<FlowOptions> {
        self.flow.as_ref()?;
        Some(self.as_given(&self.first.options))
    }

    fn actions(&self) -> Vec<Action> {
        if let Some(flips) = self.flow.as_ref().and_then(|flow| flow.flips()) {
            // One by one or many at once, they are the same.
            let count = flips.runs()[0].flips();
            return Vec::from_iter((count > 0).then_some(Action::Steps(count)));
        }
        let mut actions = Vec::new();
        for act in self.history.acts() {
            if act.anew {
                actions.push(Action::Anew);
            }
            match (&act.deed, actions.last_mut()) {
                (Deed::Step, Some(Action::Steps(count))) => *count += 1,
                (Deed::Step, _) => actions.push(Action::Steps(1)),
                (Deed::Regularise(settings), _) => actions.push(Action::Regularise(*settings)),
                (Deed::Flow(options), _) => {
                    actions.push(Action::Flow(Box::new(FlowOptions::clone(options))))
                }
            }
        }
        actions
    }

    /// How a document that `edit` makes of what is shown comes about.
    pub(super) fn origin_of(&self, mut edit: Edit) -> Option<Vec<EditRecord>> {
        if let Edit::Fill(options) = &mut edit
            && options.loops == Loops::All
        {
            options.loops = Loops::Word("all".into());
        }
        let mut records = self.origin.clone().filter(|_| !self.is_restored)?;
        records.push(EditRecord {
            flow: self.first_options(),
            path: self.actions(),
            edit,
        });
        Some(records)
    }
}

#[cfg(test)]
mod tests;
